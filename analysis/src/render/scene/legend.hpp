// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/scene/look.hpp"

class vtkRenderer;

namespace tensortopo {

struct LegendEntry {
  Look look;
  std::string text;
};

/// Draws swatches with words on a light panel in the lower left corner; `unit` is the height of a
/// line in pixels.
void add_legend(vtkRenderer& renderer, const std::vector<LegendEntry>& entries, double unit);

/// Words in the upper left corner of a scene that is so many pixels high.
void add_title(vtkRenderer& renderer, const std::string& words, double unit, double height);

}  // namespace tensortopo
