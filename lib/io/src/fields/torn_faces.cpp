// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "fields/torn_faces.hpp"

#include <algorithm>
#include <array>

#include "grids/cell_kind.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/unmatched_faces.hpp"

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Triangle = std::array<Index, 3>;
using Pairs = std::vector<std::array<std::size_t, 2>>;

Triangle ascending(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Looks outer faces up by their vertices.
class OuterFaces {
 public:
  OuterFaces(const TetMesh& mesh, std::span<const OuterFace> outer)
      : outer_(outer), has_vertex_(mesh.points.size(), 0) {
    for (const OuterFace& face : outer)
      for (const Index v : face.vertices) has_vertex_[as_size(v)] = 1;
  }

  bool has_all(const std::array<Index, 4>& vertices) const {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Index v) { return has_vertex_[as_size(v)] != 0; });
  }

  /// Their number if there is no such face.
  std::size_t find(const Triangle& vertices) const {
    const Triangle sought = ascending(vertices);
    const auto found = std::lower_bound(
        outer_.begin(), outer_.end(), sought,
        [](const OuterFace& face, const Triangle& t) { return ascending(face.vertices) < t; });
    return found == outer_.end() || ascending(found->vertices) != sought
               ? outer_.size()
               : static_cast<std::size_t>(found - outer_.begin());
  }

 private:
  std::span<const OuterFace> outer_;
  std::vector<char> has_vertex_;
};

/// Adds what lies on each other in the quadrilaterals of split cells.
void add_crossed_diagonals(const RawGrid& grid, const std::vector<Index>& vertices,
                           const OuterFaces& faces, std::size_t none, Pairs& pairs) {
  std::vector<Index> corners;
  for (std::size_t c = 0; c < grid.cells(); ++c) {
    const CellKind kind = cell_kind(grid.types[c]);
    if (kind.use != CellKind::Use::split) continue;
    corners.clear();
    for (std::int64_t i = grid.offsets[c]; i < grid.offsets[c + 1]; ++i)
      corners.push_back(vertices[as_size(grid.connectivity[as_size(i)])]);
    if (corners.size() != kind.corners) continue;  // of a ghost
    for (const auto& q : quadrilaterals(grid.types[c], corners)) {
      if (!faces.has_all(q)) continue;
      const std::array<std::size_t, 2> one{faces.find({q[0], q[1], q[2]}),
                                           faces.find({q[0], q[2], q[3]})},
          other{faces.find({q[0], q[1], q[3]}), faces.find({q[1], q[2], q[3]})};
      if (std::max({one[0], one[1], other[0], other[1]}) == none) continue;
      for (const auto i : one)
        for (const auto j : other) pairs.push_back({std::min(i, j), std::max(i, j)});
    }
  }
}

}  // namespace

TornFaces torn_faces(const std::vector<RawGrid>& pieces, const VertexMap& map, const TetMesh& mesh,
                     std::span<const OuterFace> outer) {
  Pairs pairs = unmatched_faces(mesh, outer);
  const OuterFaces faces(mesh, outer);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    add_crossed_diagonals(pieces[k], map[k], faces, outer.size(), pairs);
  return tensortopo::torn_faces(pairs, mesh, outer);
}

}  // namespace tensortopo::detail
