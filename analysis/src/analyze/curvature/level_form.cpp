// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/level_form.hpp"

#include <cstddef>

#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <class Scalar>
Scalar LevelForm<Scalar>::third(const Vector3<Scalar>& v) const {
  const Deviator<Scalar> u = v.x * derivative[0] + v.y * derivative[1] + v.z * derivative[2];
  const Scalar three(3), along = norm_form(tensor, u);
  return Scalar(6) * determinant_form(u) -
         three * ratio / norm * along * (three * norm_form(u) - along * along / norm);
}

template <class Scalar>
Scalar LevelForm<Scalar>::along(const Deviator<Scalar>& u) const {
  return inner(square(thrice(tensor)), thrice(u)) - Scalar(3) * ratio * norm_form(tensor, u);
}

namespace {

/// The gradients of the weights of the last three corners.
template <class Scalar>
std::optional<std::array<Vector3<Scalar>, 3>> dual_basis(
    const std::array<Vector3<Scalar>, 4>& corners) {
  const Vector3<Scalar> e1 = corners[1] - corners[0], e2 = corners[2] - corners[0],
                        e3 = corners[3] - corners[0];
  const Scalar volume = dot(e1, cross(e2, e3));
  if (volume == Scalar(0)) return std::nullopt;
  return std::array<Vector3<Scalar>, 3>{(Scalar(1) / volume) * cross(e2, e3),
                                        (Scalar(1) / volume) * cross(e3, e1),
                                        (Scalar(1) / volume) * cross(e1, e2)};
}

}  // namespace

template <RealScalar Scalar>
std::optional<std::array<Scalar, 4>> barycentric_coordinates(
    const std::array<Vector3<Scalar>, 4>& corners, const Vector3<Scalar>& point) {
  const auto dual = dual_basis(corners);
  if (!dual) return std::nullopt;
  const Vector3<Scalar> x = point - corners[0];
  const Scalar a = dot((*dual)[0], x), b = dot((*dual)[1], x), c = dot((*dual)[2], x);
  return std::array<Scalar, 4>{Scalar(1) - a - b - c, a, b, c};
}

template <RealScalar Scalar>
std::optional<LevelForm<Scalar>> level_form(const Deviator<Scalar>& t,
                                            const std::array<Deviator<Scalar>, 3>& u) {
  LevelForm<Scalar> form;
  form.tensor = t;
  form.derivative = u;
  const Scalar p = form.norm = norm_form(t);
  if (!(p > Scalar(0))) return std::nullopt;
  const Scalar c = form.ratio = determinant_form(t) / p, three(3);
  const auto m = thrice(t), mm = square(m);
  std::array<Scalar, 3> along;
  for (std::size_t i = 0; i < 3; ++i) along[i] = norm_form(t, u[i]);
  const auto second = [&](std::size_t i, std::size_t j) {
    const auto k = thrice(u[j]);
    return Scalar(inner(square(m + k) - mm - square(k), thrice(u[i])) -
                  three * c * (norm_form(u[i], u[j]) + along[i] * along[j] / p));
  };
  form.gradient = {form.along(u[0]), form.along(u[1]), form.along(u[2])};
  form.hessian = {second(0, 0), second(1, 1), second(2, 2),
                  second(0, 1), second(1, 2), second(0, 2)};
  return form;
}

template <RealScalar Scalar>
std::optional<LevelForm<Scalar>> level_form(const std::array<Vector3<Scalar>, 4>& corners,
                                            const std::array<SymmetricTensor<Scalar>, 4>& tensors,
                                            const Vector3<Scalar>& point) {
  const auto dual = dual_basis(corners);
  if (!dual) return std::nullopt;
  const Deviator<Scalar> first = deviator(tensors[0]);
  Deviator<Scalar> t = first;
  std::array<Deviator<Scalar>, 3> u{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<Scalar>& d = (*dual)[i];
    const Deviator<Scalar> step = deviator(tensors[i + 1]) - first;
    t = t + dot(d, point - corners[0]) * step;
    u[0] = u[0] + d.x * step;
    u[1] = u[1] + d.y * step;
    u[2] = u[2] + d.z * step;
  }
  return level_form(t, u);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                          \
  template struct LevelForm<Scalar>;                                                            \
  template std::optional<std::array<Scalar, 4>> barycentric_coordinates(                        \
      const std::array<Vector3<Scalar>, 4>&, const Vector3<Scalar>&);                           \
  template std::optional<LevelForm<Scalar>> level_form(const Deviator<Scalar>&,                 \
                                                       const std::array<Deviator<Scalar>, 3>&); \
  template std::optional<LevelForm<Scalar>> level_form(                                         \
      const std::array<Vector3<Scalar>, 4>&, const std::array<SymmetricTensor<Scalar>, 4>&,     \
      const Vector3<Scalar>&);
TENSORTOPO_INSTANTIATE(double)
TENSORTOPO_INSTANTIATE(Real50)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
