// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/drawing.hpp"
#include "render/tet/tet_directions.hpp"

namespace tensortopo {

/// What a panel of a tetrahedron's picture shows.
enum class Panel {
  curves,     ///< in space, the mode curves on the faces
  manifold,   ///< the sphere of medium eigenvectors, the quad grid, the face curves on it
  triangles,  ///< the sphere with the extracted triangles
  surface,    ///< in space, the surface and the degenerate curves
  octant,     ///< the complex domain in an eighth of the sphere, as a triangle
};

/// "manifold,surface", in any order. Throws UsageError.
std::vector<Panel> parse_panels(std::string_view text);

/// The generalized mode surface of one tetrahedron's linear field, on the sphere of medium
/// eigenvectors and in space.
struct TetPicture {
  TetField field;
  std::vector<ModeValue> modes;  ///< a column each (of one mode, a column for each panel)
  std::vector<Panel> panels{Panel::manifold, Panel::surface};
  Texture texture = Texture::none;
  /// 1: the surface in the tetrahedron. More: that of the linear field, carried on to a cube so
  /// many times as large as the tetrahedron.
  double beyond = 1;
  std::optional<Vector3<double>> marked;  ///< a direction, and the points that have it
  View view;
  double sphere_azimuth = 24, sphere_elevation = 28;  ///< from the complex domain, in degrees
};

/// The size of a picture for which nobody asked for one: upright panels.
void set_default_size(TetPicture& picture);

/// A point whose medium eigenvector is the marked direction.
struct MarkedPoint {
  Vector3<double> point{};
  double mode = 0;
  bool drawn = false;  ///< it is in the picture
};

struct TetImage {
  vtkSmartPointer<vtkImageData> image;
  std::vector<MarkedPoint> marked;
  std::vector<std::string> notes;  ///< what could not be extracted, and so is not drawn
  std::vector<ModeValue> missed;   ///< modes that are nowhere in space
};

/// Needs a display. Throws std::invalid_argument where there is no manifold, std::runtime_error
/// where nothing can be drawn.
TetImage draw_tet(const TetPicture& picture);

}  // namespace tensortopo
