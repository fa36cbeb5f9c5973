// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/level_extremality.hpp"

#include <cmath>

#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <class Scalar>
bool LevelExtremality<Scalar>::is_flat(std::size_t which) const {
  using std::abs;
  return abs(extremality[which]) <= Scalar(0x1p-40) * largest;
}

template <RealScalar Scalar>
Scalar extremality(const LevelCurvature<Scalar>& curvature, std::size_t which,
                   const Scalar& steepness, const SymmetricTensor<Scalar>& hessian,
                   const Scalar& third) {
  const Vector3<Scalar>& t = curvature.directions[which];
  return (third - Scalar(3) * curvature.principal[which] * dot(curvature.normal, hessian * t)) /
         steepness;
}

template <RealScalar Scalar>
std::optional<LevelExtremality<Scalar>> level_extremality(
    const std::array<Vector3<Scalar>, 4>& corners,
    const std::array<SymmetricTensor<Scalar>, 4>& tensors, const Vector3<Scalar>& point) {
  using std::sqrt;
  const auto form = level_form(corners, tensors, point);
  if (!form) return std::nullopt;
  const auto curvature = level_curvature(form->gradient, form->hessian);
  if (!curvature) return std::nullopt;
  const Scalar steepness = sqrt(dot(form->gradient, form->gradient));
  LevelExtremality<Scalar> result{*curvature, {}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    result.extremality[i] =
        extremality(*curvature, i, steepness, form->hessian, form->third(curvature->directions[i]));
  // With u the root of P(U_1) + P(U_2) + P(U_3): |<T, U>| <= sqrt(P) u and |Q| <= P^(3/2), so that
  // no third derivative along a unit vector exceeds 15 u^3.
  Scalar u{};
  for (const auto& d : form->derivative) u = u + norm_form(d);
  const Scalar bend = sqrt(inner(form->hessian, form->hessian)) / steepness;
  result.largest = Scalar(15) * u * sqrt(u) / steepness + Scalar(3) * bend * bend;
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                      \
  template struct LevelExtremality<Scalar>;                                                 \
  template Scalar extremality(const LevelCurvature<Scalar>&, std::size_t, const Scalar&,    \
                              const SymmetricTensor<Scalar>&, const Scalar&);               \
  template std::optional<LevelExtremality<Scalar>> level_extremality(                       \
      const std::array<Vector3<Scalar>, 4>&, const std::array<SymmetricTensor<Scalar>, 4>&, \
      const Vector3<Scalar>&);
TENSORTOPO_INSTANTIATE(double)
TENSORTOPO_INSTANTIATE(Real50)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
