// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The forms on a simplex: coefficients in barycentric coordinates are polar forms of the vertex
// tensors. Four vertices; fewer are the case in which coordinates vanish.
#include <array>

#include "certificates/step.hpp"
#include "steps/common/deviator.hpp"

namespace proofs {
namespace {

constexpr std::size_t vertices = 4;

struct Simplex {
  std::array<Polynomial, vertices> weight;
  std::array<Deviator, vertices> vertex;

  Simplex() {
    for (std::size_t i = 0; i < vertices; ++i) {
      const std::string index = std::to_string(i);
      weight[i] = variable("w" + index);
      vertex[i] = Deviator::generic(index);
    }
  }
  Deviator at_weights() const {
    Deviator sum;
    for (std::size_t i = 0; i < vertices; ++i) {
      sum.a += weight[i] * vertex[i].a;
      sum.b += weight[i] * vertex[i].b;
      sum.xy += weight[i] * vertex[i].xy;
      sum.yz += weight[i] * vertex[i].yz;
      sum.xz += weight[i] * vertex[i].xz;
    }
    return sum;
  }
};

Matrix3 thrice(const Deviator& d, Constants& k) {
  return symmetric(k(2) * d.a + d.b, d.b - d.a, -(d.a + k(2) * d.b), k(3) * d.xy, k(3) * d.yz,
                   k(3) * d.xz);
}

Polynomial polar_norm(const Deviator& s, const Deviator& t, Constants& k) {
  return k(2) * (s.a * t.a + s.b * t.b) + k(1) * (s.a * t.b + s.b * t.a) +
         k(6) * (s.xy * t.xy + s.yz * t.yz + s.xz * t.xz);
}

/// The matrix linear in both arguments that is 2 adj(S) on equal ones.
Matrix3 polar_adjugate(const Matrix3& s, const Matrix3& t, Constants& k) {
  const auto diagonal = [&](std::size_t i, std::size_t j) {
    return s[i][i] * t[j][j] + s[j][j] * t[i][i] - k(2) * s[i][j] * t[i][j];
  };
  const auto mixed = [&](std::size_t i, std::size_t j, std::size_t other) {
    return s[i][other] * t[j][other] + s[j][other] * t[i][other] - s[i][j] * t[other][other] -
           s[other][other] * t[i][j];
  };
  return symmetric(diagonal(1, 2), diagonal(0, 2), diagonal(0, 1), mixed(0, 1, 2), mixed(1, 2, 0),
                   mixed(0, 2, 1));
}

std::vector<Polynomial> norm_on_simplex(Constants& k) {
  const Simplex simplex;
  const Matrix3 at_weights = tensor(simplex.at_weights());
  Polynomial sum;
  for (std::size_t i = 0; i < vertices; ++i)
    for (std::size_t j = i; j < vertices; ++j)
      sum += k(i == j ? 1 : 2) * simplex.weight[i] * simplex.weight[j] *
             polar_norm(simplex.vertex[i], simplex.vertex[j], k);
  return {sum - k(3) * inner(at_weights, at_weights)};
}

std::vector<Polynomial> determinant_on_simplex(Constants& k) {
  const Simplex simplex;
  const auto& w = simplex.weight;
  std::array<Matrix3, vertices> tensors;
  for (std::size_t i = 0; i < vertices; ++i) tensors[i] = thrice(simplex.vertex[i], k);
  Polynomial sum;
  for (std::size_t i = 0; i < vertices; ++i)
    for (std::size_t j = i; j < vertices; ++j) {
      const Matrix3 adjugate = polar_adjugate(tensors[i], tensors[j], k);
      for (std::size_t l = j; l < vertices; ++l) {
        const int orders = i == j ? (j == l ? 1 : 3) : (j == l ? 3 : 6);
        sum += k(orders) * w[i] * w[j] * w[l] * inner(adjugate, tensors[l]);
      }
    }
  return {sum - k(162) * determinant(tensor(simplex.at_weights()))};
}

std::vector<Polynomial> polar_adjugate_on_diagonal(Constants& k) {
  const Matrix3 t = tensor(Deviator::generic());
  const Matrix3 polar = polar_adjugate(t, t, k), plain = adjugate(t);
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) differences.push_back(polar[i][j] - k(2) * plain[i][j]);
  return differences;
}

}  // namespace

std::vector<Step> polarization_steps() {
  return {
      identity(Place::forms, "norm-polarization",
               "P(sum w_i T_i) = sum over i <= j of (1 or 2) P(T_i, T_j) w_i w_j", norm_on_simplex),
      identity(Place::forms, "polar-adjugate", "the polar adjugate of T and T is 2 adj(T)",
               polar_adjugate_on_diagonal),
      identity(
          Place::forms, "determinant-polarization",
          "6 Q(sum w_i T_i) = sum over i <= j <= l of (1, 3 or 6) <polar adj(3T_i, 3T_j), 3T_l> "
          "w_i w_j w_l",
          determinant_on_simplex),
  };
}

}  // namespace proofs
