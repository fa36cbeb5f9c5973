// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "stable_simplex.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "guess_direction.hpp"
#include "regular_part.hpp"

namespace tensortopo::stability {

bool side_is_stable(const Traceless& tensor, double radius, double mu) {
  const double size = norm(tensor), sine = radius / size * (1 + kRounding);
  // Above sin(60 degrees) all modes are within reach.
  if (!(sine < 0.866)) return false;
  const double cube = size * size * size,
               mode = std::sqrt(6.0) * inner(product(tensor, tensor), tensor) / cube;
  if (!(std::abs(mode - mu) > kRounding)) return false;
  // As if the mode were the larger one: the other case is that of the opposite tensor.
  const double m = mode > mu ? mode : -mode, level = mode > mu ? mu : -mu;
  // Of three times the angles.
  const double sine3 = sine * (3 - 4 * sine * sine),
               cosine3 = std::sqrt(1 - sine * sine) * (1 - 4 * sine * sine),
               other = std::sqrt(std::max(0.0, 1 - m * m) + kRounding);
  // The sum of both angles is below 180 degrees, and its cosine above the level.
  return std::sqrt(std::max(0.0, 1 - m * m - kRounding)) * cosine3 + m * sine3 > kRounding &&
         m * cosine3 - other * sine3 > level + kRounding;
}

namespace {

/// The two corners between which the angle is largest.
template <std::size_t Vertices>
std::pair<std::size_t, std::size_t> longest_edge(const Part<Vertices, Vertices>& part) {
  std::pair<std::size_t, std::size_t> edge{0, 1};
  double least = 2;
  for (std::size_t a = 0; a < Vertices; ++a)
    for (std::size_t b = a + 1; b < Vertices; ++b) {
      const double cosine =
          inner(part.tensors[a], part.tensors[b]) / (part.norms[a] * part.norms[b]);
      if (cosine < least) {
        least = cosine;
        edge = {a, b};
      }
    }
  return edge;
}

}  // namespace

template <std::size_t Vertices>
bool has_no_critical_point(const BoxSimplex<Vertices>& simplex, double mu, int parts) {
  const double nu = mu / std::sqrt(6.0);
  std::array<Place<Vertices>, Vertices> whole{};
  for (std::size_t i = 0; i < Vertices; ++i) whole[i][i] = 1;
  std::vector<std::array<Place<Vertices>, Vertices>> open{whole};
  for (int count = 0; !open.empty(); ++count) {
    if (count == parts) return false;
    const auto places = open.back();
    open.pop_back();
    const auto part = part_of(simplex, places);
    if (is_regular(simplex, part, guess_direction(simplex, part, nu, 0), nu)) continue;
    if (is_regular(simplex, part, guess_direction(simplex, part, nu, 2), nu)) continue;
    // If it is not the part's size that is at fault, no smaller parts are regular either.
    const auto centre = centre_of(simplex, part);
    if (!is_regular(simplex, centre, guess_direction(simplex, centre, nu, 4), nu)) return false;
    const auto [a, b] = longest_edge(part);
    Place<Vertices> middle;
    for (std::size_t i = 0; i < Vertices; ++i) middle[i] = (places[a][i] + places[b][i]) / 2;
    for (const std::size_t corner : {a, b}) {
      open.push_back(places);
      open.back()[corner] = middle;
    }
  }
  return true;
}

template bool has_no_critical_point(const BoxSimplex<2>&, double, int);
template bool has_no_critical_point(const BoxSimplex<3>&, double, int);
template bool has_no_critical_point(const BoxSimplex<4>&, double, int);

}  // namespace tensortopo::stability
