// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/legend.hpp"
#include "render/look.hpp"

namespace tensortopo {
namespace {

// Size of a texture's grain: pixels, if the scene is as high as the picture.
constexpr double kGrain = 1.7;

}  // namespace

vtkSmartPointer<vtkImageData> draw(const std::vector<Sheet>& sheets, vtkPolyData* domain,
                                   const View& view) {
  const vtkSmartPointer<vtkRenderer> renderer = new_scene();
  const double unit = 0.036 * view.height * kOversampling;
  const double line = std::max(1.0, 0.0016 * view.height) * kOversampling;
  std::vector<std::optional<double>> modes;
  for (const Sheet& sheet : sheets) modes.push_back(sheet.mode);
  std::vector<LegendEntry> legend;

  if (domain != nullptr) add_domain(*renderer, domain, line);
  double size = domain != nullptr ? diagonal(domain->GetBounds()) : 0;
  for (const Sheet& sheet : sheets) size = std::max(size, diagonal(sheet.shape->GetBounds()));
  const double cell = kGrain * size / view.height;
  for (const Sheet& sheet : sheets) {
    const Look look = look_of(sheet.mode, modes);
    if (sheet.shape->GetNumberOfPolys() > 0) {
      add_triangles(*renderer, sheet.shape, look, 0.7 * line, cell);
    }
    if (sheet.shape->GetNumberOfLines() > 0) {
      add_curves(*renderer, sheet.shape, look, 0.004 * size);
    }
    if (sheet.mode) {
      const std::string name =
          *sheet.mode == 0 ? "mode 0, neutral" : fmt::format("mode {:+g}", *sheet.mode);
      legend.push_back({look, name});
    }
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  add_legend(*renderer, legend, unit);
  aim(*renderer, bounds, view, {static_cast<double>(view.width) / view.height, 0, 0, {}});
  return grab({renderer}, view.width, view.height);
}

}  // namespace tensortopo
