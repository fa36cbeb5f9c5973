// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curves/degenerate_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace certificate {
namespace {

/// An upper bound of the largest eigenvalue of K, up to doubles; K is about trace-free.
double bound_of_largest(const std::array<double, 6>& k) {
  const double square =
      k[0] * k[0] + k[1] * k[1] + k[2] * k[2] + 2 * (k[3] * k[3] + k[4] * k[4] + k[5] * k[5]);
  const double det = Conic<double>{k}.determinant();
  const double mode = std::clamp(std::sqrt(54.0) * det / (square * std::sqrt(square)), -1.0, 1.0);
  // So that the minors below do not drown in rounding: where the two largest eigenvalues are about
  // equal they are about the square of this.
  const double margin = mode > 0 ? 1 + 1e-11 : 1 + 1e-5;
  return margin * std::sqrt(square * 2 / 3) * std::cos(std::acos(mode) / 3);
}

}  // namespace

// Linear tensors M = e e^T - |e|^2/3 have tr(K M) <= (l - tr(K)/3) |e|^2 if no eigenvalue of K is
// above l, and |M|^2 = 2/3 |e|^4. If tr(K M) > c |M| at the corners, then in all of the simplex, as
// norms are convex.
bool is_free(std::span<const Tensor<Ball>* const> corners, Kind kind) {
  const int sign = static_cast<int>(kind);
  std::array<double, 6> k{};
  std::array<Ball, 4> squares;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    squares.at(i) = trace(*corners[i], *corners[i]);
    const double scale = sign / std::sqrt(squares[i].value);
    for (std::size_t n = 0; n < 6; ++n) k[n] += scale * (*corners[i])[n].value;
  }
  const double largest = bound_of_largest(k);
  if (!(largest > 0) || !(largest < 100)) return false;
  Conic<Ball> rest;  // l - K
  for (std::size_t n = 0; n < 6; ++n)
    rest.m[n] = n < 3 ? Ball(largest, 0) - Ball(k[n], 0) : Ball(-k[n], 0);
  const std::array minors{rest.m[0], rest.m[0] * rest.m[1] - rest.m[5] * rest.m[5],
                          rest.determinant()};
  if (common_sign(minors) != 1) return false;
  Tensor<Ball> test{};
  for (std::size_t n = 0; n < 6; ++n) test[n] = Ball(sign * k[n], 0);
  const Ball three_l = Ball(3) * Ball(largest, 0) - (Ball(k[0], 0) + Ball(k[1], 0) + Ball(k[2], 0));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Ball t = trace(test, *corners[i]);
    if (common_sign(std::array{t, three_l, Ball(6) * t * t - three_l * three_l * squares[i]}) != 1)
      return false;
  }
  return true;
}

namespace {

/// Another one is tried where p is on the conics, or q or r are on lines to points sought.
/// The last ones have no simple place.
constexpr std::array<Basis, 4> kBases{{{{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}},
                                       {{{{1, 0, 0}, {5, 1, 2}, {-2, 0, 1}}}},
                                       {{{{113, -71, 29}, {-37, 101, 53}, {61, 43, -127}}}},
                                       {{{{-59, 17, 97}, {83, 89, -31}, {19, -109, 47}}}}}};

template <class N>
std::array<Row<N>, 3> rows_of(const std::array<Tensor<N>, 3>& tensors) {
  return {row_of(tensors[0]), row_of(tensors[1]), row_of(tensors[2])};
}

std::array<std::size_t, 5> columns_of(const std::array<Corner, 3>& corners) {
  std::array<Row<double>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row<Ball> row = row_of(*corners[i].ball);
    for (std::size_t k = 0; k < 5; ++k) rows[i][k] = row[k].value;
  }
  return likely_columns(rows);
}

enum class PointPlace : unsigned char { open, outside, inside };

/// Are all points on the arc outside, or inside, as the weights' signs tell?
template <class N>
PointPlace place_of(const Arc<N>& arc, int side) {
  PointPlace place = PointPlace::inside;
  for (const auto& weight : arc.weight) {
    const int sign = side * common_sign(weight);
    if (sign < 0) return PointPlace::outside;
    if (sign == 0) place = PointPlace::open;
  }
  return place;
}

/// Is the face free of points, as doubles show?
bool is_free_in_balls(const std::array<Corner, 3>& corners,
                      const std::array<std::size_t, 5>& columns, Kind kind) {
  const SpanForms<Ball, 3> forms(
      rows_of<Ball>({*corners[0].ball, *corners[1].ball, *corners[2].ball}), columns);
  const int side = static_cast<int>(kind) * common_sign(std::array{forms.minor});
  if (side == 0) return false;
  constexpr std::size_t kMostArcs = 300;
  for (const std::size_t b : {0U, 1U}) {
    const auto arcs = arcs_of(forms, kBases[b]);
    if (!arcs) continue;
    std::vector<Arc<Ball>> open(arcs->begin(), arcs->end());
    std::size_t count = 0;
    for (; !open.empty() && count < kMostArcs; ++count) {
      const Arc<Ball> arc = open.back();
      open.pop_back();
      if (common_sign(arc.zero) != 0) continue;
      const PointPlace place = place_of(arc, side);
      if (place == PointPlace::outside) continue;
      const std::array ends{Ball(-1) * arc.zero.front(), arc.zero.back()};
      if (place == PointPlace::inside && common_sign(ends) != 0) return false;  // there is a point
      for (const Arc<Ball>& half : arc.halves()) open.push_back(half);
    }
    if (open.empty()) return true;
  }
  return false;
}

/// Is each part of a triangle free, cut in four so many times?
bool is_free_in_parts(const std::array<Tensor<Ball>, 3>& corners, Kind kind, int depth) {
  if (is_free(std::array<const Tensor<Ball>*, 3>{&corners[0], &corners[1], &corners[2]}, kind))
    return true;
  if (depth == 0) return false;
  std::array<Tensor<Ball>, 3> middles;  // opposite to the corners
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t n = 0; n < 8; ++n)
      middles[i][n] = Ball(0.5, 0) * (corners[(i + 1) % 3][n] + corners[(i + 2) % 3][n]);
  if (!is_free_in_parts(middles, kind, depth - 1)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!is_free_in_parts({corners[i], middles[(i + 1) % 3], middles[(i + 2) % 3]}, kind,
                          depth - 1))
      return false;
  return true;
}

/// Changes of sign among coefficients; those that are zero do not count.
int variations(const std::array<mpz_class, 5>& form) {
  int count = 0, last = 0;
  for (const mpz_class& x : form) {
    const int sign = sgn(x);
    if (sign != 0 && last != 0 && sign != last) ++count;
    if (sign != 0) last = sign;
  }
  return count;
}

/// Exactly one zero, and between the ends.
bool has_one_zero(const std::array<mpz_class, 5>& form) {
  return sgn(form.front()) != 0 && sgn(form.back()) != 0 && variations(form) == 1;
}

/// The coefficients of a form on [0, 1] become those on [0, i / 2^k], or on the rest of it.
template <std::size_t Count>
void keep(std::array<mpz_class, Count>& form, const mpz_class& i, unsigned k, bool front) {
  const mpz_class others = (mpz_class(1) << k) - i;
  auto row = form;
  for (std::size_t j = 0; j < Count; ++j) {
    const std::size_t last = Count - 1 - j;
    form[front ? j : last] = row[front ? 0 : last] << (k * last);
    for (std::size_t n = 0; n < last; ++n) row[n] = others * row[n] + i * row[n + 1];
  }
}

/// An arc without what is behind, or in front of, the parameter i / 2^k.
Arc<mpz_class> part_of(Arc<mpz_class> arc, const mpz_class& i, unsigned k, bool front) {
  for (auto& form : arc.e) keep(form, i, k, front);
  keep(arc.zero, i, k, front);
  for (auto& form : arc.weight) keep(form, i, k, front);
  return arc;
}

/// An arc in two, not at a zero: each has its zeros inside.
std::array<Arc<mpz_class>, 2> cut_apart(const Arc<mpz_class>& arc) {
  auto parts = arc.halves();
  // At most four places are zeros, or all.
  for (int i = 3; i < 16 && parts[0].zero.back() == 0; i += 2)
    parts = {part_of(arc, i, 4, true), part_of(arc, i, 4, false)};
  return parts;
}

/// Adds the points on an arc. False if it was cut too often.
/// @param budget  for how many arcs are looked at, of this and others
bool add_points(const Arc<mpz_class>& whole, int side, std::vector<FacePoint>& points,
                std::size_t& budget) {
  constexpr std::size_t kMostArcs = 400;
  if (whole.zero.front() == 0 || whole.zero.back() == 0) return false;
  std::vector<Arc<mpz_class>> open{whole};
  for (std::size_t count = 0; !open.empty(); ++count) {
    if (count == kMostArcs || budget == 0) return false;
    --budget;
    const Arc<mpz_class> arc = std::move(open.back());
    open.pop_back();
    if (common_sign(arc.zero) != 0) continue;
    const PointPlace place = place_of(arc, side);
    if (place == PointPlace::outside) continue;
    const bool is_one = has_one_zero(arc.zero);
    if (is_one && place == PointPlace::inside) {
      points.emplace_back(arc, side);
    } else if (is_one) {
      FacePoint point(arc, side);
      point.sharpen();
      open.push_back(point.arc());
    } else {
      for (Arc<mpz_class>& part : cut_apart(arc)) open.push_back(std::move(part));
    }
  }
  return true;
}

/// Where a form with one zero is about zero, in (0, 1).
double rough_zero(const std::array<mpz_class, 5>& form) {
  long shift = 0;
  for (const mpz_class& x : form)
    shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
  std::array<double, 5> b;
  for (std::size_t k = 0; k < 5; ++k) b[k] = ball_of(form[k], shift).value;
  const double sign = b[0] < 0 ? -1 : 1;
  double low = 0, high = 1;
  for (int step = 0; step < 50; ++step) {
    const double t = (low + high) / 2;
    auto row = b;
    for (std::size_t last = 4; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) row[i] += t * (row[i + 1] - row[i]);
    (sign * row[0] > 0 ? low : high) = t;
  }
  return low;
}

void drop_common_bits(std::span<mpz_class* const> numbers) {
  mp_bitcnt_t bits = ~mp_bitcnt_t{0};
  for (const mpz_class* x : numbers)
    if (*x != 0) bits = std::min(bits, mpz_scan1(x->get_mpz_t(), 0));
  for (mpz_class* x : numbers)
    if (*x != 0) *x >>= bits;
}

}  // namespace

void FacePoint::sharpen() {
  constexpr unsigned kBits = 24;
  constexpr double kAll = 1 << kBits;
  const double near = std::floor(rough_zero(arc_.zero) * kAll);
  const auto first = static_cast<long>(std::clamp(near - 2, 0.0, kAll - 4));
  Arc<mpz_class> part = part_of(arc_, first + 4, kBits, true);
  // Of the part in front, first / (first + 4): by a dyadic number that is a little less.
  const auto next = static_cast<long>(
      std::floor(static_cast<double>(first) / static_cast<double>(first + 4) * kAll));
  part = part_of(std::move(part), next, kBits, false);
  if (has_one_zero(part.zero)) {
    arc_ = std::move(part);
  } else {
    auto parts = cut_apart(arc_);
    arc_ = std::move(has_one_zero(parts[0].zero) ? parts[0] : parts[1]);
  }
  std::vector<mpz_class*> e, zero, weight;
  for (auto& form : arc_.e)
    for (mpz_class& x : form) e.push_back(&x);
  for (mpz_class& x : arc_.zero) zero.push_back(&x);
  for (auto& form : arc_.weight)
    for (mpz_class& x : form) weight.push_back(&x);
  for (const auto* numbers : {&e, &zero, &weight}) drop_common_bits(*numbers);
}

FacePoints points_in_face(const std::array<Corner, 3>& corners, Kind kind) {
  FacePoints result;
  if (is_free(std::array{corners[0].ball, corners[1].ball, corners[2].ball}, kind)) return result;
  const auto columns = columns_of(corners);
  if (is_free_in_balls(corners, columns, kind)) return result;
  result.by_integers = true;
  const SpanForms<mpz_class, 3> forms(
      rows_of<mpz_class>({corners[0].exact(), corners[1].exact(), corners[2].exact()}), columns);
  const int side = static_cast<int>(kind) * sgn(forms.minor);
  result.decided = false;
  std::size_t budget = 800;
  for (std::size_t b = 0; b < kBases.size() && side != 0 && !result.decided; ++b) {
    const auto arcs = arcs_of(forms, kBases[b]);
    result.points.clear();
    result.decided = arcs && add_points((*arcs)[0], side, result.points, budget) &&
                     add_points((*arcs)[1], side, result.points, budget);
  }
  if (result.decided) return result;
  result.points.clear();
  // What is special about the plane may be no concern of the triangle.
  constexpr int kDepth = 8;
  result.decided =
      is_free_in_parts({*corners[0].ball, *corners[1].ball, *corners[2].ball}, kind, kDepth);
  return result;
}

}  // namespace certificate
