// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/degenerate_points_on_face.hpp"

#include <cmath>

#include "extract/curves/points/cell_rows.hpp"
#include "extract/curves/points/certified_zero.hpp"
#include "extract/curves/points/degenerate_forms.hpp"
#include "extract/curves/points/dominant_direction.hpp"
#include "extract/curves/points/enclosures.hpp"
#include "extract/curves/points/exact_face_points.hpp"
#include "tensortopo/scalar/extended.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

template <class Real>
std::array<SymmetricTensor<Real>, 2> middle_of(
    const std::array<SymmetricTensor<FastInterval>, 2>& forms) {
  const auto middle = [](const FastInterval& x) {
    return Real(EnclosureOf<FastInterval>::middle(x));
  };
  std::array<SymmetricTensor<Real>, 2> result;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& f = forms[k];
    result[k] = {middle(f.xx), middle(f.yy), middle(f.zz),
                 middle(f.xy), middle(f.yz), middle(f.xz)};
  }
  return result;
}

/// A box of the size at which doubles end, around the zero near e.
std::optional<DirectionBox> certified_box(const std::array<SymmetricTensor<FastInterval>, 2>& forms,
                                          const Vector3<double>& e) {
  const auto rough = chart_around(e);
  const auto rounded = middle_of<double>(forms);
  const auto [u, v] = newton_zero<double>({rounded, rough}, {0, 0}, 2);
  const DirectionChart chart = chart_around(direction_at(rough, u, v));
  const auto inverse = inverse_of(ChartForms<double>(rounded, chart).jacobian({0, 0}));
  if (!inverse) return std::nullopt;
  std::array<std::array<FastInterval, 2>, 2> y;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) y[i][j] = FastInterval((*inverse)[i][j]);
  const ChartForms<FastInterval> exact(forms, chart);
  const auto zero = certified_zero<FastInterval>(exact, {FastInterval(0.0), FastInterval(0.0)}, y,
                                                 std::ldexp(1.0, -52));
  if (!zero) return std::nullopt;
  return DirectionBox{chart.centre,
                      chart.first,
                      chart.second,
                      {(*zero)[0].inf(), (*zero)[1].inf()},
                      {(*zero)[0].sup(), (*zero)[1].sup()}};
}

/// What the weights say of a point: positive or negative inside (linear or planar), zero outside.
Verdict place_of(const std::array<SymmetricTensor<FastInterval>, 3>& weight, Verdict orientation,
                 const Vector3<FastInterval>& e) {
  bool negative = false, positive = false, unknown = false;
  for (const auto& form : weight) {
    const Verdict sign = sign_in(polar(form, e, e));
    if (!is_strict(sign))
      unknown = true;
    else
      (sign == orientation ? positive : negative) = true;
  }
  if (negative && positive) return Verdict::zero;
  if (unknown) return Verdict::unknown;
  return positive ? Verdict::positive : Verdict::negative;
}

using Starts = std::array<Vector3<double>, 4>;

/// By intervals of doubles: nothing if these leave anything open.
std::optional<FacePoints> points_in_doubles(const CellRows<3>& cell,
                                            const std::array<std::size_t, 5>& columns,
                                            const Starts& starts, std::size_t count) {
  const FastIntervalScope scope;
  const auto forms = cell.forms<FastInterval>(columns);
  const Verdict orientation = sign_in(forms.determinant);
  if (!is_strict(orientation)) return std::nullopt;
  // Two conics with four simple common points have no others.
  if (count == 2) {
    const auto cubic = pencil_cubic(forms.across[0], forms.across[1]);
    if (sign_in(cubic_discriminant(cubic)) != Verdict::negative) return std::nullopt;
  } else if (count != 4) {
    return std::nullopt;
  }
  std::array<DirectionBox, 4> boxes;
  std::array<Vector3<FastInterval>, 4> directions;
  for (std::size_t i = 0; i < count; ++i) {
    const auto box = certified_box(forms.across, starts[i]);
    if (!box) return std::nullopt;
    boxes[i] = *box;
    directions[i] = directions_in<FastInterval>(*box);
    for (std::size_t j = 0; j < i; ++j)
      if (!are_apart(directions[i], directions[j])) return std::nullopt;
  }
  FacePoints result;
  result.in_plane = static_cast<int>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Verdict place = place_of(forms.weight, orientation, directions[i]);
    if (place == Verdict::unknown) return std::nullopt;
    if (place == Verdict::zero) continue;
    FacePoint point;
    point.linear = place == Verdict::positive;
    point.box = boxes[i];
    result.points.push_back(point);
  }
  return result;
}

/// Direction and weights, rounded, from a box.
void locate(FacePoints& face, const CellRows<3>& cell,
            const std::array<std::size_t, 5>& columns) {
  const auto forms = cell.forms<Extended>(columns);
  for (FacePoint& point : face.points) {
    const auto& box = point.box;
    const DirectionChart chart{box.centre, box.first, box.second};
    std::array<Extended, 2> x;
    for (std::size_t k = 0; k < 2; ++k) x[k] = Extended(box.low[k]) / 2 + Extended(box.high[k]) / 2;
    // A box from the other tier is already narrower than this would get.
    if (!face.exact) x = newton_zero<Extended>({forms.across, chart}, x, 2);
    point.dominant = direction_at(chart, x[0], x[1]);
    Extended sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      point.weights[i] = polar(forms.weight[i], point.dominant, point.dominant);
      sum += point.weights[i];
    }
    for (auto& w : point.weights) w /= sum;
  }
}

/// All of it by the rows at hand, in doubles.
std::optional<FacePoints> points_from(const CellRows<3>& cell) {
  const auto columns = best_columns(cell.rows<double>());
  Starts starts;
  std::size_t count = 0;
  for (const auto& point : degenerate_points(field_of(cell)).points)
    if (count < 4) starts[count++] = dominant_direction(point);
  auto result = points_in_doubles(cell, columns, starts, count);
  if (result && !result->points.empty()) locate(*result, cell, columns);
  return result;
}

}  // namespace

FacePoints degenerate_points_on_face(const std::array<ScaledTensor, 3>& tensors) {
  const FloatingPointEnvironment environment;
  CellRows<3> cell(tensors);
  if (auto result = points_from(cell)) return *result;
  if (cell.reduce())
    if (auto result = points_from(cell)) return *result;
  FacePoints result = exact_face_points(tensors);
  result.exact = true;
  if (!result.points.empty()) locate(result, cell, best_columns(cell.rows<double>()));
  return result;
}

}  // namespace tensortopo
