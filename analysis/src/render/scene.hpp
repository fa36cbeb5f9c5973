// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "render/surface_file.hpp"

namespace tensortopo {

struct View {
  int width = 1600, height = 1200;  ///< pixels
  double azimuth = 30;              ///< degrees to the right of the front (the side of small y)
  double elevation = 22;            ///< degrees above the horizon (z points up)
};

/// Draws sheets and, unless null, the boundary of their domain. Needs a display.
/// The image is RGB, one byte a channel. Throws std::runtime_error.
vtkSmartPointer<vtkImageData> draw(const std::vector<Sheet>& sheets, vtkPolyData* domain,
                                   const View& view);

}  // namespace tensortopo
