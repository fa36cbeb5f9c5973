// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/curves/arcs/conic_arc.hpp"

/// \file
/// The separation of wedges and trisectors (see CurveMesh) as a quartic form in the dominant
/// eigenvector.
///
/// With p, q, e right-handed and orthonormal, m = p + i q, and G_k the derivative of the tensor
/// along axis k: h_k = m.G_k m has as real and imaginary parts twice the components of G_k across
/// e. The determinant is sum_k,l p_k q_l Im(conj(h_k) h_l) / 4 = e.C with C_x = Im(conj(h_y) h_z) /
/// 4 and so on around. conj(m) m^T = P + i J with P = 1 - e e^T and J v = v x e, hence Im(conj(h_k)
/// h_l) = 2 tr(G_k J G_l P), which is
///
///     2 (|e|^2 tr(J G_l G_k) - e.(G_k e x G_l e))
///
/// for any length of e, up to the factor |e|^3. So the separation times |e|^4 is a polynomial of
/// degree 4 in e, with a sign that the length and the sign of e do not change.

namespace tensortopo {

/// The derivatives of a linear field along the axes, times six times its tetrahedron's volume.
template <class E>
using SpaceGradient = std::array<SymmetricTensor<E>, 3>;

template <class E>
SpaceGradient<E> space_gradient(const std::array<Vector3<double>, 4>& points,
                                const std::array<SymmetricTensor<double>, 4>& tensors) {
  const auto wide = [](const Vector3<double>& v) { return Vector3<E>{E(v.x), E(v.y), E(v.z)}; };
  const auto to = [&](std::size_t i) { return wide(points[i]) - wide(points[0]); };
  const auto x = to(1), y = to(2), z = to(3);
  const std::array<Vector3<E>, 3> gradient{cross(y, z), cross(z, x), cross(x, y)};
  const auto tensor = [&](std::size_t i) {
    const auto& t = tensors[i];
    return SymmetricTensor<E>{E(t.xx), E(t.yy), E(t.zz), E(t.xy), E(t.yz), E(t.xz)};
  };
  std::array<SymmetricTensor<E>, 3> step;
  for (std::size_t i = 0; i < 3; ++i) step[i] = tensor(i + 1) - tensor(0);
  const auto along = [&](auto component) {
    return component(gradient[0]) * step[0] + component(gradient[1]) * step[1] +
           component(gradient[2]) * step[2];
  };
  return {along([](const Vector3<E>& g) { return g.x; }),
          along([](const Vector3<E>& g) { return g.y; }),
          along([](const Vector3<E>& g) { return g.z; })};
}

/// The vector a with tr(J G_l G_k) = e.a.
template <class E>
Vector3<E> commutator_axis(const SymmetricTensor<E>& k, const SymmetricTensor<E>& l) {
  const auto row = [](const SymmetricTensor<E>& t, std::size_t i) {
    return i == 0   ? Vector3<E>{t.xx, t.xy, t.xz}
           : i == 1 ? Vector3<E>{t.xy, t.yy, t.yz}
                    : Vector3<E>{t.xz, t.yz, t.zz};
  };
  const auto entry = [&](std::size_t i, std::size_t j) { return dot(row(l, i), row(k, j)); };
  return {entry(2, 1) - entry(1, 2), entry(0, 2) - entry(2, 0), entry(1, 0) - entry(0, 1)};
}

/// The separation along an arc, times a positive factor: (6 V)^2 |e|^4 times the separation times
/// twice the square of the deviator's norm.
template <class E>
std::array<E, 9> separation_along(const SpaceGradient<E>& gradient, const ConicArc<E>& arc) {
  const auto inner = [](const Vector3<E>& x, const Vector3<E>& y) { return dot(x, y); };
  const auto outer = [](const Vector3<E>& x, const Vector3<E>& y) { return cross(x, y); };
  std::array<ConicArc<E>, 3> image;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j) image[k][j] = gradient[k] * arc[j];
  std::array<Vector3<E>, 3> axis;
  for (std::size_t m = 0; m < 3; ++m)
    axis[m] = commutator_axis(gradient[(m + 1) % 3], gradient[(m + 2) % 3]);

  ConicArc<E> turned;
  for (std::size_t j = 0; j < 3; ++j)
    turned[j] = {dot(axis[0], arc[j]), dot(axis[1], arc[j]), dot(axis[2], arc[j])};
  auto sum = product_of(convolved(arc, arc, inner), convolved(arc, turned, inner));
  for (std::size_t m = 0; m < 3; ++m) {
    const auto determinant =
        convolved(arc, convolved(image[(m + 1) % 3], image[(m + 2) % 3], outer), inner);
    std::array<E, 3> component;
    for (std::size_t j = 0; j < 3; ++j)
      component[j] = m == 0 ? arc[j].x : m == 1 ? arc[j].y : arc[j].z;
    const auto term = product_of(component, determinant);
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] = sum[j] - term[j];
  }
  return sum;
}

}  // namespace tensortopo
