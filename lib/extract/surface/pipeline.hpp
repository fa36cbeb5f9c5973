// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "extract/level/critical/nearby_levels.hpp"
#include "extract/patch/charts/manifold_mesher.hpp"
#include "extract/topology/cell_topology.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/prepared_field.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// The stages of one extraction, in order. Each writes what the next reads; all of them run over
/// items in parallel and keep their results in the order of the items.
template <class Scalar>
class Pipeline {
 public:
  /// @param last_use the field again if nobody reads it afterwards
  Pipeline(const PreparedField<Scalar>& prepared, const ModeValue& mu,
           const ExtractOptions& options, PreparedField<Scalar>* last_use = nullptr);

  Extraction run();

 private:
  using Index = TetMesh::Index;

  /// How the sheets of a tetrahedron are meshed; tried in this order.
  enum class Method {
    tubes,
    small_disc,
    graph,
    manifold,
    dominant,
    subdivision,
    fan,
    boundaries,
    cone
  };

  /// What becomes of one tetrahedron of the complex.
  struct TetState {
    std::unique_ptr<CellTopology<Scalar>> proved;  ///< until it is meshed, see `release_proofs`
    const Level<Scalar>* level =
        nullptr;  ///< of its proved topology and meshing, if not the extraction's
    Method method = Method::small_disc;
    int attempts = 0;  ///< in charts
    /// Whose turn it was when the sheets were tried as graphs, if they were for want of another
    /// way.
    std::optional<Method> before_graph;
    int sheets = 0;                               ///< how many the proved topology had
    bool refined = false;                         ///< the proved topology was
    std::unique_ptr<TetManifold> manifold;        ///< if meshed there
    std::vector<SampleRequest<Scalar>> requests;  ///< samples that the method wants on the faces
    Patch<Scalar> patch;
    UnresolvedReason obstacle{};  ///< why its boundary loops are the last resort
    std::optional<UnresolvedReason> unresolved;
  };

  /// Of a vertex of the mesh.
  enum class OnLevel : char { no, meshed_through, kept_off };

  bool keeps_off(const std::array<Index, 2>& edge) const;
  void classify_vertices();
  void screen();
  bool may_be_crossed_from_zero(const std::array<Index, 4>& tet) const;
  void find_crossings();
  void find_crossings_of(std::size_t e);
  void trace_faces();
  void trace_face(std::size_t f, const SimplexProof<Scalar, 3>* proof);
  void trace_nearby(std::size_t f);
  void prove_cells();
  bool vanishes_inside(const std::array<Index, 3>& face) const;
  UnresolvedReason unproved(std::size_t t) const;
  bool prove_one(std::size_t t, const SimplexProof<Scalar, 4>* proof);
  bool prove_cone(std::size_t t);
  void try_next_method(std::size_t t);
  void reserve_boundary_vertices();
  void number_edge_vertices();
  void number_zero_vertices();
  void number_face_vertices(std::span<const std::size_t> changed);
  std::vector<std::size_t> merge_requests(std::span<const std::size_t> asking);
  void mesh_cells();
  void release_proofs();
  void coarsen_face_curves();
  bool move_from_vertices();
  bool mesh_cell(std::size_t t);
  bool mesh_cell_as_graph(std::size_t t, const TetWithCurves<Scalar>& tet);
  bool mesh_small_discs(std::size_t t, const TetWithCurves<Scalar>& tet);
  std::size_t small_loop(std::size_t t, const TetWithCurves<Scalar>& tet,
                         std::span<const BoundaryArc> loop,
                         std::span<BoundaryVertex> boundary) const;
  BoundaryVertex crossing_vertex(std::size_t t, const TetWithCurves<Scalar>& tet, std::size_t face,
                                 const ArcEnd& end) const;
  BoundaryVertex boundary_vertex(Index id, unsigned faces) const {
    const auto v = static_cast<std::size_t>(id);
    return {id, static_cast<std::uint8_t>(faces), boundary_position_[v], boundary_medium_[v],
            boundary_dominant_[v]};
  }
  void mesh_cone(std::size_t t);
  std::vector<Index> sectors(std::size_t triangles) const;
  void add_cone_points(SurfaceMesh& surface, std::vector<char>& is_apex);
  /// What fans of triangles around crossings of edges have for vertices, if a crossing has several.
  struct CrossingCopies {
    std::vector<Index> original;  ///< of each copy
    /// Of a vertex in a tetrahedron of another fan than the first: which copy it has.
    std::map<std::pair<std::size_t, Index>, std::size_t> of;
  };
  CrossingCopies crossing_copies() const;
  LevelTopology topology(std::span<const Index> new_id) const;
  Extraction assemble();
  void count_sheets();
  void release_stages();
  void describe_vertices(SurfaceMesh& surface, const std::vector<char>& is_apex) const;

  /// Whether vertices are on one side of the level, and one of them farther from it, by the angle
  /// between tensors, than from all others: then so is the simplex.
  template <std::size_t Count>
  bool is_clear(const std::array<Index, Count>& vertices) const {
    auto clear = static_cast<std::size_t>(vertices[0]);
    const char side = above_[clear];
    for (const Index w : vertices) {
      const auto v = static_cast<std::size_t>(w);
      if (above_[v] != side) return false;
      if (clearance_[v] < clearance_[clear]) clear = v;
    }
    const double limit = clearance_[clear] * prepared_.norms[clear];
    for (const Index w : vertices) {
      const auto v = static_cast<std::size_t>(w);
      if (v != clear && !(norm_form(prepared_.tensors()[clear], prepared_.tensors()[v]) >
                          limit * prepared_.norms[v]))
        return false;
    }
    return true;
  }

  /// Whether the level passes between the vertices, none of which is isotropic.
  template <std::size_t Count>
  bool is_crossed(const std::array<Index, Count>& vertices) const {
    bool crossed = false;
    for (const Index w : vertices) {
      const auto v = static_cast<std::size_t>(w);
      if (field_.is_zero[v]) return false;
      crossed |= above_[v] != above_[static_cast<std::size_t>(vertices[0])];
    }
    return crossed;
  }

  /// The corners of a tetrahedron isotropic, as bits.
  unsigned zero_corners(const std::array<Index, 4>& tet) const {
    unsigned corners = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (field_.is_zero[static_cast<std::size_t>(tet[i])]) corners |= 1u << i;
    return corners;
  }
  const std::array<Index, 4>& vertices_of(std::size_t t) const {
    return mesh_.tets[static_cast<std::size_t>(complex_.tets[t])];
  }
  const Level<Scalar>& level_of(std::size_t t) const {
    return tets_[t].level != nullptr ? *tets_[t].level : level_;
  }
  /// The vertex tensors as given.
  template <std::size_t Count>
  std::array<SymmetricTensor<double>, Count> tensors_of(
      const std::array<Index, Count>& vertices) const {
    std::array<SymmetricTensor<double>, Count> tensors;
    for (std::size_t i = 0; i < Count; ++i)
      tensors[i] = mesh_.tensors[static_cast<std::size_t>(vertices[i])];
    return tensors;
  }
  TetWithCurves<Scalar> tet_with_curves(std::size_t t) const;
  FaceArcVertices arc_vertices(std::size_t t, const TetWithCurves<Scalar>& tet) const;
  LevelSimplex<Scalar, 3> face_simplex(std::size_t f) const;
  Sampling sampling_in(std::size_t t) const;
  Sampling sampling_on(std::size_t f) const;

  const TetMesh& mesh_;
  const ExtractOptions& options_;
  Level<Scalar> level_;
  NearbyLevels<Scalar> nearby_levels_;
  const PreparedField<Scalar>& prepared_;
  PreparedField<Scalar>* last_use_;
  const ScaledField<Scalar>& field_;
  ExtractStatistics statistics_;

  std::vector<char> above_;        ///< a mesh vertex: mode > mu
  std::vector<double> clearance_;  ///< of a mesh vertex: `screen::clearance_cosine`
  std::vector<OnLevel> on_level_;
  TetComplex complex_;

  std::vector<std::optional<std::vector<EdgeCrossing<Scalar>>>> crossings_;  ///< of each edge
  std::vector<char> edge_moved_;    ///< crossings are those of a nearby level
  std::vector<Index> edge_vertex_;  ///< first vertex of each edge
  std::vector<Index> zero_vertex_;  ///< of each mesh vertex: its vertex if it has no deviator

  std::vector<std::optional<std::vector<FaceArc<Scalar>>>> arcs_;  ///< of each face
  std::vector<char> face_moved_;    ///< arcs are those of a nearby level
  std::vector<Index> face_vertex_;  ///< first vertex of each face; anew when its samples change

  std::vector<TetState> tets_;
  std::vector<Vector3<double>> boundary_position_, boundary_medium_,
      boundary_dominant_;  ///< of edges and faces
};

}  // namespace tensortopo
