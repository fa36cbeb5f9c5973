// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/level_form.hpp"

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

template <RealScalar Scalar>
std::optional<LevelForm<Scalar>> level_form(const std::array<Vector3<Scalar>, 4>& corners,
                                            const std::array<SymmetricTensor<Scalar>, 4>& tensors,
                                            const Vector3<Scalar>& point) {
  // The reciprocal basis of the edges from the first corner.
  const Vector3<Scalar> e1 = corners[1] - corners[0], e2 = corners[2] - corners[0],
                        e3 = corners[3] - corners[0];
  const Scalar volume = dot(e1, cross(e2, e3));
  if (volume == Scalar(0)) return std::nullopt;
  const std::array<Vector3<Scalar>, 3> dual{(Scalar(1) / volume) * cross(e2, e3),
                                            (Scalar(1) / volume) * cross(e3, e1),
                                            (Scalar(1) / volume) * cross(e1, e2)};
  LevelForm<Scalar> form;
  const Deviator<Scalar> first = deviator(tensors[0]);
  Deviator<Scalar>& t = form.tensor = first;
  auto& u = form.derivative;
  for (std::size_t i = 0; i < 3; ++i) {
    const Deviator<Scalar> step = deviator(tensors[i + 1]) - first;
    t = t + dot(dual[i], point - corners[0]) * step;
    u[0] = u[0] + dual[i].x * step;
    u[1] = u[1] + dual[i].y * step;
    u[2] = u[2] + dual[i].z * step;
  }
  const Scalar p = form.norm = norm_form(t);
  if (!(p > Scalar(0))) return std::nullopt;
  const Scalar c = form.ratio = determinant_form(t) / p, three(3);
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
  form.gradient = {gradient[0], gradient[1], gradient[2]};
  form.hessian = {second(0, 0), second(1, 1), second(2, 2),
                  second(0, 1), second(1, 2), second(0, 2)};
  return form;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                      \
  template struct LevelForm<Scalar>;                                                        \
  template std::optional<LevelForm<Scalar>> level_form(                                     \
      const std::array<Vector3<Scalar>, 4>&, const std::array<SymmetricTensor<Scalar>, 4>&, \
      const Vector3<Scalar>&);
TENSORTOPO_INSTANTIATE(double)
TENSORTOPO_INSTANTIATE(Real50)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
