// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "refinement_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extractor_scalars.hpp"
#include "tiers.hpp"

namespace tensortopo::detail {

namespace {

/// Unit tensors that add up to less than this are nearly opposite; such an edge is cut at a
/// multiple of 2^-50 at the finest.
constexpr double kNearlyOpposite = 1.0 / 16;
constexpr int kCutBits = 50;

/// In a triangle unit tensors have a mean below this where the field nearly vanishes. (Around a
/// zero in space all triangles come close to it; such cuts would only use up the bits.)
constexpr double kNearlyVanishing = 1.0 / 1024;

/// A sum of tensors that is smaller than its terms by this factor is formed in the longer scalar.
constexpr double kCancelled = 64;

/// Levels with 1 - mode^2 below this are tubes so thin that cells around them get small without
/// end.
constexpr double kSmallGap = 1e-3;

/// Tensors with a smaller squared sine of their angle span no plane to speak of, and a place of
/// smaller weights is on the side of a triangle rather than inside.
constexpr double kApart = 1.0 / 256, kInside = 1.0 / 64;

/// Whole numbers in about this ratio: the finer, the smaller the sum of the tensors is there.
std::array<std::int64_t, 2> whole_shares(double first, double second, double sum) {
  const int bits = std::min(kCutBits, 6 - std::ilogb(std::max(sum, 0x1p-60)));
  const double all = std::ldexp(1.0, bits), part = std::round(first / (first + second) * all);
  return {static_cast<std::int64_t>(part), static_cast<std::int64_t>(all - part)};
}

/// The power of two that brings a norm form to [3, 12).
int normalizing_exponent(double norm_form) { return -std::ilogb(std::sqrt(norm_form / 3)); }

}  // namespace

template <class Scalar, std::size_t Vertices>
RefinementVertex<Scalar, Vertices> corner_vertex(const LevelSimplex<Scalar, Vertices>& simplex,
                                                 std::size_t i) {
  RefinementVertex<Scalar, Vertices> corner;
  corner.place = ExactWeights<Vertices>::at_corner(i);
  corner.weights = corner.place.values().high;
  corner.tensor = simplex.tensors[i];
  corner.above = simplex.above[i];
  return corner;
}

template <class Scalar, std::size_t Vertices>
std::optional<PlaceBetween<Scalar, Vertices>> place_between(
    const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
    const std::array<std::int64_t, 2>& shares, const RefinementVertex<Scalar, Vertices>& u,
    const RefinementVertex<Scalar, Vertices>& v) {
  const auto place = ExactWeights<Vertices>::combination(shares[0], u.place, shares[1], v.place);
  if (!place) return std::nullopt;
  const ExactPlace<Vertices> exact = place->values();
  const double total = std::accumulate(exact.high.begin(), exact.high.end(), 0.0);
  RefinementVertex<Scalar, Vertices> m;
  m.tensor = tensor_at(simplex.tensors, exact.high);
  const double norm = std::sqrt(static_cast<double>(norm_form(m.tensor)));
  const double gap = static_cast<double>(Scalar(1) - level.mu_squared);
  if (gap < kSmallGap && !exact.fits_in_doubles() && total <= kCancelled * norm)
    return std::nullopt;
  const bool is_cancelled = !exact.fits_in_doubles() || total > kCancelled * norm;
  if (is_cancelled) m.tensor = tensor_by_longer_scalar(simplex, exact);
  const auto square = static_cast<double>(norm_form(m.tensor));
  if (!(square > 0)) return std::nullopt;
  const int e = normalizing_exponent(square);
  m.place = place->scaled(e);
  for (std::size_t i = 0; i < Vertices; ++i) {
    m.weights[i] = std::ldexp(exact.high[i], e);
    m.rest[i] = std::ldexp(exact.low[i], e);
  }
  m.tensor = Scalar(std::ldexp(1.0, e)) * m.tensor;
  m.total = std::ldexp(total, e);
  if (is_cancelled) m.total = 1 + m.total * kLongerTotal;
  m.above = is_above<Scalar, Vertices>(simplex, m.tensor, m.exact(), level, m.total);
  return PlaceBetween<Scalar, Vertices>{m, std::ldexp(static_cast<double>(shares[0]), e),
                                        std::ldexp(static_cast<double>(shares[1]), e)};
}

template <class Scalar, std::size_t Vertices>
std::array<std::int64_t, 2> shares_of_cut(const RefinementVertex<Scalar, Vertices>& u,
                                          const RefinementVertex<Scalar, Vertices>& v,
                                          const std::array<std::int64_t, 2>& usual) {
  const auto [s, t] = rounded(std::array{u.tensor, v.tensor});
  const double s_norm = std::sqrt(norm_form(s)), t_norm = std::sqrt(norm_form(t));
  const double sum = std::sqrt(norm_form((1 / s_norm) * s + (1 / t_norm) * t));
  if (!(sum < kNearlyOpposite)) return usual;
  const auto first = static_cast<double>(usual[0]), second = static_cast<double>(usual[1]);
  const double off = (first - second) / (first + second) / 2 * sum;
  return whole_shares((0.5 + off) / s_norm, (0.5 - off) / t_norm, sum);
}

template <class Scalar, std::size_t Vertices>
std::optional<std::array<std::int64_t, 2>> shares_opposite_to(
    const RefinementVertex<Scalar, Vertices>& w, const RefinementVertex<Scalar, Vertices>& u,
    const RefinementVertex<Scalar, Vertices>& v) {
  auto units = rounded(std::array{w.tensor, u.tensor, v.tensor});
  std::array<double, 3> norms{};
  for (std::size_t i = 0; i < 3; ++i) {
    norms[i] = std::sqrt(norm_form(units[i]));
    if (!(norms[i] > 0)) return std::nullopt;
    units[i] = (1 / norms[i]) * units[i];
  }
  // The smallest of c + x a + y b.
  const auto& [c, a, b] = units;
  const double ab = norm_form(a, b), ac = norm_form(a, c), bc = norm_form(b, c);
  const double determinant = 1 - ab * ab;
  if (!(determinant > kApart)) return std::nullopt;
  const double x = (ab * bc - ac) / determinant, y = (ab * ac - bc) / determinant;
  if (!(x > kInside) || !(y > kInside)) return std::nullopt;
  const double sum = std::sqrt(norm_form(c + x * a + y * b)) / (1 + x + y);
  if (!(sum < kNearlyVanishing)) return std::nullopt;
  return whole_shares(x / norms[1], y / norms[2], sum);
}

#define TENSORTOPO_INSTANTIATE_VERTICES(Scalar, Vertices)                                          \
  template RefinementVertex<Scalar, Vertices> corner_vertex(const LevelSimplex<Scalar, Vertices>&, \
                                                            std::size_t);                          \
  template std::optional<PlaceBetween<Scalar, Vertices>> place_between(                            \
      const LevelSimplex<Scalar, Vertices>&, const Level<Scalar>&,                                 \
      const std::array<std::int64_t, 2>&, const RefinementVertex<Scalar, Vertices>&,               \
      const RefinementVertex<Scalar, Vertices>&);                                                  \
  template std::array<std::int64_t, 2> shares_of_cut(const RefinementVertex<Scalar, Vertices>&,    \
                                                     const RefinementVertex<Scalar, Vertices>&,    \
                                                     const std::array<std::int64_t, 2>&);          \
  template std::optional<std::array<std::int64_t, 2>> shares_opposite_to(                          \
      const RefinementVertex<Scalar, Vertices>&, const RefinementVertex<Scalar, Vertices>&,        \
      const RefinementVertex<Scalar, Vertices>&);
#define TENSORTOPO_INSTANTIATE(Scalar)       \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 2) \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 3) \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 4)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_VERTICES

}  // namespace tensortopo::detail
