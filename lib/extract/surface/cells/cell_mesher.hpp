// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "extract/patch/manifold/manifold_crossings.hpp"
#include "extract/patch/patch_defects.hpp"
#include "extract/surface/cells/mesh_cells.hpp"

namespace tensortopo {

/// How far the meshing of one tetrahedron is.
template <class Scalar>
struct MeshingState {
  std::size_t way = 0;                          ///< of `CellMesher::ways`, the one that is tried
  bool tried_as_graph = false;                  ///< for want of another way
  std::unique_ptr<TetManifold> manifold;        ///< if meshed there
  std::vector<SampleRequest<Scalar>> requests;  ///< samples that the mesher wants on the faces
  UnresolvedReason why_not{};                   ///< why the last way that failed has no patch
  bool must_be_embedded = true;                 ///< `PatchDefects` are not accepted
  bool was_meshed = false;                      ///< with the proved topology, but with defects
  std::size_t tried = 0;                        ///< triangles of patches with defects
  std::size_t defects = 0;                      ///< of the patch; SIZE_MAX: not all were counted
  std::size_t fewest_defects = SIZE_MAX;        ///< of patches refined before
  int in_vain = 0;                              ///< patches since then
  int refinements = 0;                          ///< of the subdivision at defects
};

/// Of each tetrahedron; none while it is as at first, which it is in most tetrahedra to the end.
template <class Scalar>
using MeshingStates = std::vector<std::unique_ptr<MeshingState<Scalar>>>;

/// A patch with defects, to go back to.
template <class Scalar>
struct DefectivePatch {
  Patch<Scalar> patch;
  PatchDefects found;
};

/// Meshes one tetrahedron; what it reads stays as it is in the meantime.
template <class Scalar>
class CellMesher {
 public:
  CellMesher(const SurfaceInput<Scalar>& input, const VertexSides& sides,
             const CellSurroundings<Scalar>& around, CellProof<Scalar>& proof,
             MeshingState<Scalar>& state, CellMesh<Scalar>& mesh);

  /// Chooses the first way.
  void begin();
  /// Tries the mesher whose turn it is; whether the patch has the proved topology and no defects.
  bool try_mesher();
  /// After a failure: chooses the next one, and what samples it needs; or gives up.
  void choose_next();

 private:
  /// A way to mesh a tetrahedron.
  struct Way {
    Mesher mesher;
    /// Whether it applies to these sheets after what has failed. Asks for the samples that it
    /// needs.
    bool (CellMesher::*applies)();
    double density = 1;  ///< of samples inside, compared with what the options ask for
  };
  /// The ways in the order in which they are tried. The first that applies is tried, and its patch
  /// taken if it has the proved topology and no defects.
  static std::span<const Way> ways();
  /// Goes on from a way to the first one that applies, or gives up.
  void choose_from(std::size_t way);

  bool is_in_chart() const {
    return mesh_.mesher == Mesher::graph || mesh_.mesher == Mesher::manifold ||
           mesh_.mesher == Mesher::dominant;
  }
  bool unfold();
  bool untangle_few();
  bool mesh_without_defects(int rounds);
  bool find_defects();
  bool are_defects_few() const;
  bool is_last_mesher() const;
  bool may_be_refined() const;
  DefectivePatch<Scalar> present() const;
  void go_back_to(DefectivePatch<Scalar> before);
  bool mend();
  bool make_finer();
  bool mesh_topology(int defect_rounds);
  bool mesh_small_discs();
  bool mesh_by_bisection();
  bool mesh_graph(int defect_rounds);
  void mesh_cone();
  bool mesh_sheet(const SheetTopology& sheet, const FaceArcVertices& vertices);
  bool mesh_sheets(const FaceArcVertices& vertices);
  bool ask_for_chart(bool denser);

  // See `Way::applies`.
  bool is_cone();
  bool is_all_tubes();
  bool is_not_all_tubes();
  bool wants_bisection();
  bool wants_graph_before_many_samples();
  bool wants_graph_after_chart();
  bool wants_chart();
  bool wants_denser_chart();
  bool has_chart();
  bool wants_denser_loops();
  bool wants_subdivision();
  bool wants_fan();
  bool wants_loops();

  const Level<Scalar>& level() const {
    return proof_.level != nullptr ? *proof_.level : input_.level;
  }

  const SurfaceInput<Scalar>& input_;
  const VertexSides& sides_;
  const CellSurroundings<Scalar> around_;
  CellProof<Scalar>& proof_;
  MeshingState<Scalar>& state_;
  CellMesh<Scalar>& mesh_;
  std::optional<bool> shows_loops_;  ///< what `ask_for_chart` said
  TetWithCurves<Scalar> tet_;
  PatchDefects found_;  ///< of the patch, once they were looked for
};

}  // namespace tensortopo
