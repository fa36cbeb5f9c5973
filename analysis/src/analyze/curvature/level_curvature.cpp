// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/level_curvature.hpp"

#include <cmath>
#include <cstddef>

#include "analyze/curvature/level_form.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {
namespace {

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
std::optional<LevelCurvature<Scalar>> level_curvature(const Vector3<Scalar>& gradient,
                                                      const SymmetricTensor<Scalar>& hessian) {
  const Scalar steepness = length(gradient);
  if (!(steepness > Scalar(0))) return std::nullopt;
  return curvature_of(Vector3<Scalar>((Scalar(1) / steepness) * gradient),
                      SymmetricTensor<Scalar>((Scalar(1) / steepness) * hessian));
}

template <RealScalar Scalar>
std::optional<LevelCurvature<Scalar>> level_curvature(
    const std::array<Vector3<Scalar>, 4>& corners,
    const std::array<SymmetricTensor<Scalar>, 4>& tensors, const Vector3<Scalar>& point) {
  const auto form = level_form(corners, tensors, point);
  return form ? level_curvature(form->gradient, form->hessian) : std::nullopt;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                            \
  template std::array<Vector3<Scalar>, 2> tangents(const Vector3<Scalar>&);                       \
  template LevelCurvature<Scalar> curvature_of(const Vector3<Scalar>&,                            \
                                               const SymmetricTensor<Scalar>&);                   \
  template std::optional<LevelCurvature<Scalar>> level_curvature(const Vector3<Scalar>&,          \
                                                                 const SymmetricTensor<Scalar>&); \
  template std::optional<LevelCurvature<Scalar>> level_curvature(                                 \
      const std::array<Vector3<Scalar>, 4>&, const std::array<SymmetricTensor<Scalar>, 4>&,       \
      const Vector3<Scalar>&);
TENSORTOPO_INSTANTIATE(double)
TENSORTOPO_INSTANTIATE(Real50)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
