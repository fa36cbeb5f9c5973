// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "nodal_stress.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>

namespace tensortopo::scenarios {

namespace {

// Axes on which the sign of a corner is positive: bit 0 for x, 1 for y, 2 for z. Integration points
// are numbered by these bits.
constexpr std::array<unsigned, 8> kCornerSigns{0, 1, 3, 2, 4, 5, 7, 6};

using WeightTable = std::array<double, 4>;

// The two small weights as 2 / (a + b sqrt 3), where nothing cancels.
WeightTable exact_table() {
  const double root3 = std::sqrt(3.0);
  return {-0.5 / (5 + 3 * root3), 0.5 / (1 + root3), -(1 + root3) / 4, (5 + 3 * root3) / 4};
}

constexpr WeightTable kCalculix{-0.04904, 0.183, -0.683, 2.549};

}  // namespace

QuarterOfRoot3 exact_weight(int agreeing) {
  constexpr std::array<QuarterOfRoot3, 4> weights{{{5, -3}, {-1, 1}, {-1, -1}, {5, 3}}};
  return weights.at(static_cast<std::size_t>(agreeing));
}

int agreeing_signs(std::size_t corner, std::size_t integration_point) {
  const unsigned differing = kCornerSigns.at(corner) ^ static_cast<unsigned>(integration_point);
  return 3 - std::popcount(differing);
}

std::vector<SymmetricTensor<double>> nodal_stress(
    const HexMesh& mesh, const std::vector<RestartFile::HexStress>& stresses, Weights weights) {
  if (stresses.size() != mesh.hexes.size())
    throw std::invalid_argument("nodal_stress: the stresses are not one for each hexahedron");
  const WeightTable table = weights == Weights::exact ? exact_table() : kCalculix;
  std::vector<SymmetricTensor<double>> nodes(mesh.points.size());
  std::vector<double> hexes_at(mesh.points.size());
  for (std::size_t h = 0; h < stresses.size(); ++h)
    for (std::size_t corner = 0; corner < 8; ++corner) {
      SymmetricTensor<double> value;
      for (std::size_t point = 0; point < 8; ++point)
        value = value +
                table[static_cast<std::size_t>(agreeing_signs(corner, point))] * stresses[h][point];
      const auto node = static_cast<std::size_t>(mesh.hexes[h][corner]);
      nodes[node] = nodes[node] + value;
      hexes_at[node] += 1;
    }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    auto& t = nodes[i];
    for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x /= hexes_at[i];
  }
  return nodes;
}

}  // namespace tensortopo::scenarios
