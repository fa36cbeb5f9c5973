// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "verify/mesh_trials.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

// A double is a rational number: nothing is rounded here.
TetrahedronField<Rational> exact_field(const std::array<SymmetricTensor<double>, 4>& tensors) {
  TetrahedronField<Rational> field;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& t = tensors[i];
    field.vertex[i] = deviator(tensor_cast<Rational>(t));
  }
  return field;
}

theory::Basis nearby_basis(const std::array<Vector3<double>, 3>& e) {
  Eigen::Matrix3d columns;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto& v = e[static_cast<std::size_t>(i)];
    columns.col(i) << v.x, v.y, v.z;
  }
  const Eigen::Quaterniond q(columns);
  const auto whole = [](double x) { return static_cast<int>(std::lround(std::ldexp(x, 16))); };
  return theory::basis_of_quaternion({whole(q.w()), whole(q.x()), whole(q.y()), whole(q.z())});
}

// With rational singularities too: A = cos(2 x), B = sin(2 x) of an x with a rational tangent.
theory::Frame nearby_frame(const CharacteristicTensor<double>& characteristic) {
  const auto& l = characteristic.eigenvalues;
  const double cosine = std::sqrt(std::clamp((l[0] - l[1]) / (l[0] - l[2]), 0.0, 1.0));
  const double tangent = std::tan(std::acos(cosine) / 2);
  const Rational t = Rational(std::lround(std::ldexp(tangent, 16))) / Rational(1 << 16);
  const Rational size = Rational(1) + t * t;
  Rational a = (Rational(1) - t * t) / size, b = (t + t) / size;
  // Next to determinant 0 the rounding may exchange them: the medium eigenvalue is >= 0.
  if (b < a) std::swap(a, b);
  const Rational aa = a * a, bb = b * b, middle = bb - aa, three(3);
  return {{Rational(middle + three * aa), middle, Rational(middle - three * bb)},
          nearby_basis(characteristic.eigenvectors),
          std::array{a, b}};
}

void move_to_rational_frame(const std::array<SymmetricTensor<double>, 4>& tensors,
                            theory::Trial& trial) {
  TetrahedronField<double> field;
  for (std::size_t i = 0; i < 4; ++i) field.vertex[i] = deviator(tensors[i]);
  const auto characteristic = characteristic_tensor(field);
  if (!characteristic) return;
  trial.frame = nearby_frame(*characteristic);
  const auto normal =
      deviator(theory::tensor_of(trial.frame->eigenvalues, trial.frame->eigenvectors));
  for (auto& d : trial.field.vertex) {
    const Rational share = norm_form(normal, d) / norm_form(normal);
    d = d - share * normal;
  }
}

}  // namespace

std::array<SymmetricTensor<double>, 4> tensors_of_tet(const TetMesh& mesh, std::size_t tet) {
  std::array<SymmetricTensor<double>, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    tensors[i] = mesh.tensors[static_cast<std::size_t>(mesh.tets[tet][i])];
  }
  return tensors;
}

theory::Trials mesh_trials(std::shared_ptr<const TetMesh> mesh, std::uint64_t seed,
                           std::size_t wanted) {
  const std::size_t all = mesh->tets.size(), count = std::min(wanted, all);
  // In the middle of equal parts of the list, so that few of them still come from all over it.
  const auto tet_at = [all, count](std::size_t i) { return (2 * i + 1) * all / (2 * count); };
  const auto is_moved = [](std::size_t i) { return i % 2 == 1; };
  return {count,
          [mesh, seed, tet_at, is_moved](std::size_t i) {
            theory::Trial trial = theory::random_trial(seed, i);
            trial.frame.reset();
            const auto tensors = tensors_of_tet(*mesh, tet_at(i));
            trial.field = exact_field(tensors);
            if (is_moved(i)) move_to_rational_frame(tensors, trial);
            return trial;
          },
          [mesh, tet_at, is_moved](std::size_t i) {
            return "cell " + std::to_string(mesh->cell_ids[tet_at(i)]) +
                   (is_moved(i) ? ", moved to a rational frame" : "");
          }};
}

}  // namespace tensortopo
