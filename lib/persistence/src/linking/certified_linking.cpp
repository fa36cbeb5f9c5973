// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/certified_linking.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "linking/hulls_apart.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {
namespace {

/// Halvings of an arc that are tried at first: until its weights have coefficients of one sign, and
/// to find hulls that are apart.
constexpr int kFirstDepth = 1, kDepth = 7;

bool are_apart(const PlaceBox& a, const PlaceBox& b) {
  return a.high.x < b.low.x || a.high.y < b.low.y || a.high.z < b.low.z || b.high.x < a.low.x ||
         b.high.y < a.low.y || b.high.z < a.low.z;
}

std::vector<PlaceBox> polygon_of(const std::vector<EnclosedArc>& arcs) {
  std::vector<PlaceBox> polygon;
  // The last point of an arc is the first one of the next.
  for (const EnclosedArc& arc : arcs)
    polygon.insert(polygon.end(), arc.points.begin(), arc.points.end() - 1);
  return polygon;
}

bool are_all_apart(const EnclosedArc& a, const EnclosedArc& b) {
  for (const auto& p : a.hulls)
    for (const auto& q : b.hulls)
      if (!are_hulls_apart(p, q)) return false;
  return true;
}

}  // namespace

std::string_view name_of(LinkObstacle obstacle) {
  switch (obstacle) {
    case LinkObstacle::special_position:
      return "special_position";
    case LinkObstacle::near_in_a_tet:
      return "near_in_a_tet";
    case LinkObstacle::projection:
      return "projection";
  }
  return "unknown";
}

std::size_t CertifiedLinks::add(const CurveArcs& arcs, std::vector<std::size_t> lines) {
  Curve curve;
  curve.arcs = &arcs;
  curve.lines = std::move(lines);
  bool is_first = true;
  for (std::size_t k = 0; k < curve.lines.size(); ++k) {
    const TetMesh::Index t = arcs.curves().tet[curve.lines[k]];
    curve.positions.emplace(t, k);
    for (const auto v : mesh_->tets[as_size(t)]) {
      const auto& p = mesh_->points[as_size(v)];
      auto& [low, high] = curve.box;
      if (is_first) low = high = p;
      is_first = false;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  curves_.push_back(std::move(curve));
  return curves_.size() - 1;
}

void CertifiedLinks::enclose(Curve& curve) const {
  if (curve.is_enclosed) return;
  curve.is_enclosed = true;
  for (const std::size_t line : curve.lines) {
    std::optional<EnclosedArc> arc;
    for (int depth = kFirstDepth; !arc && depth <= kDepth; ++depth)
      arc = curve.arcs->enclosed(line, depth);
    if (!arc) {
      curve.is_special = true;
      return;
    }
    curve.enclosed.push_back(std::move(*arc));
  }
}

bool CertifiedLinks::make_apart(Curve& a, std::size_t i, Curve& b, std::size_t j) const {
  if (are_all_apart(a.enclosed[i], b.enclosed[j])) return true;
  for (int depth = kFirstDepth + 1; depth <= kDepth; ++depth) {
    // Hulls of parts are in the hull of the whole: what was proved of a coarser arc stays so.
    const auto refine = [&](Curve& curve, std::size_t k) {
      if (curve.enclosed[k].hulls.size() >= std::size_t{1} << depth) return;
      if (auto arc = curve.arcs->enclosed(curve.lines[k], depth))
        curve.enclosed[k] = std::move(*arc);
    };
    refine(a, i);
    refine(b, j);
    if (are_all_apart(a.enclosed[i], b.enclosed[j])) return true;
  }
  return false;
}

CertifiedLink CertifiedLinks::link(std::size_t a, std::size_t b) {
  if (std::max(a, b) >= curves_.size())
    throw std::invalid_argument("curves: there is no closed curve " +
                                std::to_string(std::max(a, b)) + ", but " +
                                std::to_string(curves_.size()));
  Curve &first = curves_[a], &second = curves_[b];
  if (are_apart(first.box, second.box)) return {0, {}};
  enclose(first);
  enclose(second);
  if (first.is_special || second.is_special) return {{}, LinkObstacle::special_position};
  for (const auto& [tet, i] : first.positions) {
    const auto [begin, end] = second.positions.equal_range(tet);
    for (auto at = begin; at != end; ++at)
      if (!make_apart(first, i, second, at->second)) return {{}, LinkObstacle::near_in_a_tet};
  }
  const auto number =
      enclosed_linking_number(polygon_of(first.enclosed), polygon_of(second.enclosed));
  if (!number) return {{}, LinkObstacle::projection};
  return {number, {}};
}

}  // namespace tensortopo
