// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "regular_part.hpp"

#include <cmath>

namespace tensortopo::stability {

namespace {

/// Bounds of norms by which a product's factors may change, and the product of three.
struct Factor {
  double size, change;
};

/// By how much (a + da) (b + db) (c + dc) can differ from its linear part in the changes.
double remainder(const Factor& a, const Factor& b, const Factor& c) {
  return a.size * b.change * c.change + a.change * b.size * c.change +
         a.change * b.change * c.size + a.change * b.change * c.change;
}

/// A linear bound of |T| at the corners: <unit, T>, plus at most `more` for members.
template <std::size_t Corners>
struct NormBound {
  std::array<double, Corners> size, more;
  std::array<Traceless, Corners> unit;
};

template <std::size_t Vertices, std::size_t Corners>
NormBound<Corners> upper_bound(const Part<Vertices, Corners>& part) {
  NormBound<Corners> bound;
  for (std::size_t a = 0; a < Corners; ++a) {
    bound.size[a] = part.norms[a];
    bound.unit[a] = (1 / part.norms[a]) * part.tensors[a];
    bound.more[a] = part.radii[a] * part.radii[a] / (2 * part.norms[a]);
  }
  return bound;
}

/// Of members: false if one may vanish.
template <std::size_t Vertices, std::size_t Corners>
bool lower_bound(const Part<Vertices, Corners>& part, NormBound<Corners>& bound) {
  Traceless centre = part.tensors[0];
  for (std::size_t a = 1; a < Corners; ++a) centre = centre + part.tensors[a];
  const double size = norm(centre);
  if (!(size > 0)) return false;
  const Traceless unit = (1 / size) * centre;
  for (std::size_t a = 0; a < Corners; ++a) {
    bound.size[a] = inner(unit, part.tensors[a]);
    bound.unit[a] = unit;
    bound.more[a] = 0;
    if (!(bound.size[a] > part.radii[a] + kRounding * part.bounds[a])) return false;
  }
  return true;
}

}  // namespace

template <std::size_t Vertices, std::size_t Corners>
bool is_regular(const BoxSimplex<Vertices>& simplex, const Part<Vertices, Corners>& part,
                const std::array<double, Vertices>& d, double nu) {
  Traceless along{};
  double along_bound = 0, along_radius = 0;
  for (std::size_t i = 0; i < Vertices; ++i) {
    along = along + d[i] * simplex.tensors[i];
    along_bound += kLargestNorm * std::abs(d[i]);
    along_radius += std::abs(d[i]) * simplex.radii[i];
  }
  const double along_norm = norm(along);
  std::array<Traceless, Corners> by_other;  // gradient of trace(T_a A U) by U
  std::array<double, Corners> inner_along;
  for (std::size_t a = 0; a < Corners; ++a) {
    by_other[a] = product(part.tensors[a], along);
    inner_along[a] = inner(part.tensors[a], along);
  }
  NormBound<Corners> lower;
  if (!lower_bound(part, lower)) return false;
  const Factor change_along{along_norm, along_radius};
  const double half = nu / 2;
  const auto is_positive = [&](const NormBound<Corners>& bound) {
    for (std::size_t a = 0; a < Corners; ++a) {
      for (std::size_t b = a; b < Corners; ++b) {
        const Traceless by_along =
            product(part.tensors[a], part.tensors[b]) -
            half * (bound.size[a] * part.tensors[b] + bound.size[b] * part.tensors[a]);
        const double value = inner(by_along, along);
        double least = value - 0x1p3 * kRounding * part.bounds[a] * part.bounds[b] * along_bound;
        if (!(least > 0)) return false;
        const Traceless by_a = by_other[b] -
                               half * (bound.size[b] * along + inner_along[b] * bound.unit[a]),
                        by_b = by_other[a] -
                               half * (bound.size[a] * along + inner_along[a] * bound.unit[b]);
        for (std::size_t i = 0; i < Vertices; ++i)
          least -= simplex.radii[i] *
                   norm(d[i] * by_along + part.places[a][i] * by_a + part.places[b][i] * by_b);
        const Factor at_a{part.norms[a], part.radii[a]}, at_b{part.norms[b], part.radii[b]},
            size_a{bound.size[a], part.radii[a] + bound.more[a]},
            size_b{bound.size[b], part.radii[b] + bound.more[b]};
        // 1 / sqrt(6) < 0.4083. The linear part leaves `more` out.
        least -= 0.4083 * remainder(at_a, at_b, change_along) +
                 std::abs(half) * (remainder(size_a, at_b, change_along) +
                                   remainder(size_b, at_a, change_along) +
                                   bound.more[a] * std::abs(inner_along[b]) +
                                   bound.more[b] * std::abs(inner_along[a]));
        if (!(least > 0)) return false;
      }
    }
    return true;
  };
  return is_positive(lower) && (nu == 0 || is_positive(upper_bound(part)));
}

#define TENSORTOPO_INSTANTIATE(Vertices, Corners)                                       \
  template bool is_regular(const BoxSimplex<Vertices>&, const Part<Vertices, Corners>&, \
                           const std::array<double, Vertices>&, double);
TENSORTOPO_INSTANTIATE(2, 1)
TENSORTOPO_INSTANTIATE(2, 2)
TENSORTOPO_INSTANTIATE(3, 1)
TENSORTOPO_INSTANTIATE(3, 3)
TENSORTOPO_INSTANTIATE(4, 1)
TENSORTOPO_INSTANTIATE(4, 4)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::stability
