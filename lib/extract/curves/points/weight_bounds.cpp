// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/points/weight_bounds.hpp"

#include <algorithm>
#include <optional>

#include "extract/curves/points/cell_rows.hpp"
#include "extract/curves/points/exact_face_points.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

/// Bounds in doubles are good enough below this.
constexpr double kNarrow = 0x1p-44;

double width_of(const WeightBounds& bounds) {
  double width = 0;
  for (std::size_t i = 0; i < 3; ++i) width = std::max(width, bounds.high[i] - bounds.low[i]);
  return width;
}

/// Each x / (x + y + z), of numbers that are positive.
template <class E>
std::optional<WeightBounds> shares(const std::array<E, 3>& parts) {
  using Bound = typename EnclosureOf<E>::Bound;
  WeightBounds result;
  for (const E& x : parts)
    if (!(EnclosureOf<E>::low(x) > Bound(0))) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& x = parts[i];
    const E rest = parts[(i + 1) % 3] + parts[(i + 2) % 3];
    const auto share = [](const Bound& own, const Bound& others) {
      return static_cast<double>(Bound(own / Bound(own + others)));
    };
    // The sum, the quotient and its conversion are rounded however: by less than this.
    constexpr double kRounding = 0x1p-50;
    result.low[i] =
        share(EnclosureOf<E>::low(x), EnclosureOf<E>::high(rest)) * (1 - kRounding) - kRounding;
    result.high[i] =
        share(EnclosureOf<E>::high(x), EnclosureOf<E>::low(rest)) * (1 + kRounding) + kRounding;
  }
  return result;
}

/// What the weights' forms say at a point, on its side, each times the power of two of its tensor.
template <class E>
std::optional<WeightBounds> bounds_in(const FieldForms<E, 3>& forms, const Vector3<E>& direction,
                                      const std::array<E, 3>& powers) {
  std::array<E, 3> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i] = polar(forms.weight[i], direction, direction) * powers[i];
    if (sign_in(parts[i]) == Verdict::negative) parts[i] = -parts[i];
  }
  return shares(parts);
}

}  // namespace

std::optional<WeightBounds> weight_bounds(const std::array<ScaledTensor, 3>& tensors,
                                          const FacePoint& point) {
  const FloatingPointEnvironment environment;
  int largest = tensors[0].exponent, smallest = largest;
  for (const auto& t : tensors) {
    largest = std::max(largest, t.exponent);
    smallest = std::min(smallest, t.exponent);
  }
  constexpr int kLargestRatio = 200;
  if (largest - smallest < kLargestRatio) {
    const FastIntervalScope scope;
    std::array<FastInterval, 3> powers;
    for (std::size_t i = 0; i < 3; ++i)
      powers[i] = FastInterval(std::ldexp(1.0, tensors[i].exponent - largest));
    CellRows<3> cell(tensors);
    const auto in_doubles = [&]() -> std::optional<WeightBounds> {
      const auto bounds = bounds_in(cell.forms<FastInterval>(best_columns(cell.rows<double>())),
                                    directions_in<FastInterval>(point.box), powers);
      return bounds && width_of(*bounds) < kNarrow ? bounds : std::nullopt;
    };
    if (const auto bounds = in_doubles()) return bounds;
    if (cell.reduce())
      if (const auto bounds = in_doubles()) return bounds;
  }
  const MultiprecisionFace face(tensors);
  std::array<MultiprecisionInterval, 3> powers;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto power = ldexp(MultiprecisionInterval::End(1), tensors[i].exponent - largest);
    powers[i] = MultiprecisionInterval(power, power);
  }
  return bounds_in(face.forms, refined(face, point.box), powers);
}

}  // namespace tensortopo
