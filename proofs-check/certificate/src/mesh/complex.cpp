// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/complex.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "mesh/exact_signs.hpp"
#include "run/parallel.hpp"

namespace certificate {
namespace {

/// A face as one of its tetrahedra has it, but for its first point.
struct TetFace {
  std::uint32_t b, c;
  int side;  ///< of the face, on which the tetrahedron is: 1 or -1

  bool is_same_as(const TetFace& other) const { return b == other.b && c == other.c; }
};

template <class... Points>
std::string of_points(std::size_t last, const Points&... points) {
  std::string result = " of points";
  ((result += " " + std::to_string(points) + ","), ...);
  result.pop_back();
  return result + " and " + std::to_string(last);
}

}  // namespace

std::optional<std::string> defect_of(const std::vector<std::array<std::uint32_t, 4>>& tets,
                                     const std::vector<std::array<double, 3>>& points) {
  // Of a tetrahedron with ascending points a, b, c, d the side of face abc, on which d is. The other
  // faces follow, as each exchange of points next to each other exchanges the sides.
  std::vector<int> sides(tets.size());
  parallel_for<256>(tets.size(), [&](std::size_t t) {
    const auto& [a, b, c, d] = tets[t];
    sides[t] = side_of(points[a], points[b], points[c], points[d]);
  });
  if (const auto flat = std::find(sides.begin(), sides.end(), 0); flat != sides.end()) {
    const auto& [a, b, c, d] = tets[static_cast<std::size_t>(flat - sides.begin())];
    return "the tetrahedron" + of_points(d, a, b, c) + " is flat";
  }

  // Faces by their first point, as rows: three of a tetrahedron have its first one, one its second.
  std::vector<std::size_t> first(points.size() + 1, 0);
  for (const auto& tet : tets) first[tet[0] + 1] += 3, ++first[tet[1] + 1];
  for (std::size_t p = 0; p < points.size(); ++p) first[p + 1] += first[p];
  std::vector<TetFace> faces(4 * tets.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& [a, b, c, d] = tets[t];
    const int side = sides[t];
    for (const TetFace& face : {TetFace{b, c, side}, TetFace{b, d, -side}, TetFace{c, d, side}})
      faces[next[a]++] = face;
    faces[next[b]++] = {c, d, -side};
  }
  // Of each point, the first face with more than two tetrahedra or two on one side.
  std::vector<std::size_t> found(points.size(), faces.size());
  parallel_for<256>(points.size(), [&](std::size_t p) {
    const auto begin = faces.begin() + static_cast<std::ptrdiff_t>(first[p]),
               end = faces.begin() + static_cast<std::ptrdiff_t>(first[p + 1]);
    std::sort(begin, end, [](const TetFace& x, const TetFace& y) {
      return std::tie(x.b, x.c, x.side) < std::tie(y.b, y.c, y.side);
    });
    // Of three or more with one face, two next to each other are on one side.
    const auto at = std::adjacent_find(begin, end, [](const TetFace& x, const TetFace& y) {
      return x.is_same_as(y) && x.side == y.side;
    });
    if (at != end) found[p] = static_cast<std::size_t>(at - faces.begin());
  });
  const auto of =
      std::find_if(found.begin(), found.end(), [&](std::size_t f) { return f < faces.size(); });
  if (of == found.end()) return std::nullopt;
  const TetFace& face = faces[*of];
  const auto p = static_cast<std::size_t>(of - found.begin());
  const auto count = std::count_if(faces.begin() + static_cast<std::ptrdiff_t>(first[p]),
                                   faces.begin() + static_cast<std::ptrdiff_t>(first[p + 1]),
                                   [&](const TetFace& other) { return face.is_same_as(other); });
  return (count > 2 ? "more than two tetrahedra share the face"
                    : "two tetrahedra are on the same side of the face") +
         of_points(face.c, p, face.b);
}

std::size_t count_doubled(const std::vector<std::array<std::uint32_t, 4>>& tets,
                          const std::vector<std::array<double, 3>>& points) {
  std::vector<char> is_used(points.size(), 0);
  for (const auto& tet : tets)
    for (const auto p : tet) is_used[p] = 1;
  std::vector<std::uint32_t> used;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (is_used[p] != 0) used.push_back(static_cast<std::uint32_t>(p));
  std::sort(used.begin(), used.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::size_t count = 0;
  for (std::size_t i = 1; i < used.size(); ++i) count += points[used[i]] == points[used[i - 1]];
  return count;
}

}  // namespace certificate
