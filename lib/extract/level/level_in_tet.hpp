// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "extract/level/level.hpp"
#include "extract/level/tet_geometry.hpp"
#include "tensortopo/extract/scaled_field.hpp"

namespace tensortopo {

/// The mode of a tensor less the level's; 0 for the zero tensor, which has no mode (and for the
/// tips of cones, which sit at one).
inline double mode_difference(const Deviator<double>& t, const Level<double>& level) {
  const double p = norm_form(t);
  return p > 0 ? level_function(t, level) / (p * std::sqrt(p)) : 0;
}

/// The slope of the mode at a tensor that is not zero, up to a positive factor. As the mode does not
/// depend on the tensor's size, neither does the slope's direction on how far the mode is from a
/// level's, as that of the level function does.
SymmetricTensor<double> mode_slope(const Deviator<double>& t);

/// The level of a tetrahedron's linear field as a function of the place, in double: for meshing.
class LevelInTet {
 public:
  /// @param level  has to live as long as this
  /// @pre no vertex of the tetrahedron is isotropic
  LevelInTet(const TetMesh& mesh, const ScaledField<double>& field, TetMesh::Index tet,
             const Level<double>& level);

  /// The gradient of the mode, up to a positive factor.
  Vector3<double> mode_gradient(const Vector3<double>& x) const;
  /// The distance to the level, to first order; infinite where the gradient vanishes.
  double distance(const Vector3<double>& x) const;
  /// The mode less the level's.
  double residual(const Vector3<double>& x) const;
  Deviator<double> tensor(const Vector3<double>& x) const;

  /// The place on the level near x, by Newton's method along the gradient; in the plane of the
  /// face opposite to the corner `across` if that is not 4. Nothing unless it is found well inside
  /// the tetrahedron, or face.
  std::optional<Vector3<double>> on_level(Vector3<double> x, std::size_t across) const;

 private:
  std::array<Vector3<double>, 4> points_;
  std::array<Deviator<double>, 4> tensors_;
  TetGeometry geometry_;
  const Level<double>* level_;
};

}  // namespace tensortopo
