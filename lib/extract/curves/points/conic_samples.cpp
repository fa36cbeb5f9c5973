// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/conic_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

using Direction = Vector3<Extended>;

/// Bisections of one stretch; the turning halves with nearly every one.
constexpr int kDepth = 40;

/// What rounding moves a point off the conic by is less, unless the conic nearly crosses itself.
constexpr double kLargestStep = 0x1p-20;

constexpr double kTurn = 2 * std::numbers::pi;

Direction wide(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

ConicSampler::ConicSampler(const FieldForms<Extended, 4>& forms, const Vector3<double>& inside,
                           const Vector3<double>& first, const Vector3<double>& second)
    : form_(unit_form<Extended>(forms.across[0])),
      weight_(forms.weight),
      inside_(wide(inside)),
      first_(wide(first)),
      second_(wide(second)),
      plane_(form_ * inside_) {}

Direction ConicSampler::turned(const Direction& e) const {
  const auto u = unit(e);
  return dot(u, plane_) < 0 ? u : -u;
}

// The conic's form at m + t c is q(m) + 2 t B(m, c) + t^2 q(c) with q(c) < 0. The zero on the side
// of c has B(m, c) + t q(c) = -sqrt(B^2 - q(m) q(c)); written without cancellation for B < 0.
Direction ConicSampler::projected(const Direction& m) const {
  const Extended at_m = polar(form_, m, m), at_c = dot(inside_, plane_), mixed = dot(m, plane_);
  const Extended square = mixed * mixed - at_m * at_c;
  using std::sqrt;
  const Extended root = square > 0 ? Extended(sqrt(square)) : Extended(0);
  const Extended t = mixed < 0 ? at_m / (root - mixed) : -(mixed + root) / at_c;
  return turned(m + t * inside_);
}

double ConicSampler::angle(const Direction& e) const {
  const double a =
      elementary::atan2(static_cast<double>(dot(e, second_)), static_cast<double>(dot(e, first_)));
  return a < 0 ? a + kTurn : a;
}

CurveSample ConicSampler::sample(const Direction& e) const {
  CurveSample result;
  // Once more onto the conic, along its normal; where that vanishes to rounding, because the conic
  // nearly crosses itself, e is as good as it gets.
  const auto normal = form_ * e;
  const Extended step = dot(e, normal) / (2 * dot(normal, normal));
  using std::abs;
  const bool is_small = abs(step) * length(normal) < kLargestStep;
  result.dominant = is_small ? unit(e - step * normal) : e;
  Extended sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    result.weights[i] = polar(weight_[i], result.dominant, result.dominant);
    sum += result.weights[i];
  }
  for (auto& w : result.weights) w /= sum;
  return result;
}

void ConicSampler::bisect(const Direction& begin, const Direction& end, double least_cosine,
                          int depth, std::vector<CurveSample>& samples) const {
  if (depth == 0 || dot(begin, end) >= least_cosine) return;
  const auto middle = projected(begin + end);
  bisect(begin, middle, least_cosine, depth - 1, samples);
  samples.push_back(sample(middle));
  bisect(middle, end, least_cosine, depth - 1, samples);
}

std::vector<CurveSample> ConicSampler::between(const Direction& begin, const Direction& end,
                                               double largest_turn) const {
  std::vector<CurveSample> samples;
  const double least_cosine = elementary::cos(std::min(largest_turn, 0.5));
  const auto from = turned(begin), to = turned(end);
  const double first = angle(from);
  double sweep = angle(to) - first;
  if (sweep < 0) sweep += kTurn;
  // Stops less than a third of a turn apart, so that each middle is between its ends.
  const int parts = 1 + static_cast<int>(sweep / (kTurn / 4));
  Direction last = from;
  for (int k = 1; k <= parts; ++k) {
    Direction stop = to;
    if (k < parts) {
      const double a = first + sweep * k / parts;
      stop =
          projected(Extended(elementary::cos(a)) * first_ + Extended(elementary::sin(a)) * second_);
    }
    bisect(last, stop, least_cosine, kDepth, samples);
    if (k < parts) samples.push_back(sample(stop));
    last = stop;
  }
  return samples;
}

}  // namespace tensortopo
