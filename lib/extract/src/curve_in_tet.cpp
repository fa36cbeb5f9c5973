// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/curve_in_tet.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certified_zero.hpp"
#include "conic_samples.hpp"
#include "degenerate_forms.hpp"
#include "enclosures.hpp"
#include "exact_face_points.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {

namespace {

/// A frame of numbers taken as exact, near the eigenvectors of the conic's form: `inside` is the
/// point that the conic is seen from.
struct ConicFrame {
  Vector3<double> first{}, second{}, inside{};
};

/// A rim point as seen from inside the conic.
struct SeenPoint {
  std::size_t index = 0;  ///< in the list of rim points
  bool upper = false;     ///< in the first half turn from the reference direction
  double angle = 0;       ///< from the reference direction, rounded
  bool entering = false;
};

/// Where the reference direction is: as far as possible from the points and their opposites.
double reference_angle(const std::vector<double>& angles) {
  constexpr int kCandidates = 48;
  double best = 0, farthest = -1;
  for (int k = 0; k < kCandidates; ++k) {
    const double candidate = pi<double>() * k / kCandidates;
    double nearest = 2;
    for (const double a : angles) nearest = std::min(nearest, std::abs(std::sin(a - candidate)));
    if (nearest > farthest) farthest = nearest, best = candidate;
  }
  return best;
}

/// The order of the points around the conic, with which enter: empty if a sign is not certain.
template <class E>
std::vector<SeenPoint> order_around(const FieldForms<E, 4>& forms, Verdict conic_sign,
                                    const ConicFrame& frame, const std::vector<RimPoint>& rim,
                                    const std::vector<Vector3<E>>& directions) {
  // With det N < 0 the cone e.N e < 0 around c is solid, and every e of the conic can be turned
  // to the side of c; N' = -N otherwise.
  const auto& form = forms.across[0];
  const bool negated = conic_sign == Verdict::positive;
  const auto c = widened<E>(frame.inside);
  const auto tangent_plane = form * c;
  const Verdict at_c = sign_in(dot(c, tangent_plane));
  const Verdict weight_sign = sign_in(forms.determinant);
  if (at_c != (negated ? Verdict::positive : Verdict::negative) || !is_strict(weight_sign))
    return {};

  std::vector<Vector3<E>> turned;
  std::vector<double> angles;
  for (const auto& e : directions) {
    const Verdict side = sign_in(dot(e, tangent_plane));
    if (!is_strict(side)) return {};
    turned.push_back(side == at_c ? e : -e);
    const auto middle = [](const E& x) { return EnclosureOf<E>::middle(x); };
    const Vector3<double> m{middle(turned.back().x), middle(turned.back().y),
                            middle(turned.back().z)};
    angles.push_back(std::atan2(dot(m, frame.second), dot(m, frame.first)));
  }
  const double start = reference_angle(angles);
  const Vector3<double> reference = std::cos(start) * frame.first + std::sin(start) * frame.second;
  const auto half_plane = cross(c, widened<E>(reference));

  std::vector<SeenPoint> seen(rim.size());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Verdict half = sign_in(dot(half_plane, turned[i]));
    if (!is_strict(half)) return {};
    double angle = std::fmod(angles[i] - start, 2 * pi<double>());
    if (angle < 0) angle += 2 * pi<double>();
    // Along the conic in the sense in which the angle grows; only one weight vanishes here.
    const auto along = cross(form * turned[i], tangent_plane);
    const Verdict slope = sign_in(polar(forms.weight[rim[i].face], turned[i], along));
    if (!is_strict(slope)) return {};
    // The other weights have the sign of the point, as far as `weight` has that of the weights.
    const bool rising = slope == weight_sign;
    seen[i] = {i, half == Verdict::positive, angle, rising == rim[i].point.linear};
  }
  std::sort(seen.begin(), seen.end(), [](const SeenPoint& p, const SeenPoint& q) {
    return p.upper != q.upper ? p.upper : p.angle < q.angle;
  });
  // Angles are rounded: what they say of neighbours is proved, or put right by insertion.
  for (std::size_t i = 1; i < seen.size(); ++i)
    for (std::size_t k = i; k > 0 && seen[k].upper == seen[k - 1].upper; --k) {
      const auto plane = cross(c, turned[seen[k - 1].index]);
      const Verdict order = sign_in(dot(plane, turned[seen[k].index]));
      if (!is_strict(order)) return {};
      if (order == Verdict::positive) break;
      std::swap(seen[k - 1], seen[k]);
    }
  return seen;
}

ConicFrame frame_of(const SymmetricTensor<double>& form) {
  const auto eigen = eigen_decomposition(form);
  return {eigen.vectors[0], eigen.vectors[1], eigen.vectors[2]};
}

std::vector<SeenPoint> order_in_doubles(const std::array<ScaledTensor, 4>& tensors,
                                        const std::array<std::size_t, 5>& columns,
                                        const ConicFrame& frame, const std::vector<RimPoint>& rim) {
  const FastIntervalScope scope;
  const auto forms = field_forms(coordinate_rows<FastInterval>(tensors), columns);
  const Verdict sign = sign_in(determinant(forms.across[0]));
  if (!is_strict(sign)) return {};
  std::vector<Vector3<FastInterval>> directions;
  for (const auto& p : rim) directions.push_back(directions_in<FastInterval>(p.point.box));
  return order_around(forms, sign, frame, rim, directions);
}

/// Why 150 digits do not settle a tetrahedron.
CurveObstacle obstacle_of(const std::array<ScaledTensor, 4>& tensors) {
  const auto rows = coordinate_rows<Rational>(tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  if (forms.determinant == 0) return CurveObstacle::dependent_tensors_in_cell;
  if (determinant(forms.across[0]) == 0) return CurveObstacle::neutral_characteristic;
  return CurveObstacle::points_not_told_apart;
}

std::vector<SeenPoint> order_in_long(const std::array<ScaledTensor, 4>& tensors,
                                     const std::array<std::size_t, 5>& columns,
                                     const ConicFrame& frame, const std::vector<RimPoint>& rim) {
  const auto forms = field_forms(coordinate_rows<LongInterval>(tensors), columns);
  const Verdict sign = sign_in(determinant(forms.across[0]));
  if (!is_strict(sign)) return {};
  std::vector<Vector3<LongInterval>> directions;
  for (const auto& p : rim) {
    const LongFace face({tensors[p.corners[0]], tensors[p.corners[1]], tensors[p.corners[2]]});
    directions.push_back(refined(face, p.point.box));
  }
  return order_around(forms, sign, frame, rim, directions);
}

}  // namespace

CurveInTet degenerate_curve_in_tet(const std::array<ScaledTensor, 4>& tensors,
                                   const std::vector<RimPoint>& rim, double largest_turn) {
  CurveInTet result;
  if (rim.empty()) return result;
  const FloatingPointEnvironment environment;
  const auto rows = coordinate_rows<long double>(tensors);
  const auto columns = best_columns(rows);
  auto forms = field_forms(rows, columns);
  if (determinant(forms.across[0]) > 0) forms.across[0] = -1.0L * forms.across[0];
  const auto frame = frame_of(unit_form<double>(forms.across[0]));

  auto seen = order_in_doubles(tensors, columns, frame, rim);
  if (seen.empty()) {
    seen = order_in_long(tensors, columns, frame, rim);
    if (seen.empty()) {
      result.obstacle = obstacle_of(tensors);
      return result;
    }
  }
  const std::size_t count = seen.size();
  for (std::size_t i = 0; i < count; ++i)
    if (seen[i].entering == seen[(i + 1) % count].entering) {
      result.obstacle = CurveObstacle::points_not_told_apart;
      return result;
    }
  const ConicSampler sampler(forms, frame.inside, frame.first, frame.second);
  for (std::size_t i = 0; i < count; ++i) {
    if (!seen[i].entering) continue;
    const auto &begin = seen[i], &end = seen[(i + 1) % count];
    CurvePiece piece;
    piece.begin = begin.index;
    piece.end = end.index;
    piece.inner = sampler.between(rim[begin.index].point.dominant, rim[end.index].point.dominant,
                                  largest_turn);
    result.pieces.push_back(std::move(piece));
  }
  return result;
}

}  // namespace tensortopo
