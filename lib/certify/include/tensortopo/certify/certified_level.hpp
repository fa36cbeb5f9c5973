// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/quadric/extract_invariant_surface.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo {

/// A dyadic interval [place / 2^depth, (place + 1) / 2^depth] of barycentric coordinates on an
/// edge, from its first vertex to its second.
struct DyadicBracket {
  std::uint64_t place = 0;  ///< below 2^depth
  int depth = 0;  ///< how often the edge is halved
};

/// A connected component of a surface, as claimed.
struct ComponentClaim {
  std::int64_t euler_characteristic = 0;  ///< vertices - edges + triangles
  std::size_t boundary_loops = 0;  ///< closed curves that bound it
  bool orientable = true;  ///< triangles can be turned to agree
  std::size_t triangles = 0;  ///< how many it has
  SurfaceMesh::Index first_vertex = -1;  ///< the smallest
};

/// How far the triangles are from the level, both ways.
struct DistanceClaim {
  /// For each vertex of the surface the length (4 + n mod 4) 2^floor(n/4) by which it, moved along
  /// the gradient of the mode, or other invariant, in the edge, face or tetrahedron that holds it,
  /// comes to the other side of the level, and with it the triangles around. See `reach_length`.
  std::vector<int> reach;
  double bound = 0;  ///< a bound on both distances where `reach` proves one
  /// Tetrahedra (positions in the mesh) where it does not, ascending: there the distances are
  /// below `coarse_bounds`.
  std::vector<TetMesh::Index> coarse;
  std::vector<double> coarse_bounds;  ///< of each, no more than about its longest edge
  double coarse_bound = 0;            ///< the largest of these, which is what is claimed of all
};

/// A tetrahedron about which nothing is claimed.
struct UndecidedCell {
  TetMesh::Index tet = -1;  ///< position in the mesh
  std::string reason;  ///< the name that reports use
};

/// The tetrahedra of a list, in its order.
std::vector<TetMesh::Index> tets_of(const std::vector<UndecidedCell>& cells);

/// Everything that a certificate claims about the surface of one level: see proofs-check's
/// description of the file for what each claim means.
struct CertifiedLevel {
  std::variant<ModeValue, InvariantLevel> value;  ///< the mode, or the value of another invariant
  /// Numbers of the surface.
  std::size_t vertices = 0, triangles = 0;
  std::size_t on_level = 0;                 ///< vertices of the mesh with exactly this value
  std::vector<UndecidedCell> undecided;     ///< ascending
  LevelTopology topology;                   ///< of all other tetrahedra
  /// An interval around each crossing, in the order of `topology.edges` and their crossings, with
  /// different sides of the level at its ends.
  std::vector<std::vector<DyadicBracket>> brackets;
  std::vector<ComponentClaim> components;   ///< by first vertex
  DistanceClaim distance;  ///< between triangles and level
  std::optional<StabilityClaim> stability;  ///< of an uncertain field
  bool embedded = false;  ///< see `is_embedded`; false if that is not claimed
  /// Tetrahedra with triangles in which these are not claimed to be isotopic to the level,
  /// ascending; they are in all others that are not undecided. Nothing: that is claimed of none.
  std::optional<std::vector<TetMesh::Index>> not_isotopic;
  /// Of a surface put together from pieces: the ids of vertices and tetrahedra of the mesh, in the
  /// whole mesh, ascending; the file then names these. Empty: it has the numbers of the vertices,
  /// and the mesh's own `cell_ids`.
  std::vector<std::int64_t> vertex_ids, cell_ids;

  /// The edges, as indices into those of `topology`, that `stability` claims to be crossed alike in
  /// all fields; ascending.
  std::vector<std::size_t> claimed_crossings() const;

  /// Entities claimed: crossed edges, faces and tetrahedra, components, distance, stable components,
  /// that edges are crossed alike.
  std::size_t claims() const {
    return topology.edges.size() + topology.faces.size() + topology.tets.size() +
           topology.cones.size() + components.size() + 1 + (embedded ? 1 : 0) + (not_isotopic ? 1 : 0) +
           (stability ? stability->components.size() : 0) +
           (claimed_crossings().empty() ? 0 : 1);
  }
};

/// The claims that an extraction supports. Its topology is that of the extraction's own proofs;
/// crossings get brackets whose ends are decided exactly, distances a proof in double with error
/// bounds. Only the tetrahedra that the extraction names are looked at.
/// @param extraction  made of `mesh` with `ExtractOptions::keep_topology`; its topology is moved
///                    out
/// @throws std::invalid_argument if a surface has no topology: it was not kept, or moved out before
CertifiedLevel certify(const TetMesh& mesh, const ModeValue& mode, Extraction& extraction);

/// The same with the field that the extraction was made from, in place of one made anew.
/// @param wanted  a distance, in the mesh's units: where moved triangles do not prove it
///                (`DistanceClaim::coarse`), parts of the tetrahedron may. 0: there the bound is
///                the longest edge
CertifiedLevel certify(const PreparedField<double>& field, const ModeValue& mode,
                       Extraction& extraction, double wanted = 0);

/// The claims that the extraction of an invariant's surface supports: its triangles' topology in
/// each tetrahedron is proved, so they are read off these. Undecided besides the tetrahedra with a
/// zero tensor are those in which the level has a critical point, exactly
/// (`critical_value_on_edge`, `_on_face`, `_in_cell`): there the surface is that of all levels just
/// above, which no checker that looks at this one can tell.
CertifiedLevel certify(const TetMesh& mesh, const InvariantLevel& level,
                       const InvariantExtraction& extraction);

/// The length that a reach of n stands for.
double reach_length(int n);

/// The smallest n whose length is at least `length` > 0.
int reach_of(double length);

}  // namespace tensortopo
