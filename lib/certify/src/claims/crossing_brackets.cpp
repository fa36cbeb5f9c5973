// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/crossing_brackets.hpp"

#include <array>
#include <cmath>

#include "claims/bracket_search.hpp"
#include "extract/level/proofs/is_above.hpp"
#include "extract/subdivision/refinement.hpp"

namespace tensortopo {

namespace {

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

  /// The barycentric coordinate of the second vertex, from those among scaled tensors.
  double coordinate(const std::array<double, 2>& weights) const {
    // T_i = 2^-exponent U_i: v U_0 + w U_1 is along v / s_0 T_0 + w / s_1 T_1.
    const double first = weights[0] / scale_[0], second = weights[1] / scale_[1];
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
  std::vector<NearCrossing> crossings;
  for (const auto& crossing : edge.crossings)
    crossings.push_back({sides.coordinate(crossing.weights), crossing.rising});
  return find_brackets(crossings, [&](double t) { return sides.is_above(t); });
}

}  // namespace tensortopo
