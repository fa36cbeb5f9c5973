// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "steps/common/glued_cube.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace proofs {
namespace {

using Point = std::array<int, 3>;
/// In cyclic order.
using Square = std::array<Point, 4>;
using Edge = std::pair<Point, Point>;

Point opposite(const Point& p, int n, int kept) {
  Point result = p;
  for (std::size_t i = static_cast<std::size_t>(kept); i < 3; ++i) result[i] = n - p[i];
  return result;
}

std::vector<Square> cube_squares(int n, const IsLeftOut& left_out) {
  std::vector<Square> squares;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int level : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto point = [&](int u, int v) {
            Point p{};
            p[axis] = level;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            return p;
          };
          if (left_out && left_out(point(i, j), axis)) continue;
          squares.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        }
  return squares;
}

std::set<Point> corners(const Square& square) { return {square.begin(), square.end()}; }

/// Connected parts of so many things, joined in pairs.
class JoinedParts {
 public:
  explicit JoinedParts(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::size_t> parent_;
};

struct Side {
  std::size_t face;
  bool forwards;  ///< from the smaller end to the larger one
};

using Sides = std::map<Edge, std::vector<Side>>;

Sides sides_of(const std::vector<Square>& faces) {
  Sides sides;
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &from = faces[face][i], &to = faces[face][(i + 1) % 4];
      sides[std::minmax(from, to)].push_back({face, from < to});
    }
  return sides;
}

/// Around each vertex the faces are one part, joined across the edges there.
bool one_cycle_at_each_vertex(const std::vector<Square>& faces, const Sides& sides) {
  std::map<Point, std::vector<std::size_t>> around;
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (const Point& p : corners(faces[face])) around[p].push_back(face);
  return std::all_of(around.begin(), around.end(), [&](const auto& vertex) {
    JoinedParts parts(faces.size());
    for (const auto& [edge, pair] : sides)
      if (edge.first == vertex.first || edge.second == vertex.first)
        parts.join(pair.front().face, pair.back().face);
    return std::all_of(vertex.second.begin(), vertex.second.end(), [&](std::size_t face) {
      return parts.of(face) == parts.of(vertex.second.front());
    });
  });
}

/// JoinedParts of the edges in one face.
int count_boundary_loops(const Sides& sides) {
  std::map<Point, std::size_t> number;
  std::vector<std::array<std::size_t, 2>> ends;
  for (const auto& [edge, pair] : sides) {
    if (pair.size() != 1) continue;
    const std::size_t first = number.try_emplace(edge.first, number.size()).first->second;
    const std::size_t second = number.try_emplace(edge.second, number.size()).first->second;
    ends.push_back({first, second});
  }
  JoinedParts parts(number.size());
  for (const auto& [first, second] : ends) parts.join(first, second);
  int loops = 0;
  for (std::size_t i = 0; i < number.size(); ++i) loops += parts.of(i) == i ? 1 : 0;
  return loops;
}

}  // namespace

GluedSurface glue_opposites(int n, const std::vector<TopSquare>& removed, int kept,
                            const IsLeftOut& left_out) {
  std::set<std::set<Point>> holes;
  std::set<Point> rim;
  for (const auto& [x, y] : removed) {
    const Square top{{{x, y, n}, {x + 1, y, n}, {x + 1, y + 1, n}, {x, y + 1, n}}};
    Square bottom = top;
    for (Point& p : bottom) p = opposite(p, n, kept);
    for (const Square& hole : {top, bottom}) {
      holes.insert(corners(hole));
      rim.insert(hole.begin(), hole.end());
    }
  }
  std::vector<Square> faces = cube_squares(n, left_out);
  std::erase_if(faces, [&](const Square& s) { return holes.count(corners(s)) > 0; });
  // One of each pair of opposites on the rim stands for both.
  std::set<Point> vertices;
  for (Square& face : faces)
    for (Point& p : face) {
      if (rim.count(p) > 0) p = std::min(p, opposite(p, n, kept));
      vertices.insert(p);
    }

  const Sides sides = sides_of(faces);
  // A face and its reverse as two sheets: orientable if no face is joined to its reverse.
  JoinedParts faces_joined(faces.size()), sheets(2 * faces.size());
  GluedSurface surface{.vertices = static_cast<long>(vertices.size()),
                       .edges = static_cast<long>(sides.size()),
                       .faces = static_cast<long>(faces.size()),
                       .is_manifold = true,
                       .orientable = true};
  for (const auto& [edge, pair] : sides) {
    surface.is_manifold = surface.is_manifold && pair.size() <= 2;
    if (pair.size() == 1) {
      ++surface.boundary_edges;
      continue;
    }
    const std::size_t first = pair.front().face, second = pair.back().face;
    const std::size_t turned = pair.front().forwards == pair.back().forwards ? 1 : 0;
    faces_joined.join(first, second);
    sheets.join(2 * first, 2 * second + turned);
    sheets.join(2 * first + 1, 2 * second + 1 - turned);
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    surface.components += faces_joined.of(face) == face ? 1 : 0;
    surface.orientable = surface.orientable && sheets.of(2 * face) != sheets.of(2 * face + 1);
  }
  surface.is_manifold = surface.is_manifold && one_cycle_at_each_vertex(faces, sides);
  surface.boundary_loops = count_boundary_loops(sides);
  return surface;
}

}  // namespace proofs
