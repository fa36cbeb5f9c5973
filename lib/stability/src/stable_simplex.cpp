// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "stable_simplex.hpp"

#include <algorithm>
#include <cmath>

#include "guess_direction.hpp"
#include "parts.hpp"
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

template <std::size_t Vertices>
bool has_no_critical_point(const BoxSimplex<Vertices>& simplex, double mu, int parts) {
  const double nu = mu / std::sqrt(6.0);
  return holds_in_parts(
      simplex, parts,
      [&](const auto& part) {
        return is_regular(simplex, part, guess_direction(simplex, part, nu, 0), nu) ||
               is_regular(simplex, part, guess_direction(simplex, part, nu, 2), nu);
      },
      [&](const auto& centre) {
        return is_regular(simplex, centre, guess_direction(simplex, centre, nu, 4), nu);
      });
}

template bool has_no_critical_point(const BoxSimplex<2>&, double, int);
template bool has_no_critical_point(const BoxSimplex<3>&, double, int);
template bool has_no_critical_point(const BoxSimplex<4>&, double, int);

}  // namespace tensortopo::stability
