// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "tensortopo/algebra/barycentric_polynomial.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// The forms P = 3 |T|^2 and 6 Q = 162 det T of a linear field on a simplex, as polynomials in
/// the barycentric coordinates. Only ring operations; polar forms of the vertex tensors.
///
/// The field may be given by any positive multiples of its vertex tensors: that is a projective
/// change of the barycentric coordinates, which changes no sign, no level set and no order along
/// a line. So each vertex tensor may be scaled to norm about 1 on its own.
template <class Scalar, std::size_t Vertices>
struct ModeForms {
  BarycentricPolynomial<Scalar, Vertices, 2> norm;         ///< P
  BarycentricPolynomial<Scalar, Vertices, 3> determinant;  ///< 6 Q
};

namespace detail {

/// Twice the polarised adjugate: `contract(polar_adjugate(A, B), C)` is 6 times the polar form
/// of the determinant at (A, B, C).
template <class Scalar>
SymmetricTensor<Scalar> polar_adjugate(const SymmetricTensor<Scalar>& s,
                                       const SymmetricTensor<Scalar>& t) {
  const Scalar two(2);
  return {s.yy * t.zz + s.zz * t.yy - two * s.yz * t.yz,
          s.xx * t.zz + s.zz * t.xx - two * s.xz * t.xz,
          s.xx * t.yy + s.yy * t.xx - two * s.xy * t.xy,
          s.xz * t.yz + s.yz * t.xz - s.xy * t.zz - s.zz * t.xy,
          s.xy * t.xz + s.xz * t.xy - s.yz * t.xx - s.xx * t.yz,
          s.xy * t.yz + s.yz * t.xy - s.xz * t.yy - s.yy * t.xz};
}

}  // namespace detail

template <class Scalar, std::size_t Vertices>
ModeForms<Scalar, Vertices> mode_forms(const std::array<Deviator<Scalar>, Vertices>& tensors) {
  ModeForms<Scalar, Vertices> forms;
  std::array<SymmetricTensor<Scalar>, Vertices> thrice_tensor;
  for (std::size_t i = 0; i < Vertices; ++i) thrice_tensor[i] = thrice(tensors[i]);

  const Scalar one(1), two(2), three(3), six(6);
  std::size_t pair = 0, triple = 0;
  // Degree 2 and 3 monomials in their stored order: i <= j, i <= j <= k.
  for (std::size_t i = 0; i < Vertices; ++i)
    for (std::size_t j = i; j < Vertices; ++j) {
      forms.norm.coefficients[pair++] = (i == j ? one : two) * norm_form(tensors[i], tensors[j]);
      const auto adjugate = detail::polar_adjugate(thrice_tensor[i], thrice_tensor[j]);
      for (std::size_t k = j; k < Vertices; ++k) {
        const Scalar& multiplicity = i == j ? (j == k ? one : three) : (j == k ? three : six);
        forms.determinant.coefficients[triple++] = multiplicity * inner(adjugate, thrice_tensor[k]);
      }
    }
  return forms;
}

/// The degree-six form (6 Q)^2 - 18 mu^2 P^3, which vanishes on the generalized mode mu surface
/// and is positive where |mode| > |mu| (paper, degree-six equation with the constant mu).
template <class Scalar, std::size_t Vertices>
BarycentricPolynomial<Scalar, Vertices, 6> generalized_mode_form(
    const ModeForms<Scalar, Vertices>& forms, const Scalar& mu_squared) {
  const auto cube = forms.norm * (forms.norm * forms.norm);
  return forms.determinant * forms.determinant - (Scalar(18) * mu_squared) * cube;
}

}  // namespace tensortopo
