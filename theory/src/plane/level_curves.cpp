// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/level_curves.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "plane/real_zeros.hpp"

namespace tensortopo::theory {
namespace {

std::array<std::size_t, 2> ascending(std::size_t a, std::size_t b) {
  return {std::min(a, b), std::max(a, b)};
}

Integer sum(const Vector3<Integer>& v) { return v.x + v.y + v.z; }

// Sets of consecutive numbers that are joined one by one.
class Sets {
 public:
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.back();
  }
  std::size_t root(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::optional<LevelCurves> LevelCurves::trace(const Plane& plane, const Rational& mode_squared,
                                              std::size_t most_cells) {
  LevelCurves curves(plane, Level(mode_squared));
  const Integer zero(0), one(1);
  const bool resolved = curves.add_corner({one, zero, zero}) &&
                        curves.add_corner({zero, one, zero}) &&
                        curves.add_corner({zero, zero, one}) && curves.refine(most_cells);
  if (!resolved) return std::nullopt;
  curves.connect();
  return curves;
}

// False if it lies on the level.
bool LevelCurves::add_corner(const Vector3<Integer>& weights) {
  const IntegerTensor tensor = combined(plane_.basis, weights);
  const Sign side = level_.at(tensor);
  if (side == Sign::zero) return false;
  corners_.push_back({weights, tensor, side});
  return true;
}

// The corner that cuts an edge near its middle: not always in it, for curves of symmetric fields
// like to touch lines of symmetric places.
std::size_t LevelCurves::cut(const Edge& edge) {
  const auto known = cuts_.find(edge);
  if (known != cuts_.end()) return known->second;
  const Vector3<Integer> a = corners_[edge[0]].weights, b = corners_[edge[1]].weights;
  while (true) {
    const Integer to_a(random_.integer(7, 9)), to_b(random_.integer(7, 9));
    const Vector3<Integer> m = to_a * sum(b) * a + to_b * sum(a) * b;
    const Integer common = gcd(gcd(m.x, m.y), m.z);
    if (add_corner({m.x / common, m.y / common, m.z / common})) break;
  }
  return cuts_[edge] = corners_.size() - 1;
}

bool LevelCurves::refine(std::size_t most_cells) {
  const std::array<IntegerTensor, 2> directions = {plane_.basis[1] - plane_.basis[0],
                                                   plane_.basis[2] - plane_.basis[0]};
  cells_.push_back({{0, 1, 2}});
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_.size() > most_cells) return false;
    const auto [a, b, c] = cells_[i].corner;
    cells_[i].kind = kind_of_cell({corners_[a].tensor, corners_[b].tensor, corners_[c].tensor},
                                  directions, level_);
    if (cells_[i].kind != CellKind::unclear) continue;
    const std::size_t m = cut(ascending(a, b));
    cells_[i].child = cells_.size();
    cells_.push_back({{a, c, m}});
    cells_.push_back({{c, b, m}});
  }
  return true;
}

// The smallest edge in which the one crossing between two corners lies.
LevelCurves::Edge LevelCurves::crossed_part(std::size_t a, std::size_t b) const {
  for (auto cut = cuts_.find(ascending(a, b)); cut != cuts_.end();
       cut = cuts_.find(ascending(a, b))) {
    (corners_[cut->second].side == corners_[a].side ? a : b) = cut->second;
  }
  return ascending(a, b);
}

void LevelCurves::connect() {
  Sets sets;
  std::map<Edge, std::size_t> number;
  std::vector<int> uses;  // by cells: once means that it is on the triangle's boundary
  const auto use = [&](const Edge& edge) {
    const auto [place, is_new] = number.try_emplace(edge, uses.size());
    if (is_new) sets.add(), uses.push_back(0);
    ++uses[place->second];
    return place->second;
  };
  for (const Cell& cell : cells_) {
    if (cell.kind != CellKind::simple) continue;
    std::vector<std::size_t> crossed;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = cell.corner[i], b = cell.corner[(i + 1) % 3];
      if (corners_[a].side != corners_[b].side) crossed.push_back(use(crossed_part(a, b)));
    }
    if (!crossed.empty()) sets.join(crossed[0], crossed[1]);
  }
  std::map<std::size_t, std::vector<Edge>> components;
  for (const auto& [edge, i] : number) components[sets.root(i)].push_back(edge);
  for (const auto& [root, edges] : components) {
    const bool is_open = std::any_of(edges.begin(), edges.end(),
                                     [&](const Edge& edge) { return uses[number[edge]] == 1; });
    if (is_open) {
      ++open_;
    } else {
      surround(edges);
    }
  }
}

// Appends a closed curve: corners on either side of it are told apart by the number of crossings on
// the way from a corner of the triangle.
void LevelCurves::surround(const std::vector<Edge>& crossed) {
  std::vector<std::vector<std::size_t>> neighbours(corners_.size());
  for (const Cell& cell : cells_) {
    if (cell.child != 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      // A side that is cut on the other side of it is a path of smaller edges.
      std::vector<Edge> parts{{cell.corner[i], cell.corner[(i + 1) % 3]}};
      while (!parts.empty()) {
        const auto [a, b] = parts.back();
        parts.pop_back();
        const auto cut = cuts_.find(ascending(a, b));
        if (cut == cuts_.end()) {
          neighbours[a].push_back(b), neighbours[b].push_back(a);
        } else {
          parts.push_back({a, cut->second}), parts.push_back({cut->second, b});
        }
      }
    }
  }
  Closed curve{Sign::zero, std::vector<bool>(corners_.size())};
  std::vector<bool> reached(corners_.size());
  std::vector<std::size_t> open{0};
  reached[0] = true;
  while (!open.empty()) {
    const std::size_t a = open.back();
    open.pop_back();
    for (const std::size_t b : neighbours[a]) {
      if (reached[b]) continue;
      const bool crosses = std::binary_search(crossed.begin(), crossed.end(), ascending(a, b));
      curve.inside[b] = curve.inside[a] != crosses;
      reached[b] = true;
      open.push_back(b);
    }
  }
  // Between the curve and the end where |mode| is larger the mode keeps its sign.
  const Edge& edge = crossed.front();
  const Corner& high = corners_[corners_[edge[0]].side == Sign::positive ? edge[0] : edge[1]];
  curve.mode = static_cast<Sign>(determinant(high.tensor).sign());
  closed_.push_back(std::move(curve));
}

int LevelCurves::closed_count(Sign mode) const {
  return static_cast<int>(std::count_if(closed_.begin(), closed_.end(),
                                        [&](const Closed& c) { return c.mode == mode; }));
}

std::vector<std::optional<std::size_t>> LevelCurves::cells_of(const PointFamily& family) const {
  const RealZeros zeros(family.parameters);
  const auto x = zeros.signs(family.weights.x), y = zeros.signs(family.weights.y),
             z = zeros.signs(family.weights.z);
  std::vector<std::optional<std::size_t>> result;
  for (std::size_t i = 0; i < zeros.count(); ++i) {
    const auto among = [&](Sign s) { return x[i] == s || y[i] == s || z[i] == s; };
    result.emplace_back();
    if (among(Sign::positive) && among(Sign::negative)) continue;
    const Sign positive = among(Sign::negative) ? Sign::negative : Sign::positive;
    std::size_t cell = 0;
    while (cells_[cell].child != 0) {
      const auto [a, b, c] = cells_[cell].corner;
      const std::size_t m = cuts_.at(ascending(a, b));
      const Vector3<Integer> line = cross(corners_[c].weights, corners_[m].weights);
      const Polynomial side = Polynomial(line.x) * family.weights.x +
                              Polynomial(line.y) * family.weights.y +
                              Polynomial(line.z) * family.weights.z;
      const auto side_of_a = static_cast<Sign>(dot(line, corners_[a].weights).sign());
      const bool with_a = zeros.sign(side, i) * positive == side_of_a;
      cell = cells_[cell].child + (with_a ? 0 : 1);
    }
    result.back() = cell;
  }
  return result;
}

}  // namespace tensortopo::theory
