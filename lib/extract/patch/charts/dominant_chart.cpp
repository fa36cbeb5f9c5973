// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/dominant_chart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

double positive_remainder(double angle, double period) {
  const double r = std::fmod(angle, period);
  return r < 0 ? r + period : r;
}

/// Bounds of the logarithm of the ratio of the radii of a polar layout.
constexpr double kLeastGrowth = 2.5, kMostGrowth = 600;

}  // namespace

DominantChart::DominantChart(const CharacteristicTensor<double>& characteristic,
                             const ModeParameter<double>& mode, About about)
    : characteristic_(characteristic),
      mode_(mode),
      about_(about),
      axes_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      period_(about == About::cone ? 2 * std::numbers::pi : std::numbers::pi) {
  if (about == About::cone) return;
  // N is isotropic across A e1 + B e3 and -A e1 + B e3.
  const auto& [b1, b2, b3] = characteristic.eigenvalues;
  const double a = std::sqrt((b1 - b2) / (b1 - b3)), b = std::sqrt((b2 - b3) / (b1 - b3));
  const double side = about == About::first_plane ? 1 : -1;
  axes_ = {{{b, 0, -side * a}, {0, 1, 0}, {side * a, 0, b}}};
}

DominantChart::Frame DominantChart::frame_at(double around, double elevation) const {
  const double c = elementary::cos(around), s = elementary::sin(around);
  const double ce = elementary::cos(elevation), se = elementary::sin(elevation);
  const auto across = c * axes_[0] + s * axes_[1];
  return {ce * across + se * axes_[2], ce * axes_[2] - se * across, c * axes_[1] - s * axes_[0]};
}

DominantChart::Place DominantChart::place(const Vector3<double>& dominant,
                                          const Vector3<double>& medium) const {
  const auto& [e1, e2, e3] = characteristic_.eigenvectors;
  const auto in_frame = [&, e1 = e1, e2 = e2, e3 = e3](const Vector3<double>& v) {
    return Vector3<double>{dot(v, e1), dot(v, e2), dot(v, e3)};
  };
  auto e = in_frame(dominant);
  const auto m = in_frame(medium);
  if (about_ == About::cone && e.z < 0) e = -e;
  const auto angle_of = [&] { return elementary::atan2(dot(e, axes_[1]), dot(e, axes_[0])); };
  double around = cut_ + positive_remainder(angle_of() - cut_, 2 * std::numbers::pi);
  if (around - cut_ >= period_) {  // the other end of the line
    e = -e;
    around -= std::numbers::pi;
  }
  const auto frame = frame_at(around, elementary::asin(std::clamp(dot(e, axes_[2]), -1.0, 1.0)));
  return {around, positive_remainder(2 * elementary::atan2(dot(m, frame.along), dot(m, frame.up)),
                                     2 * std::numbers::pi)};
}

std::optional<SymmetricTensor<double>> DominantChart::tensor(const Place& place) const {
  const auto& [b1, b2, b3] = characteristic_.eigenvalues;
  const auto& [l1, l2, l3] = mode_.eigenvalues;
  const double c = elementary::cos(place.around), s = elementary::sin(place.around);
  const double start = about_ == About::cone
                           ? elementary::atan2(std::sqrt(b1 * c * c + b2 * s * s), std::sqrt(-b3))
                           : 0;
  const double cos_turn = elementary::cos(place.turn / 2),
               sin_turn = elementary::sin(place.turn / 2);
  const auto times_n = [&, b1 = b1, b2 = b2, b3 = b3](const Vector3<double>& v) {
    return Vector3<double>{b1 * v.x, b2 * v.y, b3 * v.z};
  };
  // Newton's method for the elevation at which the tensor is orthogonal to N, from the cone or
  // plane.
  double elevation = start, last = 1;
  for (int step = 0; step < 20; ++step) {
    const auto [e, up, along] = frame_at(place.around, elevation);
    const auto m = cos_turn * up + sin_turn * along;
    const auto minor = cos_turn * along - sin_turn * up;
    const auto ne = times_n(e);
    const double value =
        l1 * dot(e, ne) + l2 * dot(m, times_n(m)) + l3 * dot(minor, times_n(minor));
    const double slope =
        2 * (l1 * dot(up, ne) - l2 * cos_turn * dot(m, ne) + l3 * sin_turn * dot(minor, ne));
    if (!(std::abs(slope) > 0)) return std::nullopt;
    last = value / slope;
    elevation -= last;
    if (std::abs(last) < 1e-15) break;
  }
  // A guess that is brought onto the level, and whose place is checked, by those who ask.
  const double lowest = about_ == About::cone ? 0 : -std::numbers::pi / 2;
  if (!(std::abs(last) < 1e-12) || !(elevation > lowest && elevation < std::numbers::pi / 2))
    return std::nullopt;
  const auto frame = frame_at(place.around, elevation);
  const auto& [e1, e2, e3] = characteristic_.eigenvectors;
  const auto in_space = [&, e1 = e1, e2 = e2, e3 = e3](const Vector3<double>& v) {
    return v.x * e1 + v.y * e2 + v.z * e3;
  };
  const auto e = in_space(frame.e);
  const auto m = in_space(cos_turn * frame.up + sin_turn * frame.along);
  // l1 e e + l2 m m + l3 (I - e e - m m)
  const double p = l1 - l3, q = l2 - l3;
  return SymmetricTensor<double>{
      l3 + p * e.x * e.x + q * m.x * m.x, l3 + p * e.y * e.y + q * m.y * m.y,
      l3 + p * e.z * e.z + q * m.z * m.z, p * e.x * e.y + q * m.x * m.y,
      p * e.y * e.z + q * m.y * m.z,      p * e.x * e.z + q * m.x * m.z};
}

void DominantChart::lay_out(std::vector<double> rows, double height,
                            const std::optional<double>& turn_cut) {
  rows_ = std::move(rows);
  turn_cut_ = turn_cut;
  const auto count = static_cast<double>(rows_.size() - 1);
  height_ = turn_cut ? height : std::clamp(height, kLeastGrowth / count, kMostGrowth / count);
}

/// The coordinate along the rows.
double DominantChart::along(double around) const {
  const auto next = std::clamp(std::upper_bound(rows_.begin(), rows_.end(), around),
                               rows_.begin() + 1, rows_.end() - 1);
  const double from = *(next - 1);
  return height_ *
         (static_cast<double>(next - 1 - rows_.begin()) + (around - from) / (*next - from));
}

double DominantChart::around_at(double along) const {
  const double row = along / height_;
  const auto last = static_cast<double>(rows_.size() - 2);
  const double whole = std::clamp(std::floor(row), 0.0, last);
  const auto i = static_cast<std::size_t>(whole);
  return rows_[i] + (row - whole) * (rows_[i + 1] - rows_[i]);
}

DominantChart::Point DominantChart::point(const Place& place) const {
  const double x = along(place.around);
  if (turn_cut_) return {x, positive_remainder(place.turn - *turn_cut_, 2 * std::numbers::pi)};
  const double radius = elementary::exp(x);
  return {radius * elementary::cos(place.turn), radius * elementary::sin(place.turn)};
}

DominantChart::Place DominantChart::place_at(const Point& point) const {
  if (turn_cut_) return {around_at(point[0]), point[1] + *turn_cut_};
  return {around_at(elementary::log(elementary::hypot(point[0], point[1]))),
          elementary::atan2(point[1], point[0])};
}

double DominantChart::length_of(double turn, const Point& at) const {
  return 2 * turn * (turn_cut_ ? 1 : elementary::hypot(at[0], at[1]));
}

}  // namespace tensortopo
