// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <vector>

#include "render/input/feature_edges.hpp"
#include "render/scene/look.hpp"

namespace tensortopo {

/// Where a scene is looked at from, and the size of its picture.
struct View {
  int width = 1600, height = 1200;  ///< pixels
  bool sized = false;               ///< somebody asked for this size
  double azimuth = 30;              ///< degrees to the right of the front (the side of small y)
  double elevation = 22;            ///< degrees above the horizon (z points up)
  /// A point of space that is seen in the middle; nothing: all is in view, as large as it can be.
  std::optional<std::array<double, 3>> focus;
  double zoom = 1;  ///< how much larger than that
};

/// A picture is drawn this many times larger each way, and averaged: smooth edges with
/// translucent sheets, which multisampling does not give.
inline constexpr int kOversampling = 2;

double diagonal(const double* bounds);

/// An empty white scene, lit. `part` is the part of the window: left, bottom, right, top in [0, 1].
vtkSmartPointer<vtkRenderer> new_scene(const std::array<double, 4>& part = {0, 0, 1, 1});

/// Edges of a kind, as lines.
void add_edges(vtkRenderer& renderer, vtkPolyData* shape, EdgeKind kind, const Colour& colour,
               double width);
/// Glass walls with dark creases.
void add_domain(vtkRenderer& renderer, vtkPolyData* domain, double line);
/// A surface with its boundary. Where the shape has an array of lines (see `texture.hpp`), textured
/// with grains of size `cell`.
void add_triangles(vtkRenderer& renderer, vtkPolyData* shape, const Look& look, double line,
                   double cell);
/// Lines that follow each other as tubes.
void add_curves(vtkRenderer& renderer, vtkPolyData* shape, const Look& look, double radius);
/// Lines as such, unlit.
void add_lines(vtkRenderer& renderer, vtkPolyData* shape, const Colour& colour, double width);
/// Triangles with the colours of their vertices; `soft` light leaves these easy to tell.
void add_coloured(vtkRenderer& renderer, vtkPolyData* shape, bool soft, double opacity = 1);
void add_ball(vtkRenderer& renderer, const std::array<double, 3>& middle, double radius,
              const Colour& colour);

/// What a scene has to fit in.
struct Frame {
  double aspect = 1;  ///< width / height
  double rise =
      0;  ///< how far its middle is above the picture's, of half the height: below are words
  double margin = 0;  ///< above and below together, of half the height: above is the title
  std::vector<std::array<double, 3>> points;  ///< that must be seen; none: the corners of the box
};

/// Aims at the middle of a box and comes as near as the frame allows; of a view with a focus or a
/// zoom the picture is a part of that, enlarged.
void aim(vtkRenderer& renderer, const double* bounds, const View& view, const Frame& frame);

/// What the scenes look like, one byte a channel, RGB. Throws std::runtime_error.
vtkSmartPointer<vtkImageData> grab(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers,
                                   int width, int height);

}  // namespace tensortopo
