// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "free_simplex.hpp"

#include <algorithm>

#include "guess.hpp"
#include "parts.hpp"

namespace certificate {
namespace {

/// 6 / sqrt(6), rounded up.
constexpr double kRootSix = 2.4494897427831783;

Ball root_of_six() { return {kRootSix, 0x1p-50}; }

/// A function of members' tensors T + E, linear up to a rest: value + tr(gradient E), and for
/// members up to `more` above it.
struct Bound {
  Ball value;
  Matrix gradient;
  double more = 0, size = 0;  ///< rounded up; of the value's modulus
};

/// The part of (a + da) (b + db) (c + dc) that is not linear in changes of at most these.
double rest(double a, double da, double b, double db, double c, double dc) {
  return (a * db * dc + da * b * dc + da * db * c + da * db * dc) * Ball::kSlack;
}

/// Is F positive on a part for all members, with these bounds for the norm?
template <std::size_t V, std::size_t C>
bool is_positive(const std::array<Widened, V>& corners, const std::array<Point<V>, C>& part,
                 const std::array<Bound, C>& norms, const std::array<double, V>& d,
                 const Ball& six_nu) {
  Matrix along;
  double along_radius = 0;
  for (std::size_t i = 0; i < V; ++i) {
    along = along + Ball(d[i], 0) * corners[i].centre;
    along_radius = (along_radius + std::abs(d[i]) * corners[i].radius) * Ball::kSlack;
  }
  const double along_norm = largest_norm(along);
  // Everything below is six times F.
  const Ball half = six_nu * Ball(0.5, 0);
  const double size_of_half = std::abs(half.value) + half.error;
  for (std::size_t a = 0; a < C; ++a)
    for (std::size_t b = a; b < C; ++b) {
      const Matrix by_along =
          sixfold(part[a].matrix, part[b].matrix) +
          (Ball(-1) * half) *
              (norms[a].value * part[b].matrix + norms[b].value * part[a].matrix);
      double least = lower(inner(by_along, along));
      if (!(least > 0)) return false;
      const auto by = [&](std::size_t at, std::size_t other) {
        return sixfold(part[other].matrix, along) +
               (Ball(-1) * half) * (norms[other].value * along +
                                    inner(part[other].matrix, along) * norms[at].gradient);
      };
      const Matrix by_a = by(a, b), by_b = by(b, a);
      double loss = 0;
      for (std::size_t i = 0; i < V; ++i)
        loss += corners[i].radius *
                largest_norm(Ball(d[i], 0) * by_along + Ball(part[a].weights[i], 0) * by_a +
                             Ball(part[b].weights[i], 0) * by_b);
      const Point<V>&p = part[a], &q = part[b];
      loss += kRootSix * Ball::kSlack *
              rest(p.norm, p.radius, q.norm, q.radius, along_norm, along_radius);
      const auto of_norm = [&](const Bound& norm, const Point<V>& at, const Point<V>& other) {
        return rest(norm.size, at.radius + norm.more, other.norm, other.radius, along_norm,
                    along_radius) +
               norm.more * upper_modulus(inner(other.matrix, along));
      };
      loss += size_of_half * (of_norm(norms[a], p, q) + of_norm(norms[b], q, p));
      least -= loss * Ball::kSlack * Ball::kSlack;
      if (!(least > 0)) return false;
    }
  return true;
}

/// Is a part free, by one direction?
template <std::size_t V, std::size_t C>
bool part_is_free(const std::array<Widened, V>& corners, const std::array<Point<V>, C>& part,
                  const std::array<double, V>& d, const ModeBall& mode) {
  // <U, T> <= |T| for U the sum's direction, made a little shorter.
  Matrix sum;
  for (const auto& point : part) sum = sum + point.matrix;
  const double size = largest_norm(sum);
  if (!(size > 0)) return false;
  const Matrix unit = Ball(1 / size / Ball::kSlack, 0) * sum;
  if (!(largest_norm(unit) <= 1)) return false;
  std::array<Bound, C> norms;
  for (std::size_t a = 0; a < C; ++a) {
    norms[a] = {inner(unit, part[a].matrix), unit, 0, part[a].norm};
    if (!(lower(norms[a].value) > part[a].radius * Ball::kSlack)) return false;  // a zero
  }
  if (!is_positive(corners, part, norms, d, mode.times_root_six)) return false;
  if (mode.times_root_six.value == 0 && mode.times_root_six.error == 0) return true;
  // |T| <= (|T|^2 / r + r) / 2 for r about |T|.
  for (std::size_t a = 0; a < C; ++a) {
    const double r = part[a].norm;
    const Ball over = inverse(Ball(r, 0)), half(0.5, 0);
    const Matrix& m = part[a].matrix;
    norms[a] = {half * (inner(m, m) * over + Ball(r, 0)), over * m,
                part[a].radius * part[a].radius / (2 * r) * Ball::kSlack, r * Ball::kSlack};
  }
  return is_positive(corners, part, norms, d, mode.times_root_six);
}

}  // namespace

ModeBall::ModeBall(const mpz_class& numerator, const mpz_class& denominator) {
  if (numerator == 0) return;
  mode = ball_of(numerator, 0) * inverse(ball_of(denominator, 0));
  times_root_six = mode * root_of_six();
}

Answer vertex_is_free(const Widened& vertex, const ModeBall& level) {
  const Matrix& d = vertex.centre;
  if (vertex.radius >= largest_norm(d)) return Answer::no;
  if (!(vertex.radius * Ball::kSlack < smallest_norm(d))) return Answer::unsure;
  const Ball size = root(inner(d, d)), over = inverse(size),
             sine = Ball(vertex.radius, vertex.radius * Ball::kUnit) * over;
  // sin(60 degrees) = 0.86602...: all modes are within reach.
  if (lower(sine) > 0.8661) return Answer::no;
  if (!(upper(sine) < 0.866)) return Answer::unsure;
  // The mode is sqrt(6) tr(D^3) / |D|^3.
  Ball mode = root_of_six() * Ball(1.0 / 6, 0x1p-54) * inner(sixfold(d, d), d) * over * over * over;
  Ball mu = level.mode;
  const Ball gap = mode - mu;
  if (!(std::abs(gap.value) > gap.error)) return Answer::unsure;
  if (gap.value < 0) mode = Ball(-1) * mode, mu = Ball(-1) * mu;
  const Ball square = sine * sine, sine3 = sine * (Ball(3) - Ball(4) * square),
             cosine3 = root(Ball(1) - square) * (Ball(1) - Ball(4) * square),
             other = root(Ball(1) - mode * mode);
  // Of the sum of three times both angles.
  const Ball sum_sine = other * cosine3 + mode * sine3,
             sum_cosine = mode * cosine3 - other * sine3 - mu;
  if (lower(sum_sine) > 0 && lower(sum_cosine) > 0) return Answer::yes;
  return upper(sum_sine) < 0 || upper(sum_cosine) < 0 ? Answer::no : Answer::unsure;
}

template <std::size_t V>
Answer simplex_is_free(const std::array<Widened, V>& corners, const ModeBall& mode) {
  const double nu = mode.times_root_six.value / 6;
  return holds_in_parts<V>(
      corners,
      [&](const std::array<Point<V>, V>& part) {
        for (const int steps : {0, 2, 8})
          if (part_is_free(corners, part,
                           guess_direction<V, V>(corners, weights_of(part), nu, steps), mode))
            return true;
        return false;
      },
      [&](const std::array<Point<V>, 1>& middle) {
        return part_is_free(corners, middle,
                            guess_direction<V, 1>(corners, weights_of(middle), nu, 8), mode);
      });
}

template Answer simplex_is_free(const std::array<Widened, 2>&, const ModeBall&);
template Answer simplex_is_free(const std::array<Widened, 3>&, const ModeBall&);
template Answer simplex_is_free(const std::array<Widened, 4>&, const ModeBall&);

}  // namespace certificate
