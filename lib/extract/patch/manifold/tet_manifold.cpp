// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/manifold/tet_manifold.hpp"

#include <cmath>
#include <numbers>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

BoundaryPosition<double> TetManifold::boundary_position(const Vector3<double>& medium,
                                                        const Vector3<double>& dominant) const {
  auto at = manifold.boundary_position(medium);
  if (!small_ovals) return at;
  // Along an oval that shrinks to a point the dominant eigenvector turns evenly, by half a turn, in
  // the plane across it: so two places tell all others.
  const auto angle = [&, v = at.sign * medium](const Vector3<double>& d) {
    const auto& e = manifold.characteristic().eigenvectors[1];
    return 2 * elementary::atan2(dot(d, cross(v, e)), dot(d, e));
  };
  const auto angle_at = [&](double phi) {
    return angle(manifold.dominant_eigenvector(manifold.boundary_point(at.loop, phi)));
  };
  const double start = angle_at(0);
  const double sense = elementary::sin(angle_at(std::numbers::pi / 2) - start) > 0 ? 1 : -1;
  const double phi = std::remainder(sense * (angle(dominant) - start), 2 * std::numbers::pi);
  at.phi = phi < 0 ? phi + 2 * std::numbers::pi : phi;
  return at;
}

}  // namespace tensortopo
