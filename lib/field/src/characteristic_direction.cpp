// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "minors.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/interval.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

template <FieldScalar Scalar>
Deviator<Scalar> characteristic_direction(const TetrahedronField<Scalar>& field) {
  detail::Rows4<Scalar> rows{};
  for (std::size_t i = 0; i < 4; ++i) rows[i] = detail::coordinates(field.vertex[i]);
  std::array<Scalar, 5> covector = detail::minors<false>(rows);
  covector[1] = -covector[1];
  covector[3] = -covector[3];
  const Deviator<Scalar> direction = detail::from_covector(covector);
  if constexpr (OrderedField<Scalar>)
    if (determinant_form(direction) > Scalar(0)) return Scalar(-1) * direction;
  return direction;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template Deviator<Scalar> characteristic_direction(const TetrahedronField<Scalar>&);
TENSORTOPO_FOR_EACH_FIELD(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
