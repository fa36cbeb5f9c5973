// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tensortopo/extract/curve_arcs.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The linking number of two closed polygons whose vertices are anywhere in these boxes, the first
/// vertex following the last one: the same for all of them.
/// @return nothing if that is not proved, in any of several projections
std::optional<int> enclosed_linking_number(std::span<const PlaceBox> a,
                                           std::span<const PlaceBox> b);

/// Why a linking number of curves is not proved.
enum class LinkObstacle {
  special_position,  ///< one of the curves is in special position in a tetrahedron
  near_in_a_tet,     ///< arcs of both in one tetrahedron are not proved to be apart
  projection,        ///< polygons on the curves cross too closely in all projections
};

/// The name that reports use.
std::string_view name_of(LinkObstacle obstacle);

/// The linking number of two closed curves, or why it is not proved.
struct CertifiedLink {
  std::optional<int> number;             ///< of the curves, as their lines run
  std::optional<LinkObstacle> obstacle;  ///< if there is no number
};

/// Linking numbers of closed degenerate curves: of the exact curves, not of extracted polygons.
///
/// Each curve is replaced by a polygon with vertices on it: points of faces, and at least one point
/// inside each tetrahedron that it passes. An arc and its chords are in the interior of the arc's
/// tetrahedron but for points on faces, which are vertices; the tetrahedron is convex, so the arc
/// moves straight to the chords inside it. So curves that share no tetrahedron never meet on the
/// way, and the polygons are linked as the curves are. In a tetrahedron that both pass the arcs are
/// cut into parts until convex hulls around the parts of one are proved to be apart from those of
/// the other; parts move within their hulls. The vertices are not rounded but enclosed, and the
/// number is computed for all polygons within the enclosures.
///
/// The linking number does not change where a curve meets itself, so nothing is asked of that.
class CertifiedLinks {
 public:
  /// @param mesh  valid (see `validate`), with tetrahedra that do not overlap; kept by reference
  explicit CertifiedLinks(const TetMesh& mesh) : mesh_(&mesh) {}

  /// Adds a closed curve, and returns its number.
  /// @param arcs   kept by reference
  /// @param lines  of these, each ending where the next one begins, the last one where the first
  /// does
  std::size_t add(const CurveArcs& arcs, std::vector<std::size_t> lines);

  /// The linking number of two curves that were added.
  /// @throws std::invalid_argument for other numbers
  CertifiedLink link(std::size_t a, std::size_t b);

 private:
  struct Curve {
    const CurveArcs* arcs = nullptr;
    std::vector<std::size_t> lines;
    PlaceBox box;  ///< of the tetrahedra
    bool is_enclosed = false, is_special = false;
    std::vector<EnclosedArc> enclosed;                     ///< one for each line
    std::multimap<TetMesh::Index, std::size_t> positions;  ///< of the lines of a tetrahedron
  };

  void enclose(Curve& curve) const;
  bool make_apart(Curve& a, std::size_t i, Curve& b, std::size_t j) const;

  const TetMesh* mesh_;
  std::vector<Curve> curves_;
};

}  // namespace tensortopo
