// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "field.hpp"
#include "places.hpp"
#include "surface/compare_surface.hpp"

namespace certificate {

/// Exact tensors of the linear field at points of simplices, by weights of the corners: doubles
/// that are not negative, in proportion to which the point's weights are.
class WeightedTensors : public ExactTensors {
 public:
  /// @param count  of points, to be set
  explicit WeightedTensors(const Field& field, std::size_t count = 0)
      : field_(field), points_(count) {}

  /// Different points may be set at the same time.
  void set(std::uint32_t id, const Carrier& carrier, const std::array<double, 4>& weights);
  std::uint32_t add(const Carrier& carrier, const std::array<double, 4>& weights);

  const std::array<double, 4>& weights(std::uint32_t id) const { return points_[id].weights; }
  /// The weights of the field's exact tensors there.
  Place<4> place(std::uint32_t id) const;
  /// Its tensor, and the side on which it is, or should be.
  Corner corner(std::uint32_t id, bool above) const {
    return {&points_[id].ball, points_[id].shift, this, id, above};
  }
  Tensor<mpz_class> exact(std::uint32_t id) const override;

 private:
  struct Point {
    Carrier carrier;
    std::array<double, 4> weights{};
    Tensor<Ball> ball;
    long shift = 0;
  };
  long unit_of(const Point& point) const;

  const Field& field_;
  std::vector<Point> points_;
};

/// The largest scale of the corners' balls.
long scale_of(const Field& field, const Carrier& carrier);

}  // namespace certificate
