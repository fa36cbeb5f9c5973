// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "extract/patch/charts/manifold_crossings.hpp"
#include "extract/surface/cells/mesh_cells.hpp"

namespace tensortopo {

/// How far the meshing of one tetrahedron is.
template <class Scalar>
struct MeshingState {
  int attempts = 0;  ///< in charts
  /// Whose turn it was when the sheets were tried as graphs, if they were for want of another way.
  std::optional<Mesher> before_graph;
  std::unique_ptr<TetManifold> manifold;        ///< if meshed there
  std::vector<SampleRequest<Scalar>> requests;  ///< samples that the mesher wants on the faces
  UnresolvedReason last_resort{};               ///< why boundary loops are the last resort
  bool must_be_embedded = true;                 ///< `PatchDefects` are not accepted
  bool was_meshed = false;                      ///< with the proved topology, but with defects
  std::size_t tried = 0;                        ///< triangles of patches with defects
  std::size_t defects = 0;                      ///< of the patch
  int halvings = 0;                             ///< of steps along boundary loops beside defects
  int refinements = 0;                          ///< of the subdivision at defects
  std::vector<SampleRequest<Scalar>> beside_defects;  ///< samples of boundary loops there
};

/// Meshes one tetrahedron; what it reads stays as it is in the meantime.
template <class Scalar>
class CellMesher {
 public:
  CellMesher(const SurfaceInput<Scalar>& input, const VertexSides& sides,
             const CellSurroundings<Scalar>& around, CellProof<Scalar>& proof,
             MeshingState<Scalar>& state, CellMesh<Scalar>& mesh);

  /// Begins with rings around the arcs of the degenerate curve, where all sheets are tubes.
  void begin_with_tubes();
  /// Tries the mesher whose turn it is; whether the patch has the proved topology and no defects.
  bool try_mesher();
  /// After a failure: chooses the next one, and what samples it needs; or gives up.
  void choose_next();

 private:
  bool is_in_chart() const {
    return mesh_.mesher == Mesher::graph || mesh_.mesher == Mesher::manifold ||
           mesh_.mesher == Mesher::dominant;
  }
  bool unfold();
  bool mesh_without_defects(int rounds);
  bool find_defects();
  bool are_defects_few() const;
  bool mend();
  bool make_finer();
  bool mesh_topology(int defect_rounds);
  bool mesh_small_discs();
  bool mesh_graph(int defect_rounds);
  void mesh_cone();
  bool mesh_sheet(const SheetTopology& sheet, const FaceArcVertices& vertices);
  bool mesh_sheets(const FaceArcVertices& vertices);
  bool try_as_graph();
  bool ask_for_manifold();
  const Level<Scalar>& level() const {
    return proof_.level != nullptr ? *proof_.level : input_.level;
  }

  const SurfaceInput<Scalar>& input_;
  const VertexSides& sides_;
  const CellSurroundings<Scalar>& around_;
  CellProof<Scalar>& proof_;
  MeshingState<Scalar>& state_;
  CellMesh<Scalar>& mesh_;
  TetWithCurves<Scalar> tet_;
};

}  // namespace tensortopo
