// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "levels/forms.hpp"

namespace tensortopo::theory {

/// Medium eigenvector v and sigma = d.N (v x d), d dominant, of the tensors of mode mu > 0 of a
/// simplex, as polynomials in the weights.
///
/// Such a tensor T has the eigenvalues k (3 + s, -2 s, s - 3), k > 0, so |T|^2 = 6 (3 + s^2) k^2
/// and det T = 2 s (9 - s^2) k^3. Hence v v^T, a negative multiple of (T - l1 I) (T - l3 I) = T^2 -
/// 2 s k T - (9 - s^2) k^2 I, is a positive one of
///     V = -|T|^2 T^2 + a det(T) T + |T|^4 I / a,  a = 6 (3 + s^2) / (9 - s^2).
/// And T N - N T has the entry (l1 - l3) sigma between d and v x d: sigma is a positive multiple of
/// v.c, c the vector of that skew matrix. So V c is a positive multiple of sigma v, whichever of
/// the two signs v has. N is diagonal here.
template <std::size_t N>
struct MediumForms {
  using Number = Bounded<double>;
  using Matrix = std::array<std::array<Form<N, 4>, 3>, 3>;

  Matrix v;                          ///< V
  std::array<Form<N, 1>, 3> vector;  ///< c

  /// @param normal  the diagonal of N
  /// @param factor  a
  MediumForms(const std::array<BoundedDeviator, N>& tensors, const std::array<Number, 3>& normal,
              const Number& factor) {
    const Form<N, 1> a = linear_form(tensors, &BoundedDeviator::a),
                     b = linear_form(tensors, &BoundedDeviator::b);
    const Number three(3);
    // Three times the tensor.
    const Form<N, 1> x = a + a + b, y = b - a, z = Number(-1) * (a + b + b),
                     xy = three * linear_form(tensors, &BoundedDeviator::xy),
                     yz = three * linear_form(tensors, &BoundedDeviator::yz),
                     xz = three * linear_form(tensors, &BoundedDeviator::xz);
    const std::array<std::array<Form<N, 1>, 3>, 3> t = {{{x, xy, xz}, {xy, y, yz}, {xz, yz, z}}};
    const Form<N, 2> norm = x * x + y * y + z * z + Number(2) * (xy * xy + yz * yz + xz * xz);
    const Form<N, 3> determinant = factor * (x * (y * z - yz * yz) - y * (xz * xz) - z * (xy * xy) +
                                             Number(2) * ((xy * yz) * xz));
    const Form<N, 4> on_diagonal = (Number(1) / factor) * (norm * norm);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) {
        const Form<N, 2> square = t[i][0] * t[0][j] + t[i][1] * t[1][j] + t[i][2] * t[2][j];
        v[i][j] = determinant * t[i][j] - norm * square;
        if (i == j) v[i][j] = v[i][j] + on_diagonal;
        v[j][i] = v[i][j];
      }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      vector[i] = (normal[k] - normal[j]) * t[j][k];
    }
  }

  /// (g.v)^2, up to a positive factor.
  Form<N, 4> squared_along(const std::array<double, 3>& g) const {
    Form<N, 4> sum;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum = sum + Number(g[i], 0) * (Number(g[j], 0) * v[i][j]);
    return sum;
  }

  /// (g.v) sigma, up to a positive factor.
  Form<N, 5> sigma_along(const std::array<double, 3>& g) const {
    Form<N, 5> sum;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum = sum + Number(g[i], 0) * (v[i][j] * vector[j]);
    return sum;
  }
};

}  // namespace tensortopo::theory
