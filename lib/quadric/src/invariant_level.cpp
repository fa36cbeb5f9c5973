// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/quadric/invariant_level.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cell_scale.hpp"
#include "tensortopo/scalar/nearest.hpp"
#include "tensortopo/scalar/parse_rational.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

constexpr std::array<std::pair<Invariant, std::string_view>, 3> names{
    {{Invariant::magnitude, "magnitude"},
     {Invariant::deviator_magnitude, "deviator-magnitude"},
     {Invariant::anisotropy, "anisotropy"}}};

}  // namespace

std::string_view name_of(Invariant invariant) {
  for (const auto& [which, name] : names)
    if (which == invariant) return name;
  return "unknown";
}

std::optional<Invariant> invariant_named(std::string_view name) {
  for (const auto& [which, its_name] : names)
    if (its_name == name) return which;
  return std::nullopt;
}

double invariant_of(Invariant invariant, const SymmetricTensor<double>& t) {
  const CellScale scale({&t, &t, &t, &t});
  const auto scaled = scale(t);
  const double norm = std::sqrt(inner(scaled, scaled));
  if (invariant == Invariant::magnitude) return std::ldexp(norm, -scale.exponent);
  const double of_deviator = std::sqrt(norm_form(deviator(scaled)) / 3);
  if (invariant == Invariant::deviator_magnitude) return std::ldexp(of_deviator, -scale.exponent);
  return norm == 0 ? 0 : of_deviator / norm;
}

InvariantLevel InvariantLevel::parse(Invariant invariant, std::string_view text) {
  const Rational value = parse_rational(text);
  if (value <= 0) throw std::invalid_argument("not positive");
  if (invariant == Invariant::anisotropy && value >= 1)
    throw std::invalid_argument("an anisotropy has surfaces between 0 and 1 only");
  return {invariant, value.str()};
}

double InvariantLevel::approx() const { return nearest<double>(Rational(text_)); }

}  // namespace tensortopo
