// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "cut_folds.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "isotropic_tets.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

class Stretches {
 public:
  Stretches(const PieceSurface& piece, const std::vector<char>& in_part)
      : piece_(piece), surface_(piece.surface) {
    for (std::size_t t = 0; t < piece.cells.tets.size(); ++t) {
      if (!in_part[t]) continue;
      const auto& corners = piece.cells.tets[t];
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<Index, 3> face{};
        for (std::size_t k = 0, n = 0; k < 4; ++k)
          if (k != i) face[n++] = corners[k];
        std::sort(face.begin(), face.end());
        if (std::count_if(face.begin(), face.end(), [&](Index v) {
              return is_isotropic(piece.cells.tensors[as_size(v)]);
            }) == 2)
          at_[face].push_back(static_cast<Index>(t));
      }
    }
  }

  bool is_halfway(Index v) const {
    return surface_.carrier[as_size(v)] == Carrier::edge &&
           surface_.medium_eigenvector[as_size(v)] == Vector3<double>{};
  }
  bool is_tip(Index v) const { return surface_.carrier[as_size(v)] == Carrier::vertex; }

  /// Does the part have all of the stretch between two triangles that share a tip and a vertex
  /// halfway?
  bool has_all(std::size_t i, std::size_t j) const {
    const Index first = surface_.tet[i], last = surface_.tet[j];
    auto [head, back, axis] = ends_of(i);
    if (first == last && is_after(head, back) == (ordinal_of(j) > ordinal_of(i))) return true;
    for (Index at = first;;) {
      std::array<Index, 3> face{axis[0], axis[1], head};
      std::sort(face.begin(), face.end());
      const auto beside = at_.find(face);
      if (beside == at_.end()) return false;
      const auto next = std::find_if(beside->second.begin(), beside->second.end(),
                                     [&](Index t) { return t != at; });
      if (next == beside->second.end()) return false;
      at = *next;
      for (const Index v : piece_.cells.tets[as_size(at)])
        if (std::find(face.begin(), face.end(), v) == face.end()) back = v;
      head = back;
      if (at == last) return true;
      if (at == first) return false;
    }
  }

 private:
  struct Ends {
    Index head, back;  ///< of the opposite edge: on the side of larger modes, and the other
    std::array<Index, 2> axis;  ///< the isotropic vertices
  };

  /// Triangles run counter-clockwise seen from larger modes, and tetrahedra are positive.
  Ends ends_of(std::size_t i) const {
    const auto& triangle = surface_.triangles[i];
    std::size_t k = 0;
    while (!(is_tip(triangle[k]) && is_halfway(triangle[(k + 1) % 3])) &&
           !(is_halfway(triangle[k]) && is_tip(triangle[(k + 1) % 3])))
      ++k;
    const bool leaves = is_tip(triangle[k]);
    const Index tip = triangle[leaves ? k : (k + 1) % 3], half = triangle[leaves ? (k + 1) % 3 : k];
    const auto& ends = surface_.carrier_vertices[as_size(half)];
    const Index at = surface_.carrier_vertices[as_size(tip)][0];
    const Index other = ends[0] == at ? ends[1] : ends[0];
    std::array<Index, 4> order{leaves ? at : other, leaves ? other : at, -1, -1};
    const auto& corners = piece_.cells.tets[as_size(surface_.tet[i])];
    std::size_t n = 2;
    for (const Index v : corners)
      if (v != at && v != other) order[n++] = v;
    bool is_even = true;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b)
        if (place(corners, order[a]) > place(corners, order[b])) is_even = !is_even;
    return {order[is_even ? 3 : 2], order[is_even ? 2 : 3], {at, other}};
  }
  static std::ptrdiff_t place(const std::array<Index, 4>& corners, Index v) {
    return std::find(corners.begin(), corners.end(), v) - corners.begin();
  }

  /// In the order of points, in which crossings of an edge are numbered.
  bool is_after(Index v, Index w) const {
    const auto &p = piece_.cells.points[as_size(v)], &q = piece_.cells.points[as_size(w)];
    return std::tie(q.x, q.y, q.z) < std::tie(p.x, p.y, p.z);
  }
  /// Of the crossing that the triangle has.
  std::int32_t ordinal_of(std::size_t i) const {
    for (const Index v : surface_.triangles[i])
      if (!is_tip(v) && !is_halfway(v)) return piece_.ordinals[as_size(v)];
    return 0;
  }

  const PieceSurface& piece_;
  const SurfaceMesh& surface_;
  std::map<std::array<Index, 3>, std::vector<Index>> at_;  ///< by faces with two isotropic vertices
};

}  // namespace

std::set<std::array<std::size_t, 2>> cut_folds(const PieceSurface& piece,
                                               const std::vector<char>& in_part) {
  const Stretches stretches(piece, in_part);
  std::map<std::array<Index, 2>, std::size_t> sides;  // tip and vertex halfway: a triangle
  std::set<std::array<std::size_t, 2>> result;
  for (std::size_t i = 0; i < piece.surface.triangles.size(); ++i)
    for (const Index tip : piece.surface.triangles[i])
      for (const Index half : piece.surface.triangles[i]) {
        if (!stretches.is_tip(tip) || !stretches.is_halfway(half)) continue;
        const auto [known, is_new] = sides.try_emplace({tip, half}, i);
        if (!is_new && !stretches.has_all(known->second, i)) result.insert({known->second, i});
      }
  return result;
}

}  // namespace tensortopo
