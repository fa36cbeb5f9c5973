// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "interval_roots.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

using namespace detail;
using Tensor = IntervalTensor;

Tensor enclosure(const SymmetricTensor<double>& t) { return normalized(deviator_enclosure(t)); }

template <std::size_t Count>
std::array<Tensor, Count> enclosures(const std::array<SymmetricTensor<double>, Count>& tensors) {
  std::array<Tensor, Count> t;
  for (std::size_t i = 0; i < Count; ++i) t[i] = enclosure(tensors[i]);
  return t;
}

template <std::size_t Count>
bool are_independent(const std::array<SymmetricTensor<double>, Count>& tensors) {
  return exact_rank(std::span<const SymmetricTensor<double>>(tensors)) == int{Count};
}

Verdict sign_in(const Range& x) {
  if (x.inf() > 0) return Verdict::positive;
  if (x.sup() < 0) return Verdict::negative;
  return Verdict::unknown;
}

Range root_of(const Range& x) { return CGAL::sqrt(Range(std::max(x.inf(), 0.0), x.sup())); }

/// The mode is in [low, high] given that its square is 1 - gap.
void narrow_by_gap(CriticalPoint& point, const Range& gap, const Range& determinant) {
  const Range size = root_of(Range(1) - Range(std::max(gap.inf(), 0.0), std::min(gap.sup(), 1.0)));
  const bool up = determinant.inf() >= 0, down = determinant.sup() <= 0;
  if (!up) point.low = std::max(point.low, -size.sup());
  if (!down) point.high = std::min(point.high, size.sup());
  if (up) point.low = std::max(point.low, size.inf());
  if (down) point.high = std::min(point.high, -size.inf());
}

/// Encloses the mode of a tensor: by the quotient, and next to 1 and -1 by the discriminant.
void enclose_mode(CriticalPoint& point, const Tensor& t) {
  const Range p = norm_form(t), q = determinant_form(t);
  if (!(p.inf() > 0)) return;
  const Range quotient = root_of(Range(2)) * q / (p * root_of(p));
  point.low = std::max(point.low, quotient.inf());
  point.high = std::min(point.high, quotient.sup());
  narrow_by_gap(point, degenerate_gap(t), q);
}

/// The first and second derivative of the mode at a tensor, times positive numbers; the second
/// one where the first vanishes.
struct Derivatives {
  explicit Derivatives(const Tensor& at)
      : t(at), m(thrice(at)), mm(square(m)), p(norm_form(at)), q(determinant_form(at)) {}

  Range first(const Tensor& u) const {
    return Range(2) * p * inner(mm, thrice(u)) - Range(6) * q * norm_form(t, u);
  }
  // From Q - mode P^(3/2), as Q = tr M^3 / 3 for M three times a traceless tensor.
  Range second(const Tensor& u, const Tensor& v) const {
    const auto k = thrice(v);
    const Range cubic = inner(square(m + k) - mm - square(k), thrice(u));
    return Range(4) * p * p * cubic - Range(12) * p * q * norm_form(u, v) -
           Range(12) * q * norm_form(t, u) * norm_form(t, v);
  }

  Tensor t;
  SymmetricTensor<Range> m, mm;
  Range p, q;
};

void look_around(CriticalPoint& point, const Derivatives& d,
                 std::span<const SymmetricTensor<double>> around) {
  for (std::size_t i = 0; i < around.size(); ++i)
    point.towards[i] = sign_in(d.first(enclosure(around[i])));
}

/// Weights of the tensors as given from those of normalized ones.
template <std::size_t Count>
void set_weights(CriticalPoint& point, std::array<double, Count> weights,
                 const std::array<SymmetricTensor<double>, Count>& given,
                 const std::array<Tensor, Count>& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto d = deviator(given[i]);
    const double scale = norm_form(d) > 0 ? std::sqrt(norm_form(middle(normal[i])) / norm_form(d)) : 1;
    sum += weights[i] = std::max(weights[i] * scale, 0.0);
  }
  for (std::size_t i = 0; i < Count; ++i)
    point.weights[i] = sum > 0 && std::isfinite(sum) ? weights[i] / sum : 1.0 / Count;
}

/// The tensors critical on what is orthogonal to N (given by its line and a place on it), up to
/// sign: N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N, times a positive number.
Tensor critical_tensor(const SymmetricTensor<Range>& m, const Range& p, const Range& q) {
  return deviator(p * square(m) - q * m);
}

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

  void run(std::vector<CriticalPoint>& points) const {
    half(n1_, n2_, points);
    half(n2_, n1_, points);
  }

 private:
  void half(const Tensor& a, const Tensor& b, std::vector<CriticalPoint>& points) const {
    const Line line(a, b);
    const Polynomial cubic = minus(times(line.quadratic(line.m), line.linear(line.k)),
                                   times(line.quadratic(line.k), line.linear(line.m)));
    std::array<Polynomial, 3> weights;
    for (std::size_t i = 0; i < 3; ++i)
      weights[i] = minus(times(line.norm, line.quadratic(dual_[i])),
                         times(line.determinant, line.linear(dual_[i])));
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
    constexpr double kOnce = 1 - 1e-9;
    for (IntervalRoot root : interval_roots(cubic, -1, 1, is_outside)) {
      if (is_outside(root.x)) continue;
      root.is_certain &= root.x.inf() > -kOnce && root.x.sup() < kOnce;
      points.push_back(point_at(line, a + root.x * b, weights, root));
    }
  }

  CriticalPoint point_at(const Line& line, const Tensor& n, const std::array<Polynomial, 3>& weights,
                         const IntervalRoot& root) const {
    CriticalPoint point;
    point.towards.assign(around_.size(), Verdict::unknown);
    const Range p = range_of(line.norm, root.x), q = range_of(line.determinant, root.x);
    std::array<Range, 3> w;
    bool positive = true, negative = true;
    std::array<double, 3> about{};
    for (std::size_t i = 0; i < 3; ++i) {
      w[i] = range_of(weights[i], root.x) / sides_[i];
      positive &= w[i].inf() > 0;
      negative &= w[i].sup() < 0;
      about[i] = std::abs(middle(w[i]));
    }
    set_weights(point, about, given_, corners_);
    // G itself has mode <= 0, and -G mode >= 0.
    if (p.inf() > 0)
      narrow_by_gap(point, Range(2) * CGAL::square(q) / (p * p * p),
                    positive ? Range(-1) : negative ? Range(1) : Range(-1, 1));
    if (!root.is_certain || !(positive || negative)) return point;
    const Tensor g = normalized(critical_tensor(thrice(n), p, q));
    const Tensor t = positive ? g : Range(-1) * g;
    enclose_mode(point, t);
    const Derivatives d(t);
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

/// What is critical in a tetrahedron: G, made of the characteristic tensor N, or -G.
struct Saddle {
  Tensor g;
  Range p, q;                    ///< of N
  std::array<Range, 4> weights;  ///< of G in normalized vertex tensors
  bool positive = false, negative = false;  ///< all weights are
  bool mixed = false;                       ///< some are positive, some negative

  void set_signs() {
    int up = 0, down = 0;
    for (const Range& w : weights) up += w.inf() > 0, down += w.sup() < 0;
    positive = up == 4, negative = down == 4, mixed = up > 0 && down > 0;
  }
  bool is_outside() const { return mixed; }
  bool is_inside() const { return positive || negative; }
};

Saddle saddle_in_intervals(const std::array<Tensor, 4>& corners) {
  Saddle saddle;
  const Tensor n = orthogonal_to(spread_out(corners));
  saddle.p = norm_form(n), saddle.q = determinant_form(n);
  saddle.g = normalized(critical_tensor(thrice(n), saddle.p, saddle.q));
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor dual = dual_tensor(corners, i, n);
    saddle.weights[i] = norm_form(saddle.g, dual) / norm_form(corners[i], dual);
  }
  saddle.set_signs();
  return saddle;
}

Range enclosure(const Rational& x) {
  if (x == 0) return Range(0);
  const double about = static_cast<double>(x);
  return {std::nextafter(about, -HUGE_VAL), std::nextafter(about, HUGE_VAL)};
}

/// Divided by a number such that the largest component is 1.
Deviator<Rational> normalized(const Deviator<Rational>& t) {
  Rational largest = 0;
  for (const Rational& x : {t.a, t.b, t.xy, t.yz, t.xz})
    largest = std::max(largest, Rational(abs(x)));
  return largest == 0 ? t : (Rational(1) / largest) * t;
}

/// The same where the vertex tensors are nearly dependent, in rationals. (`normalized` ones differ
/// from those given by powers of two.)
/// @pre they are independent
Saddle saddle_in_rationals(const std::array<SymmetricTensor<double>, 4>& given,
                           const std::array<Tensor, 4>& corners) {
  Saddle saddle;
  TetrahedronField<Rational> field;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& t = given[i];
    field.vertex[i] = deviator(SymmetricTensor<Rational>{
        Rational(t.xx), Rational(t.yy), Rational(t.zz), Rational(t.xy), Rational(t.yz),
        Rational(t.xz)});
  }
  const auto n = normalized(characteristic_direction(field));
  const Rational p = norm_form(n), q = determinant_form(n);
  const auto m = thrice(n);
  const auto g = normalized(deviator(p * square(m) - q * m));
  saddle.p = enclosure(p), saddle.q = enclosure(q);
  saddle.g = {enclosure(g.a), enclosure(g.b), enclosure(g.xy), enclosure(g.yz), enclosure(g.xz)};
  for (std::size_t i = 0; i < 4; ++i) {
    TetrahedronField<Rational> others = field;
    others.vertex[i] = n;
    const auto dual = characteristic_direction(others);
    const Range scale = root_of(norm_form(corners[i])) /
                        root_of(enclosure(Rational(norm_form(field.vertex[i]))));
    saddle.weights[i] =
        enclosure(Rational(norm_form(g, dual) / norm_form(field.vertex[i], dual))) / scale;
  }
  saddle.set_signs();
  return saddle;
}

}  // namespace

CriticalPoint critical_vertex(const SymmetricTensor<double>& tensor,
                              std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  CriticalPoint point;
  point.weights[0] = 1;
  point.is_certain = true;
  point.towards.assign(around.size(), Verdict::unknown);
  const Tensor t = enclosure(tensor);
  enclose_mode(point, t);
  look_around(point, Derivatives(t), around);
  return point;
}

std::vector<CriticalPoint> critical_points_on_edge(
    const std::array<SymmetricTensor<double>, 2>& edge,
    std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  const auto ends = enclosures(edge);
  const Tensor step = ends[1] - ends[0];
  const Line line(ends[0], step);
  Polynomial q_part = times(line.norm, derivative(line.determinant));
  Polynomial p_part = times(derivative(line.norm), line.determinant);
  for (auto& c : q_part) c *= Range(2);
  for (auto& c : p_part) c *= Range(3);
  Polynomial increase = minus(q_part, p_part);
  increase[4] = Range(0);  // 2 * 3 - 3 * 2 times the same
  const auto nowhere = [](const Range&) { return false; };
  const auto roots = interval_roots(increase, 0, 1, nowhere);
  const auto is_vague = [](const IntervalRoot& root) { return !root.is_certain; };
  if (std::any_of(roots.begin(), roots.end(), is_vague) && !are_independent(edge)) return {};
  std::vector<CriticalPoint> points;
  for (const IntervalRoot& root : roots) {
    CriticalPoint point;
    point.towards.assign(around.size(), Verdict::unknown);
    const Tensor t = ends[0] + root.x * step;
    const double x = middle(root.x);
    set_weights(point, std::array{1 - x, x}, edge, ends);
    enclose_mode(point, t);
    point.is_certain = root.is_certain;
    point.index = root.slope < 0 ? 1 : 0;
    if (point.is_certain) look_around(point, Derivatives(t), around);
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<CriticalPoint> critical_points_on_face(
    const std::array<SymmetricTensor<double>, 3>& face,
    std::span<const SymmetricTensor<double>> around) {
  const UpwardRounding upward;
  FaceSearch search(face, around);
  std::vector<CriticalPoint> points;
  if (search.prepare()) {
    search.run(points);
  } else if (are_independent(face)) {
    CriticalPoint anywhere;
    anywhere.weights = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
    anywhere.towards.assign(around.size(), Verdict::unknown);
    points.push_back(anywhere);
  }
  return points;
}

std::vector<CriticalPoint> critical_points_in_tet(
    const std::array<SymmetricTensor<double>, 4>& tensors) {
  const UpwardRounding upward;
  const auto corners = enclosures(tensors);
  auto saddle = saddle_in_intervals(corners);
  if (saddle.is_outside()) return {};
  if (!saddle.is_inside()) {
    if (!are_independent(tensors)) return {};
    saddle = saddle_in_rationals(tensors, corners);
    if (saddle.is_outside()) return {};
  }
  CriticalPoint point;
  std::array<double, 4> about{};
  for (std::size_t i = 0; i < 4; ++i) about[i] = std::abs(middle(saddle.weights[i]));
  set_weights(point, about, tensors, corners);
  // G itself has mode <= 0, and -G mode >= 0.
  const int sign = saddle.positive ? -1 : saddle.negative ? 1 : 0;
  if (saddle.p.inf() > 0)
    narrow_by_gap(point, Range(2) * CGAL::square(saddle.q) / (saddle.p * saddle.p * saddle.p),
                  sign == 0 ? Range(-1, 1) : Range(sign));
  if (sign == 0) return {point};
  const Tensor t = Range(-sign) * saddle.g;
  enclose_mode(point, t);
  const Derivatives d(t);
  const std::array<Tensor, 3> u{corners[1] - corners[0], corners[2] - corners[0],
                                corners[3] - corners[0]};
  const Range xx = d.second(u[0], u[0]), yy = d.second(u[1], u[1]), zz = d.second(u[2], u[2]),
              xy = d.second(u[0], u[1]), yz = d.second(u[1], u[2]), xz = d.second(u[0], u[2]);
  const Range det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  // It is a saddle: the mode falls in one direction or in two.
  point.is_certain = is_not_zero(det);
  point.index = det.sup() < 0 ? 1 : 2;
  return {point};
}

}  // namespace tensortopo
