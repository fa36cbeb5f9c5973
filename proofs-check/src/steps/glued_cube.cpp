// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "steps/glued_cube.hpp"

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

Point antipode(const Point& p, int n) { return {n - p[0], n - p[1], n - p[2]}; }

std::vector<Square> cube_squares(int n) {
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
          squares.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        }
  return squares;
}

std::set<Point> corners(const Square& square) { return {square.begin(), square.end()}; }

/// Connected parts of so many things, joined in pairs.
class Parts {
 public:
  explicit Parts(std::size_t size) : parent_(size) {
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
    Parts parts(faces.size());
    for (const auto& [edge, pair] : sides)
      if (edge.first == vertex.first || edge.second == vertex.first)
        parts.join(pair.front().face, pair.back().face);
    return std::all_of(vertex.second.begin(), vertex.second.end(), [&](std::size_t face) {
      return parts.of(face) == parts.of(vertex.second.front());
    });
  });
}

}  // namespace

GluedSurface glue_antipodes(int n, const std::vector<TopSquare>& removed) {
  std::set<std::set<Point>> holes;
  std::set<Point> rim;
  for (const auto& [x, y] : removed) {
    const Square top{{{x, y, n}, {x + 1, y, n}, {x + 1, y + 1, n}, {x, y + 1, n}}};
    Square bottom = top;
    for (Point& p : bottom) p = antipode(p, n);
    for (const Square& hole : {top, bottom}) {
      holes.insert(corners(hole));
      rim.insert(hole.begin(), hole.end());
    }
  }
  std::vector<Square> faces = cube_squares(n);
  std::erase_if(faces, [&](const Square& s) { return holes.count(corners(s)) > 0; });
  // One of each pair of antipodes on the rim stands for both.
  std::set<Point> vertices;
  for (Square& face : faces)
    for (Point& p : face) {
      if (rim.count(p) > 0) p = std::min(p, antipode(p, n));
      vertices.insert(p);
    }

  const Sides sides = sides_of(faces);
  // A face and its reverse as two sheets: orientable if no face is joined to its reverse.
  Parts faces_joined(faces.size()), sheets(2 * faces.size());
  GluedSurface surface{static_cast<long>(vertices.size()),
                       static_cast<long>(sides.size()),
                       static_cast<long>(faces.size()),
                       true,
                       true,
                       true};
  for (const auto& [edge, pair] : sides) {
    surface.closed = surface.closed && pair.size() == 2;
    const std::size_t first = pair.front().face, second = pair.back().face;
    const std::size_t turned = pair.front().forwards == pair.back().forwards ? 1 : 0;
    faces_joined.join(first, second);
    sheets.join(2 * first, 2 * second + turned);
    sheets.join(2 * first + 1, 2 * second + 1 - turned);
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    surface.connected = surface.connected && faces_joined.of(face) == faces_joined.of(0);
    surface.orientable = surface.orientable && sheets.of(2 * face) != sheets.of(2 * face + 1);
  }
  surface.closed = surface.closed && one_cycle_at_each_vertex(faces, sides);
  return surface;
}

}  // namespace proofs
