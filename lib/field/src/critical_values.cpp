// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_values.hpp"

#include <array>
#include <vector>

#include "rational_polynomial.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

namespace {

using detail::RationalPolynomial;
using detail::tarski_query;
using Tensor = Deviator<Rational>;

// Squares of modes from one, which belongs to the range or not, to the other, which does.
struct SquaredModes {
  Rational from, to;
  OwnLevel own;

  // Of the tensors orthogonal to the critical ones.
  SquaredModes of_complement() const { return {Rational(1) - from, Rational(1) - to, own}; }

  bool contain(const Tensor& t) const {
    const Rational p = norm_form(t), q = determinant_form(t);
    const Rational cube = p * p * p, twice = Rational(2) * q * q;
    const Sign at_from = sign_of(Rational(twice - from * cube)),
               at_to = sign_of(Rational(twice - to * cube));
    return at_from * at_to == Sign::negative || at_to == Sign::zero ||
           (at_from == Sign::zero && own == OwnLevel::included);
  }
};

// A positive multiple in integers: of the same mode, and so are the values on its spans.
Tensor in_integers(const Tensor& t) {
  std::array<Rational, 5> x{t.a, t.b, t.xy, t.yz, t.xz};
  detail::make_primitive(x);
  return {x[0], x[1], x[2], x[3], x[4]};
}

Tensor exact(const SymmetricTensor<double>& t) {
  return in_integers(deviator(tensor_cast<Rational>(t)));
}

// P and Q on the tensors a + x b.
struct Line {
  Line(const Tensor& a, const Tensor& b) : m(thrice(a)), k(thrice(b)) {
    const auto mm = square(m), kk = square(k);
    squares = {mm, square(m + k) - mm - kk, kk};
    norm = polynomial({norm_form(a), 2 * norm_form(a, b), norm_form(b)});
    // Q of a traceless tensor is a third of the trace of the cube of its multiple.
    determinant =
        polynomial({determinant_form(a), inner(mm, k), inner(kk, m), determinant_form(b)});
  }

  static RationalPolynomial polynomial(std::vector<Rational> coefficients) {
    return RationalPolynomial(coefficients.begin(), coefficients.end());
  }
  RationalPolynomial linear(const SymmetricTensor<Rational>& t) const {
    return polynomial({inner(m, t), inner(k, t)});
  }
  RationalPolynomial quadratic(const SymmetricTensor<Rational>& t) const {
    return polynomial({inner(squares[0], t), inner(squares[1], t), inner(squares[2], t)});
  }
  // 2 Q^2 - c P^3, times a positive number: the sign of mode^2 - c.
  RationalPolynomial level_form(const Rational& c) const {
    return Rational(2 * denominator(c)) * determinant * determinant -
           Rational(numerator(c)) * (norm * norm * norm);
  }
  // Zero where the mode is critical along the line.
  RationalPolynomial increase() const {
    return Rational(2) * norm * determinant.prime() - Rational(3) * determinant * norm.prime();
  }
  // Zero where a tensor that is critical on the complement belongs to N; see `critical_gaps`.
  RationalPolynomial cubic() const { return quadratic(m) * linear(k) - quadratic(k) * linear(m); }

  SymmetricTensor<Rational> m, k;
  std::array<SymmetricTensor<Rational>, 3> squares;
  RationalPolynomial norm, determinant;
};

// Whether no zero has its mode, squared, in a range.
bool are_outside(const RationalPolynomial& zeros, const Line& line, const SquaredModes& modes) {
  const auto at_from = line.level_form(modes.from), at_to = line.level_form(modes.to);
  const auto all = tarski_query(zeros, RationalPolynomial{Rational(1)});
  if (tarski_query(zeros, at_to * at_to) != all) return false;
  const bool own = modes.own == OwnLevel::included;
  const auto product = at_from * at_to;
  const auto apart = tarski_query(zeros, product * product);
  return tarski_query(zeros, product) == apart && (!own || apart == all);
}

// A line such that no zero of a form of the degree given is at infinity; nothing if it has more
// zeros than that.
template <class Form>
std::vector<Line> line_with_all_zeros(const Tensor& a, const Tensor& b, std::size_t degree,
                                      const Form& form) {
  for (std::size_t turn = 0; turn <= degree; ++turn) {
    Line line(a, b + Rational(static_cast<int>(turn)) * a);
    const RationalPolynomial zeros = form(line);
    if (!zeros.is_zero() && zeros.degree() == degree) return {line};
  }
  return {};
}

// Two independent tensors orthogonal to three.
std::array<Tensor, 2> complement(const std::array<Tensor, 3>& t) {
  const Rational zero(0), one(1);
  for (const Tensor& axis :
       {Tensor{one, zero, zero, zero, zero}, Tensor{zero, one, zero, zero, zero},
        Tensor{zero, zero, one, zero, zero}, Tensor{zero, zero, zero, one, zero}}) {
    const Tensor first =
        in_integers(characteristic_direction(TetrahedronField<Rational>{{t[0], t[1], t[2], axis}}));
    if (norm_form(first) == 0) continue;
    return {first, in_integers(characteristic_direction(
                       TetrahedronField<Rational>{{t[0], t[1], t[2], first}}))};
  }
  return {};  // not reached: three tensors span no more than three axes
}

const auto increase_of = [](const Line& line) { return line.increase(); };
const auto cubic_of = [](const Line& line) { return line.cubic(); };

bool edge_is_free(const Tensor& a, const Tensor& b, const SquaredModes& modes) {
  const auto line = line_with_all_zeros(a, b, 3, increase_of);
  // The mode is constant: its value is that at the vertices.
  if (line.empty()) return true;
  return are_outside(line[0].increase(), line[0], modes);
}

bool face_is_free(const std::array<Tensor, 3>& t, const SquaredModes& modes) {
  const auto [a, b] = complement(t);
  const auto line = line_with_all_zeros(a, b, 3, cubic_of);
  // On a plane of symmetry all N are neutral, and the critical values are 1 and -1.
  if (line.empty()) return Line(a, b).determinant.is_zero();
  return are_outside(line[0].cubic(), line[0], modes.of_complement());
}

}  // namespace

bool is_free_of_critical_values(std::span<const SymmetricTensor<double>> tensors,
                                const ModeValue& mu, const ModeValue& other, OwnLevel own) {
  const auto from = to_scalar<Rational>(mu), to = to_scalar<Rational>(other);
  const SquaredModes modes{from * from, to * to, own};
  for (unsigned chosen = 1; chosen < (1u << tensors.size()); ++chosen) {
    std::vector<SymmetricTensor<double>> given;
    std::vector<Tensor> part;
    for (std::size_t i = 0; i < tensors.size(); ++i)
      if (chosen >> i & 1) {
        given.push_back(tensors[i]);
        part.push_back(exact(tensors[i]));
      }
    // Dependent tensors span no more than some of them.
    if (exact_rank(std::span<const SymmetricTensor<double>>(given)) <
        static_cast<int>(given.size()))
      continue;
    const bool is_free =
        part.size() == 1   ? !modes.contain(part[0])
        : part.size() == 2 ? edge_is_free(part[0], part[1], modes)
        : part.size() == 3 ? face_is_free({part[0], part[1], part[2]}, modes)
                           : !modes.of_complement().contain(characteristic_direction(
                                 TetrahedronField<Rational>{{part[0], part[1], part[2], part[3]}}));
    if (!is_free) return false;
  }
  return true;
}

bool is_critical_on_edge(const SymmetricTensor<double>& first,
                         const SymmetricTensor<double>& second, const ModeValue& mu) {
  const Tensor a = exact(first);
  const Line line(a, exact(second) - a);  // of multiples: another way to run along the edge
  RationalPolynomial zeros = line.increase();
  if (zeros.is_zero()) return false;
  // Critical points at the ends do not count.
  const RationalPolynomial at_first{Rational(0), Rational(1)}, at_second{Rational(-1), Rational(1)};
  while (zeros.evaluate(Rational(0)) == 0) zeros /= at_first;
  while (zeros.evaluate(Rational(1)) == 0) zeros /= at_second;
  const auto value = to_scalar<Rational>(mu);
  const auto form = line.level_form(value * value);
  // Zeros of the form: all less those where its square is positive. With the sign of mu: where the
  // determinant has that sign, or vanishes.
  const RationalPolynomial one{Rational(1)};
  const auto on_level = [&](const RationalPolynomial& p) {
    return detail::tarski_query_on_unit(zeros, p) -
           detail::tarski_query_on_unit(zeros, p * form * form);
  };
  const int all = on_level(one);
  if (all == 0 || value == 0) return all > 0;
  // As many more of the sign of mu as there are; they are not zero there.
  const int surplus = on_level(line.determinant) * (value > 0 ? 1 : -1);
  return all + surplus > 0;
}

bool is_critical_on_plane(const std::array<SymmetricTensor<double>, 3>& tensors,
                          const ModeValue& mu) {
  if (exact_rank(std::span<const SymmetricTensor<double>>(tensors)) < 3) return false;
  const auto [a, b] = complement({exact(tensors[0]), exact(tensors[1]), exact(tensors[2])});
  const auto line = line_with_all_zeros(a, b, 3, cubic_of);
  if (line.empty()) return false;
  const auto value = to_scalar<Rational>(mu);
  const auto form = line[0].level_form(Rational(1) - value * value);
  const auto zeros = line[0].cubic();
  return tarski_query(zeros, RationalPolynomial{Rational(1)}) > tarski_query(zeros, form * form);
}

}  // namespace tensortopo
