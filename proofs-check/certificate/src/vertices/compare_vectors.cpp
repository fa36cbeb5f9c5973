// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertices/compare_vectors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "run/parallel.hpp"
#include "vertices/linear_field.hpp"

namespace certificate {
namespace {

using BallVector = Vector3<Ball>;

enum class Shown : char { neither, yes, no };

/// Squares of what vectors may be off, and of what they certainly are if they are refuted.
constexpr double kNear = 0x1p-32, kFar = 0x1p-12, kNormalNear = 0x1p-20, kNormalFar = 0x1p-6;
/// Squares of the largest radius of an enclosure, in parts of what it encloses, by which a vector is
/// refuted. A vector that was computed in doubles is off by rounding of the same sums and products
/// as are enclosed here, so by a multiple of that radius. Sixteen times 2^-11 is half of 2^-6, the
/// root of `kFar`, and sixteen times 2^-8 half of 2^-3, that of `kNormalFar`.
constexpr double kKnown = 0x1p-22, kNormalKnown = 0x1p-16;
/// Of squares of eigenvalues: two of them may be as near as to exchange their order.
constexpr double kEqual = 0x1p-16;

bool is_positive(const Ball& x) { return x.value > x.error; }
bool is_negative(const Ball& x) { return -x.value > x.error; }

BallVector vector_at(const Array& array, std::size_t v) {
  return {Ball(array.numbers[3 * v], 0), Ball(array.numbers[3 * v + 1], 0),
          Ball(array.numbers[3 * v + 2], 0)};
}

/// The zero vector says nothing.
bool is_zero(const BallVector& v) { return v[0].value == 0 && v[1].value == 0 && v[2].value == 0; }

/// Is its length one, about? What is divided by its length in doubles is off by less than 2^-48.
Shown has_unit_length(const BallVector& v) {
  const Ball off = dot(v, v) - Ball(1);
  if (std::abs(off.value) + off.error < 0x1p-30) return Shown::yes;
  return std::abs(off.value) - off.error > 0x1p-10 ? Shown::no : Shown::neither;
}

/// Is the radius of the enclosures small beside the least length that they allow?
/// @param known  for squares
template <class Entries>
bool is_known(const Entries& entries, const Ball& square, double known) {
  double radius = 0;
  for (const Ball& x : entries) radius += 2 * x.error * x.error;  // some entries count twice
  return radius <= known * (square.value - square.error);
}

/// Whose eigenvector, of a tensor's three eigenvalues.
enum class Eigenvalue { largest, medium, smallest };

/// With w = M v, r = w - (v w) v for a unit vector v: it is an eigenvector of M - r v^T - v r^T. As
/// the three eigenvalues add up to 0, x is the medium one if and only if 6 x^2 <= tr(M^2).
Shown is_eigenvector(const Tensor<Ball>& m, const BallVector& v, Eigenvalue which) {
  const Conic<Ball> matrix{{m[0], m[1], m[2], m[3], m[4], m[5]}};
  const BallVector w = matrix.times(v);
  const Ball value = dot(v, w), length = dot(v, v), size = trace(m, m);
  if (!is_positive(size)) return Shown::neither;
  BallVector r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = length * w[k] - value * v[k];
  const Ball square = dot(r, r), six = Ball(6) * value * value;
  const Shown otherwise =
      is_known(std::span(m).first<6>(), size, kKnown) ? Shown::no : Shown::neither;
  if (is_positive(square - Ball(kFar, 0) * size)) return otherwise;
  const bool is_medium = which == Eigenvalue::medium;
  const Ball beyond =
      is_medium ? Ball(1 + kEqual, 0) * size - six : six - Ball(1 - kEqual, 0) * size;
  const bool has_sign =
      is_medium || is_positive(which == Eigenvalue::largest ? value : Ball(-1) * value);
  const bool has_other_sign =
      !is_medium && is_negative(which == Eigenvalue::largest ? value : Ball(-1) * value);
  if (is_negative(beyond + Ball(kFar, 0) * size) || has_other_sign) return otherwise;
  const bool is_near = is_negative(square - Ball(kNear, 0) * size);
  return is_near && is_positive(beyond) && has_sign ? Shown::yes : Shown::neither;
}

/// A level's vectors.
class Vectors {
 public:
  /// @param invariant  of which the level is; nothing: the mode
  Vectors(const LevelCase& c, const PlacedSurface& placed, std::optional<Invariant> invariant);
  Shown show_eigenvector(const Array& array, std::size_t v, Eigenvalue which) const;
  Shown show_normal(const Array& array, std::size_t v) const;

 private:
  struct Around {
    std::size_t first = 0, count = 0;  ///< in `tets_`
  };
  bool is_apex(std::size_t v) const { return certificate::is_apex(c_, placed_.carriers[v]); }
  Point3 rounding_at(std::size_t field) const;
  std::optional<BallVector> gradient_at(std::size_t field, const Point3& x) const;

  const LevelCase& c_;
  const PlacedSurface& placed_;
  std::optional<Invariant> invariant_;
  std::vector<std::size_t> names_;  ///< of `fields_`: tetrahedra, ascending
  std::vector<LinearField> fields_;
  std::vector<Around> around_;     ///< each vertex
  std::vector<std::size_t> tets_;  ///< places in `fields_`
};

Vectors::Vectors(const LevelCase& c, const PlacedSurface& placed,
                 std::optional<Invariant> invariant)
    : c_(c), placed_(placed), invariant_(invariant), names_(placed.tets), around_(placed.carriers.size()) {
  std::sort(names_.begin(), names_.end());
  names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
  fields_.reserve(names_.size());
  for (const std::size_t t : names_) fields_.emplace_back(c.input, c.input.tets[t]);
  std::vector<std::array<std::size_t, 2>> pairs;  // vertex, field
  for (std::size_t t = 0; t < placed.tets.size(); ++t) {
    const auto field = static_cast<std::size_t>(
        std::lower_bound(names_.begin(), names_.end(), placed.tets[t]) - names_.begin());
    for (const std::uint32_t v : c.surface.triangles[c.triangles.first + t])
      pairs.push_back({v - c.vertices.first, field});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [v, field] : pairs) {
    Around& around = around_[v];
    if (around.count++ == 0) around.first = tets_.size();
    tets_.push_back(field);
  }
}

/// Of a vertex' coordinates.
Point3 Vectors::rounding_at(std::size_t field) const {
  Point3 largest{};
  for (const Vertex i : c_.input.tets[names_[field]])
    for (std::size_t k = 0; k < 3; ++k)
      largest[k] = std::max(largest[k], rounding_of(std::abs(c_.input.points[i][k])));
  return largest;
}

Shown Vectors::show_eigenvector(const Array& array, std::size_t v, Eigenvalue which) const {
  if (is_apex(v) || around_[v].count == 0) return Shown::neither;
  const std::size_t field = tets_[around_[v].first];
  const BallVector vector = vector_at(array, c_.vertices.first + v);
  if (is_zero(vector)) return Shown::neither;
  const Shown unit = has_unit_length(vector);
  if (unit != Shown::yes) return unit;
  Tensor<Ball> m = fields_[field].at(c_.surface.points[c_.vertices.first + v], rounding_at(field));
  const Ball& volume = fields_[field].volume();
  if (!is_positive(volume) && !is_negative(volume)) return Shown::neither;
  if (is_negative(volume))
    for (Ball& x : m) x = Ball(-1) * x;
  scale_to_one(m);
  return is_eigenvector(m, vector, which);
}

/// The gradient of P dQ - 3/2 Q dP for P = tr(M^2) and Q = det(M): P adj(M) - 3 Q M.
Tensor<Ball> gradient_of_mode(const Tensor<Ball>& m) {
  const Tensor<Ball> adjugate{m[1] * m[2] - m[3] * m[3], m[0] * m[2] - m[4] * m[4],
                              m[0] * m[1] - m[5] * m[5], m[4] * m[5] - m[0] * m[3],
                              m[3] * m[5] - m[1] * m[4], m[3] * m[4] - m[2] * m[5]};
  const Ball p = trace(m, m);
  const Ball q = m[0] * adjugate[0] + m[5] * adjugate[5] + m[4] * adjugate[4];
  Tensor<Ball> result;
  for (std::size_t k = 0; k < 6; ++k) result[k] = p * adjugate[k] - Ball(3) * q * m[k];
  return result;
}

/// Of the mode or another invariant, at a positive multiple of the tensor m, as long as the changes
/// go from one place to others: up to a positive factor and what is the same for all changes.
std::array<Ball, 4> increases_along(const std::optional<Invariant>& invariant,
                                    const Tensor<Ball>& m, const LinearField& field) {
  std::array<Ball, 4> result;
  const Tensor<Ball> gradient = invariant ? m : gradient_of_mode(m);
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor<Ball>& change = field.corner(i);
    const Ball along = trace(gradient, change);
    // With P = tr(M^2) and the trace t: 9 |D|^2 = P, 9 |T|^2 = P + 3 t^2, and the anisotropy
    // increases with P / t^2.
    const Ball of_trace = m[6] * change[6];
    if (!invariant || *invariant == Invariant::deviator_magnitude) result[i] = along;
    else if (*invariant == Invariant::magnitude) result[i] = along + Ball(3) * of_trace;
    else result[i] = m[6] * (m[6] * along - trace(m, m) * change[6]);
  }
  return result;
}

/// As long as one, if that is shown.
std::optional<BallVector> Vectors::gradient_at(std::size_t field, const Point3& x) const {
  const LinearField& inside = fields_[field];
  const bool is_turned = is_negative(inside.volume());
  if (!is_turned && !is_positive(inside.volume())) return std::nullopt;
  Tensor<Ball> m = inside.at(x, rounding_at(field));
  if (is_turned)
    for (Ball& entry : m) entry = Ball(-1) * entry;
  scale_to_one(m);
  BallVector g = inside.gradient(increases_along(invariant_, m, inside));
  const Ball length = square_root(dot(g, g));
  if (!(length.error < length.value)) return std::nullopt;
  for (Ball& entry : g) entry = quotient(is_turned ? Ball(-1) * entry : entry, length);
  return g;
}

/// The mean of the gradients in the tetrahedra around, each as long as one.
Shown Vectors::show_normal(const Array& array, std::size_t v) const {
  if (is_apex(v) || around_[v].count == 0) return Shown::neither;
  const BallVector vector = vector_at(array, c_.vertices.first + v);
  if (is_zero(vector)) return Shown::neither;
  const Shown unit = has_unit_length(vector);
  if (unit != Shown::yes) return unit;
  BallVector sum{};
  for (std::size_t i = 0; i < around_[v].count; ++i) {
    const auto g =
        gradient_at(tets_[around_[v].first + i], c_.surface.points[c_.vertices.first + v]);
    if (!g) return Shown::neither;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += (*g)[k];
  }
  const Ball square = dot(sum, sum), along = dot(sum, vector);
  const BallVector across = cross(sum, vector);
  const Ball off = dot(across, across);
  if (!is_positive(square - Ball(0x1p-10, 0))) return Shown::neither;
  if (is_negative(along) || is_positive(off - Ball(kNormalFar, 0) * square))
    return is_known(sum, square, kNormalKnown) ? Shown::no : Shown::neither;
  return is_positive(along) && is_negative(off - Ball(kNormalNear, 0) * square) ? Shown::yes
                                                                                : Shown::neither;
}

}  // namespace

void compare_vectors(const LevelCase& c, const PlacedSurface& placed, Ledger& ledger) {
  std::optional<Vectors> vectors;
  std::optional<Invariant> invariant;
  bool is_negative_mode = false;
  if (const auto mode = c.claims.find("mode"); mode != c.claims.end())
    is_negative_mode = mode->get<std::string>()[0] == '-';
  else
    invariant = invariant_of(c.claims["invariant"]);
  const Eigenvalue dominant = is_negative_mode ? Eigenvalue::smallest : Eigenvalue::largest;
  for (const Array& array : c.surface.arrays) {
    const bool is_normal = array.name == "normal",
               is_medium = !invariant && array.name == "medium_eigenvector",
               is_dominant = !invariant && array.name == "dominant_eigenvector";
    if (array.of != "points" || array.components != 3 || !(is_normal || is_medium || is_dominant))
      continue;
    if (!vectors) vectors.emplace(c, placed, invariant);
    std::vector<Shown> shown(placed.carriers.size());
    parallel_for(shown.size(), [&](std::size_t v) {
      shown[v] = is_normal ? vectors->show_normal(array, v)
                           : vectors->show_eigenvector(array, v,
                                                       is_medium ? Eigenvalue::medium : dominant);
    });
    ledger.of_level().vectors[array.name] =
        static_cast<std::size_t>(std::count(shown.begin(), shown.end(), Shown::yes));
    const auto wrong = std::find(shown.begin(), shown.end(), Shown::no);
    if (wrong == shown.end()) continue;
    const std::size_t v = c.vertices.first + static_cast<std::size_t>(wrong - shown.begin());
    const Json claimed = {array.numbers[3 * v], array.numbers[3 * v + 1], array.numbers[3 * v + 2]};
    ledger.refute(array.name + " at vertex " + std::to_string(v), claimed.dump(),
                  is_normal ? "it is not in the direction of the gradients around"
                            : "it is no such eigenvector of the field there");
  }
}

}  // namespace certificate
