// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "critical_parts.hpp"
#include "interval_roots.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Tensor = IntervalTensor;

/// The points of a face that belong to the tensors N = a + x b.
class FaceSearch {
 public:
  FaceSearch(const std::array<SymmetricTensor<double>, 3>& given,
             std::span<const SymmetricTensor<double>> around)
      : given_(given), around_(around), corners_(enclosures(given)) {}

  /// False if the tensors are too close to dependent.
  bool prepare() {
    const auto own = spread_out(corners_);
    const auto complement = orthogonal_pair(own);
    n1_ = orthogonal_to({own[0], own[1], own[2], complement[1]});
    n2_ = orthogonal_to({own[0], own[1], own[2], complement[0]});
    const Range gram = norm_form(n1_) * norm_form(n2_) - norm_form(n1_, n2_) * norm_form(n1_, n2_);
    if (!(gram.inf() > 0)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto others =
          spread_out(std::array{corners_[i == 0 ? 1 : 0], corners_[i == 2 ? 1 : 2]});
      Tensor d = orthogonal_to({others[0], others[1], complement[0], complement[1]});
      sides_[i] = norm_form(corners_[i], d);
      if (!is_not_zero(sides_[i])) return false;
      if (sides_[i].sup() < 0) d = Range(-1) * d, sides_[i] = -sides_[i];
      dual_[i] = thrice(d);
    }
    return true;
  }

  /// The same in rationals, for tensors that are independent.
  void prepare_in_rationals() {
    std::array<Deviator<Rational>, 3> t;
    for (std::size_t i = 0; i < 3; ++i) t[i] = deviator(tensor_cast<Rational>(given_[i]));
    const auto across = [](const std::array<Deviator<Rational>, 4>& four) {
      return tensortopo::detail::normalized(
          characteristic_direction(TetrahedronField<Rational>{four}));
    };
    const Rational zero(0), one(1);
    Deviator<Rational> n1{}, n2{};
    for (const Deviator<Rational>& axis : {Deviator<Rational>{one, zero, zero, zero, zero},
                                           {zero, one, zero, zero, zero},
                                           {zero, zero, one, zero, zero},
                                           {zero, zero, zero, one, zero},
                                           {zero, zero, zero, zero, one}}) {
      n1 = across({t[0], t[1], t[2], axis});
      if (norm_form(n1) > 0) break;
    }
    n2 = across({t[0], t[1], t[2], n1});
    n1_ = enclosure(n1), n2_ = enclosure(n2);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto d = across({t[i == 0 ? 1 : 0], t[i == 2 ? 1 : 2], n1, n2});
      const Rational side = norm_form(t[i], d);
      const Rational sign = side > 0 ? 1 : -1;
      dual_[i] = thrice(enclosure(Deviator<Rational>(sign * d)));
      const Range scale =
          root_of(norm_form(corners_[i])) / root_of(enclosure(Rational(norm_form(t[i]))));
      sides_[i] = enclosure(Rational(sign * side)) * scale;
    }
  }

  void run(std::vector<CriticalPoint>& points) const {
    half(n1_, n2_, points);
    half(n2_, n1_, points);
  }

 private:
  void half(const Tensor& a, const Tensor& b, std::vector<CriticalPoint>& points) const {
    const Line line(a, b);
    const Polynomial cubic = line.critical_cubic();
    std::array<Polynomial, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) weights[i] = line.critical_weight(dual_[i]);
    // Weights of both signs: the point is outside.
    const auto is_outside = [&](const Range& x) {
      bool positive = false, negative = false;
      for (const auto& w : weights) {
        const Range value = range_of(w, x);
        positive |= value.inf() > 0;
        negative |= value.sup() < 0;
      }
      return positive && negative;
    };
    // The lines a + x b and b + x a share their ends: a zero there is found twice, so not counted.
    constexpr double kOnce = 1 - 0x1p-30;
    for (IntervalRoot root : interval_roots(cubic, -1, 1, is_outside)) {
      if (is_outside(root.x)) continue;
      root.is_certain &= root.x.inf() > -kOnce && root.x.sup() < kOnce;
      // G has mode <= 0, and counts if no weight is negative; -G has mode >= 0.
      std::array<Range, 3> w;
      bool some_positive = false, some_negative = false;
      for (std::size_t i = 0; i < 3; ++i) {
        w[i] = range_of(weights[i], root.x) / sides_[i];
        some_positive |= w[i].inf() > 0;
        some_negative |= w[i].sup() < 0;
      }
      if (!some_negative) points.push_back(point_at(line, a + root.x * b, w, root, -1));
      if (!some_positive) points.push_back(point_at(line, a + root.x * b, w, root, 1));
    }
  }

  /// mode(N)^2 over where a zero may be; in parts if it may be in many places, as then the mode of
  /// N hardly changes.
  static Range gap_over(const Line& line, const IntervalRoot& root) {
    bool is_defined = true;
    const auto value = [&](const Range& x) {
      const Range p = horner(line.norm, x);
      is_defined &= p.inf() > 0;
      return Range(2) * CGAL::square(horner(line.determinant, x)) / (p * p * p);
    };
    const Polynomial increase = increase_along(line);
    const auto slope = [&](const Range& x) {
      const Range p = range_of(line.norm, x);
      is_defined &= p.inf() > 0;
      return Range(2) * range_of(line.determinant, x) * range_of(increase, x) / CGAL::square(p * p);
    };
    double low = 1, high = 0;
    const auto take = [&](const Range& gap) {
      low = std::min(low, gap.inf());
      high = std::max(high, gap.sup());
    };
    if (root.is_certain)
      take(value(root.x));
    else
      in_parts(root.x, value, slope, take);
    return is_defined ? Range(std::min(low, high), high) : Range(0, 1);
  }

  /// @param sign  of the mode, and opposite to that of the weights
  CriticalPoint point_at(const Line& line, const Tensor& n, const std::array<Range, 3>& weights,
                         const IntervalRoot& root, int sign) const {
    CriticalPoint point;
    point.towards.assign(around_.size(), Verdict::unknown);
    bool is_inside = true;
    std::array<double, 3> about{};
    for (std::size_t i = 0; i < 3; ++i) {
      is_inside &= (Range(-sign) * weights[i]).inf() > 0;
      about[i] = std::abs(middle(weights[i]));
    }
    set_weights(point, about, given_, corners_);
    narrow_by_gap(point, gap_over(line, root), Range(sign));
    if (!root.is_certain || !is_inside) return point;
    const Range p = range_of(line.norm, root.x), q = range_of(line.determinant, root.x);
    const Tensor t = Range(-sign) * normalized(critical_tensor(thrice(n), p, q));
    enclose_mode(point, t);
    point.deviator = box_of(t);
    const Derivatives<Range> d(t);
    const Tensor u = corners_[1] - corners_[0], v = corners_[2] - corners_[0];
    const Range uu = d.second(u, u), uv = d.second(u, v), vv = d.second(v, v);
    const Range det = uu * vv - uv * uv;
    if (!is_not_zero(det)) return point;
    point.index = det.sup() < 0 ? 1 : uu.inf() > 0 ? 0 : uu.sup() < 0 ? 2 : -1;
    point.is_certain = point.index >= 0;
    if (point.is_certain) look_around(point, d, around_);
    return point;
  }

  const std::array<SymmetricTensor<double>, 3>& given_;
  std::span<const SymmetricTensor<double>> around_;
  std::array<Tensor, 3> corners_;
  Tensor n1_, n2_;
  std::array<SymmetricTensor<Range>, 3> dual_;
  std::array<Range, 3> sides_;
};

}  // namespace

std::vector<CriticalPoint> critical_points_on_face(
    const std::array<SymmetricTensor<double>, 3>& face,
    std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  FaceSearch search(face, around);
  std::vector<CriticalPoint> points;
  if (search.prepare()) {
    search.run(points);
  } else if (are_independent(face)) {
    search.prepare_in_rationals();
    search.run(points);
  }
  return points;
}

}  // namespace tensortopo
