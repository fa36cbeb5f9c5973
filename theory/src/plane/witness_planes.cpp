// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/witness_planes.hpp"

namespace tensortopo::theory {
namespace {

const SymmetricTensor<Rational> kXy = {0, 0, 0, 1, 0, 0}, kYz = {0, 0, 0, 0, 1, 0},
                                kXz = {0, 0, 0, 0, 0, 1};
const std::array<std::array<Rational, 2>, 3> kWide = {{{-16, -8}, {16, -8}, {0, 20}}};

Rational quarters(int n) { return Rational(n) / Rational(4); }

}  // namespace

TriangleField<Rational> WitnessPlane::face() const {
  TriangleField<Rational> field;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y] = corners[i];
    field.vertex[i] = deviator(tensors[0] + x * tensors[1] + y * tensors[2]);
  }
  return field;
}

TriangleField<Rational> WitnessPlane::span() const {
  return {{deviator(tensors[0]), deviator(tensors[1]), deviator(tensors[2])}};
}

const WitnessPlane& off_diagonal() {
  static const WitnessPlane plane = {
      "[[0, 1, x], [1, 0, y], [x, y, 0]]", {kXy, kXz, kYz}, {{{-4, -2}, {4, -2}, {0, 5}}}};
  return plane;
}

const WitnessPlane& off_diagonal_shifted() {
  static const WitnessPlane plane = {
      "[[0, 1, 1 + x], [1, 0, 1 + y], [1 + x, 1 + y, 0]]",
      {kXy + kXz + kYz, kXz, kYz},
      {{{quarters(-3), quarters(-3)}, {quarters(6), quarters(-3)}, {quarters(-3), quarters(6)}}}};
  return plane;
}

const WitnessPlane& ring() {
  static const WitnessPlane plane = {"[[1 + x, y, 0], [y, 1 - x, 0], [0, 0, -2]]",
                                     {{{1, 1, -2, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, kXy}},
                                     kWide};
  return plane;
}

const WitnessPlane& three_fold_ring() {
  static const WitnessPlane plane = {
      "[[10 + 10 x, 10 y, x], [10 y, 10 - 10 x, -y], [x, -y, -20]]",
      {{{10, 10, -20, 0, 0, 0}, {10, -10, 0, 0, 0, 1}, {0, 0, 0, 10, -1, 0}}},
      kWide};
  return plane;
}

const WitnessPlane& ring_with_two_extrema() {
  static const WitnessPlane plane = {
      "[[10 + 10 x, 10 y, x], [10 y, 10 - 10 x, y], [x, y, -20]]",
      {{{10, 10, -20, 0, 0, 0}, {10, -10, 0, 0, 0, 1}, {0, 0, 0, 10, 1, 0}}},
      kWide};
  return plane;
}

const WitnessPlane& smooth_maximum() {
  static const WitnessPlane plane = {
      "[[y - 1, 2 x - y, 1 + x + 2 y], [2 x - y, 2 + x, 1 + y], [1 + x + 2 y, 1 + y, -1 - x - y]]",
      {{{-1, 2, -1, 0, 1, 1}, {0, 1, -1, 2, 0, 1}, {1, 0, -1, -1, 1, 2}}},
      {{{-3, -3}, {3, -3}, {0, 4}}}};
  return plane;
}

}  // namespace tensortopo::theory
