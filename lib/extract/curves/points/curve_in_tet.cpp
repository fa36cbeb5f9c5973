// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/curve_in_tet.hpp"

#include "extract/curves/points/cell_rows.hpp"
#include "extract/curves/points/conic_order.hpp"
#include "extract/curves/points/conic_samples.hpp"
#include "extract/curves/points/exact_face_points.hpp"
#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {

namespace {

/// A boundary loop point in its place around the conic.
struct OrderedPoint {
  std::size_t index = 0;  ///< in the list of boundary loop points
  bool entering = false;
};

/// The boundary loop points in their order around the conic, with which enter: empty if a sign is
/// not certain.
template <class E>
std::vector<OrderedPoint> order_of(const FieldForms<E, 4>& forms, Verdict conic_sign,
                                   const ConicFrame& frame,
                                   const std::vector<BoundaryPoint>& boundary,
                                   const std::vector<Vector3<E>>& directions) {
  const auto& form = forms.across[0];
  const Verdict weight_sign = sign_in(forms.determinant);
  if (!is_strict(weight_sign)) return {};
  const auto order = order_around(form, conic_sign, frame, directions);
  std::vector<OrderedPoint> result;
  for (const SeenPoint& point : order.seen) {
    const std::size_t i = point.index;
    // Along the conic in the sense in which the angle grows; only one weight vanishes here.
    const auto along = cross(form * order.turned[i], order.tangent_plane);
    const Verdict slope = sign_in(polar(forms.weight[boundary[i].face], order.turned[i], along));
    if (!is_strict(slope)) return {};
    // The other weights have the sign of the point, as far as `weight` has that of the weights.
    const bool rising = slope == weight_sign;
    result.push_back({i, rising == boundary[i].point.linear});
  }
  return result;
}

/// The conic of a tetrahedron, rounded, with a form of negative determinant.
struct Conic {
  explicit Conic(const CellRows<4>& cell)
      : columns(best_columns(cell.rows<Extended>())), forms(cell.forms<Extended>(columns)) {
    if (determinant(forms.across[0]) > 0) forms.across[0] = -1.0L * forms.across[0];
    frame = frame_of(unit_form<double>(forms.across[0]));
  }

  std::array<std::size_t, 5> columns;
  FieldForms<Extended, 4> forms;
  ConicFrame frame;
};

std::vector<OrderedPoint> order_in_doubles(const CellRows<4>& cell, const Conic& conic,
                                           const std::vector<BoundaryPoint>& boundary) {
  const FastIntervalScope scope;
  const auto forms = cell.forms<FastInterval>(conic.columns);
  const Verdict sign = sign_in(determinant(forms.across[0]));
  if (!is_strict(sign)) return {};
  std::vector<Vector3<FastInterval>> directions;
  for (const auto& p : boundary) directions.push_back(directions_in<FastInterval>(p.point.box));
  return order_of(forms, sign, conic.frame, boundary, directions);
}

/// Why 150 digits do not settle a tetrahedron.
CurveObstacle obstacle_of(const std::array<ScaledTensor, 4>& tensors) {
  const auto rows = coordinate_rows<Rational>(tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  if (forms.determinant == 0) return CurveObstacle::dependent_tensors_in_cell;
  if (determinant(forms.across[0]) == 0) return CurveObstacle::neutral_characteristic;
  return CurveObstacle::points_not_told_apart;
}

std::vector<OrderedPoint> order_in_multiprecision(const std::array<ScaledTensor, 4>& tensors,
                                                  const Conic& conic,
                                                  const std::vector<BoundaryPoint>& boundary) {
  const auto forms = field_forms(coordinate_rows<MultiprecisionInterval>(tensors), conic.columns);
  const Verdict sign = sign_in(determinant(forms.across[0]));
  if (!is_strict(sign)) return {};
  std::vector<Vector3<MultiprecisionInterval>> directions;
  for (const auto& p : boundary) {
    const MultiprecisionFace face(
        {tensors[p.corners[0]], tensors[p.corners[1]], tensors[p.corners[2]]});
    directions.push_back(refined(face, p.point.box));
  }
  return order_of(forms, sign, conic.frame, boundary, directions);
}

}  // namespace

CurveInTet degenerate_curve_in_tet(const std::array<ScaledTensor, 4>& tensors,
                                   const std::vector<BoundaryPoint>& boundary,
                                   double largest_turn) {
  CurveInTet result;
  if (boundary.empty()) return result;
  const FloatingPointEnvironment environment;
  CellRows<4> cell(tensors);
  Conic conic(cell);
  auto seen = order_in_doubles(cell, conic, boundary);
  if (seen.empty() && cell.reduce()) {
    conic = Conic(cell);
    seen = order_in_doubles(cell, conic, boundary);
  }
  if (seen.empty()) seen = order_in_multiprecision(tensors, conic, boundary);
  if (seen.empty()) {
    result.obstacle = obstacle_of(tensors);
    return result;
  }
  const std::size_t count = seen.size();
  for (std::size_t i = 0; i < count; ++i)
    if (seen[i].entering == seen[(i + 1) % count].entering) {
      result.obstacle = CurveObstacle::points_not_told_apart;
      return result;
    }
  const ConicSampler sampler(conic.forms, conic.frame.inside, conic.frame.first, conic.frame.second);
  for (std::size_t i = 0; i < count; ++i) {
    if (!seen[i].entering) continue;
    const auto &begin = seen[i], &end = seen[(i + 1) % count];
    CurvePiece piece;
    piece.begin = begin.index;
    piece.end = end.index;
    piece.inner = sampler.between(boundary[begin.index].point.dominant,
                                  boundary[end.index].point.dominant, largest_turn);
    result.pieces.push_back(std::move(piece));
  }
  return result;
}

}  // namespace tensortopo
