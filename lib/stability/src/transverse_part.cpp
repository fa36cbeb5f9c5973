// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "transverse_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo::stability {

namespace {

/// Bounds are taken larger than need be, so that a checker with somewhat larger ones agrees.
constexpr double kMargin = 1.0625;

/// The half angle of a cone around a unit tensor that holds all members of a part; infinite if it
/// is not convex.
template <std::size_t Vertices, std::size_t Corners>
double cone_angle(const Part<Vertices, Corners>& part, const Traceless& unit) {
  double largest = 0;
  for (std::size_t a = 0; a < Corners; ++a) {
    const double rounding = 0x1p3 * kRounding * part.bounds[a], radius = part.radii[a] + rounding,
                 along = inner(unit, part.tensors[a]),
                 across = norm(part.tensors[a] - along * unit) + rounding,
                 sine = radius / (part.norms[a] - rounding);
    if (!(along > rounding) || !(sine < 1) || !(sine >= 0))
      return std::numeric_limits<double>::infinity();
    largest =
        std::max(largest, elementary::atan2(across, along - rounding) + elementary::asin(sine));
  }
  return largest < 1.57 ? largest * (1 + kRounding) : std::numeric_limits<double>::infinity();
}

/// A vector in the plane across an axis.
struct Column {
  double x, y;
};

double cross(const Column& a, const Column& b) { return a.x * b.y - a.y * b.x; }

/// Is |<y, c>| > 1 for each unit vector y and some column c?
///
/// The largest of these moduli is, between the directions at which two of them are equal, least at
/// such a direction: there y is orthogonal to the difference or the sum of two columns.
template <std::size_t Count>
bool exceed_unit_disc(const std::array<Column, Count>& columns) {
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t j = i + 1; j < Count; ++j)
      for (const double sign : {1.0, -1.0}) {
        const Column side{columns[i].x + sign * columns[j].x, columns[i].y + sign * columns[j].y};
        const double length = elementary::hypot(side.x, side.y),
                     sizes = elementary::hypot(columns[i].x, columns[i].y) +
                             elementary::hypot(columns[j].x, columns[j].y);
        if (!(sizes > 0)) return false;
        if (length == 0) continue;  // equal in all directions
        // The direction is off by a few roundings of the columns.
        const double error = 0x1p-48 * sizes / length;
        const bool one_exceeds = std::any_of(columns.begin(), columns.end(), [&](const Column& c) {
          return std::abs(cross(side, c)) / length >
                 1 + error * elementary::hypot(c.x, c.y) + kRounding;
        });
        if (!one_exceeds) return false;
      }
  return true;
}

/// Orthonormal, up to a few roundings, with the axis of a linear degenerate tensor.
struct Frame {
  Vector3<double> p, q, axis;

  /// A tensor's parts along the two traceless tensors in the plane across the axis.
  Column normal_part(const Traceless& t) const {
    const Vector3<double> tp = t * p, tq = t * q;
    const double root = std::sqrt(0.5);
    return {root * (dot(p, tp) - dot(q, tq)), 2 * root * dot(p, tq)};
  }
};

/// Is no member degenerate with an axis that is at most an angle from the frame's? `sine` is that
/// of the half angle of a cone around the frame's degenerate tensor that holds all members.
///
/// A degenerate member has no normal part along its own axis, and turning the plane there changes
/// that of T by at most |T| (angle * sine + angle^2). So it is enough that the normal parts of all
/// members lie beyond this on one side of a line.
template <std::size_t Vertices, std::size_t Corners>
bool is_beside(const Part<Vertices, Corners>& part, const Frame& frame, double angle, double sine) {
  std::array<Column, Corners> places;
  std::array<double, Corners> least;
  Column mean{0, 0};
  for (std::size_t a = 0; a < Corners; ++a) {
    places[a] = frame.normal_part(part.tensors[a]);
    least[a] = part.radii[a] + (part.norms[a] + part.radii[a]) * (angle * sine + angle * angle) +
               0x1p4 * kRounding * part.bounds[a];
    mean.x += places[a].x, mean.y += places[a].y;
  }
  const auto separates = [&](Column y) {
    const double length = elementary::hypot(y.x, y.y);
    if (!(length > 0)) return false;
    y.x /= length, y.y /= length;
    for (std::size_t a = 0; a < Corners; ++a)
      if (!(y.x * places[a].x + y.y * places[a].y > kMargin * least[a])) return false;
    return true;
  };
  if (separates(mean)) return true;
  for (std::size_t a = 0; a < Corners; ++a)
    for (std::size_t b = a + 1; b < Corners; ++b) {
      const Column across{places[b].y - places[a].y, places[a].x - places[b].x};
      if (separates(across) || separates({-across.x, -across.y})) return true;
    }
  return false;
}

/// Do members cross the linear degenerate tensors transversally wherever they are degenerate with
/// an axis that is at most an angle from the frame's?
template <std::size_t Vertices>
bool crosses(const BoxSimplex<Vertices>& simplex, const Frame& frame, double angle) {
  std::array<Column, Vertices> columns;
  for (std::size_t i = 0; i < Vertices; ++i) {
    const Traceless& t = simplex.tensors[i];
    const Vector3<double> along = t * frame.axis;
    const double across = elementary::hypot(dot(frame.p, along), dot(frame.q, along)),
                 size = norm(t),
                 change = std::min(angle * size,
                                   std::sqrt(2.0) * angle * across + angle * angle * size) +
                          simplex.radii[i] + 0x1p6 * kRounding;
    const Column part = frame.normal_part(t);
    columns[i] = {part.x / (kMargin * change), part.y / (kMargin * change)};
  }
  return exceed_unit_disc(columns);
}

}  // namespace

template <std::size_t Vertices, std::size_t Corners>
bool is_transverse(const BoxSimplex<Vertices>& simplex, const Part<Vertices, Corners>& part) {
  Traceless centre = part.tensors[0];
  for (std::size_t a = 1; a < Corners; ++a) centre = centre + part.tensors[a];
  const double size = norm(centre);
  if (!(size > 0)) return false;
  const Traceless unit = (1 / size) * centre;
  const double mode = std::sqrt(6.0) * inner(product(unit, unit), unit),
               lode_angle = elementary::acos(std::clamp(mode, -1.0, 1.0)) / 3;
  if (kMargin * cone_angle(part, unit) + kAngleError < lode_angle) return true;
  const auto eigen = eigen_decomposition(unit);
  const Frame frame{eigen.vectors[1], eigen.vectors[2], eigen.vectors[0]};
  const Vector3<double>& n = frame.axis;
  const double third = dot(n, n) / 3, scale = std::sqrt(1.5);
  const Traceless degenerate{scale * (n.x * n.x - third), scale * (n.y * n.y - third),
                             scale * (n.z * n.z - third), scale * n.x * n.y,
                             scale * n.y * n.z,           scale * n.x * n.z};
  const double cone = cone_angle(part, degenerate);
  if (!(cone < 0.8)) return false;
  const double angle =
      elementary::asin(2 / std::sqrt(3.0) * elementary::sin(cone / 2)) * (1 + kRounding) +
      kRounding;
  if (is_beside(part, frame, angle, elementary::sin(cone) + kRounding)) return true;
  return Vertices > 2 && crosses(simplex, frame, angle);
}

#define TENSORTOPO_INSTANTIATE(Vertices, Corners) \
  template bool is_transverse(const BoxSimplex<Vertices>&, const Part<Vertices, Corners>&);
TENSORTOPO_INSTANTIATE(2, 1)
TENSORTOPO_INSTANTIATE(2, 2)
TENSORTOPO_INSTANTIATE(3, 1)
TENSORTOPO_INSTANTIATE(3, 3)
TENSORTOPO_INSTANTIATE(4, 1)
TENSORTOPO_INSTANTIATE(4, 4)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::stability
