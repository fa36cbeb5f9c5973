// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/stability/uncertain_field.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "tensortopo/scalar/elementary.hpp"
#include "traceless.hpp"

namespace tensortopo {

using stability::kRounding;

namespace {

double radius(double value) {
  if (!std::isfinite(value) || value < 0)
    throw std::invalid_argument("uncertainty: must be finite and not negative");
  return value;
}

/// A relative error of kRounding is much more than what the products below round.
double rounded_up(double value) {
  return std::min(value * (1 + kRounding) + std::numeric_limits<double>::denorm_min(),
                  std::numeric_limits<double>::max());
}

}  // namespace

Uncertainty parse_uncertainty(std::string_view text) {
  Uncertainty result;
  std::string_view number = text;
  if (number.ends_with('%')) {
    result.kind = Uncertainty::Kind::relative;
    number.remove_suffix(1);
  }
  const char* const end = number.data() + number.size();
  const auto [last, error] = std::from_chars(number.data(), end, result.value);
  if (error != std::errc() || last != end || !std::isfinite(result.value) || result.value < 0)
    throw std::invalid_argument("'" + std::string(text) +
                                "' is neither a number from 0 on nor one with %");
  if (result.kind == Uncertainty::Kind::relative) result.value /= 100;
  return result;
}

std::vector<double> vertex_radii(const TetMesh& mesh, const Uncertainty& uncertainty) {
  switch (uncertainty.kind) {
    case Uncertainty::Kind::absolute:
      return std::vector<double>(mesh.tensors.size(), radius(uncertainty.value));
    case Uncertainty::Kind::relative: {
      const double share = radius(uncertainty.value);
      const ScaledField<double> field(mesh);
      std::vector<double> radii(mesh.tensors.size(), 0);
      for (std::size_t v = 0; v < radii.size(); ++v)
        if (!field.is_zero[v])
          radii[v] =
              rounded_up(std::ldexp(share * stability::norm(stability::traceless(field.tensors[v])),
                                    -field.exponents[v]));
      return radii;
    }
    case Uncertainty::Kind::per_vertex:
      break;
  }
  if (uncertainty.radii.size() != mesh.tensors.size())
    throw std::invalid_argument("uncertainty: must have one radius for each vertex");
  for (const double r : uncertainty.radii) radius(r);
  return uncertainty.radii;
}

UncertainField::UncertainField(const TetMesh& m, std::span<const double> given)
    : mesh(&m),
      field(m),
      radii(given.size()),
      may_vanish(given.size(), 0),
      lode_angles(given.size(), 0),
      turns(given.size(), 0) {
  for (std::size_t v = 0; v < radii.size(); ++v) {
    // The scaled tensor is off by a few roundings of its norm.
    radii[v] = rounded_up(std::ldexp(radius(given[v]), field.exponents[v])) + kRounding;
    const auto tensor = stability::traceless(field.tensors[v]);
    const double size = stability::norm(tensor);
    may_vanish[v] = field.is_zero[v] || !(radii[v] < size * (1 - kRounding));
    if (may_vanish[v]) continue;
    const double mode =
        std::sqrt(6.0) * inner(stability::product(tensor, tensor), tensor) / (size * size * size);
    lode_angles[v] = elementary::acos(std::clamp(mode, -1.0, 1.0)) / 3;
    turns[v] = elementary::asin(radii[v] / size);
  }
}

}  // namespace tensortopo
