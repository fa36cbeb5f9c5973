// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/charts/line_view.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

void make_sum_one(std::array<double, 4>& weights) {
  double total = 0;
  for (const double w : weights) total += w;
  for (double& w : weights) w /= total;
}

}  // namespace

template <class Scalar>
LineView<Scalar>::LineView(const TetWithCurves<Scalar>& tet, const std::array<Scalar, 4>& direction)
    : tet_(tet), direction_(direction), geometry_(tet.points, tet.simplex.exponents) {
  const auto& exponents = tet.simplex.exponents;
  const int largest = *std::max_element(exponents.begin(), exponents.end());
  Weights d;
  double up = 0, down = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    scale_[i] = std::ldexp(1.0, exponents[i] - largest);
    d[i] = scale_[i] * static_cast<double>(direction[i]);
    (d[i] > 0 ? up : down) += std::abs(d[i]);
  }
  Vector3<double> line{0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    form_[i] = d[i] > 0 ? down : d[i] < 0 ? up : (up + down) / 2;
    scale_[i] *= form_[i];
    line += (form_[i] * d[i]) * tet.points[i];
  }
  // The coordinates across: the line and two vectors at right angles.
  line = unit(line);
  const double x = std::abs(line.x), y = std::abs(line.y), z = std::abs(line.z);
  const Vector3<double> other{x <= y && x <= z ? 1.0 : 0.0, y < x && y <= z ? 1.0 : 0.0,
                              z < x && z < y ? 1.0 : 0.0};
  auto first = cross(line, other);
  first = unit(first);
  const auto second = cross(line, first);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto p = tet.points[i] - tet.points[0];
    corner_[i] = {dot(p, first), dot(p, second)};
  }
}

template <class Scalar>
std::optional<LineView<Scalar>> LineView<Scalar>::along(const TetWithCurves<Scalar>& tet,
                                                        const std::array<Scalar, 4>& direction) {
  const auto is_up = [](const Scalar& x) { return x > Scalar(0); };
  const auto is_down = [](const Scalar& x) { return x < Scalar(0); };
  if (std::none_of(direction.begin(), direction.end(), is_up) ||
      std::none_of(direction.begin(), direction.end(), is_down))
    return std::nullopt;
  return LineView(tet, direction);
}

template <class Scalar>
auto LineView<Scalar>::mapped(const Vector3<double>& position) const -> Weights {
  Weights weights;
  for (std::size_t i = 0; i < 4; ++i)
    weights[i] = form_[i] * std::max(0.0, geometry_.weight(i, position));
  make_sum_one(weights);
  return weights;
}

template <class Scalar>
auto LineView<Scalar>::mapped(const InnerVertex<Scalar>& vertex) const -> Weights {
  Weights weights;
  for (std::size_t i = 0; i < 4; ++i)
    weights[i] = scale_[i] * static_cast<double>(vertex.weights[i]);
  make_sum_one(weights);
  return weights;
}

template <class Scalar>
std::array<double, 2> LineView<Scalar>::seen(const Weights& mapped) const {
  std::array<double, 2> at{0, 0};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 2; ++k) at[k] += mapped[i] * corner_[i][k];
  return at;
}

template <class Scalar>
std::optional<InnerVertex<Scalar>> LineView<Scalar>::on_level(const Weights& mapped,
                                                              const Level<Scalar>& level) const {
  std::array<Scalar, 4> base;
  for (std::size_t i = 0; i < 4; ++i) base[i] = Scalar(mapped[i] / scale_[i]);
  // Both ends of the line in the tetrahedron.
  Scalar down(0), up(0);
  bool first_down = true, first_up = true;
  for (std::size_t i = 0; i < 4; ++i) {
    if (direction_[i] == Scalar(0)) continue;
    const Scalar k = -base[i] / direction_[i];
    if (direction_[i] > Scalar(0)) {
      if (first_down || k > down) down = k;
      first_down = false;
    } else {
      if (first_up || k < up) up = k;
      first_up = false;
    }
  }
  const auto at = [&](const Scalar& k) {
    std::array<Scalar, 4> w;
    Scalar total(0);
    for (std::size_t i = 0; i < 4; ++i) {
      w[i] = base[i] + k * direction_[i];
      total = total + w[i];
    }
    for (auto& x : w) x = x / total;
    return w;
  };
  const auto& tensors = tet_.simplex.tensors;
  const auto lower = at(down), upper = at(up);
  const auto below = tensor_at(tensors, lower), above = tensor_at(tensors, upper);
  if (!(level_function(below, level) < Scalar(0)) || !(level_function(above, level) > Scalar(0)))
    return std::nullopt;
  const Scalar root = segment_root(below, above, level);
  InnerVertex<Scalar> vertex;
  for (std::size_t i = 0; i < 4; ++i) {
    vertex.weights[i] = lower[i] + root * (upper[i] - lower[i]);
    if (!(vertex.weights[i] > Scalar(0))) return std::nullopt;
  }
  vertex.tensor = tensor_at(tensors, vertex.weights);
  return vertex;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template class LineView<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
