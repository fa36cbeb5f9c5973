// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_points.hpp"

#include "critical_parts.hpp"
#include "interval_roots.hpp"

namespace tensortopo {

using namespace detail;

namespace {

/// Encloses the mode on a part of an edge where it hardly changes.
void enclose_mode_along(CriticalPoint& point, const Line& line, const Polynomial& increase,
                        const Range& x) {
  double low = 1, high = -1;
  bool is_defined = true;
  const auto value = [&](const Range& at) {
    const Range p = horner(line.norm, at);
    return root_of(Range(2)) * horner(line.determinant, at) / (p * root_of(p));
  };
  const auto slope = [&](const Range& at) {
    const Range p = range_of(line.norm, at);
    is_defined &= p.inf() > 0;
    return range_of(increase, at) / (root_of(Range(2)) * p * p * root_of(p));
  };
  in_parts(x, value, slope, [&](const Range& mode) {
    low = std::min(low, mode.inf());
    high = std::max(high, mode.sup());
  });
  if (!is_defined) return;
  point.low = std::max(point.low, low);
  point.high = std::min(point.high, high);
}

}  // namespace

CriticalPoint critical_vertex(const SymmetricTensor<double>& tensor,
                              std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  CriticalPoint point;
  point.weights[0] = 1;
  point.is_certain = true;
  point.towards.assign(around.size(), Verdict::unknown);
  const IntervalTensor t = enclosure(tensor);
  enclose_mode(point, t);
  point.deviator = box_of(t);
  look_around(point, Derivatives<Range>(t), around);
  return point;
}

std::vector<CriticalPoint> critical_points_on_edge(
    const std::array<SymmetricTensor<double>, 2>& edge,
    std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  const auto ends = enclosures(edge);
  const IntervalTensor step = ends[1] - ends[0];
  const Line line(ends[0], step);
  const Polynomial increase = increase_along(line);
  const auto nowhere = [](const Range&) { return false; };
  const auto roots = interval_roots(increase, 0, 1, nowhere);
  const auto is_vague = [](const IntervalRoot& root) { return !root.is_certain; };
  if (std::any_of(roots.begin(), roots.end(), is_vague) && !are_independent(edge)) return {};
  std::vector<CriticalPoint> points;
  for (const IntervalRoot& root : roots) {
    CriticalPoint point;
    point.towards.assign(around.size(), Verdict::unknown);
    const IntervalTensor t = ends[0] + root.x * step;
    const double x = middle(root.x);
    set_weights(point, std::array{1 - x, x}, edge, ends);
    enclose_mode(point, t);
    if (!root.is_certain) enclose_mode_along(point, line, increase, root.x);
    point.is_certain = root.is_certain;
    point.index = root.slope < 0 ? 1 : 0;
    point.deviator = box_of(t);
    if (point.is_certain) look_around(point, Derivatives<Range>(t), around);
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace tensortopo
