// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/quadric/quadric_form.hpp"

#include <cmath>

#include "cell_scale.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

QuadraticLevel::QuadraticLevel(const InvariantLevel& level) : value(level.approx()) {
  const Rational exact(level.text()), square = exact * exact;
  if (level.invariant() == Invariant::anisotropy) {
    tau = -square / (1 - square);
    return;
  }
  tau = level.invariant() == Invariant::magnitude ? 1 : 0;
  gamma = 3 * square;
}

/// kError: a size is the root of 3 P + |tau| m^2 + gamma, m being the sum of the absolute diagonal,
/// so a polar form evaluated in absolute values stays below the product (that of P below 3 times
/// the roots). A term passes through less than 40 roundings: 2 in a deviator, 6 in P, 8 in
/// tau tr tr, 4 in gamma, 20 in the sum over coordinates. Underflow adds less than 2^-1000, little
/// beside the square of the smallest size admitted.
QuadricForm::QuadricForm(const QuadraticLevel& level,
                     const std::array<const SymmetricTensor<double>*, 4>& tensors)
    : level_(level), tensors_(tensors) {
  const CellScale scale(tensors);
  const double tau = level.tau.convert_to<double>();
  const double value = level.gamma == 0 ? 0 : std::ldexp(level.value, scale.exponent);
  const double gamma = 3 * value * value;
  std::array<Deviator<double>, 4> deviators;
  std::array<double, 4> traces;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto t = scale(*tensors[i]);
    deviators[i] = deviator(t);
    traces[i] = trace(t);
    const double trace_size = std::abs(t.xx) + std::abs(t.yy) + std::abs(t.zz);
    size_[i] = std::sqrt(3 * norm_form(deviators[i]) +
                         std::abs(tau) * trace_size * trace_size + gamma);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      form_[i][j] = form_[j][i] =
          norm_form(deviators[i], deviators[j]) + tau * (traces[i] * traces[j]) - gamma;
}

Rational QuadricForm::exact(std::size_t i, std::size_t j) const {
  const auto s = tensor_cast<Rational>(*tensors_[i]), t = tensor_cast<Rational>(*tensors_[j]);
  return norm_form(deviator(s), deviator(t)) + level_.tau * (trace(s) * trace(t)) - level_.gamma;
}

}  // namespace tensortopo
