// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hex_mesh.hpp"

namespace tensortopo::scenarios {

/// Isotropic linear elasticity.
struct Material {
  double young = 0;  ///< MPa
  double poisson = 0;
};

/// A pressure on the highest faces, up to a factor that its resultant settles.
struct Load {
  enum class Shape {
    square,      ///< constant on a square
    paraboloid,  ///< 1 - (r / R)^2 on a disc
    everywhere,  ///< constant on all highest faces
  };
  Shape shape = Shape::everywhere;
  double x = 0, y = 0;    ///< centre, mm
  double half_width = 0;  ///< of the square; radius of the disc, mm
  double force = 0;       ///< resultant in N, positive downwards
};

/// One solid block: clamped at its lowest points, loaded on its highest faces.
struct Scenario {
  std::string name;
  HexMesh mesh;
  std::vector<Material> materials;
  std::vector<Load> loads;
};

enum class Size {
  small,  ///< 6000 to 7488 tetrahedra
  full,   ///< 480,000, 450,000, 384,000 and 286,416, as in the paper's section on performance
};

/// s1_compress, s1_compress_off, s2_pushpull, s3_three, s4_slab.
///
/// The paper shows its blocks and names their loads, but no sizes; counts of tetrahedra aside,
/// dimensions, loads and materials are ours. s1_compress_off is s1_compress with its load beside
/// the centre: without symmetry, and so without the non-generic tensors that symmetry makes.
const std::vector<std::string>& scenario_names();

/// Throws  std::invalid_argument for an unknown name.
Scenario make_scenario(std::string_view name, Size size);

}  // namespace tensortopo::scenarios
