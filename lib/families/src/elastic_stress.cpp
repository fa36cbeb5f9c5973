// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/elastic_stress.hpp"

#include <cmath>

#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <RealScalar Scalar>
SymmetricTensor<Scalar> kelvin_stress(const Vector3<Scalar>& x, const Vector3<Scalar>& force,
                                      const Scalar& poisson) {
  using std::sqrt;
  const Scalar r2 = dot(x, x);
  const Vector3<Scalar> n = (Scalar(1) / sqrt(r2)) * x;
  const Scalar along = dot(n, force), soft = Scalar(1) - Scalar(2) * poisson;
  const auto entry = [&](const Scalar& ni, const Scalar& nj, const Scalar& fi, const Scalar& fj,
                         int delta) {
    return -(soft * (ni * fj + nj * fi - Scalar(delta) * along) + Scalar(3) * ni * nj * along) / r2;
  };
  return {entry(n.x, n.x, force.x, force.x, 1), entry(n.y, n.y, force.y, force.y, 1),
          entry(n.z, n.z, force.z, force.z, 1), entry(n.x, n.y, force.x, force.y, 0),
          entry(n.y, n.z, force.y, force.z, 0), entry(n.x, n.z, force.x, force.z, 0)};
}

template <RealScalar Scalar>
SymmetricTensor<Scalar> boussinesq_stress(const Vector3<Scalar>& x, const Scalar& load,
                                          const Scalar& poisson) {
  using std::sqrt;
  const Scalar z = x.z, r2 = dot(x, x), r = sqrt(r2), r3 = r2 * r, below = r + z;
  const Scalar soft = Scalar(1) - Scalar(2) * poisson, scale = load / r2;
  const Scalar hoop = scale * soft * (z / r - r / below);
  // (T_rr - T_tt) over the squared distance from the axis, where both vanish: R - z cancels.
  const Scalar spread =
      scale * (soft * (Scalar(2) * r + z) / (r * below * below) - Scalar(3) * z / r3);
  const Scalar shear = -Scalar(3) * load * z * z / (r3 * r2);
  return {hoop + spread * x.x * x.x,
          hoop + spread * x.y * x.y,
          shear * z,
          spread * x.x * x.y,
          shear * x.y,
          shear * x.x};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template SymmetricTensor<Scalar> kelvin_stress(const Vector3<Scalar>&, const Vector3<Scalar>&, \
                                                 const Scalar&);                                 \
  template SymmetricTensor<Scalar> boussinesq_stress(const Vector3<Scalar>&, const Scalar&,      \
                                                     const Scalar&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
