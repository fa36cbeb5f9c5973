// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The Lode angle is 1-Lipschitz in the angle between tensors: eigenvalues in order are at most as
// far apart as the tensors.
#include "certificates/step.hpp"
#include "steps/common/rotation.hpp"

namespace proofs {
namespace {

std::vector<Polynomial> squared_rotation(Constants& k) {
  const Matrix3 r = rotation_times_norm();
  std::vector<Polynomial> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    Polynomial row, columns;
    for (std::size_t j = 0; j < 3; ++j) {
      row += square(r[i][j]);
      columns += square(r[j][i]);
    }
    differences.push_back(row - k(1) * square(quaternion_norm()));
    differences.push_back(columns - k(1) * square(quaternion_norm()));
  }
  return differences;
}

std::vector<Polynomial> distance_of_tensors(Constants& k) {
  // S = diag(b), T = R diag(a) R^T, with R times its norm: |T - S|^2 by a, b and squares of R.
  const Matrix3 r = rotation_times_norm();
  const Vector3 a{variable("a1"), variable("a2"), variable("a3")},
      b{variable("b1"), variable("b2"), variable("b3")};
  const Polynomial norm2 = square(quaternion_norm());
  const Matrix3 t = r * diagonal(a) * transpose(r), s = diagonal(norm2 * b);
  Polynomial mixed;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) mixed += b[i] * a[j] * square(r[i][j]);
  return {inner(t - s, t - s) - norm2 * (norm2 * (dot(a, a) + dot(b, b)) - k(2) * mixed)};
}

void rearrangement(Checks& c) {
  // Row and column sums 1; the gaps p, q of a and x, y of b are not negative.
  const auto p = variable("p"), q = variable("q"), x = variable("x"), y = variable("y");
  const auto a3 = variable("a3"), b3 = variable("b3");
  const Vector3 a{a3 + q + p, a3 + q, a3}, b{b3 + y + x, b3 + y, b3};
  const auto s12 = variable("s12"), s13 = variable("s13"), s21 = variable("s21"),
             s23 = variable("s23"), s31 = variable("s31"), s32 = variable("s32");
  const Matrix3 s{{{c.k(1) - s12 - s13, s12, s13},
                   {s21, c.k(1) - s21 - s23, s23},
                   {s31, s32, c.k(1) - s31 - s32}}};
  const Polynomial excess = dot(a, b) - dot(a, s * b);
  // Column sums: s12 + s13 = s21 + s31 and s13 + s23 = s31 + s32.
  const auto with_columns = [&](const Polynomial& f) {
    return f.with("s12", s21 + s31 - s13).with("s32", s13 + s23 - s31);
  };
  const Polynomial claimed = c.k(1) * p * x * (s12 + s13) + c.k(1) * p * y * s13 +
                             c.k(1) * q * x * s31 + c.k(1) * q * y * (s13 + s23);
  c.vanishes(with_columns(excess - claimed));
  c.positive_on_orthant(claimed);
}

std::vector<Polynomial> angle_of_eigenvalues(Constants& k) {
  // cos(f), cos(f -+ 2 pi/3) and the same of g; w = sqrt(3).
  const auto w = variable("w");
  const auto eigenvalues = [&](const Polynomial& cosine, const Polynomial& sine) {
    const Polynomial half = k(1, 2);
    return Vector3{cosine, half * (w * sine - cosine), -half * (w * sine + cosine)};
  };
  const auto cf = variable("cf"), sf = variable("sf"), cg = variable("cg"), sg = variable("sg");
  const Polynomial product = dot(eigenvalues(cf, sf), eigenvalues(cg, sg)).with_square("w", k(3));
  return {product - k(3, 2) * (cf * cg + sf * sg)};
}

}  // namespace

std::vector<Step> lode_angle_steps() {
  const Place place = Place::screen;
  return {
      identity(place, "squared-rotation",
               "the squares of the entries of a rotation have row and column sums 1",
               squared_rotation),
      identity(place, "distance-of-tensors",
               "T of eigenvalues a, S of eigenvalues b, R between their eigenvectors: |T - S|^2 = "
               "|a|^2 + |b|^2 - 2 (sum of b_i a_j R_ij^2)",
               distance_of_tensors),
      claim(place, "rearrangement", Kind::inequality,
            "a and b descending, row and column sums 1: the sum of a_i s_ij b_j is at most a.b, so "
            "|a - b| <= |T - S|; the difference is a sum of products of gaps and entries",
            rearrangement),
      identity(
          place, "angle-of-eigenvalues",
          "eigenvalues by the Lode angles f and g: the inner product is 3/2 cos(f - g), so the "
          "vectors of unit tensors are f - g apart",
          angle_of_eigenvalues),
  };
}

}  // namespace proofs
