// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Directions on triangles, without sign: at each vertex a tensor, the eigenvector of whose larger
/// eigenvalue in the plane of a triangle is the direction there. Between vertices tensors are
/// interpolated; where a tensor is isotropic in the plane (0, an umbilic) there is no direction.
using LineField = std::vector<SymmetricTensor<double>>;

/// Which directions a surface's texture shows.
enum class Texture {
  none,
  major,     ///< of the larger principal curvature (positive where normals spread)
  minor,     ///< of the smaller one
  dominant,  ///< the dominant eigenvector, projected
};

/// d d^T. A direction and its opposite give the same bits.
SymmetricTensor<double> dyad(const Vector3<double>& d);

/// A point of a triangle; `triangle` is -1 for one of none.
struct SurfacePlace {
  SurfaceMesh::Index triangle = 0;
  Vector3<double> point{};
};

struct LicOptions {
  double cell = 1;          ///< size of a grain of the noise, in units of length
  double half_length = 16;  ///< of the piece of a line that is averaged, in cells
  std::uint32_t seed = 1;   ///< of the noise
};

/// Line integral convolution on a surface: at each place the mean of a solid noise along the line
/// of the field through it, both ways (B. Cabral and C. Leedom, 1993; with noise in space as
/// X. Mao et al., 1997, so that the picture does not depend on how triangles lie). Lines go
/// straight on across edges, and end where there is no direction or no triangle.
///
/// Laws      (1) values are in [0, 1]; (2) they do not depend on the number of threads;
///           (3) places whose lines visit the same points have the same value.
/// Values without contrast: `stretched` gives them some.
std::vector<double> line_integral_convolution(const SurfaceMesh& surface, const LineField& field,
                                              const std::vector<SurfacePlace>& places,
                                              const LicOptions& options);

/// The values moved to mean 1/2 and, if they differ, a standard deviation of 1/4, clamped to [0,
/// 1].
std::vector<double> stretched(std::vector<double> values);

/// The solid noise, in [0, 1]: random numbers at the points of a lattice, interpolated.
double solid_noise(const Vector3<double>& point, const LicOptions& options);

}  // namespace tensortopo
