// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/exact_critical_points.hpp"

#include <algorithm>

#include "critical_parts.hpp"
#include "rational/exact_zeros.hpp"
#include "rational/rational_line.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Exact = Deviator<Rational>;

template <std::size_t Count>
std::array<Exact, Count> exact_deviators(
    const std::array<SymmetricTensor<double>, Count>& tensors) {
  std::array<Exact, Count> t;
  for (std::size_t i = 0; i < Count; ++i) t[i] = exact_deviator(tensors[i]);
  return t;
}

/// By which positive number one is a multiple of another.
Rational quotient(const Exact& multiple, const Exact& t) {
  const std::array<Rational, 5> x{multiple.a, multiple.b, multiple.xy, multiple.yz, multiple.xz},
      y{t.a, t.b, t.xy, t.yz, t.xz};
  for (std::size_t i = 0; i < 5; ++i)
    if (y[i] != 0) return x[i] / y[i];
  return 1;
}

/// From weights of the multiples by which `exact_deviators` computes.
template <std::size_t Count>
void set_weights(CriticalPoint& point, std::array<Rational, Count> weights,
                 const std::array<SymmetricTensor<double>, Count>& given,
                 const std::array<Exact, Count>& multiples) {
  Rational sum = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    weights[i] *= quotient(multiples[i], deviator(tensor_cast<Rational>(given[i])));
    sum += weights[i];
  }
  for (std::size_t i = 0; i < Count; ++i)
    point.weights[i] = static_cast<double>(Rational(weights[i] / sum));
}

/// Encloses the positive combinations of two tensors, up to positive factors.
IntervalTensor enclosure_between(const Exact& first, const Exact& second) {
  const IntervalTensor s = enclosure(normalized(first)), t = enclosure(normalized(second));
  const auto hull = [](const Range& x, const Range& y) {
    return Range(std::min(x.inf(), y.inf()), std::max(x.sup(), y.sup()));
  };
  return {hull(s.a, t.a), hull(s.b, t.b), hull(s.xy, t.xy), hull(s.yz, t.yz), hull(s.xz, t.xz)};
}

/// Zero counts as unknown: a derivative that vanishes does not tell where the mode goes.
Verdict verdict(Sign s) { return s == Sign::zero ? Verdict::unknown : static_cast<Verdict>(s); }

/// Narrows 1 - mode^2 at a zero on a line to some digits, however small it is.
/// @param is_complement  the mode is that of the tensor on the line: of its square this is one less
void narrow_gap(CriticalPoint& point, const RationalLine& line, const ExactZeros& zeros,
                const ExactZeros::Zero& zero, bool is_complement) {
  const Rational p = line.norm.evaluate(zero.low), q = line.determinant.evaluate(zero.low);
  const Rational square = 2 * q * q / (p * p * p), gap = is_complement ? square : 1 - square;
  const Rational slack = gap / (1 << 20);
  for (const int side : {-1, 1}) {
    const Rational bound = gap + side * slack;
    const Sign sign = zeros.sign_at(zero, line.level_form(is_complement ? bound : 1 - bound));
    const bool is_above = (sign == Sign::positive) == is_complement;  // the gap, of the bound
    if (sign == Sign::zero || is_above != (side < 0)) continue;
    const Range enclosed = detail::enclosure(bound);
    if (side < 0)
      point.gap_low = std::max(point.gap_low, enclosed.inf());
    else
      point.gap_high = std::min(point.gap_high, enclosed.sup());
  }
}

/// The index of a critical point of a plane by its second derivatives.
struct PlaneIndex {
  Sign determinant, first;
  bool is_certain() const { return determinant != Sign::zero; }
  int index() const { return determinant == Sign::negative ? 1 : first == Sign::positive ? 0 : 2; }
};

}  // namespace

CriticalPoint exact_critical_vertex(const SymmetricTensor<double>& tensor,
                                    std::span<const SymmetricTensor<double>> around) {
  CriticalPoint point = critical_vertex(tensor, around);
  const Derivatives<Rational> d(exact_deviator(tensor));
  for (std::size_t i = 0; i < around.size(); ++i)
    if (point.towards[i] == Verdict::unknown)
      point.towards[i] = verdict(sign_of(d.first(exact_deviator(around[i]))));
  return point;
}

std::vector<CriticalPoint> exact_critical_points_on_edge(
    const std::array<SymmetricTensor<double>, 2>& edge,
    std::span<const SymmetricTensor<double>> around) {
  const auto ends = exact_deviators(edge);
  const RationalLine line(ends[0], ends[1] - ends[0]);
  const auto increase = line.increase();
  if (increase.is_zero()) return {};
  const ExactZeros zeros(increase, Rational(0), Rational(1));
  const UpwardRounding upward;
  std::vector<CriticalPoint> points;
  for (const auto& zero : zeros.zeros()) {
    CriticalPoint point;
    point.towards.assign(around.size(), Verdict::unknown);
    const IntervalTensor t = enclosure_between(line.at(zero.low), line.at(zero.high));
    set_weights(point, std::array{Rational(1 - zero.low), zero.low}, edge, ends);
    enclose_mode(point, t);
    narrow_gap(point, line, zeros, zero, false);
    point.deviator = box_of(t);
    const Sign slope = zeros.sign_at(zero, increase.prime());
    point.is_certain = slope != Sign::zero;
    point.index = slope == Sign::negative ? 1 : 0;
    for (std::size_t i = 0; i < around.size(); ++i)
      point.towards[i] =
          verdict(zeros.sign_at(zero, line.increase_towards(exact_deviator(around[i]))));
    points.push_back(std::move(point));
  }
  return points;
}

namespace {

/// The tensors G of `RationalLine::critical_cubic`, times a positive number.
Exact critical_at(const RationalLine& line, const Rational& x) {
  const Exact n = line.at(x);
  return critical_tensor(thrice(n), norm_form(n), determinant_form(n));
}

/// The points of a face that belong to the tensors N = a + x b.
class ExactFaceSearch {
 public:
  ExactFaceSearch(const std::array<SymmetricTensor<double>, 3>& given,
                  std::span<const SymmetricTensor<double>> around)
      : given_(given), around_(around), corners_(exact_deviators(given)) {
    complement_ = rational_complement(corners_);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto d = in_integers(characteristic_direction(TetrahedronField<Rational>{
          {corners_[i == 0 ? 1 : 0], corners_[i == 2 ? 1 : 2], complement_[0], complement_[1]}}));
      const Rational side = norm_form(corners_[i], d);
      dual_[i] = (Rational(1) / side) * d;
    }
  }

  /// False where the points are not isolated.
  bool run(std::vector<CriticalPoint>& points) const {
    // The lines a + x b and b + x a have the tensors a + x b with |x| = bound in common.
    const auto& [a, b] = complement_;
    const RationalLine line(a, b);
    const auto cubic = line.critical_cubic();
    if (cubic.is_zero()) return false;
    Rational bound = 1;
    while (cubic.evaluate(bound) == 0 || cubic.evaluate(-bound) == 0) bound += Rational(1) / 8;
    return half(line, bound, points) && half(RationalLine(b, a), Rational(1) / bound, points);
  }

 private:
  bool half(const RationalLine& line, const Rational& bound,
            std::vector<CriticalPoint>& points) const {
    const ExactZeros zeros(line.critical_cubic(), -bound, bound);
    for (const auto& zero : zeros.zeros()) {
      std::array<Sign, 3> weights;
      for (std::size_t i = 0; i < 3; ++i)
        weights[i] = zeros.sign_at(zero, line.increase_towards(dual_[i]));
      if (weights == std::array{Sign::zero, Sign::zero, Sign::zero}) return false;
      // G has mode <= 0, and -G has mode >= 0.
      for (const Sign sign : {Sign::positive, Sign::negative})
        if (weights == std::array{sign, sign, sign})
          points.push_back(point_at(line, zeros, zero, -sign));
    }
    return true;
  }

  CriticalPoint point_at(const RationalLine& line, const ExactZeros& zeros,
                         const ExactZeros::Zero& zero, Sign sign) const {
    CriticalPoint point;
    point.towards.assign(around_.size(), Verdict::unknown);
    const PlaneIndex second = index_at(line, zeros, zero, sign);
    point.is_certain = second.is_certain();
    point.index = second.index();
    // The derivative at G and -G is a multiple of N. Of which sign: with N = (cos a, cos(a + 120),
    // cos(a - 120)) in its eigenvectors G is N turned by 90 degrees, so <G^2, N> = -cos 3a up to a
    // positive factor, and det N has the sign of cos 3a.
    const Sign along = -zeros.sign_at(zero, line.determinant);
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const auto product = line.linear(thrice(exact_deviator(around_[i])));
      point.towards[i] = verdict(along * zeros.sign_at(zero, product));
    }
    enclose(point, line, zero, sign);
    narrow_gap(point, line, zeros, zero, true);
    return point;
  }

  PlaneIndex index_at(const RationalLine& line, const ExactZeros& zeros,
                      const ExactZeros::Zero& zero, Sign sign) const {
    const std::array<Exact, 2> sides{corners_[1] - corners_[0], corners_[2] - corners_[0]};
    const auto second = [&](std::size_t i, std::size_t j) {
      return interpolated(20, [&](const Rational& x) {
        return Derivatives<Rational>(critical_at(line, x)).second(sides[i], sides[j]);
      });
    };
    const auto uu = second(0, 0), uv = second(0, 1), vv = second(1, 1);
    // The second derivatives at -G are the opposite ones.
    return {zeros.sign_at(zero, uu * vv - uv * uv), -sign * zeros.sign_at(zero, uu)};
  }

  void enclose(CriticalPoint& point, const RationalLine& line, const ExactZeros::Zero& zero,
               Sign sign) const {
    const UpwardRounding upward;
    const Rational up(static_cast<int>(sign));
    std::array<Rational, 3> weights;
    for (std::size_t i = 0; i < 3; ++i)
      weights[i] = -up * norm_form(critical_at(line, zero.low), dual_[i]);
    set_weights(point, weights, given_, corners_);
    const IntervalTensor n = enclosure_between(line.at(zero.low), line.at(zero.high));
    const Range p = norm_form(n), q = determinant_form(n);
    const Range is_up(static_cast<double>(static_cast<int>(sign)));
    if (p.inf() > 0) narrow_by_gap(point, Range(2) * CGAL::square(q) / (p * p * p), is_up);
    const IntervalTensor t = -is_up * normalized(critical_tensor(thrice(n), p, q));
    enclose_mode(point, t);
    point.deviator = box_of(t);
  }

  const std::array<SymmetricTensor<double>, 3>& given_;
  std::span<const SymmetricTensor<double>> around_;
  std::array<Exact, 3> corners_;
  std::array<Exact, 2> complement_;
  std::array<Exact, 3> dual_;  ///< the product with a tensor of the face is the weight of a corner
};

}  // namespace

std::vector<CriticalPoint> exact_critical_points_on_face(
    const std::array<SymmetricTensor<double>, 3>& face,
    std::span<const SymmetricTensor<double>> around) {
  if (!are_independent(face)) return {};
  std::vector<CriticalPoint> points;
  if (ExactFaceSearch(face, around).run(points)) return points;
  return critical_points_on_face(face, around);
}

}  // namespace tensortopo
