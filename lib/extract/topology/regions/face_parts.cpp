// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/face_parts.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "extract/run/budget.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/sign.hpp"

namespace tensortopo {

namespace {

using Weights = std::array<double, 3>;

template <class Number>
Number determinant_of_rows(const Weights& u, const Weights& v, const Weights& w) {
  const auto product = [](double x, double y, double z) {
    return Number(x) * Number(y) * Number(z);
  };
  return product(u[0], v[1], w[2]) + product(u[1], v[2], w[0]) + product(u[2], v[0], w[1]) -
         product(u[0], v[2], w[1]) - product(u[1], v[0], w[2]) - product(u[2], v[1], w[0]);
}

/// On which side of the line through v and w the place u lies; weights are not negative.
Sign orientation(const Weights& u, const Weights& v, const Weights& w) {
  const double value = determinant_of_rows<double>(u, v, w);
  double sizes = 0;
  for (const double x : u)
    for (const double y : v)
      for (const double z : w) sizes += x * y * z;
  // Each product passes through at most seven roundings.
  const double bound = 16 * std::numeric_limits<double>::epsilon() * sizes;
  if (bound > std::numeric_limits<double>::min()) {
    if (value > bound) return Sign::positive;
    if (value < -bound) return Sign::negative;
  }
  return sign_of(determinant_of_rows<Rational>(u, v, w));
}

}  // namespace

template <class Scalar>
bool FaceParts<Scalar>::build(const LevelSimplex<Scalar, 3>& triangle, const Level<Scalar>& level) {
  refinement_.reset(triangle, level);
  if (!refinement_.run(face_cell_limit(Budget::large, level.gap()))) return false;
  superlevel_is_above_ = level.sign > 0;
  const auto& vertices = refinement_.vertices();
  for (const auto& v : vertices)
    if (!v.exact().fits_in_doubles()) return false;
  parts_ = UnionFind(vertices.size());
  for (const auto& cell : refinement_.cells()) {
    if (!cell.alive) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto u = cell.vertices[i], v = cell.vertices[(i + 1) % 3];
      if (vertices[u].above == superlevel_is_above_ && vertices[v].above == superlevel_is_above_)
        parts_.unite(u, v);
    }
  }
  return true;
}

template <class Scalar>
std::optional<std::uint32_t> FaceParts<Scalar>::part_of(const Weights& place) {
  const auto& vertices = refinement_.vertices();
  for (const auto& cell : refinement_.cells()) {
    if (!cell.alive) continue;
    bool inside = true;
    for (std::size_t i = 0; i < 3 && inside; ++i)  // cells run counter-clockwise
      inside = orientation(place, vertices[cell.vertices[i]].weights,
                           vertices[cell.vertices[(i + 1) % 3]].weights) != Sign::negative;
    if (!inside) continue;
    for (const auto v : cell.vertices)
      if (vertices[v].above == superlevel_is_above_) return parts_.find(v);
    return std::nullopt;
  }
  return std::nullopt;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class FaceParts<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
