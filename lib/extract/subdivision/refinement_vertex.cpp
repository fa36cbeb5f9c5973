// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/refinement_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extract/level/proofs/is_above.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo::detail {

namespace {

/// A sum of tensors that is smaller than its terms by this factor is formed in the multiprecision
/// scalar.
constexpr double kCancelled = 64;

/// Levels with 1 - mode^2 below this are tubes so thin that cells around them get small without
/// end.
constexpr double kSmallGap = 1e-3;

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

template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<PlaceAmong<Scalar, Vertices, Corners>> place_among(
    const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
    const Shares<Corners>& shares,
    const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>& corners) {
  std::array<ExactWeights<Vertices>, Corners> places;
  for (std::size_t i = 0; i < Corners; ++i) places[i] = corners[i]->place;
  const auto place = ExactWeights<Vertices>::combination(shares, places);
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
  if (is_cancelled) m.tensor = tensor_in_multiprecision(simplex, exact);
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
  if (is_cancelled) m.total = 1 + m.total * kMultiprecisionTotal;
  m.above = is_above<Scalar, Vertices>(simplex, m.tensor, m.exact(), level, m.total);
  PlaceAmong<Scalar, Vertices, Corners> among{m, {}};
  for (std::size_t i = 0; i < Corners; ++i)
    among.parts[i] = std::ldexp(static_cast<double>(shares[i]), e);
  return among;
}

#define TENSORTOPO_INSTANTIATE_PLACES(Scalar, Vertices, Corners)                           \
  template std::optional<PlaceAmong<Scalar, Vertices, Corners>> place_among(               \
      const LevelSimplex<Scalar, Vertices>&, const Level<Scalar>&, const Shares<Corners>&, \
      const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>&);
#define TENSORTOPO_INSTANTIATE_VERTICES(Scalar, Vertices)                                          \
  template RefinementVertex<Scalar, Vertices> corner_vertex(const LevelSimplex<Scalar, Vertices>&, \
                                                            std::size_t);
#define TENSORTOPO_INSTANTIATE(Scalar)        \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 2)  \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 3)  \
  TENSORTOPO_INSTANTIATE_VERTICES(Scalar, 4)  \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 2, 2) \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 3, 2) \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 3, 3) \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 4, 2) \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 4, 3) \
  TENSORTOPO_INSTANTIATE_PLACES(Scalar, 4, 4)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_VERTICES
#undef TENSORTOPO_INSTANTIATE_PLACES

}  // namespace tensortopo::detail
