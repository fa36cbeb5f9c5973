// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "crossing_brackets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tensortopo/extract/refinement.hpp"

namespace tensortopo {

namespace {

/// Coarse brackets are short to write and quick to check, fine ones part close crossings.
constexpr std::array kDepths{16, 24, 32, 40, 50};

/// Beyond this the smaller of two vertex tensors is lost in the sum.
constexpr int kLargestRatio = 900;

class EdgeSides {
 public:
  EdgeSides(const LevelTopology::Edge& edge, const ScaledField<double>& field,
            const Level<double>& level)
      : level_(level) {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto v = static_cast<std::size_t>(edge.vertices[i]);
      simplex_.tensors[i] = field.tensors[v];
      simplex_.exact[i] = &field.mesh->tensors[v];
      simplex_.exponents[i] = field.exponents[v];
    }
    const int least = std::min(simplex_.exponents[0], simplex_.exponents[1]);
    for (std::size_t i = 0; i < 2; ++i) scale_[i] = std::ldexp(1.0, least - simplex_.exponents[i]);
    is_usable_ = std::abs(simplex_.exponents[0] - simplex_.exponents[1]) < kLargestRatio;
  }

  bool is_usable() const { return is_usable_; }

  /// The barycentric coordinate of the second vertex, from that among scaled tensors.
  double coordinate(double weight) const {
    // T_i = 2^-exponent U_i: (1 - w) U_0 + w U_1 is along (1 - w) / s_0 T_0 + w / s_1 T_1.
    const double first = (1 - weight) / scale_[0], second = weight / scale_[1];
    return second / (first + second);
  }

  /// Whether the level is below the point t, exactly; t has few enough bits that 1 - t is exact.
  bool is_above(double t) const {
    const std::array<double, 2> weights{(1 - t) * scale_[0], t * scale_[1]};
    return tensortopo::is_above(simplex_, tensor_at(simplex_.tensors, weights), weights, level_);
  }

 private:
  const Level<double>& level_;
  LevelSimplex<double, 2> simplex_{};
  std::array<double, 2> scale_{};
  bool is_usable_ = true;
};

}  // namespace

std::optional<std::vector<DyadicBracket>> crossing_brackets(const LevelTopology::Edge& edge,
                                                            const ScaledField<double>& field,
                                                            const Level<double>& level) {
  const EdgeSides sides(edge, field, level);
  if (!sides.is_usable()) return std::nullopt;
  std::vector<DyadicBracket> brackets;
  double free_from = 0;  // end of the last bracket
  for (std::size_t k = 0; k < edge.crossings.size(); ++k) {
    const auto& crossing = edge.crossings[k];
    const double t = std::clamp(sides.coordinate(crossing.weight), 0.0, 1.0);
    const double next = k + 1 < edge.crossings.size()
                            ? sides.coordinate(edge.crossings[k + 1].weight)
                            : 1;
    const auto holds = [&](double place, int depth) {
      const double low = std::ldexp(place, -depth), high = std::ldexp(place + 1, -depth);
      if (place < 0 || high > 1 || low < free_from) return false;
      // The next crossing needs room.
      if (k + 1 < edge.crossings.size() && high >= next) return false;
      return sides.is_above(low) != crossing.rising && sides.is_above(high) == crossing.rising;
    };
    const auto find = [&]() -> std::optional<DyadicBracket> {
      for (const int depth : kDepths) {
        const double place = std::min(std::floor(std::ldexp(t, depth)), std::ldexp(1.0, depth) - 1);
        for (const double shift : {0.0, -1.0, 1.0})
          if (holds(place + shift, depth))
            return DyadicBracket{static_cast<std::uint64_t>(place + shift), depth};
      }
      return std::nullopt;
    };
    const auto bracket = find();
    if (!bracket) return std::nullopt;
    free_from = std::ldexp(static_cast<double>(bracket->place + 1), -bracket->depth);
    brackets.push_back(*bracket);
  }
  return brackets;
}

}  // namespace tensortopo
