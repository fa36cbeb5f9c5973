// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/special/special_full_cell.hpp"

#include <algorithm>

#include "extract/curves/points/certified_zero.hpp"
#include "extract/curves/points/conic_order.hpp"
#include "extract/curves/special/line_pair.hpp"
#include "extract/curves/special/plane_directions.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

template <std::size_t Vertices>
SpecialForms<Vertices>::SpecialForms(const std::array<ScaledTensor, Vertices>& tensors,
                                     bool linear) {
  const auto rows = coordinate_rows<Rational>(tensors);
  columns = best_columns(rows);
  exact = field_forms(rows, columns);
  enclosed = field_forms(coordinate_rows<MultiprecisionInterval>(tensors), columns);
  rounded = field_forms(coordinate_rows<Extended>(tensors), columns);
  positive = (exact.determinant > 0) == linear;
}

template <std::size_t Vertices>
std::array<Verdict, Vertices> SpecialForms<Vertices>::signs(const ExactDirection& e) const {
  std::array<Verdict, Vertices> result;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto value = polar(enclosed.weight[i], e, e);
    result[i] = sign_in(positive ? value : -value);
  }
  return result;
}

template <std::size_t Vertices>
Verdict SpecialForms<Vertices>::inside(const ExactDirection& e) const {
  bool all = true;
  for (const Verdict sign : signs(e)) {
    if (sign == Verdict::negative) return Verdict::negative;
    all = all && sign == Verdict::positive;
  }
  return all ? Verdict::positive : Verdict::unknown;
}

template <std::size_t Vertices>
CurveSample SpecialForms<Vertices>::sample(const Vector3<Extended>& e) const {
  CurveSample result;
  result.dominant = e;
  Extended sum = 0;
  for (std::size_t i = 0; i < Vertices; ++i) {
    result.weights[i] = polar(rounded.weight[i], e, e);
    sum += result.weights[i];
  }
  for (auto& w : result.weights) w /= sum;
  return result;
}

template <std::size_t Vertices>
SpecialPoint SpecialForms<Vertices>::point(const ExactDirection& e) const {
  SpecialPoint result;
  result.support = kAllVertices<Vertices>;
  result.dominant = rounded_direction(e);
  result.weights = sample(result.dominant).weights;
  result.direction = e;
  return result;
}

template struct SpecialForms<3>;
template struct SpecialForms<4>;

namespace {

SpecialCell not_told_apart() {
  SpecialCell cell;
  cell.obstacle = CurveObstacle::points_not_told_apart;
  return cell;
}

/// A direction of the curve across the normal, if it has no point on the boundary: then all of it
/// is inside, or nothing.
std::optional<ExactDirection> direction_inside(const SpecialForms<3>& forms,
                                               const ExactDirection& normal, bool& certain) {
  certain = true;
  for (const double x : {1.0, -2.0, 5.0, 0.25}) {
    const ExactDirection other{MultiprecisionInterval(x), MultiprecisionInterval(x * x + 1),
                               MultiprecisionInterval(3 - x)};
    const auto e = normalized(cross(normal, other));
    const Verdict verdict = forms.inside(e);
    if (verdict == Verdict::positive) return e;
    if (verdict == Verdict::negative) return std::nullopt;
  }
  certain = false;
  return std::nullopt;
}

/// The directions of the conic that pass between two others, seen from inside.
struct ConicArcs {
  const SpecialForms<4>& forms;
  const SymmetricTensor<MultiprecisionInterval>& form;
  const ConicFrame& frame;

  Verdict inside(const ExactDirection& first, const ExactDirection& second) const {
    const auto c = widened<MultiprecisionInterval>(frame.inside);
    const auto plane = form * c;
    const auto at_c = dot(c, plane);
    const auto turns_left = [&](const ExactDirection& x, const ExactDirection& y) {
      return sign_in(dot(cross(c, x), y)) == Verdict::positive;
    };
    // Less than half a turn may be less than doubles resolve, and so may what is left of a turn.
    const bool is_short = turns_left(first, second), is_long = turns_left(second, first);
    const auto verdict_at = [&](const ExactDirection& m) {
      const bool between = is_long ? turns_left(m, second) || turns_left(first, m)
                                   : turns_left(first, m) && turns_left(m, second);
      if (!between) return Verdict::unknown;
      // Where the conic's form, negative at c, vanishes at m + t c, on the side of c.
      const auto mixed = dot(m, plane);
      const auto root = sqrt_of(mixed * mixed - polar(form, m, m) * at_c);
      return forms.inside(normalized((-at_c) * m + (mixed + root) * c));
    };
    const double begin = angle(first);
    double width = angle(second) - begin;
    if (width <= 0 || (is_long && width < 1)) width += 2 * pi<double>();
    for (const double part : {0.5, 0.375, 0.625, 0.25, 0.75, 0.4375}) {
      const double a = begin + part * width;
      const Verdict verdict =
          verdict_at(is_short ? MultiprecisionInterval(1 - part) * first +
                                    MultiprecisionInterval(part) * second
                              : widened<MultiprecisionInterval>(elementary::cos(a) * frame.first +
                                                                elementary::sin(a) * frame.second));
      if (is_strict(verdict)) return verdict;
    }
    return Verdict::unknown;
  }
  double angle(const ExactDirection& e) const {
    const auto u = rounded_direction(e);
    const Vector3<double> m{static_cast<double>(u.x), static_cast<double>(u.y),
                            static_cast<double>(u.z)};
    return elementary::atan2(dot(m, frame.second), dot(m, frame.first));
  }
};

SpecialCell curve_on_conic(const SpecialForms<4>& forms, bool negated,
                           std::span<const SpecialPoint> boundary, double largest_turn) {
  SpecialCell cell;
  // One point alone is touched.
  if (boundary.size() < 2) return cell;
  auto rounded = forms.rounded;
  auto form = forms.enclosed.across[0];
  if (negated) {
    rounded.across[0] = Extended(-1) * rounded.across[0];
    form = MultiprecisionInterval(-1.0) * form;
  }
  const auto frame = frame_of(unit_form<double>(rounded.across[0]));
  std::vector<ExactDirection> directions;
  for (const auto& point : boundary) directions.push_back(*point.direction);
  const auto order = order_around(form, Verdict::negative, frame, directions);
  if (order.seen.empty()) return not_told_apart();
  const ConicSampler sampler(rounded, frame.inside, frame.first, frame.second);
  const ConicArcs arcs{forms, form, frame};
  for (std::size_t i = 0; i < order.seen.size(); ++i) {
    const std::size_t begin = order.seen[i].index;
    const std::size_t end = order.seen[(i + 1) % order.seen.size()].index;
    const Verdict inside = arcs.inside(order.turned[begin], order.turned[end]);
    if (!is_strict(inside)) return not_told_apart();
    if (inside == Verdict::negative) continue;
    cell.pieces.push_back(
        {{begin, end},
         sampler.between(boundary[begin].dominant, boundary[end].dominant, largest_turn),
         false});
  }
  return cell;
}

/// The vertices of positive weight at the crossing of two lines; nothing if a weight is negative.
std::optional<unsigned> support_at(const SpecialForms<4>& forms,
                                   const Vector3<Rational>& crossing) {
  unsigned support = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const int sign = polar(forms.exact.weight[i], crossing, crossing).sign();
    if (sign != 0 && (sign > 0) != forms.positive) return std::nullopt;
    if (sign != 0) support |= 1u << i;
  }
  return support;
}

/// The characteristic tensor is neutral: two planes of directions, and where they cross the curve
/// crosses itself.
SpecialCell curve_on_lines(const SpecialForms<4>& forms, std::span<const SpecialPoint> boundary,
                           double largest_turn, std::span<const SpecialCell* const> faces) {
  SpecialCell cell;
  const LinePair lines(forms.exact.across[0]);
  const auto crossing = normalized(interval_of(lines.kernel()));
  const auto support = support_at(forms, lines.kernel());
  std::optional<std::size_t> crossing_stop;
  if (support == kAllVertices<4>) {
    cell.points.push_back(forms.point(crossing));
    crossing_stop = boundary.size();
  }
  std::array<ExactDirection, 2> normals{lines.normal(0), lines.normal(1)};
  std::array<std::vector<std::size_t>, 2> stops;
  std::array<std::vector<ExactDirection>, 2> directions;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const auto& e = *boundary[i].direction;
    const bool crosses = support && boundary[i].support == *support && !are_apart(e, crossing);
    std::array<bool, 2> on;
    for (std::size_t k = 0; k < 2; ++k) on[k] = !is_strict(sign_in(dot(normals[k], e)));
    if (!crosses && on[0] == on[1]) return not_told_apart();
    for (std::size_t k = 0; k < 2; ++k)
      if (on[k]) stops[k].push_back(i), directions[k].push_back(e);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (crossing_stop) stops[k].push_back(*crossing_stop), directions[k].push_back(crossing);
    if (stops[k].empty()) continue;
    // A whole line in a face is found there.
    bool in_face = false;
    for (const SpecialCell* face : faces)
      if (face && face->axis)
        in_face = in_face || !are_apart(normals[k], normalized(interval_of(*face->axis)));
    if (!in_face &&
        !add_turning_pieces(forms, normals[k], stops[k], directions[k], largest_turn, false, cell))
      return not_told_apart();
  }
  if (cell.pieces.empty()) cell.points.clear();
  return cell;
}

}  // namespace

Vector3<Rational> crossing_of(const std::array<ScaledTensor, 4>& tensors) {
  const auto rows = coordinate_rows<Rational>(tensors);
  const auto forms = field_forms(rows, best_columns(rows));
  if (forms.determinant == 0 || determinant(forms.across[0]) != 0) return {};
  return kernel_of(forms.across[0]);
}

SpecialCell curve_in_full_face(const std::array<ScaledTensor, 3>& tensors, bool linear,
                               std::span<const SpecialPoint> boundary, double largest_turn,
                               std::span<const ExactDirection> crossings) {
  SpecialCell cell;
  const auto plane = plane_directions(tensors);
  if (!plane.settled) return not_told_apart();
  const SpecialForms<3> forms(tensors, linear);
  std::vector<std::size_t> stops;  // across the axis
  std::vector<ExactDirection> directions;
  std::vector<char> on_boundary(plane.points.size(), 0);
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const auto& e = *boundary[i].direction;
    if (const auto k = position_in(plane.points, e))
      on_boundary[*k] = 1;
    else if (plane.axis)
      stops.push_back(i), directions.push_back(e);
    else
      return not_told_apart();
  }
  for (std::size_t k = 0; k < plane.points.size(); ++k) {
    const Verdict inside = forms.inside(plane.points[k]);
    if (inside == Verdict::negative || on_boundary[k]) continue;
    if (inside != Verdict::positive) return not_told_apart();
    cell.points.push_back(forms.point(plane.points[k]));
  }
  cell.axis = plane.axis;
  if (!plane.axis) return cell;
  const auto normal = normalized(interval_of(*plane.axis));
  for (const auto& e : crossings) {
    const bool known = std::any_of(directions.begin(), directions.end(),
                                   [&](const auto& other) { return !are_apart(e, other); });
    const Verdict inside = forms.inside(e);
    if (known || inside == Verdict::negative) continue;
    if (inside != Verdict::positive) return not_told_apart();
    stops.push_back(boundary.size() + cell.points.size());
    directions.push_back(e);
    cell.points.push_back(forms.point(e));
  }
  if (stops.empty()) {
    bool certain = true;
    const auto e = direction_inside(forms, normal, certain);
    if (!certain) return not_told_apart();
    if (!e) return cell;
    stops.push_back(boundary.size() + cell.points.size());
    directions.push_back(*e);
    cell.points.push_back(forms.point(*e));
  }
  if (!add_turning_pieces(forms, normal, stops, directions, largest_turn, true, cell))
    return not_told_apart();
  return cell;
}

SpecialCell curve_in_full_tet(const std::array<ScaledTensor, 4>& tensors, bool linear,
                              std::span<const SpecialPoint> boundary, double largest_turn,
                              std::span<const SpecialCell* const> faces) {
  if (boundary.empty()) return {};
  const SpecialForms<4> forms(tensors, linear);
  const int sign = determinant(forms.exact.across[0]).sign();
  if (sign == 0) return curve_on_lines(forms, boundary, largest_turn, faces);
  return curve_on_conic(forms, sign > 0, boundary, largest_turn);
}

}  // namespace tensortopo
