// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/plane_directions.hpp"

#include "extract/curves/points/exact_face_points.hpp"
#include "extract/curves/special/line_pair.hpp"

namespace tensortopo {

namespace {

/// x M + y N at the double zero of the cubic c: rational, as it is the only one of its kind.
SymmetricTensor<Rational> form_at_double_zero(const std::array<Rational, 4>& c,
                                              const SymmetricTensor<Rational>& m,
                                              const SymmetricTensor<Rational>& n) {
  // The Hessian of the cubic is a multiple of the square of the factor sought.
  const Rational a = c[1] * c[1] - 3 * c[0] * c[2], b = c[1] * c[2] - 9 * c[0] * c[3],
                 d = c[2] * c[2] - 3 * c[1] * c[3];
  Rational x, y;
  if (a != 0) {
    x = -b, y = 2 * a;
  } else if (d != 0) {
    x = 1, y = 0;
  } else if (c[0] != 0) {  // a triple zero
    x = -c[1], y = 3 * c[0];
  } else {
    x = 1, y = 0;
  }
  return x * m + y * n;
}

PlaneDirections of_touching_conics(const FieldForms<Rational, 3>& forms,
                                   const std::array<Rational, 4>& cubic) {
  PlaneDirections result;
  const auto singular = form_at_double_zero(cubic, forms.across[0], forms.across[1]);
  const LinePair lines(singular);
  // Another form of the pencil: any that is not a multiple of this one.
  const auto combination = [&](const SymmetricTensor<Rational>& f) {
    const std::array<Rational, 6> u{f.xx, f.yy, f.zz, f.xy, f.yz, f.xz};
    const auto& s = singular;
    const std::array<Rational, 6> v{s.xx, s.yy, s.zz, s.xy, s.yz, s.xz};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (u[i] * v[j] != u[j] * v[i]) return false;
    return true;
  };
  const auto& other = combination(forms.across[0]) ? forms.across[1] : forms.across[0];
  result.points = lines.zeros_of(other);
  result.settled = true;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      result.settled = result.settled && are_apart(result.points[i], result.points[j]);
  return result;
}

}  // namespace

PlaneDirections plane_directions(const std::array<ScaledTensor, 3>& tensors) {
  PlaneDirections result;
  const auto rows = coordinate_rows<Rational>(tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  const auto cubic = pencil_cubic(forms.across[0], forms.across[1]);
  const Rational discriminant = cubic_discriminant(cubic);
  if (discriminant != 0) {
    const std::size_t count = discriminant > 0 ? 4 : 2;
    for (const auto& zero : isolated_zeros(MultiprecisionFace(tensors), count))
      result.points.push_back(normalized(zero.direction));
    result.settled = result.points.size() == count;
    return result;
  }
  for (const Rational& c : cubic)
    if (c != 0) return of_touching_conics(forms, cubic);
  result.settled = true;
  const auto k = kernel_of(forms.across[0]);
  if (!is_zero(k) && is_zero(forms.across[1] * k)) {
    result.points.push_back(normalized(interval_of(k)));
    return result;
  }
  result.axis = cross(k, kernel_of(forms.across[1]));
  result.points.push_back(normalized(interval_of(*result.axis)));
  return result;
}

}  // namespace tensortopo
