// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "monotone_cell.hpp"

#include <algorithm>
#include <set>

#include "regions.hpp"

namespace certificate {
namespace {

using Id = Refinement::Id;
using Weights = std::array<mpz_class, 4>;

mpz_class determinant(const std::array<const Weights*, 4>& rows) {
  const auto minor = [&](std::size_t r, std::size_t s, std::size_t i, std::size_t j) {
    return mpz_class((*rows[r])[i] * (*rows[s])[j] - (*rows[r])[j] * (*rows[s])[i]);
  };
  return minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 1, 0, 2) * minor(2, 3, 1, 3) +
         minor(0, 1, 0, 3) * minor(2, 3, 1, 2) + minor(0, 1, 1, 2) * minor(2, 3, 0, 3) -
         minor(0, 1, 1, 3) * minor(2, 3, 0, 2) + minor(0, 1, 2, 3) * minor(2, 3, 0, 1);
}

/// The refined boundary of a cell, with the regions into which the level cuts it.
class Boundary {
 public:
  Boundary(const Level& level, const Refinement& refinement, const std::array<Id, 4>& corners,
           const std::array<const FaceLevel*, 4>& levels)
      : levels_(levels) {
    for (std::size_t f = 0; f < 4; ++f) {
      faces_[f] = levels[f]->refinement;
      if (faces_[f]) continue;  // it has been cut already
      const auto [i, j, k] = without(f);
      const auto face = std::make_shared<Refinement>(
          level, refinement.corners_at(std::array{corners[i], corners[j], corners[k]}));
      is_refined_ = is_refined_ && face->run();
      faces_[f] = face;
    }
  }

  /// Joins what lies in one region. False if a face takes too many parts.
  bool find_regions();
  /// Adds to each component of one side what lies under it.
  bool join_along(const Weights& direction);
  /// The components beside a curve.
  std::array<std::size_t, 2> beside(const RimCurve& curve);

 private:
  std::size_t segment(unsigned edge, std::size_t n) const { return segments_.at(edge) + n; }
  /// A point's weights at the corners of the cell.
  Weights weights(std::size_t f, const Refinement::Point& point) const {
    Weights result;
    const auto face = without(f);
    for (std::size_t i = 0; i < 3; ++i) result[face[i]] = point.weights[i];
    return result;
  }

  const std::array<const FaceLevel*, 4>& levels_;
  std::array<std::shared_ptr<const Refinement>, 4> faces_;
  bool is_refined_ = true;
  std::vector<FaceRegions> regions_;
  std::array<std::size_t, 4> first_{};            ///< node of each face's first point
  std::map<unsigned, std::size_t> segments_;      ///< node of each edge's first segment
  std::optional<UnionFind> nodes_;
};

bool Boundary::find_regions() {
  if (!is_refined_) return false;
  std::size_t count = 0;
  std::vector<RootEdges> edges;
  for (std::size_t f = 0; f < 4; ++f) {
    regions_.emplace_back(*faces_[f]);
    edges.emplace_back(*faces_[f]);
    first_[f] = count;
    count += faces_[f]->points().size();
    for (const unsigned edge : {3U, 5U, 6U})
      if (segments_.emplace(in_cell(edge, f), count).second) count += edges[f].count(edge) + 1;
  }
  nodes_.emplace(count);
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& points = faces_[f]->points();
    for (Id p = 0; p < points.size(); ++p)
      nodes_->join(first_[f] + p, first_[f] + regions_[f].find(p));
    for (const unsigned edge : {3U, 5U, 6U}) {
      std::size_t n = 0;
      bool above = points[edges[f].along(edge)[0]].above;
      for (const Id p : edges[f].along(edge)) {
        if (points[p].above != above) above = !above, ++n;
        nodes_->join(first_[f] + p, segment(in_cell(edge, f), n));
      }
    }
  }
  return true;
}

bool Boundary::join_along(const Weights& direction) {
  // Where a component's points are told apart: does one lie where all come out?
  std::set<std::size_t> arrived;
  const auto each_point = [&](const auto& f) {
    for (std::size_t face = 0; face < 4; ++face)
      for (Id p = 0; p < faces_[face]->points().size(); ++p)
        f(face, faces_[face]->points()[p], first_[face] + p);
  };
  each_point([&](std::size_t face, const Refinement::Point& point, std::size_t node) {
    const Weights w = weights(face, point);
    for (std::size_t i = 0; i < 4; ++i)
      if (w[i] == 0 && (point.above ? direction[i] <= 0 : direction[i] >= 0))
        arrived.insert(nodes_->find(node));
  });
  std::vector<std::array<std::size_t, 2>> joins;
  bool found = true;
  each_point([&](std::size_t face, const Refinement::Point& point, std::size_t node) {
    if (!arrived.insert(nodes_->find(node)).second) return;
    const Weights w = weights(face, point);
    const auto speed = [&](std::size_t i) {
      return point.above ? mpz_class(-direction[i]) : direction[i];
    };
    std::size_t out = 4;
    for (std::size_t i = 0; i < 4; ++i)
      if (speed(i) > 0 && (out == 4 || w[i] * speed(out) < w[out] * speed(i))) out = i;
    if (out == 4) return void(found = false);
    std::array<mpz_class, 3> exit;
    const auto corners = without(out);
    for (std::size_t i = 0; i < 3; ++i)
      exit[i] = w[corners[i]] * speed(out) - w[out] * speed(corners[i]);
    const auto region = regions_[out].find(exit, point.above);
    if (!region) return void(found = false);
    joins.push_back({node, first_[out] + *region});
  });
  for (const auto& [a, b] : joins) nodes_->join(a, b);
  return found;
}

std::array<std::size_t, 2> Boundary::beside(const RimCurve& curve) {
  for (std::size_t f = 0; f < 4; ++f) {
    if (curve.simplex != in_cell(7, f)) continue;
    const auto [a, b] = levels_[f]->loops.at(curve.number)[0];
    return std::array{nodes_->find(first_[f] + a), nodes_->find(first_[f] + b)};
  }
  const std::size_t n = segment(curve.simplex, curve.number);
  return std::array{nodes_->find(n), nodes_->find(n + 1)};
}

}  // namespace

std::optional<std::vector<std::size_t>> pieces_of_cell(const Level& level,
                                                       const Refinement& refinement,
                                                       const std::array<Id, 4>& corners,
                                                       const std::array<const FaceLevel*, 4>& faces,
                                                       const Weights& direction,
                                                       const std::vector<RimCurve>& curves) {
  Boundary boundary(level, refinement, corners, faces);
  if (!boundary.find_regions()) return std::nullopt;
  std::array<const Weights*, 4> rows;
  for (std::size_t i = 0; i < 4; ++i) rows[i] = &refinement.points()[corners[i]].weights;
  const int turn = sgn(determinant(rows));
  Weights in_cell_weights;
  for (std::size_t i = 0; i < 4; ++i) {
    auto replaced = rows;
    replaced[i] = &direction;
    in_cell_weights[i] = turn * determinant(replaced);
  }
  if (!boundary.join_along(in_cell_weights)) return std::nullopt;
  std::vector<std::size_t> pieces;
  std::map<std::array<std::size_t, 2>, std::size_t> numbers;
  std::set<std::size_t> components;
  for (const RimCurve& curve : curves) {
    auto beside = boundary.beside(curve);
    std::sort(beside.begin(), beside.end());
    if (beside[0] == beside[1]) return std::nullopt;
    pieces.push_back(numbers.emplace(beside, numbers.size()).first->second);
    components.insert(beside.begin(), beside.end());
  }
  // The components are joined like a tree by the pieces between them.
  if (components.size() != numbers.size() + 1) return std::nullopt;
  return pieces;
}

}  // namespace certificate
