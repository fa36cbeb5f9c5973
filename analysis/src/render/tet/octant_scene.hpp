// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkRenderer.h>

#include <vector>

#include "render/scene/legend.hpp"
#include "render/tet/tet_directions.hpp"

namespace tensortopo {

/// An eighth of the sphere of medium eigenvectors, which by its symmetry is all of it, as the
/// triangle of the squares (a^2, b^2, c^2) of a direction's coordinates along the characteristic
/// eigenvectors (paper, proof of the bifurcation): the complex domain grey, its boundary, an arc of
/// a parabola, and where that ends on an edge. c^2 = 1 is left, a^2 = 1 right, b^2 = 1 above.
void add_octant(vtkRenderer& renderer, const TetDirections& directions, double line);

std::vector<LegendEntry> octant_legend();

/// Looks at the triangle with parallel rays. It fills `share` of the frame's width (or height), and
/// its middle is above that of the frame by `rise` of half the height.
void aim_at_octant(vtkRenderer& renderer, double aspect, double share, double rise);

}  // namespace tensortopo
