// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string_view>

#include "render/scene/line_field.hpp"
#include "render/scene/look.hpp"

namespace tensortopo {

/// "major", "minor", "dominant". Throws UsageError.
Texture parse_texture(std::string_view text);

/// Makes lines an array of the shape's points.
void set_line_field(vtkPolyData& shape, const LineField& field);
/// What `set_line_field` put there; empty if nothing.
LineField line_field_of(vtkPolyData& shape);

/// The triangles, points and normals of a shape.
SurfaceMesh surface_of(vtkPolyData& shape);

/// The shape cut finely, its vertices coloured: the colour, lighter and darker along the lines.
/// @param cell  size of a grain of noise
vtkSmartPointer<vtkPolyData> textured(vtkPolyData& shape, const Colour& colour, double cell);

/// A colour, lighter or darker: `value` in [0, 1].
Colour shaded(const Colour& colour, double value);

}  // namespace tensortopo
