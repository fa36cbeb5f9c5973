// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/small_field.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo::detail {

namespace {

/// Unit tensors that add up to less than this are nearly opposite; a place has multiples of 2^-50
/// at the finest.
constexpr double kNearlyOpposite = 1.0 / 16;
constexpr int kFinest = 50;

/// In a triangle or tetrahedron unit tensors have a mean below this where the field nearly
/// vanishes. (Around a zero in space all triangles come close to it; such places would only use up
/// the bits.)
constexpr double kNearlyVanishing = 1.0 / 1024;

/// Unit tensors whose Gram determinant is smaller span less than they should, and a place of
/// smaller weights is on a side rather than inside.
constexpr double kApart = 1.0 / 256, kWellInside = 1.0 / 64;

/// Whole numbers in about these ratios: the finer, the smaller the sum of the tensors is there.
template <std::size_t Corners>
Shares<Corners> whole_shares(const std::array<double, Corners>& shares, double sum) {
  const int bits = std::min(kFinest, 6 - std::ilogb(std::max(sum, 0x1p-60)));
  double all = 0;
  for (const double x : shares) all += x;
  Shares<Corners> whole;
  for (std::size_t i = 0; i < Corners; ++i)
    whole[i] = static_cast<std::int64_t>(std::round(std::ldexp(shares[i] / all, bits)));
  return whole;
}

}  // namespace

template <class Scalar, std::size_t Vertices>
Shares<2> shares_of_cut(const RefinementVertex<Scalar, Vertices>& u,
                        const RefinementVertex<Scalar, Vertices>& v, const Shares<2>& usual) {
  const auto [s, t] = rounded(std::array{u.tensor, v.tensor});
  const double s_norm = std::sqrt(norm_form(s)), t_norm = std::sqrt(norm_form(t));
  const double sum = std::sqrt(norm_form((1 / s_norm) * s + (1 / t_norm) * t));
  if (!(sum < kNearlyOpposite)) return usual;
  const auto first = static_cast<double>(usual[0]), second = static_cast<double>(usual[1]);
  const double off = (first - second) / (first + second) / 2 * sum;
  return whole_shares<2>({(0.5 + off) / s_norm, (0.5 - off) / t_norm}, sum);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<Shares<Corners>> shares_of_small_field(
    const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>& corners) {
  std::array<Deviator<double>, 4> units{};
  std::array<double, Corners> norms;
  for (std::size_t i = 0; i < Corners; ++i) {
    const auto t = rounded(std::array{corners[i]->tensor})[0];
    norms[i] = std::sqrt(norm_form(t));
    if (!(norms[i] > 0)) return std::nullopt;
    units[i] = (1 / norms[i]) * t;
  }
  // The smallest of the first one and multiples of the others.
  const auto& [first, a, b, c] = units;
  const double ab = norm_form(a, b), ac = norm_form(a, c), bc = norm_form(b, c);
  const Vector3<double> of_a{1, ab, ac}, of_b{ab, 1, bc}, of_c{ac, bc, 1};
  const double determinant = dot(of_a, cross(of_b, of_c));
  if (!(determinant > kApart)) return std::nullopt;
  const auto solution = (-1 / determinant) * (norm_form(a, first) * cross(of_b, of_c) +
                                              norm_form(b, first) * cross(of_c, of_a) +
                                              norm_form(c, first) * cross(of_a, of_b));
  const std::array<double, 4> multiples{1, solution.x, solution.y, solution.z};
  double all = 0, least = 1;
  for (std::size_t i = 0; i < Corners; ++i)
    all += multiples[i], least = std::min(least, multiples[i]);
  if (!(least > kWellInside * all)) return std::nullopt;
  std::array<double, Corners> shares;
  Deviator<double> smallest{};
  for (std::size_t i = 0; i < Corners; ++i) {
    smallest = smallest + multiples[i] * units[i];
    shares[i] = multiples[i] / norms[i];
  }
  const double sum = std::sqrt(norm_form(smallest)) / all;
  if (!(sum < kNearlyVanishing)) return std::nullopt;
  return whole_shares(shares, sum);
}

#define TENSORTOPO_INSTANTIATE_EDGES(Scalar, Vertices)                        \
  template Shares<2> shares_of_cut(const RefinementVertex<Scalar, Vertices>&, \
                                   const RefinementVertex<Scalar, Vertices>&, const Shares<2>&);
#define TENSORTOPO_INSTANTIATE_PARTS(Scalar, Vertices, Corners)  \
  template std::optional<Shares<Corners>> shares_of_small_field( \
      const std::array<const RefinementVertex<Scalar, Vertices>*, Corners>&);
#define TENSORTOPO_INSTANTIATE(Scalar)       \
  TENSORTOPO_INSTANTIATE_EDGES(Scalar, 2)    \
  TENSORTOPO_INSTANTIATE_EDGES(Scalar, 3)    \
  TENSORTOPO_INSTANTIATE_EDGES(Scalar, 4)    \
  TENSORTOPO_INSTANTIATE_PARTS(Scalar, 3, 3) \
  TENSORTOPO_INSTANTIATE_PARTS(Scalar, 4, 3) \
  TENSORTOPO_INSTANTIATE_PARTS(Scalar, 4, 4)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_EDGES
#undef TENSORTOPO_INSTANTIATE_PARTS

}  // namespace tensortopo::detail
