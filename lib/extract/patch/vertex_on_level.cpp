// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/vertex_on_level.hpp"

#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// One step, with the tensor that it begins with.
/// @return the square of its length in weights; nothing if it leaves the tetrahedron, or there is
/// no gradient
template <class Scalar>
std::optional<Scalar> newton_step(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                  InnerVertex<Scalar>& vertex) {
  const auto& tensors = tet.simplex.tensors;
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
  return at.value * at.value / square;
}

}  // namespace

template <class Scalar>
std::optional<InnerVertex<Scalar>> vertex_on_level(const TetWithCurves<Scalar>& tet,
                                                   const Level<Scalar>& level,
                                                   const std::array<Scalar, 4>& weights) {
  InnerVertex<Scalar> vertex;
  vertex.weights = weights;
  for (int step = 0; step < 4; ++step)
    if (!newton_step(tet, level, vertex)) return std::nullopt;
  vertex.tensor = tensor_at(tet.simplex.tensors, vertex.weights);
  return vertex;
}

template <class Scalar>
std::optional<InnerVertex<Scalar>> vertex_on_far_level(const TetWithCurves<Scalar>& tet,
                                                       const Level<Scalar>& level,
                                                       const std::array<Scalar, 4>& weights) {
  // Steps that are so small are squared by the next one.
  constexpr int kMostSteps = 10;
  const Scalar small(0x1p-44);
  InnerVertex<Scalar> vertex;
  vertex.weights = weights;
  bool is_last = false;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto square = newton_step(tet, level, vertex);
    if (!square) return std::nullopt;
    if (is_last) {
      vertex.tensor = tensor_at(tet.simplex.tensors, vertex.weights);
      return vertex;
    }
    is_last = *square < small;
  }
  return std::nullopt;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                   \
  template std::optional<InnerVertex<Scalar>> vertex_on_level(                           \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const std::array<Scalar, 4>&); \
  template std::optional<InnerVertex<Scalar>> vertex_on_far_level(                       \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const std::array<Scalar, 4>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
