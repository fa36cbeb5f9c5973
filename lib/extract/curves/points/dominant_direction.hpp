// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "extract/curves/points/cell_rows.hpp"
#include "tensortopo/field/planar_critical_points.hpp"

namespace tensortopo {

/// The eigenvector of a tensor near s (e e^T - I / 3): from a column of what adding the right
/// multiple of I leaves.
template <class Real>
Vector3<Real> dominant_direction(const PlanarCriticalPoint<Real>& point) {
  using std::sqrt;
  const auto t = thrice(Real(point.mode < 0 ? -1 : 1) * point.tensor);
  const Real shift = sqrt(Real(inner(t, t) / 6));
  const Real x = t.xx + shift, y = t.yy + shift, z = t.zz + shift;
  if (x >= y && x >= z) return {x, t.xy, t.xz};
  if (y >= z) return {t.xy, y, t.yz};
  return {t.xz, t.yz, z};
}

/// A triangle with these deviators, reduced or not: the same plane.
inline TriangleField<double> field_of(const CellRows<3>& cell) {
  const auto rows = cell.rows<double>();
  TriangleField<double> field;
  for (std::size_t i = 0; i < 3; ++i)
    field.vertex[i] = {rows[i][0], rows[i][1], rows[i][2], rows[i][3], rows[i][4]};
  return field;
}

}  // namespace tensortopo
