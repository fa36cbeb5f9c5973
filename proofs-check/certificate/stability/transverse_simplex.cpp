// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "transverse_simplex.hpp"

#include <algorithm>

#include "free_simplex.hpp"
#include "parts.hpp"

namespace certificate {
namespace {

using Vector = std::array<double, 3>;

/// A ball around a tensor that holds all members of a part: it is convex.
template <std::size_t V, std::size_t C>
Widened around(const Matrix& centre, const std::array<Point<V>, C>& part) {
  Widened ball{centre, 0};
  for (const Point<V>& point : part)
    ball.radius = std::max(ball.radius, (largest_norm(point.matrix + Ball(-1) * centre) +
                                         point.radius) * Ball::kSlack);
  return ball;
}

/// A guess at the eigenvector of the largest eigenvalue, of about unit length: the largest column of
/// a high power of the matrix with its norm added.
Vector guess_axis(const Matrix& matrix) {
  const double norm = largest_norm(matrix);
  const auto& m = matrix;
  std::array<Vector, 3> power{{{m[0].value + norm, m[5].value, m[4].value},
                               {m[5].value, m[1].value + norm, m[3].value},
                               {m[4].value, m[3].value, m[2].value + norm}}};
  std::size_t column = 0;
  for (int n = 0; n < 6; ++n) {
    std::array<Vector, 3> square{};
    double trace = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) square[i][j] += power[i][k] * power[k][j];
        if (i == j) trace += square[i][j];
      }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) power[i][j] = square[i][j] / trace;
  }
  for (std::size_t i = 1; i < 3; ++i)
    if (power[i][i] > power[column][column]) column = i;
  Vector axis = power[column];
  const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  for (double& x : axis) x /= length;
  return axis;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// v^T M w.
Ball form(const Matrix& m, const Vector& v, const Vector& w) {
  const auto at = [&](std::size_t i) { return Ball(v[i], 0); };
  const auto to = [&](std::size_t i) { return Ball(w[i], 0); };
  return at(0) * (m[0] * to(0) + m[5] * to(1) + m[4] * to(2)) +
         at(1) * (m[5] * to(0) + m[1] * to(1) + m[3] * to(2)) +
         at(2) * (m[4] * to(0) + m[3] * to(1) + m[2] * to(2));
}

/// Is |<y, c>| > 1 + 2^-9 for every unit vector y and some of these columns c, exact doubles?
template <std::size_t V>
bool reach_beyond_disc(const std::array<std::array<double, 2>, V>& columns) {
  for (std::size_t i = 0; i < V; ++i)
    for (std::size_t j = i + 1; j < V; ++j)
      for (const int sign : {1, -1}) {
        // y is orthogonal to this side of the parallelogram of two columns.
        const auto& [ax, ay] = columns[i];
        const auto& [bx, by] = columns[j];
        if (ax == 0 && ay == 0 && bx == 0 && by == 0) return false;
        if (ax == -sign * bx && ay == -sign * by) continue;
        const Ball x = Ball(ax, 0) + Ball(sign) * Ball(bx, 0),
                   y = Ball(ay, 0) + Ball(sign) * Ball(by, 0);
        const double length = std::hypot(std::abs(x.value) + x.error, std::abs(y.value) + y.error);
        const bool found = std::any_of(columns.begin(), columns.end(), [&](const auto& c) {
          const Ball product = x * Ball(c[1], 0) - y * Ball(c[0], 0);
          return std::abs(product.value) - product.error > length * (1 + 0x1p-9) * Ball::kSlack;
        });
        if (!found) return false;
      }
  return true;
}

/// Three vectors that are orthonormal but for 2^-45.
struct Frame {
  Vector p{}, q{}, axis;

  explicit Frame(const Vector& n) : axis(n) {
    Vector other{};
    other[std::abs(n[0]) < 0.6 ? 0 : std::abs(n[1]) < 0.6 ? 1 : 2] = 1;
    p = cross(n, other);
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (double& x : p) x /= length;
    q = cross(n, p);
  }
  /// Along the two tensors normal to the degenerate ones of the axis.
  std::array<Ball, 2> normal_part(const Matrix& m) const {
    const Ball half(0.7071067811865476, 0x1p-52);
    return {half * (form(m, p, p) - form(m, q, q)), half * (form(m, p, q) + form(m, p, q))};
  }
};

/// Is no member of a part degenerate with an axis at most an angle from the frame's? `distance` is at least
/// that of members from a degenerate tensor of this axis.
template <std::size_t V, std::size_t C>
bool is_beside(const std::array<Point<V>, C>& part, const Frame& frame, double angle,
               double distance) {
  std::array<std::array<double, 2>, C> places;
  std::array<double, C> least;
  std::array<double, 2> mean{};
  for (std::size_t a = 0; a < C; ++a) {
    const auto normal = frame.normal_part(part[a].matrix);
    places[a] = {normal[0].value, normal[1].value};
    mean[0] += places[a][0], mean[1] += places[a][1];
    const double size = part[a].norm + part[a].radius;
    least[a] = (part[a].radius + angle * distance + angle * angle * size + 0x1p-38 * size +
                normal[0].error + normal[1].error) *
               Ball::kSlack * Ball::kSlack;
  }
  const auto separates = [&](double x, double y) {
    const double length = std::hypot(x, y);
    return length > 0 && std::isfinite(length) && [&] {
      for (std::size_t a = 0; a < C; ++a)
        if (!((x * places[a][0] + y * places[a][1]) / length > least[a])) return false;
      return true;
    }();
  };
  if (separates(mean[0], mean[1])) return true;
  for (std::size_t a = 0; a < C; ++a)
    for (std::size_t b = a + 1; b < C; ++b)
      for (const int sign : {1, -1})
        if (separates(sign * (places[b][1] - places[a][1]), sign * (places[a][0] - places[b][0])))
          return true;
  return false;
}

/// Are members transverse wherever they are degenerate with an axis at most an angle from the frame's?
template <std::size_t V>
bool is_transverse(const std::array<Widened, V>& corners, const Frame& frame, double angle) {
  std::array<std::array<double, 2>, V> columns;
  for (std::size_t i = 0; i < V; ++i) {
    const Matrix& m = corners[i].centre;
    const auto normal = frame.normal_part(m);
    const double size = largest_norm(m),
                 across = std::hypot(upper_modulus(form(m, frame.axis, frame.p)),
                                     upper_modulus(form(m, frame.axis, frame.q)));
    // The frame and the quotients below are rounded.
    const double change = (std::min(angle * size, 1.4143 * angle * across + angle * angle * size) +
                           corners[i].radius + 0x1p-38 * size + normal[0].error + normal[1].error) *
                          Ball::kSlack;
    if (!(change > 0)) return false;
    columns[i] = {normal[0].value / change, normal[1].value / change};
  }
  return reach_beyond_disc(columns);
}

template <std::size_t V, std::size_t C>
bool part_is_transverse(const std::array<Widened, V>& corners,
                        const std::array<Point<V>, C>& part) {
  Matrix centre;
  for (const auto& point : part) centre = centre + Ball(1.0 / C, 0) * point.matrix;
  static const ModeBall one(1, 1);
  if (vertex_is_free(around(centre, part), one) == Answer::yes) return true;
  const Vector n = guess_axis(centre);
  if (!std::isfinite(n[0] + n[1] + n[2])) return false;
  // s (n n^T - (n . n) I / 3), s about what the centre has along n.
  const Ball s(1.5 * form(centre, n, n).value, 0);
  const auto entry = [&](std::size_t i, std::size_t j) { return Ball(n[i], 0) * Ball(n[j], 0); };
  const Ball third = Ball(1.0 / 3, 0x1p-54) * (entry(0, 0) + entry(1, 1) + entry(2, 2));
  if (!(s.value > 0)) return false;
  const Matrix degenerate = s * Matrix{entry(0, 0) - third, entry(1, 1) - third,
                                       entry(2, 2) - third, entry(1, 2), entry(0, 2), entry(0, 1)};
  const double distance = around(degenerate, part).radius,
               sine = distance / smallest_norm(degenerate) * Ball::kSlack;
  if (!(sine < 0.75)) return false;  // of the angle a between the tensors
  // sin^2 of that between their axes is 2 (1 - cos a) / 3, and 1 - cos a = sin^2 a / (1 + cos a).
  const double cosine = std::sqrt(1 - sine * sine) / Ball::kSlack,
               between = std::sqrt(2.0 / 3 * sine * sine / (1 + cosine)) * Ball::kSlack * Ball::kSlack;
  if (!(between < 0.5)) return false;
  const double angle = 1.048 * between;  // arcsin(1/2) = 0.5235...
  const Frame frame(n);
  return is_beside(part, frame, angle, distance) || (V > 2 && is_transverse(corners, frame, angle));
}

}  // namespace

template <std::size_t V>
Answer simplex_is_transverse(const std::array<Widened, V>& corners) {
  const auto test = [&](const auto& part) { return part_is_transverse(corners, part); };
  return holds_in_parts<V>(corners, test, test);
}

template Answer simplex_is_transverse(const std::array<Widened, 2>&);
template Answer simplex_is_transverse(const std::array<Widened, 3>&);
template Answer simplex_is_transverse(const std::array<Widened, 4>&);

}  // namespace certificate
