// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotopy/compare_isotopy.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <set>
#include <utility>

#include "claims/containment.hpp"
#include "isotopy/apart.hpp"
#include "isotopy/layers.hpp"
#include "run/parallel.hpp"
#include "surface/box_tree.hpp"

namespace certificate {
namespace {

using Tet = std::size_t;  ///< among the tetrahedra of the input

bool is_part(const Carrier& part, std::span<const Vertex> whole) {
  return std::all_of(part.corners.begin(),
                     part.corners.begin() + static_cast<std::ptrdiff_t>(part.count),
                     [&](Vertex v) { return std::find(whole.begin(), whole.end(), v) != whole.end(); });
}

/// Why each tetrahedron that holds triangles is not shown; nothing if it is.
class Isotopy {
 public:
  Isotopy(const LevelCase& c, const PlacedSurface& placed, bool is_near);
  const std::map<Tet, const char*>& reasons() const { return reasons_; }
  double moved() const { return moved_; }

 private:
  std::span<const std::uint32_t, 3> corners(std::size_t triangle) const {
    return c_.surface.triangles[c_.triangles.first + triangle];
  }
  std::size_t place(std::uint32_t vertex) const { return vertex - c_.vertices.first; }
  void exclude(Tet tet, const char* reason) {
    if (const char*& known = reasons_.at(tet); known == nullptr) known = reason;
  }
  const char* reason_in_topology(Tet tet) const;
  void choose_layers();
  void put(std::size_t vertex);
  void require_order();
  void require_places();
  void require_gaps();
  void require_layers();

  const LevelCase& c_;
  const PlacedSurface& placed_;
  std::map<Tet, const char*> reasons_;
  std::map<Tet, const char*> layered_;  ///< to be shown by layers, and why not otherwise
  std::vector<std::array<double, 4>> weights_;  ///< of each vertex' exact point of its carrier
  std::vector<BallPoint> points_;               ///< all places between a vertex and that point
  std::vector<char> is_placed_, has_fans_;
  double moved_ = 0;
};

Isotopy::Isotopy(const LevelCase& c, const PlacedSurface& placed, bool is_near)
    : c_(c),
      placed_(placed),
      weights_(placed.carriers.size()),
      points_(placed.carriers.size()),
      is_placed_(placed.carriers.size(), 1),
      has_fans_(placed.carriers.size()) {
  for (const Tet tet : placed.tets)
    if (!c.left_out[tet]) reasons_.emplace(tet, nullptr);
  for (auto& [tet, reason] : reasons_) reason = reason_in_topology(tet);
  if (is_near) choose_layers();
  parallel_for(points_.size(), [&](std::size_t v) { put(v); });
  require_order();
  require_places();
  require_gaps();
  require_layers();
}

/// Whatever the sheets are, layers may do where the distance is proved.
void Isotopy::choose_layers() {
  std::set<Tet> coarse;
  for (const Json& cell : c_.claims["distance"]["coarse"])
    coarse.insert(c_.input.tet_at(cell.get<Number>()));
  for (auto& [tet, reason] : reasons_) {
    if (reason == nullptr || c_.topology.tet(tet) == nullptr || coarse.contains(tet)) continue;
    const auto closed = placed_.closed_pieces.find(tet);
    if (closed != placed_.closed_pieces.end() &&
        std::any_of(closed->second.begin(), closed->second.end(),
                    [](const ClosedPiece& p) { return p.euler_characteristic != 2; }))
      continue;
    layered_.emplace(tet, std::exchange(reason, nullptr));
  }
}

/// Each sheet a disc, and curves of faces distinguished by the crossings that they join.
const char* Isotopy::reason_in_topology(Tet tet) const {
  const TetTopology* const found = c_.topology.tet(tet);
  if (found == nullptr) return "zero_deviator_vertex";
  for (const MeshSheet& sheet : found->sheets)
    if (sheet.euler_characteristic != 1 || sheet.loops.size() != 1) return "sheet_is_no_disc";
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceTopology* const face = c_.topology.face(without(c_.input.tets[tet], i));
    if (face == nullptr || face->level.loops.empty()) continue;
    if (face->level.loops.size() > 1 || !face->arcs.empty()) return "closed_curves_on_face";
  }
  return nullptr;
}

/// Takes a point inside the carrier, about the nearest, and encloses the way there.
void Isotopy::put(std::size_t vertex) {
  const Carrier& carrier = placed_.carriers[vertex];
  const Point3& x = c_.surface.points[c_.vertices.first + vertex];
  if (carrier.count < 2) {
    is_placed_[vertex] = 0;
    return;
  }
  std::array<Point3, 4> corners;
  for (std::size_t i = 0; i < carrier.count; ++i) corners[i] = c_.input.points[carrier.corners[i]];
  auto& weights = weights_[vertex];
  weights = weights_near(x, std::span(corners.data(), carrier.count));
  Ball total = 0;
  for (std::size_t i = 0; i < carrier.count; ++i) {
    weights[i] = std::max(weights[i], 0x1p-100);
    if (!(weights[i] <= 2)) is_placed_[vertex] = 0;
    total += Ball(weights[i], 0);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    Ball sum = 0;
    for (std::size_t i = 0; i < carrier.count; ++i)
      sum += Ball(weights[i], 0) * (Ball(corners[i][k], 0) - Ball(x[k], 0));
    const double reach =
        (std::abs(sum.value) + sum.error) / (total.value - total.error) * Ball::kSlack + Ball::kTiny;
    if (!(reach < 0x1p1000)) is_placed_[vertex] = 0;
    points_[vertex][k] = Ball(x[k], reach);
  }
}

/// Vertices of crossings of an edge are in order along it. A crossing with several vertices is the
/// only point that parts of the mesh have in common there: vertices beside each other are no part
/// of that.
void Isotopy::require_order() {
  for (const Json& edge : c_.claims["edges"]) {
    mpq_class last = 0;
    std::size_t before = 0;
    for (std::size_t n = 2; n < edge.size(); ++n) {
      const std::size_t v = place(edge[n][2].get<std::uint32_t>());
      for (std::size_t i = 2; edge[n].size() > 3 && i < edge[n].size(); ++i)
        has_fans_[place(edge[n][i].get<std::uint32_t>())] = 1;
      if (edge.size() == 3 || !is_placed_[v]) continue;
      const auto& w = weights_[v];
      const mpq_class at = mpq_class(w[1]) / (mpq_class(w[0]) + mpq_class(w[1]));
      if (n > 2 && at <= last) is_placed_[v] = is_placed_[before] = 0;
      last = at, before = v;
    }
  }
}

/// Each vertex is in what holds it, of each tetrahedron and face that has it.
void Isotopy::require_places() {
  for (const auto& [vertex, carrier] : placed_.places)
    if (const std::size_t v = vertex - c_.vertices.first;
        !is_part(placed_.carriers[v], std::span(carrier.corners.data(), carrier.count)))
      is_placed_[v] = 0;
  for (std::size_t t = 0; t < placed_.tets.size(); ++t) {
    const Tet tet = placed_.tets[t];
    if (c_.left_out[tet]) continue;
    for (const std::uint32_t corner : corners(t)) {
      const std::size_t v = place(corner);
      if (has_fans_[v]) exclude(tet, "several_fans");
      if (!is_placed_[v] || !is_part(placed_.carriers[v], c_.input.tets[tet]))
        exclude(tet, "vertex_out_of_place");
    }
  }
}

/// No two triangles meet elsewhere than in what they share, wherever their corners are between the
/// vertices and their exact points.
void Isotopy::require_gaps() {
  std::vector<std::size_t> asked;
  for (std::size_t t = 0; t < placed_.tets.size(); ++t)
    if (!c_.left_out[placed_.tets[t]] && reasons_.at(placed_.tets[t]) == nullptr)
      asked.push_back(t);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Box> boxes;
  for (const std::size_t t : asked) {
    auto& triangle = triangles.emplace_back();
    Box& box = boxes.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i] = static_cast<std::uint32_t>(place(corners(t)[i]));
      const BallPoint& p = points_[triangle[i]];
      Point3 low, high;
      for (std::size_t k = 0; k < 3; ++k) {  // outwards, however these are rounded
        low[k] = p[k].value - 2 * p[k].error - std::abs(p[k].value) * Ball::kUnit;
        high[k] = p[k].value + 2 * p[k].error + std::abs(p[k].value) * Ball::kUnit;
      }
      box.add(low), box.add(high);
    }
  }
  const BoxTree tree(std::move(boxes));
  std::mutex mutex;
  const auto leave = [&](std::size_t s) {
    const std::lock_guard lock(mutex);
    exclude(placed_.tets[asked[s]], "triangles_too_close");
  };
  parallel_for(
      asked.size(),
      [&](std::size_t s) {
        const auto& [a, b, c] = triangles[s];
        const bool all = tree.for_meeting(s, [&](std::size_t t) {
          if (!are_apart(points_, triangles[s], triangles[t])) leave(s), leave(t);
        });
        if (!all || !has_area(points_[a], points_[b], points_[c])) leave(s);
      },
      c_.progress, "isotopy");
  for (std::size_t s = 0; s < asked.size(); ++s) {
    if (reasons_.at(placed_.tets[asked[s]]) != nullptr) continue;
    for (const std::uint32_t v : triangles[s]) {
      const BallPoint& p = points_[v];
      moved_ = std::max(moved_, (1 + 0x1p-40) * std::hypot(p[0].error, p[1].error, p[2].error));
    }
  }
}

/// Tetrahedra with sheets that need not be discs: the level is between layers of a product.
void Isotopy::require_layers() {
  std::map<Tet, std::vector<std::size_t>> triangles;
  for (std::size_t t = 0; t < placed_.tets.size(); ++t)
    if (const Tet tet = placed_.tets[t]; layered_.contains(tet) && reasons_.at(tet) == nullptr)
      triangles[tet].push_back(t);
  if (triangles.empty()) return;
  const MovedVertices moved(c_, placed_, c_.claims["distance"]["reach"]);
  const Layers layers(c_, placed_, moved, points_);
  const std::vector<std::pair<Tet, std::vector<std::size_t>>> asked(triangles.begin(),
                                                                   triangles.end());
  std::vector<char> is_shown(asked.size());
  parallel_for(asked.size(),
               [&](std::size_t i) { is_shown[i] = layers.are_embedded(asked[i].second); });
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (!is_shown[i]) exclude(asked[i].first, layered_.at(asked[i].first));
}

}  // namespace

void compare_isotopy(const LevelCase& c, const PlacedSurface* placed, bool is_near,
                     Ledger& ledger) {
  LevelReport& report = ledger.of_level();
  report.claims_isotopy = true;
  if (placed == nullptr || !report.embedded)
    return ledger.leave_open("isotopic", "it rests on claims that are not certified");
  const Isotopy isotopy(c, *placed, is_near);
  std::set<Tet> excepted;
  for (const Json& cell : c.claims["isotopic"]["except"]) {
    const Tet tet = c.input.tet_at(cell.get<Number>());
    if (tet == Input::kNone || !isotopy.reasons().contains(tet))
      return ledger.refute("isotopic", "but in tetrahedron " + cell.dump(),
                           "cell " + cell.dump() +
                               " holds no triangles that are claimed to be the level");
    excepted.insert(tet);
  }
  std::string open;
  for (const auto& [tet, reason] : isotopy.reasons()) {
    const bool is_claimed = !excepted.contains(tet);
    if (is_claimed && reason == nullptr) {
      ++report.isotopic;
      continue;
    }
    const std::string why = reason == nullptr ? "not_claimed" : reason;
    report.not_isotopic[why].push_back(c.input.cells[tet]);
    if (is_claimed && open.empty())
      open = "not shown in tetrahedron " + std::to_string(c.input.cells[tet]) + ": " + why;
  }
  report.moved = isotopy.moved();
  if (open.empty()) return ledger.certify();
  ledger.leave_open("isotopic", open);
}

}  // namespace certificate
