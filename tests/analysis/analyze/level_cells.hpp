// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <array>
#include <optional>

#include "analyze/curvature/level_extremality.hpp"
#include "support/fields/random_fields.hpp"
#include "support/fields/witness_fields.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo::test {

template <class Scalar>
Vector3<Scalar> to(const Vector3<double>& v) {
  return {Scalar(v.x), Scalar(v.y), Scalar(v.z)};
}

/// A tetrahedron with tensors at its corners.
template <class Scalar>
struct Cell {
  std::array<Vector3<Scalar>, 4> points;
  std::array<SymmetricTensor<Scalar>, 4> tensors;

  std::optional<LevelCurvature<Scalar>> at(const Vector3<Scalar>& x) const {
    return level_curvature(points, tensors, x);
  }
  std::optional<LevelExtremality<Scalar>> extremality(const Vector3<Scalar>& x) const {
    return level_extremality(points, tensors, x);
  }
};

inline constexpr std::array<Vector3<double>, 4> kCorners{
    {{-4, -3, -2}, {5, -2, -1}, {1, 6, -3}, {0, 1, 7}}};

/// At these corners.
template <class Scalar>
Cell<Scalar> cell_of(const TetTensors& tensors) {
  Cell<Scalar> cell;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& t = tensors[i];
    cell.points[i] = to<Scalar>(kCorners[i]);
    cell.tensors[i] = tensor_cast<Scalar>(t);
  }
  return cell;
}

template <class Scalar>
Cell<Scalar> cell_of(const LinearField& field) {
  return cell_of<Scalar>(field.at(kCorners));
}

/// A random field and a point.
struct Drawn {
  TetTensors tensors;
  Vector3<double> point;
};

inline Drawn drawn() {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  return {random.tet_tensors(), {random.normal(), random.normal(), random.normal()}};
}

}  // namespace tensortopo::test
