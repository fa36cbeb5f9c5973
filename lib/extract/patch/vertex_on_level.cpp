// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/vertex_on_level.hpp"

#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
std::optional<InnerVertex<Scalar>> vertex_on_level(const TetWithCurves<Scalar>& tet,
                                                   const Level<Scalar>& level,
                                                   const std::array<Scalar, 4>& weights) {
  InnerVertex<Scalar> vertex;
  vertex.weights = weights;
  const auto& tensors = tet.simplex.tensors;
  for (int step = 0; step < 4; ++step) {
    vertex.tensor = tensor_at(tensors, vertex.weights);
    const auto at = level_slope(vertex.tensor, level);
    std::array<Scalar, 4> gradient;
    Scalar mean(0), square(0);
    for (std::size_t i = 0; i < 4; ++i) {
      gradient[i] = inner(at.slope, thrice(tensors[i]));
      mean = mean + gradient[i] / Scalar(4);
    }
    for (auto& g : gradient) {
      g = g - mean;
      square = square + g * g;
    }
    if (!(square > Scalar(0))) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      vertex.weights[i] = vertex.weights[i] - at.value / square * gradient[i];
      if (!(vertex.weights[i] > Scalar(0))) return std::nullopt;
    }
  }
  vertex.tensor = tensor_at(tensors, vertex.weights);
  return vertex;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                         \
  template std::optional<InnerVertex<Scalar>> vertex_on_level( \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const std::array<Scalar, 4>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
