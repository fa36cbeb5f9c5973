// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkRenderer.h>

#include <optional>
#include <vector>

#include "render/scene/drawing.hpp"
#include "render/tet/tet_directions.hpp"

namespace tensortopo {

/// Colours of the sphere: as in the paper's figure of the parameterization.
inline constexpr Colour kCyan{0.36, 0.84, 0.92};
inline constexpr Colour kMagenta{0.93, 0.40, 0.80};
inline constexpr Colour kBlue{0.36, 0.50, 0.93};
inline constexpr Colour kComplexGrey{0.60, 0.60, 0.60};
inline constexpr Colour kRed{0.88, 0.10, 0.10};

inline constexpr Colour kFaceCurve{0.05, 0.16, 0.72};

/// How much white is in the colours of directions that are not in the tetrahedron.
inline constexpr double kPale = 0.55, kPaleGrey = 0.25;

Colour colour_of(DirectionKind kind);
/// Of the sheets of a mode: teal, gold, or for mode 0 chartreuse.
Colour sheet_colour(double mode);

struct SphereLook {
  Texture texture = Texture::none;
  bool inside = true;  ///< the directions in the tetrahedron in their sheets' colours, others pale
  bool grid = true;    ///< the quad parameterization
  double line = 2;     ///< width in pixels of the window
  double radius_pixels = 300;
};

/// How the sphere is turned: the frame of the characteristic eigenvectors, e1 to the right, e2
/// up, e3 to the viewer (so that the complex domain is in view), turned by a view's angles.
struct SphereFrame {
  Vector3<double> right{}, up{}, viewer{};
};
/// `back` turns the sphere by half a turn about e2.
SphereFrame sphere_frame(const TetDirections& directions, double azimuth, double elevation,
                         bool back);

/// Whether more of the directions in the tetrahedron are on the back.
bool inside_is_behind(const TetDirections& directions, const SphereFrame& frame);

/// Directions of the visible half, evenly spread.
std::vector<Vector3<double>> visible_directions(const SphereFrame& frame);

/// The boundary of the complex domain where its points are in the tetrahedron (`inside`), or where
/// they are not.
std::vector<std::vector<Vector3<double>>> boundary_pieces(const TetDirections& directions,
                                                          bool inside);

/// The visible half of the sphere, the quad grid, the complex domain's boundary (green where its
/// points are in the tetrahedron) and the singularities.
void add_sphere(vtkRenderer& renderer, const TetDirections& directions, const SphereFrame& frame,
                const SphereLook& look);

/// The visible parts of polylines on the sphere, just above it.
void add_sphere_lines(vtkRenderer& renderer, const SphereFrame& frame,
                      const std::vector<std::vector<Vector3<double>>>& lines, const Colour& colour,
                      double width, double height = 1.004);

/// Looks at the sphere with parallel rays. It fills `share` of the frame, and its middle is above
/// that of the frame by `rise` of half the height.
void aim_at_sphere(vtkRenderer& renderer, const SphereFrame& frame, double aspect, double share,
                   double rise);

}  // namespace tensortopo
