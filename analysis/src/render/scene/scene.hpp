// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "render/input/surface_file.hpp"
#include "render/scene/drawing.hpp"

namespace tensortopo {

struct Drawn {
  vtkSmartPointer<vtkImageData> image;
  bool surface_in_view = false;  ///< a vertex of a sheet is within the picture's frame
};

/// Draws sheets, named by descending mode, and, unless null, the boundary of their domain. Needs a
/// display.
/// The image is RGB, one byte a channel. Throws std::runtime_error.
Drawn draw(std::vector<Sheet> sheets, vtkPolyData* domain, const View& view);

}  // namespace tensortopo
