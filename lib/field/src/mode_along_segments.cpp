// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/mode_along_segments.hpp"

#include <vector>

#include "critical_parts.hpp"

namespace tensortopo {
namespace {

using namespace detail;

IntervalTensor tensor_of(const DeviatorBox& box) {
  const auto range = [&](std::size_t i) { return Range(box.low[i], box.high[i]); };
  return {range(0), range(1), range(2), range(3), range(4)};
}

/// mode > level for all tensors of an enclosure. Next to 1 and -1 the quotient cancels, and
/// 1 - mode^2 does not.
bool is_above(const IntervalTensor& t, double level) {
  const Range p = norm_form(t), q = determinant_form(t);
  if (!(p.inf() > 0) || level >= 1) return false;
  if (level < 0 && q.inf() >= 0) return true;
  if ((root_of(Range(2)) * q / (p * root_of(p))).inf() > level) return true;
  const Range gap = degenerate_gap(t),
              bound = (Range(1) - Range(level)) * (Range(1) + Range(level));
  return level >= 0 ? q.inf() > 0 && gap.sup() < bound.inf() : gap.inf() > bound.sup();
}

bool is_below(const IntervalTensor& t, double level) {
  const Range p = norm_form(t), q = determinant_form(t);
  return p.inf() > 0 && (root_of(Range(2)) * q / (p * root_of(p))).sup() < level;
}

IntervalTensor combine(const std::array<IntervalTensor, 4>& t, const TetWeights& weights) {
  IntervalTensor sum{Range(0), Range(0), Range(0), Range(0), Range(0)};
  for (std::size_t i = 0; i < 4; ++i)
    if (weights[i] != 0) sum = sum + Range(weights[i]) * t[i];
  return sum;
}

IntervalTensor hull(const IntervalTensor& s, const IntervalTensor& t) {
  const auto both = [](const Range& x, const Range& y) {
    return Range(std::min(x.inf(), y.inf()), std::max(x.sup(), y.sup()));
  };
  return {both(s.a, t.a), both(s.b, t.b), both(s.xy, t.xy), both(s.yz, t.yz), both(s.xz, t.xz)};
}

/// The vertex that weights are all of, or -1.
int only_vertex(const TetWeights& weights) {
  int vertex = -1;
  for (int i = 0; i < 4; ++i)
    if (weights[static_cast<std::size_t>(i)] != 0) {
      if (vertex >= 0) return -1;
      vertex = i;
    }
  return vertex;
}

}  // namespace

namespace detail {

DeviatorBox box_of(const IntervalTensor& t) {
  return {{t.a.inf(), t.b.inf(), t.xy.inf(), t.yz.inf(), t.xz.inf()},
          {t.a.sup(), t.b.sup(), t.xy.sup(), t.yz.sup(), t.xz.sup()}};
}

}  // namespace detail

DeviatorBox deviator_box(const TetTensors4& tensors, const TetWeights& weights) {
  const UpwardRounding upward;
  return box_of(normalized(combine(scaled_deviators(tensors), weights)));
}

std::array<double, 2> mode_range(const DeviatorBox& box) {
  const UpwardRounding upward;
  CriticalPoint point;
  enclose_mode(point, tensor_of(box));
  return {point.low, point.high};
}

bool is_mode_above(const DeviatorBox& from, const DeviatorBox& to, double level, int most_parts) {
  const UpwardRounding upward;
  const IntervalTensor a = tensor_of(from), step = tensor_of(to) - a;
  const Line line(a, step);
  const Polynomial increase = increase_along(line);
  struct Part {
    double from, to;
  };
  std::vector<Part> parts{{0, 1}};
  for (int looked = 0; !parts.empty(); ++looked) {
    const Part part = parts.back();
    parts.pop_back();
    const Range x(part.from, part.to), m(middle(x));
    const IntervalTensor at = a + m * step;
    if (looked >= most_parts || is_below(at, level)) return false;
    const Range p = range_of(line.norm, x), p_at = norm_form(at);
    if (p.inf() > 0 && p_at.inf() > 0) {
      const Range slope = range_of(increase, x) / (root_of(Range(2)) * p * p * root_of(p));
      const Range value = root_of(Range(2)) * determinant_form(at) / (p_at * root_of(p_at));
      if ((value + slope * (x - m)).inf() > level) continue;
    }
    if (is_above(a + x * step, level)) continue;
    parts.push_back({middle(x), part.to});
    parts.push_back({part.from, middle(x)});
  }
  return true;
}

std::optional<TetWeights> rise_from(const TetTensors4& tensors, const Departure& departure,
                                    double level) {
  constexpr int kMostHalvings = 26;
  const UpwardRounding upward;
  const auto t = scaled_deviators(tensors);
  const IntervalTensor from = tensor_of(departure.deviator);
  const IntervalTensor about = combine(t, departure.weights);
  // Weights of the point for which the tensors have the size that they have in the box.
  const double factor = middle(norm_form(from, about)) / middle(norm_form(about));
  if (!(factor > 0) || !std::isfinite(factor)) return std::nullopt;
  TetWeights start = departure.weights, step_weights = departure.towards;
  for (double& w : start) w *= factor;
  const int vertex = only_vertex(departure.towards);
  IntervalTensor step;
  if (vertex >= 0) {
    step = t[static_cast<std::size_t>(vertex)] - from;
    for (std::size_t i = 0; i < 4; ++i) step_weights[i] -= start[i];
  } else {
    // As far as to the boundary of the tetrahedron, nearly.
    double most = HUGE_VAL;
    for (std::size_t i = 0; i < 4; ++i)
      if (step_weights[i] < 0) most = std::min(most, start[i] / -step_weights[i]);
    if (!(most > 0) || !std::isfinite(most)) return std::nullopt;
    for (double& w : step_weights) w *= 0.999 * most;
    step = combine(t, step_weights);
  }
  const Line line(from, step);
  Polynomial increase = increase_along(line);
  if (departure.is_critical)
    increase = {increase[1], increase[2], increase[3], increase[4], Range(0)};
  double x = 1;
  for (int halving = 0; halving < kMostHalvings; ++halving, x /= 2) {
    const Range part(0, x);
    if (!(range_of(increase, part).inf() > 0) || !(range_of(line.norm, part).inf() > 0)) continue;
    if (vertex >= 0 && x == 1) return departure.towards;
    TetWeights weights;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool stays_zero = start[i] == 0 && step_weights[i] <= 0;
      weights[i] = stays_zero ? 0 : std::max(0.0, start[i] + x * step_weights[i]);
    }
    // Between the point itself and its rounded weights.
    if (is_above(hull(from + Range(x) * step, combine(t, weights)), level)) return weights;
  }
  return std::nullopt;
}

}  // namespace tensortopo
