// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "high_precision_mode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {

namespace {

using Vector = Vector3<Real50>;
using Tensor50 = SymmetricTensor<Real50>;

Vector widen(const Vector3<double>& v) { return {Real50(v.x), Real50(v.y), Real50(v.z)}; }

// Half the distance to the next double of larger magnitude.
double half_ulp(double x) {
  const double magnitude = std::abs(x);
  return (std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude) / 2;
}

double to_double(const Real50& x) { return x.convert_to<double>(); }

}  // namespace

PreciseMode precise_mode(const TetMesh& mesh, TetMesh::Index tet, const Vector3<double>& point,
                         double level) {
  const auto& corners = mesh.tets[static_cast<std::size_t>(tet)];
  std::array<Vector, 4> p;
  for (std::size_t i = 0; i < 4; ++i)
    p[i] = widen(mesh.points[static_cast<std::size_t>(corners[i])]);
  const Vector x = widen(point);

  // Gradients of the barycentric coordinates, each a cross product over the volume.
  std::array<Vector, 4> gradient;
  const Real50 volume = dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]));
  const Real50 inverse = Real50(1) / volume;
  gradient[1] = inverse * cross(p[2] - p[0], p[3] - p[0]);
  gradient[2] = inverse * cross(p[3] - p[0], p[1] - p[0]);
  gradient[3] = inverse * cross(p[1] - p[0], p[2] - p[0]);
  gradient[0] = -(gradient[1] + gradient[2] + gradient[3]);
  std::array<Real50, 4> b;
  for (std::size_t i = 1; i < 4; ++i) b[i] = dot(gradient[i], x - p[0]);
  b[0] = Real50(1) - b[1] - b[2] - b[3];

  const Vector3<double> half{half_ulp(point.x), half_ulp(point.y), half_ulp(point.z)};
  Vector3<double> largest{};
  for (const auto corner : corners) {
    const auto& q = mesh.points[static_cast<std::size_t>(corner)];
    largest = {std::max(largest.x, std::abs(q.x)), std::max(largest.y, std::abs(q.y)),
               std::max(largest.z, std::abs(q.z))};
  }
  PreciseMode result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.barycentric[i] = to_double(b[i]);
    result.barycentric_rounding[i] = std::abs(to_double(gradient[i].x)) * half_ulp(largest.x) +
                                     std::abs(to_double(gradient[i].y)) * half_ulp(largest.y) +
                                     std::abs(to_double(gradient[i].z)) * half_ulp(largest.z);
  }

  // mode = 3 sqrt(6) det(D) / |D|^3 with D the deviator; its derivative in the direction E is
  // 3 sqrt(6) / |D|^3 (<cofactor(D), E> - 3 det(D) <D, E> / |D|^2).
  std::array<Tensor50, 4> corner;
  Tensor50 d{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& t = mesh.tensors[static_cast<std::size_t>(corners[i])];
    const auto wide = tensor_cast<Real50>(t);
    const Real50 mean = trace(wide) / Real50(3);
    corner[i] =
        wide - mean * Tensor50{Real50(1), Real50(1), Real50(1), Real50(0), Real50(0), Real50(0)};
    d = d + b[i] * corner[i];
  }
  const Real50 square_norm = inner(d, d), det = determinant(d);
  const Real50 factor = Real50(3) * sqrt(Real50(6)) / (square_norm * sqrt(square_norm));
  result.residual = to_double(factor * det - Real50(level));
  const Tensor50 cofactor{d.yy * d.zz - d.yz * d.yz, d.xx * d.zz - d.xz * d.xz,
                        d.xx * d.yy - d.xy * d.xy, d.yz * d.xz - d.xy * d.zz,
                        d.xy * d.xz - d.xx * d.yz, d.xy * d.yz - d.yy * d.xz};
  Vector slope{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Real50 along =
        factor * (inner(cofactor, corner[i]) - Real50(3) * det * inner(d, corner[i]) / square_norm);
    slope += along * gradient[i];
  }
  result.rounding = std::abs(to_double(slope.x)) * half.x + std::abs(to_double(slope.y)) * half.y +
                    std::abs(to_double(slope.z)) * half.z;
  result.gradient = to_double(sqrt(dot(slope, slope)));
  return result;
}

}  // namespace tensortopo::test
