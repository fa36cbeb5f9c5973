// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "convex_level.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// Barycentric coordinates in a tetrahedron.
using Weights = std::array<double, 4>;

/// Where the level is, in double arithmetic: nothing here decides topology.
class CellGeometry {
 public:
  /// @param is_positive  the tetrahedron's volume, in this order of its points
  CellGeometry(const ConvexLevel& level,
               const std::array<const SymmetricTensor<double>*, 4>& tensors,
               const std::array<Vector3<double>, 4>& points, bool is_positive);

  /// A place of the body in the simplex with these two to four corners, all of them outside: where
  /// q is least, kept off the boundary.
  Weights inner_place(std::span<const Weights> corners) const;

  /// The level between a place of the body and one outside, kept 2^-40 of the way off both ends: a
  /// level through a vertex of the mesh has its vertices next to it, all different.
  Weights crossing(const Weights& inside, const Weights& outside) const;

  Vector3<double> position(const Weights& w) const;
  /// Unit gradient of the invariant: outward from the body. Zero if it vanishes.
  Vector3<double> normal(const Weights& w) const;

 private:
  struct Parts {
    Deviator<double> deviator{};
    double trace = 0;
  };
  Parts tensor_at(const Weights& w) const;
  double form(const Weights& u, const Weights& v) const;

  std::array<Vector3<double>, 4> points_;
  /// Gradients of the coordinates 1 to 3, times the volume, in a unit of the tetrahedron's size.
  std::array<Vector3<double>, 3> inward_;
  std::array<Deviator<double>, 4> deviators_;
  std::array<double, 4> traces_;
  double tau_, gamma_;
};

}  // namespace tensortopo
