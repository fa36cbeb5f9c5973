// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/inner_vertices.hpp"

#include <algorithm>

#include "extract/level/position.hpp"
#include "extract/patch/vertex_on_level.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
bool InnerVertices<Scalar>::has_one_sign(const std::array<double, 4>& weights) const {
  return std::all_of(weights.begin(), weights.end(),
                     [&](double w) { return on_.sign > 0 ? w > 0 : w < 0; });
}

template <class Scalar>
std::optional<InnerVertex<Scalar>> InnerVertices<Scalar>::at(
    const SymmetricTensor<double>& tensor) const {
  const auto guess = on_.lift.weights(tensor);
  if (!has_one_sign(guess)) return std::nullopt;
  double total = 0;
  for (const double w : guess) total += w;
  std::array<Scalar, 4> weights;
  for (std::size_t i = 0; i < 4; ++i) weights[i] = Scalar(guess[i] / total);
  auto vertex = vertex_on_level(tet_, level_, weights);
  if (vertex && taken_.contains(place_of(*vertex))) return std::nullopt;
  return vertex;
}

template <class Scalar>
std::array<double, 3> InnerVertices<Scalar>::place_of(const InnerVertex<Scalar>& vertex) const {
  const auto x = position_at(vertex.weights, tet_.simplex.exponents, tet_.points);
  return {x.x, x.y, x.z};
}

template <class Scalar>
std::int32_t InnerVertices<Scalar>::add(const InnerVertex<Scalar>& vertex) {
  taken_.insert(place_of(vertex));
  out_.inner.push_back(vertex);
  return -static_cast<std::int32_t>(out_.inner.size());
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class InnerVertices<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
