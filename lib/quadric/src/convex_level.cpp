// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "convex_level.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cell_scale.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

constexpr double kEntryError = QuadricForm::kError, kSmallestSize = QuadricForm::kSmallestSize;

/// Errors of determinants of order n whose entries are at most 1 and wrong by kEntryError: below
/// n! n kEntryError, and as much again for the rounding of the determinant.
constexpr std::array<double, 5> kDeterminantError{0, 2 * kEntryError, 8 * kEntryError,
                                                  40 * kEntryError, 240 * kEntryError};

template <class Scalar>
Scalar combine(const std::array<Scalar, 4>& values, const GridPoint& p) {
  Scalar sum(0);
  for (std::size_t i = 0; i < 4; ++i) sum += Scalar(p[i]) * values[i];
  return sum;
}

template <class Form>
auto combine(const Form& form, const GridPoint& p, const GridPoint& r) {
  using Scalar = std::decay_t<decltype(form[0][0])>;
  Scalar sum(0);
  for (std::size_t i = 0; i < 4; ++i)
    if (p[i] != 0) sum += Scalar(p[i]) * combine(form[i], r);
  return sum;
}

Side side_of_trace(int nappe, int trace_sign) {
  if (nappe == 0) return Side::inside;
  if (trace_sign == 0) return Side::zero;
  return trace_sign == nappe ? Side::inside : Side::opposite;
}

int sign(const Rational& r) { return r > 0 ? 1 : r < 0 ? -1 : 0; }

}  // namespace

ConvexLevel::ConvexLevel(const InvariantLevel& level, int which)
    : QuadraticLevel(level), nappe(which) {
  const bool is_cone = level.invariant() == Invariant::anisotropy;
  if (is_cone != (nappe == 1 || nappe == -1) || (!is_cone && nappe != 0))
    throw std::invalid_argument("ConvexLevel: an anisotropy has the nappes 1 and -1, others 0");
}

struct CellForm::Exact {
  SquareMatrix<Rational, 4> form;
  std::array<Rational, 4> trace;
};

CellForm::CellForm(const ConvexLevel& level,
                   const std::array<const SymmetricTensor<double>*, 4>& tensors)
    : level_(level), tensors_(tensors), form_(level, tensors) {
  const CellScale scale(tensors);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto t = scale(*tensors[i]);
    size_[i] = form_.size(i);
    trace_[i] = trace(t);
    trace_size_[i] = std::abs(t.xx) + std::abs(t.yy) + std::abs(t.zz);
  }
}

CellForm::~CellForm() = default;

const CellForm::Exact& CellForm::exact() const {
  ++exact_answers_;
  if (exact_) return *exact_;
  exact_ = std::make_unique<Exact>();
  for (std::size_t i = 0; i < 4; ++i) {
    exact_->trace[i] = trace(tensor_cast<Rational>(*tensors_[i]));
    for (std::size_t j = 0; j <= i; ++j)
      exact_->form[i][j] = exact_->form[j][i] = form_.exact(i, j);
  }
  return *exact_;
}

bool CellForm::is_clearly_outside() const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(size_[i] > kSmallestSize)) return false;
    for (std::size_t j = 0; j <= i; ++j)
      if (!(form_[i][j] > kEntryError * size_[i] * size_[j])) return false;
  }
  return true;
}

Side CellForm::side(const GridPoint& p) const {
  const double size = combine(size_, p), value = combine(form_, p, p);
  if (size > kSmallestSize) {
    const double bound = kEntryError * size * size;
    if (value > bound) return Side::outside;
    if (value < -bound) {
      if (level_.nappe == 0) return Side::inside;
      const double t = combine(trace_, p), t_bound = kEntryError * combine(trace_size_, p);
      if (std::abs(t) > t_bound) return side_of_trace(level_.nappe, t > 0 ? 1 : -1);
    }
  }
  const Exact& form = exact();
  if (combine(form.form, p, p) > 0) return Side::outside;
  return side_of_trace(level_.nappe, sign(combine(form.trace, p)));
}

bool CellForm::is_on_level(const GridPoint& p) const {
  const double size = combine(size_, p);
  if (size > kSmallestSize && std::abs(combine(form_, p, p)) > kEntryError * size * size)
    return false;
  return combine(exact().form, p, p) == 0 && side(p) != Side::zero;
}

/// Whether a zero tensor is in an open face, none being on the smaller ones: the
/// Gram matrix is singular and its kernel, spanned by the cofactors, positive.
template <std::size_t Corners>
bool CellForm::has_zero_inside(unsigned mask) const {
  SquareMatrix<Rational, Corners> gram;
  std::array<SymmetricTensor<Rational>, Corners> tensors;
  std::size_t k = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1) tensors[k++] = tensor_cast<Rational>(*tensors_[i]);
  for (std::size_t i = 0; i < Corners; ++i)
    for (std::size_t j = 0; j < Corners; ++j) gram[i][j] = inner(tensors[i], tensors[j]);
  if constexpr (Corners == 1) {
    return gram[0][0] == 0;
  } else {
    const auto cofactors = last_cofactors<Rational, Corners>(gram);
    for (const auto& c : cofactors)
      if (!(c > 0)) return false;
    return determinant_of<Rational, Corners>(gram) == 0;
  }
}

bool CellForm::holds_zero() const {
  for (const auto component :
       {&SymmetricTensor<double>::xx, &SymmetricTensor<double>::yy, &SymmetricTensor<double>::zz,
        &SymmetricTensor<double>::xy, &SymmetricTensor<double>::yz, &SymmetricTensor<double>::xz}) {
    int positive = 0, negative = 0;
    for (const auto* t : tensors_) {
      positive += t->*component > 0;
      negative += t->*component < 0;
    }
    if (positive == 4 || negative == 4) return false;
  }
  // Independent tensors have no zero among their sums.
  const CellScale scale(tensors_);
  std::array<SymmetricTensor<double>, 4> unit;
  for (std::size_t i = 0; i < 4; ++i) {
    unit[i] = scale(*tensors_[i]);
    unit[i] = (1 / std::sqrt(inner(unit[i], unit[i]))) * unit[i];
  }
  SquareMatrix<double, 4> gram;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) gram[i][j] = inner(unit[i], unit[j]);
  if (determinant_of<double, 4>(gram) > kDeterminantError[4]) return false;
  ++exact_answers_;
  for (unsigned mask = 1; mask < 16; ++mask) {
    const int corners = std::popcount(mask);
    if ((corners == 1 && has_zero_inside<1>(mask)) || (corners == 2 && has_zero_inside<2>(mask)) ||
        (corners == 3 && has_zero_inside<3>(mask)) || (corners == 4 && has_zero_inside<4>(mask)))
      return true;
  }
  return false;
}

template <std::size_t Corners>
Side CellForm::meeting_of(std::span<const GridPoint> corners) const {
  std::array<double, Corners> size;
  bool measurable = true;
  for (std::size_t i = 0; i < Corners; ++i) {
    size[i] = combine(size_, corners[i]);
    measurable &= size[i] > kSmallestSize && std::isfinite(size[i]);
  }
  if (measurable) {
    // A positive diagonal scaling does not change signs.
    SquareMatrix<double, Corners> a;
    for (std::size_t i = 0; i < Corners; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        a[i][j] = a[j][i] = combine(form_, corners[i], corners[j]) / (size[i] * size[j]);
    const auto cofactors = last_cofactors<double, Corners>(a);
    const auto [least, most] = std::minmax_element(cofactors.begin(), cofactors.end());
    if (*least < -kDeterminantError[Corners - 1]) return Side::outside;
    double determinant = 0;
    for (std::size_t j = 0; j < Corners; ++j) determinant += a[Corners - 1][j] * cofactors[j];
    if (determinant > kDeterminantError[Corners]) return Side::outside;
    if (*least > kDeterminantError[Corners - 1] && determinant < -kDeterminantError[Corners]) {
      if (level_.nappe == 0) return Side::inside;
      double t = 0, t_bound = 0;
      for (std::size_t i = 0; i < Corners; ++i) {
        const double weight = cofactors[i] / size[i];
        const double m = combine(trace_size_, corners[i]) / size[i];
        t += weight * combine(trace_, corners[i]);
        t_bound += (kEntryError * *most + kDeterminantError[Corners - 1]) * m;
      }
      if (std::abs(t) > t_bound) return side_of_trace(level_.nappe, t > 0 ? 1 : -1);
    }
  }
  const Exact& form = exact();
  SquareMatrix<Rational, Corners> a;
  for (std::size_t i = 0; i < Corners; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      a[i][j] = a[j][i] = combine(form.form, corners[i], corners[j]);
  const auto cofactors = last_cofactors<Rational, Corners>(a);
  if (is_positive_inside<Rational, Corners>(a, cofactors)) return Side::outside;
  Rational t(0);
  for (std::size_t i = 0; i < Corners; ++i) t += cofactors[i] * combine(form.trace, corners[i]);
  return side_of_trace(level_.nappe, sign(t));
}

Side CellForm::meeting(std::span<const GridPoint> corners) const {
  switch (corners.size()) {
    case 2:
      return meeting_of<2>(corners);
    case 3:
      return meeting_of<3>(corners);
    case 4:
      return meeting_of<4>(corners);
  }
  throw std::invalid_argument("CellForm::meeting: two to four corners");
}

}  // namespace tensortopo
