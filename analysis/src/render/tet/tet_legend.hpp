// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/scene/legend.hpp"
#include "render/tet/tet_directions.hpp"
#include "render/tet/tet_surface.hpp"

namespace tensortopo {

/// What the visible half of a sphere shows, or of several: the legend names no more.
struct SphereSeen {
  bool complex = false, positive = false, negative = false, mixed = false;  ///< outside or anywhere
  bool neutral_mixed = false;                                               ///< the same of mode 0
  bool inside_positive = false, inside_negative = false, inside_neutral = false;
  bool curves = false;    ///< mode curves on faces
  bool boundary = false;  ///< the complex domain's boundary, where it is in the tetrahedron

  /// A direction of the half, at which `inside` says whether the tetrahedron has a colour.
  void add(const TetDirections& directions, const Vector3<double>& v, bool inside);
};

/// @param inside  directions that are not in the tetrahedron are pale
std::vector<LegendEntry> sphere_legend(const SphereSeen& seen, bool inside);

/// Of what is in space in any column.
std::vector<LegendEntry> space_legend(const std::vector<const TetSurface*>& surfaces, bool curves);

}  // namespace tensortopo
