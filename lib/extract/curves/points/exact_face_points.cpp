// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/exact_face_points.hpp"

#include <algorithm>

#include "extract/curves/points/dominant_direction.hpp"
#include "extract/curves/points/exact_direction.hpp"
#include "extract/level/proofs/screen.hpp"
#include "tensortopo/field/planar_critical_points.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

namespace {

using Corners = std::array<Deviator<double>, 3>;

/// The next step of Newton's method would be below 100 digits.
const Real100 kLastStep = ldexp(Real100(1), -200);

/// Halvings of the sides after which a triangle is no longer cut to exclude points in it.
constexpr int kDepth = 6;

/// Whether the triangle holds no degenerate tensor of a kind, by the screen on its parts. Rounding
/// moves the corners of these by a few units of 2^-53, so corners that are not much smaller than
/// the first ones are as good as exact: an angle may be wrong by far less than the screen allows
/// for.
bool is_excluded(const Corners& corners, double lode_angle, int depth) {
  bool large = true;
  for (const auto& t : corners) large = large && norm_form(t) > 0.01;
  if (large && screen::excludes(corners, lode_angle)) return true;
  if (depth == 0) return false;
  const auto middle = [&](std::size_t i, std::size_t j) {
    return 0.5 * corners[i] + 0.5 * corners[j];
  };
  const auto m01 = middle(0, 1), m02 = middle(0, 2), m12 = middle(1, 2);
  const std::array<Corners, 4> parts{
      {{corners[0], m01, m02}, {corners[1], m01, m12}, {corners[2], m02, m12}, {m01, m02, m12}}};
  return std::all_of(parts.begin(), parts.end(),
                     [&](const Corners& part) { return is_excluded(part, lode_angle, depth - 1); });
}

/// Whether all rows are multiples of one. Exact.
bool are_multiples(const std::array<Covector<Rational>, 3>& rows) {
  const auto pivot_of = [](const Covector<Rational>& row) {
    return std::find_if(row.begin(), row.end(), [](const Rational& x) { return x != 0; }) -
           row.begin();
  };
  const auto leading =
      std::min_element(rows.begin(), rows.end(),
                       [&](const auto& a, const auto& b) { return pivot_of(a) < pivot_of(b); });
  const auto p = static_cast<std::size_t>(pivot_of(*leading));
  if (p == leading->size()) return true;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      if (row[c] * (*leading)[p] != row[p] * (*leading)[c]) return false;
  return true;
}

/// Of conics that meet in infinitely many points, or in fewer than four complex ones.
CurveObstacle obstacle_of(const FieldForms<Rational, 3>& forms, const std::array<Rational, 4>& f) {
  for (const Rational& c : f)
    if (c != 0) return CurveObstacle::coincident_points_on_face;
  // All forms of the pencil are singular: they share a line of zeros, or a singular point.
  const auto k = kernel_of(forms.across[0]);
  if (!is_zero(k) && is_zero(forms.across[1] * k)) return CurveObstacle::coincident_points_on_face;
  return CurveObstacle::degenerate_conic_on_face;
}

/// The coordinates of a direction in a chart whose vectors are orthonormal up to rounding: good
/// enough for Newton's method.
template <class Real>
std::array<double, 2> coordinates_in(const DirectionChart& chart, const Vector3<Real>& e) {
  const Real along = dot(widened<Real>(chart.centre), e);
  return {static_cast<double>(Real(dot(widened<Real>(chart.first), e) / along)),
          static_cast<double>(Real(dot(widened<Real>(chart.second), e) / along))};
}

}  // namespace

MultiprecisionFace::MultiprecisionFace(const std::array<ScaledTensor, 3>& input)
    : tensors(input),
      columns(best_columns(coordinate_rows<Real100>(input))),
      forms(field_forms(coordinate_rows<MultiprecisionInterval>(input), columns)),
      rounded(field_forms(coordinate_rows<Real100>(input), columns)) {}

std::optional<std::array<MultiprecisionInterval, 2>> MultiprecisionFace::zero_near(
    const DirectionChart& chart, const std::array<double, 2>& at) const {
  const ChartForms<Real100> approximate(rounded.across, chart);
  const auto place = newton_zero<Real100>(approximate, {Real100(at[0]), Real100(at[1])}, 8,
                                          kLastStep);
  const auto inverse = inverse_of(approximate.jacobian(place));
  if (!inverse) return std::nullopt;
  std::array<MultiprecisionInterval, 2> centre;
  std::array<std::array<MultiprecisionInterval, 2>, 2> y;
  for (std::size_t i = 0; i < 2; ++i) {
    centre[i] = MultiprecisionInterval(place[i]);
    for (std::size_t j = 0; j < 2; ++j) y[i][j] = MultiprecisionInterval((*inverse)[i][j]);
  }
  return certified_zero<MultiprecisionInterval>(
      ChartForms<MultiprecisionInterval>(forms.across, chart), centre, y,
      ldexp(MultiprecisionInterval::End(1), -300));
}

namespace {

/// The zeros near the dominant eigenvectors of these points; none if one is not proved.
template <class Real>
std::vector<IsolatedZero> zeros_near(const MultiprecisionFace& face,
                                     const TriangleField<Real>& field) {
  std::vector<IsolatedZero> found;
  for (const auto& start : degenerate_points(field).points) {
    const auto e = dominant_direction(start);
    const DirectionChart chart = chart_around(
        {static_cast<double>(e.x), static_cast<double>(e.y), static_cast<double>(e.z)});
    const auto zero = face.zero_near(chart, coordinates_in(chart, e));
    if (!zero) return {};
    const auto box = direction_at(chart, (*zero)[0], (*zero)[1]);
    for (const auto& former : found)
      if (!are_apart(former.direction, box)) return {};
    found.push_back({chart, *zero, box});
  }
  return found;
}

}  // namespace

std::vector<IsolatedZero> isolated_zeros(const MultiprecisionFace& face, std::size_t expected) {
  CellRows<3> cell(face.tensors);
  cell.reduce();
  auto found = zeros_near(face, field_of(cell));
  if (found.size() == expected) return found;
  TriangleField<Real100> field;
  for (std::size_t i = 0; i < 3; ++i) field.vertex[i] = exact_deviator<Real100>(face.tensors[i]);
  return zeros_near(face, field);
}

namespace {

/// The number of degenerate points in the projective plane, or what keeps them from being counted.
struct PlaneCount {
  int points = 0;
  std::optional<CurveObstacle> obstacle;
};

PlaneCount count_in_plane(const MultiprecisionFace& face) {
  const auto sign =
      sign_in(cubic_discriminant(pencil_cubic(face.forms.across[0], face.forms.across[1])));
  if (is_strict(sign_in(face.forms.determinant)) && is_strict(sign))
    return {sign == Verdict::positive ? 4 : 2, std::nullopt};
  const auto rows = coordinate_rows<Rational>(face.tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  if (forms.determinant == 0) return {0, CurveObstacle::dependent_tensors_on_face};
  const auto cubic = pencil_cubic(forms.across[0], forms.across[1]);
  const Rational discriminant = cubic_discriminant(cubic);
  if (discriminant == 0) return {0, obstacle_of(forms, cubic)};
  return {discriminant > 0 ? 4 : 2, std::nullopt};
}

}  // namespace

FacePoints exact_face_points(const std::array<ScaledTensor, 3>& tensors) {
  FacePoints result;
  // What is wrong with the plane may be no concern of the triangle.
  const auto with = [&](CurveObstacle obstacle) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = exact_deviator<double>(tensors[i]);
    FacePoints none;
    none.concerns_linear = !is_excluded(corners, 0, kDepth);
    none.concerns_planar = !is_excluded(corners, pi<double>() / 3, kDepth);
    if (none.concerns_linear || none.concerns_planar) none.obstacle = obstacle;
    return none;
  };
  // Where the field is the same up to a factor, as in uniaxial stress, digits tell nothing.
  if (are_multiples(coordinate_rows<Rational>(tensors)))
    return with(CurveObstacle::dependent_tensors_on_face);
  const MultiprecisionFace face(tensors);
  const PlaneCount counted = count_in_plane(face);
  if (counted.obstacle) return with(*counted.obstacle);
  const Verdict orientation = sign_in(face.forms.determinant);
  if (!is_strict(orientation)) return with(CurveObstacle::points_not_told_apart);

  const auto zeros = isolated_zeros(face, static_cast<std::size_t>(counted.points));
  if (static_cast<int>(zeros.size()) != counted.points)
    return with(CurveObstacle::points_not_told_apart);
  for (const auto& [chart, zero, direction] : zeros) {
    int positive = 0, negative = 0;
    for (const auto& form : face.forms.weight) {
      const Verdict sign = sign_in(polar(form, direction, direction));
      if (is_strict(sign)) ++(sign == orientation ? positive : negative);
    }
    if (positive > 0 && negative > 0) continue;
    if (positive + negative < 3) {
      // Numbers that 150 digits do not tell from zero: at most two of the three.
      if (negative == 0) result.concerns_linear = true;
      if (positive == 0) result.concerns_planar = true;
      continue;
    }
    FacePoint point;
    point.linear = positive > 0;
    point.box = {chart.centre, chart.first, chart.second, {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      point.box.low[k] = mpfr_get_d(zero[k].low.backend().data(), MPFR_RNDD);
      point.box.high[k] = mpfr_get_d(zero[k].high.backend().data(), MPFR_RNDU);
    }
    result.points.push_back(point);
  }
  if (!result.concerns_linear && !result.concerns_planar) {
    result.in_plane = counted.points;
    return result;
  }
  result.obstacle = CurveObstacle::degenerate_point_on_edge;
  std::erase_if(result.points, [&](const FacePoint& point) {
    return point.linear ? result.concerns_linear : result.concerns_planar;
  });
  return result;
}

Vector3<MultiprecisionInterval> refined(const MultiprecisionFace& face, const DirectionBox& box) {
  const DirectionChart chart{box.centre, box.first, box.second};
  const std::array<double, 2> middle{0.5 * box.low[0] + 0.5 * box.high[0],
                                     0.5 * box.low[1] + 0.5 * box.high[1]};
  const auto inside = [&](const MultiprecisionInterval& x, std::size_t k) {
    return x.low >= box.low[k] && x.high <= box.high[k];
  };
  if (const auto zero = face.zero_near(chart, middle))
    if (inside((*zero)[0], 0) && inside((*zero)[1], 1))
      return direction_at(chart, (*zero)[0], (*zero)[1]);
  return directions_in<MultiprecisionInterval>(box);
}

}  // namespace tensortopo
