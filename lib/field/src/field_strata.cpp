// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/field_strata.hpp"

#include <algorithm>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

using Tensors = std::array<SymmetricTensor<double>, 4>;

template <class Scalar>
TetrahedronField<Scalar> field_of(const Tensors& tensors) {
  TetrahedronField<Scalar> field;
  for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensor_cast<Scalar>(tensors[i]));
  return field;
}

// The axial vector of the antisymmetric matrix S T - T S: zero if they commute.
Vector3<Rational> commutator_axis(const SymmetricTensor<Rational>& s,
                                  const SymmetricTensor<Rational>& t) {
  const auto entry = [&](const Vector3<Rational>& u, const Vector3<Rational>& w) {
    return Rational(dot(s * u, t * w) - dot(t * u, s * w));
  };
  const Vector3<Rational> x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  return {-entry(y, z), -entry(z, x), -entry(x, y)};
}

// A common eigenvector is in the kernel of every commutator; one that is not zero leaves only its
// axis, and tensors that all commute have all eigenvectors in common.
bool have_common_eigenvector(const TetrahedronField<Rational>& field) {
  std::array<SymmetricTensor<Rational>, 4> t;
  for (std::size_t i = 0; i < 4; ++i) t[i] = thrice(field.vertex[i]);
  const Vector3<Rational> none{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Vector3<Rational> axis = commutator_axis(t[i], t[j]);
      if (axis == none) continue;
      return std::all_of(t.begin(), t.end(), [&](const SymmetricTensor<Rational>& s) {
        return cross(axis, s * axis) == none;
      });
    }
  }
  return true;
}

// Whether a form of the characteristic direction is zero.
template <class Form>
bool is_zero(const Tensors& tensors, const Form& form) {
  const Verdict sign = certified_sign(form(characteristic_direction(field_of<Interval>(tensors))));
  if (sign != Verdict::unknown) return sign == Verdict::zero;
  return form(characteristic_direction(field_of<Rational>(tensors))) == 0;
}

}  // namespace

FieldStrata field_strata(const Tensors& tensors) {
  FieldStrata strata;
  strata.rank = exact_rank(tensors);
  for (const auto& t : tensors) {
    const bool zero = t.xx == t.yy && t.yy == t.zz && t.xy == 0 && t.yz == 0 && t.xz == 0;
    strata.zero_vertices += zero ? 1 : 0;
  }
  if (strata.rank < 4) {
    strata.common_eigenvector = have_common_eigenvector(field_of<Rational>(tensors));
    return strata;
  }
  strata.neutral_characteristic =
      is_zero(tensors, [](const auto& d) { return determinant_form(d); });
  strata.degenerate_characteristic =
      is_zero(tensors, [](const auto& d) { return discriminant_form(d); });
  return strata;
}

}  // namespace tensortopo
