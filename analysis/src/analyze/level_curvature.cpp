// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/level_curvature.hpp"

#include <cmath>
#include <cstddef>

#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
Scalar length(const Vector3<Scalar>& v) {
  using std::sqrt;
  return sqrt(dot(v, v));
}

/// a a^t.
template <class Scalar>
SymmetricTensor<Scalar> dyad(const Vector3<Scalar>& a) {
  return {a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.y * a.z, a.x * a.z};
}

}  // namespace

template <RealScalar Scalar>
std::array<Vector3<Scalar>, 2> tangents(const Vector3<Scalar>& normal) {
  using std::abs;
  const Scalar x = abs(normal.x), y = abs(normal.y), z = abs(normal.z);
  Vector3<Scalar> axis{};
  (x <= y && x <= z ? axis.x : y <= z ? axis.y : axis.z) = Scalar(1);
  const Vector3<Scalar> across = cross(normal, axis);
  const Vector3<Scalar> first = (Scalar(1) / length(across)) * across;
  return {first, cross(normal, first)};
}

template <RealScalar Scalar>
LevelCurvature<Scalar> curvature_of(const Vector3<Scalar>& normal,
                                    const SymmetricTensor<Scalar>& tensor) {
  using std::atan2, std::cos, std::sin, std::sqrt;
  const auto [a, b] = tangents(normal);
  const Scalar aa = dot(a, tensor * a), ab = dot(a, tensor * b), bb = dot(b, tensor * b);
  const Scalar mean = (aa + bb) / Scalar(2), p = (aa - bb) / Scalar(2);
  const Scalar spread = sqrt(p * p + ab * ab);
  const Scalar angle = spread > Scalar(0) ? Scalar(atan2(ab, p) / Scalar(2)) : Scalar(0);
  LevelCurvature<Scalar> result;
  result.normal = normal;
  result.principal = {mean + spread, mean - spread};
  result.directions[0] = Scalar(cos(angle)) * a + Scalar(sin(angle)) * b;
  result.directions[1] = cross(normal, result.directions[0]);
  result.tensor = result.principal[0] * dyad(result.directions[0]) +
                  result.principal[1] * dyad(result.directions[1]);
  return result;
}

template <RealScalar Scalar>
std::optional<LevelCurvature<Scalar>> level_curvature(
    const std::array<Vector3<Scalar>, 4>& corners,
    const std::array<SymmetricTensor<Scalar>, 4>& tensors, const Vector3<Scalar>& point) {
  // The reciprocal basis of the edges from the first corner.
  const Vector3<Scalar> e1 = corners[1] - corners[0], e2 = corners[2] - corners[0],
                        e3 = corners[3] - corners[0];
  const Scalar volume = dot(e1, cross(e2, e3));
  if (volume == Scalar(0)) return std::nullopt;
  const std::array<Vector3<Scalar>, 3> dual{(Scalar(1) / volume) * cross(e2, e3),
                                            (Scalar(1) / volume) * cross(e3, e1),
                                            (Scalar(1) / volume) * cross(e1, e2)};
  const Deviator<Scalar> first = deviator(tensors[0]);
  Deviator<Scalar> t = first;
  std::array<Deviator<Scalar>, 3> u{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Deviator<Scalar> step = deviator(tensors[i + 1]) - first;
    t = t + dot(dual[i], point - corners[0]) * step;
    u[0] = u[0] + dual[i].x * step;
    u[1] = u[1] + dual[i].y * step;
    u[2] = u[2] + dual[i].z * step;
  }
  const Scalar p = norm_form(t);
  if (!(p > Scalar(0))) return std::nullopt;
  const Scalar c = determinant_form(t) / p, three(3);
  const auto m = thrice(t), mm = square(m);
  std::array<Scalar, 3> along, gradient;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = norm_form(t, u[i]);
    gradient[i] = inner(mm, thrice(u[i])) - three * c * along[i];
  }
  const auto second = [&](std::size_t i, std::size_t j) {
    const auto k = thrice(u[j]);
    return Scalar(inner(square(m + k) - mm - square(k), thrice(u[i])) -
                  three * c * (norm_form(u[i], u[j]) + along[i] * along[j] / p));
  };
  const Vector3<Scalar> g{gradient[0], gradient[1], gradient[2]};
  const Scalar steepness = length(g);
  if (!(steepness > Scalar(0))) return std::nullopt;
  const SymmetricTensor<Scalar> hessian{second(0, 0), second(1, 1), second(2, 2),
                                        second(0, 1), second(1, 2), second(0, 2)};
  return curvature_of(Vector3<Scalar>((Scalar(1) / steepness) * g),
                      SymmetricTensor<Scalar>((Scalar(1) / steepness) * hessian));
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                      \
  template std::array<Vector3<Scalar>, 2> tangents(const Vector3<Scalar>&);                 \
  template LevelCurvature<Scalar> curvature_of(const Vector3<Scalar>&,                      \
                                               const SymmetricTensor<Scalar>&);             \
  template std::optional<LevelCurvature<Scalar>> level_curvature(                           \
      const std::array<Vector3<Scalar>, 4>&, const std::array<SymmetricTensor<Scalar>, 4>&, \
      const Vector3<Scalar>&);
TENSORTOPO_INSTANTIATE(double)
TENSORTOPO_INSTANTIATE(Real50)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
