// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/critical_values.hpp"

#include <array>
#include <vector>

#include "rational/rational_line.hpp"
#include "rational/rational_polynomial.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/sign.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {

namespace {

using detail::exact_deviator;
using detail::rational_complement;
using detail::RationalPolynomial;
using detail::tarski_query;
using Line = detail::RationalLine;
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

const auto increase_of = [](const Line& line) { return line.increase(); };
const auto cubic_of = [](const Line& line) { return line.critical_cubic(); };

bool edge_is_free(const Tensor& a, const Tensor& b, const SquaredModes& modes) {
  const auto line = line_with_all_zeros(a, b, 3, increase_of);
  // The mode is constant: its value is that at the vertices.
  if (line.empty()) return true;
  return are_outside(line[0].increase(), line[0], modes);
}

bool face_is_free(const std::array<Tensor, 3>& t, const SquaredModes& modes) {
  const auto [a, b] = rational_complement(t);
  const auto line = line_with_all_zeros(a, b, 3, cubic_of);
  // On a plane of symmetry all N are neutral, and the critical values are 1 and -1.
  if (line.empty()) return Line(a, b).determinant.is_zero();
  return are_outside(line[0].critical_cubic(), line[0], modes.of_complement());
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
        part.push_back(exact_deviator(tensors[i]));
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
  const Tensor a = exact_deviator(first);
  const Line line(a,
                  exact_deviator(second) - a);  // of multiples: another way to run along the edge
  if (line.increase().is_zero()) return false;
  // Critical points at the ends do not count.
  const auto zeros = detail::without_zeros_at(line.increase(), {Rational(0), Rational(1)});
  const auto value = to_scalar<Rational>(mu);
  const auto form = line.level_form(value * value);
  // Zeros of the form: all less those where its square is positive. With the sign of mu: where the
  // determinant has that sign, or vanishes.
  const RationalPolynomial one{Rational(1)};
  const auto on_level = [&](const RationalPolynomial& p) {
    return tarski_query(zeros, p, Rational(0), Rational(1)) -
           tarski_query(zeros, p * form * form, Rational(0), Rational(1));
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
  const auto [a, b] = rational_complement(
      {exact_deviator(tensors[0]), exact_deviator(tensors[1]), exact_deviator(tensors[2])});
  const auto line = line_with_all_zeros(a, b, 3, cubic_of);
  if (line.empty()) return false;
  const auto value = to_scalar<Rational>(mu);
  const auto form = line[0].level_form(Rational(1) - value * value);
  const auto zeros = line[0].critical_cubic();
  return tarski_query(zeros, RationalPolynomial{Rational(1)}) > tarski_query(zeros, form * form);
}

}  // namespace tensortopo
