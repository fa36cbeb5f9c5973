// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curves/curves_in_tet.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace certificate {
namespace {

/// A sign that stayed open.
struct Open {};

/// The boundary points around the conic n(e, e) = 0 of a tetrahedron's degenerate tensors, as seen
/// from a point c inside it.
class ConicOrder {
 public:
  ConicOrder(const Conic<mpz_class>& n, const Vector3<mpz_class>& c,
             std::vector<BoundaryPoint>& boundary)
      : n_(n), c_(c), polar_(n.times(c)), boundary_(boundary) {
    // An e and its opposite are one point of the conic: that on the side of c is taken.
    const int at_c = sgn(dot(c_, polar_));
    for (std::size_t i = 0; i < boundary.size(); ++i)
      turns_.push_back(at_c * settled(i, i, [&] {
                         std::array<mpz_class, 3> values;
                         for (std::size_t k = 0; k < 3; ++k)
                           values[k] = dot(boundary_[i].point.arc().control(k), polar_);
                         return common_sign(values);
                       }));
  }

  /// From the first one on, counter-clockwise: det(c, e, e') > 0 where e' is less than half a turn
  /// ahead of e.
  std::vector<std::size_t> order() {
    std::vector<std::size_t> result;
    std::vector<bool> is_ahead{true};
    for (std::size_t i = 1; i < boundary_.size(); ++i) is_ahead.push_back(turn(0, i) > 0);
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      const auto place = std::find_if(result.begin(), result.end(), [&](std::size_t k) {
        if (k == 0 || is_ahead[k] != is_ahead[i]) return k != 0 && is_ahead[i];
        return turn(i, k) > 0;
      });
      result.insert(place, i);
    }
    return result;
  }

  /// Does a form grow, 1, or fall, -1, at a boundary point that is a zero of it, going
  /// counter-clockwise?
  int slope(std::size_t i, const Conic<mpz_class>& form) {
    // The tangent there is n e x n c: det(c, e, n e x n c) = (c.n e)^2 - (c.n c)(e.n e) > 0.
    return settled(i, i, [&] {
      const Arc<mpz_class>& arc = boundary_[i].point.arc();
      std::array<Vector3<mpz_class>, 3> e, tangent;
      for (std::size_t k = 0; k < 3; ++k) {
        e[k] = arc.control(k);
        tangent[k] = cross(n_.times(e[k]), polar_);
      }
      std::vector<mpz_class> values;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l <= k; ++l)
          values.emplace_back(form(e[k], tangent[l]) + form(e[l], tangent[k]));
      return common_sign(values);
    });
  }

 private:
  int turn(std::size_t i, std::size_t k) {
    return turns_[i] * turns_[k] * settled(i, k, [&] {
             std::vector<mpz_class> values;
             for (std::size_t a = 0; a < 3; ++a) {
               const auto plane = cross(c_, boundary_[i].point.arc().control(a));
               for (std::size_t b = 0; b < 3; ++b)
                 values.push_back(dot(plane, boundary_[k].point.arc().control(b)));
             }
             return common_sign(values);
           });
  }
  /// Asks with shorter and shorter arcs around two points.
  template <class Question>
  int settled(std::size_t i, std::size_t k, const Question& question) {
    constexpr int kMostCuts = 24;
    for (int cut = 0; cut < kMostCuts; ++cut) {
      if (const int sign = question(); sign != 0) return sign;
      boundary_[i].point.sharpen();
      if (k != i) boundary_[k].point.sharpen();
    }
    throw Open();
  }

  const Conic<mpz_class>& n_;
  Vector3<mpz_class> c_, polar_;
  std::vector<BoundaryPoint>& boundary_;
  std::vector<int> turns_;
};

/// Points that are probably inside the conic, for others to prove: near the eigenvector of the one
/// eigenvalue with a sign of its own, and beside it.
/// @param sign  of the determinant, and of that eigenvalue, as the form is trace-free
std::vector<Vector3<mpz_class>> likely_insides(const Conic<mpz_class>& n, int sign) {
  long shift = 0;
  for (const mpz_class& x : n.m)
    shift = std::max(shift, static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)));
  std::array<double, 6> m;
  for (std::size_t k = 0; k < 6; ++k) m[k] = ball_of(n.m[k], shift).value;
  const Eigen::Matrix3d matrix{{m[0], m[5], m[4]}, {m[5], m[1], m[3]}, {m[4], m[3], m[2]}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const Eigen::Index one = sign < 0 ? 0 : 2;
  std::vector<Vector3<mpz_class>> result;
  for (const double aside : {0.0, 0.25, -0.125}) {
    const double size = std::sqrt(std::abs(solver.eigenvalues()[one] / solver.eigenvalues()[1]));
    if (!(size < 1e300)) break;
    const Eigen::Vector3d c =
        solver.eigenvectors().col(one) + aside * size * solver.eigenvectors().col(1);
    Vector3<mpz_class> point;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = std::ldexp(c[static_cast<Eigen::Index>(k)], 40);
      if (!std::isfinite(x)) return result;
      point[k] = x;
    }
    result.push_back(point);
  }
  return result;
}

/// Where the curve enters the tetrahedron at a boundary point, it leaves it at the next one:
/// between them no weight changes its sign.
std::optional<std::vector<std::array<std::size_t, 2>>> pieces_seen_from(
    const SpanForms<mpz_class, 4>& forms, const Vector3<mpz_class>& c,
    std::vector<BoundaryPoint>& boundary, int side) {
  ConicOrder conic(forms.across[0], c, boundary);
  const std::vector<std::size_t> order = conic.order();
  std::vector<bool> enters(boundary.size());
  for (std::size_t i = 0; i < boundary.size(); ++i)
    enters[i] = conic.slope(i, forms.weight[boundary[i].opposite]) == side;
  std::vector<std::array<std::size_t, 2>> pieces;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k], next = order[(k + 1) % order.size()];
    if (enters[i] == enters[next]) return std::nullopt;
    if (enters[i]) pieces.push_back({i, next});
  }
  return pieces;
}

}  // namespace

std::optional<std::vector<std::array<std::size_t, 2>>> joined_in_tet(
    const std::array<Corner, 4>& corners, std::vector<BoundaryPoint> boundary, Kind kind) {
  std::array<Row<mpz_class>, 4> rows;
  std::array<Row<double>, 4> rough;
  for (std::size_t i = 0; i < 4; ++i) {
    rows[i] = row_of(corners[i].exact());
    const Row<Ball> row = row_of(*corners[i].ball);
    for (std::size_t k = 0; k < 5; ++k) rough[i][k] = row[k].value;
  }
  const SpanForms<mpz_class, 4> forms(rows, likely_columns(rough));
  const Conic<mpz_class>& n = forms.across[0];
  const int sign = sgn(n.determinant());
  if (forms.minor == 0 || sign == 0) return std::nullopt;
  for (const Vector3<mpz_class>& c : likely_insides(n, sign)) {
    if (sgn(n(c, c)) != sign) continue;
    try {
      return pieces_seen_from(forms, c, boundary, static_cast<int>(kind) * sgn(forms.minor));
    } catch (const Open&) {  // two of the points may be opposite to each other as seen from c
    }
  }
  return std::nullopt;
}

}  // namespace certificate
