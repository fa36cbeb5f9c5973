// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/scene.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/scene/legend.hpp"
#include "render/scene/look.hpp"

namespace tensortopo {
namespace {

// Size of a texture's grain: pixels, if the scene is as high as the picture.
constexpr double kGrain = 1.7;
// Radii of tubes, of the diagonal. Ridges lie on a surface, and are many.
constexpr double kTube = 0.004, kRidgeTube = 0.0018;

std::string name_of(const Sheet& sheet) {
  if (sheet.value) return fmt::format("value {:g}", *sheet.value);
  if (sheet.ridge_kind) return *sheet.ridge_kind > 0 ? "ridges" : "valleys";
  if (!sheet.mode) return "";
  return *sheet.mode == 0 ? "mode 0, neutral" : fmt::format("mode {:+g}", *sheet.mode);
}

bool any_in_view(vtkRenderer& renderer, const std::vector<Sheet>& sheets, double aspect) {
  vtkMatrix4x4& projection =
      *renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  for (const Sheet& sheet : sheets)
    for (vtkIdType i = 0; i < sheet.shape->GetNumberOfPoints(); ++i) {
      double place[4]{0, 0, 0, 1}, seen[4];
      sheet.shape->GetPoint(i, place);
      projection.MultiplyPoint(place, seen);
      if (seen[3] > 0 && std::abs(seen[0]) <= seen[3] && std::abs(seen[1]) <= seen[3]) return true;
    }
  return false;
}

}  // namespace

Drawn draw(std::vector<Sheet> sheets, vtkPolyData* domain, const View& view) {
  const auto place = [](const Sheet& s) {
    return std::pair{-s.mode.value_or(-2), s.value.value_or(0)};  // all modes first
  };
  std::stable_sort(sheets.begin(), sheets.end(),
                   [&](const Sheet& a, const Sheet& b) { return place(a) < place(b); });
  const vtkSmartPointer<vtkRenderer> renderer = new_scene();
  const double unit =
      0.04 * std::sqrt(static_cast<double>(view.width) * view.height) * kOversampling;
  const double line = std::max(1.0, 0.0016 * view.height) * kOversampling;
  std::vector<std::optional<double>> modes, values;
  for (const Sheet& sheet : sheets) {
    const auto add = [](auto& list, const auto& one) {
      if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
    };
    add(modes, sheet.mode);
    add(values, sheet.value);
  }
  std::vector<LegendEntry> legend;

  if (domain != nullptr) add_domain(*renderer, domain, line);
  double size = domain != nullptr ? diagonal(domain->GetBounds()) : 0;
  for (const Sheet& sheet : sheets)
    if (sheet.shape->GetNumberOfPoints() > 0)  // else its bounds are none
      size = std::max(size, diagonal(sheet.shape->GetBounds()));
  const double cell = kGrain * size / view.height / view.zoom;
  for (const Sheet& sheet : sheets) {
    Look look = sheet.value        ? look_of_value(*sheet.value, values)
                : sheet.ridge_kind ? look_of_ridges(*sheet.ridge_kind)
                                   : look_of(sheet.mode, modes);
    if (sheet.is_unstable) look = faded(look);
    if (sheet.shape->GetNumberOfPolys() > 0) {
      add_triangles(*renderer, sheet.shape, look, 0.7 * line, cell);
    }
    if (sheet.shape->GetNumberOfLines() > 0) {
      const double radius = (sheet.ridge_kind ? kRidgeTube : kTube) * size / view.zoom;
      add_curves(*renderer, sheet.shape, look, radius);
    }
    if (const std::string name = name_of(sheet); !name.empty())
      legend.push_back({look, sheet.is_unstable ? name + ", not stable" : name});
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (vtkMath::AreBoundsInitialized(bounds) == 0)  // nothing is visible
    for (int k = 0; k < 3; ++k) bounds[2 * k] = 0, bounds[2 * k + 1] = 1;
  add_legend(*renderer, legend, unit);
  const double aspect = static_cast<double>(view.width) / view.height;
  aim(*renderer, bounds, view, {aspect, 0, 0, {}});
  const bool in_view = any_in_view(*renderer, sheets, aspect);
  return {grab({renderer}, view.width, view.height), in_view};
}

}  // namespace tensortopo
