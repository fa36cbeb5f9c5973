// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/random_source.hpp"

namespace tensortopo {

double RandomSource::uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

double RandomSource::normal() {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine_() >> 24) * 0x1p-40;
  return sum;
}

int RandomSource::integer(int low, int high) {
  return low + static_cast<int>(uniform() * (high - low + 1));
}

SymmetricTensor<double> RandomSource::tensor() {
  SymmetricTensor<double> t;
  for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *entry = normal();
  return t;
}

std::array<int, 4> RandomSource::quaternion() {
  std::array<int, 4> q{};
  for (int& entry : q) entry = integer(-3, 3);
  if (q == std::array<int, 4>{}) q[0] = 1;
  return q;
}

SymmetricTensor<double> turned(const SymmetricTensor<double>& t, const std::array<int, 4>& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double r[3][3] = {
      {w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
      {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
      {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
  const double m[3][3] = {{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}};
  double result[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) result[i][j] += r[i][k] * m[k][l] * r[j][l];
  return {result[0][0], result[1][1], result[2][2], result[0][1], result[1][2], result[0][2]};
}

}  // namespace tensortopo
