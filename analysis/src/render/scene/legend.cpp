// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/legend.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace tensortopo {
namespace {

struct Rectangle {
  double x, y, width, height;
};

void add_rectangle(vtkRenderer& renderer, const Rectangle& box, const Look& look) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(box.x, box.y, 0);
  points->InsertNextPoint(box.x + box.width, box.y, 0);
  points->InsertNextPoint(box.x + box.width, box.y + box.height, 0);
  points->InsertNextPoint(box.x, box.y + box.height, 0);
  vtkNew<vtkCellArray> polygons;
  constexpr std::array<vtkIdType, 4> corners{0, 1, 2, 3};
  polygons->InsertNextCell(4, corners.data());
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(polygons);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  paint(*actor->GetProperty(), look.colour);
  actor->GetProperty()->SetOpacity(look.opacity);
  renderer.AddActor2D(actor);
}

vtkNew<vtkTextActor> text_at(double x, double y, double size, const std::string& words) {
  vtkNew<vtkTextActor> text;
  text->SetInput(words.c_str());
  text->GetTextProperty()->SetFontFamilyToArial();
  text->GetTextProperty()->SetFontSize(static_cast<int>(size));
  paint(*text->GetTextProperty(), kInk);
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  text->SetPosition(x, y);
  return text;
}

/// In pixels.
double width_of(vtkTextActor& text) {
  std::array<int, 4> box{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(text.GetTextProperty(), text.GetInput(),
                                                 box.data(), 72);
  return box[1] - box[0];
}

}  // namespace

void add_legend(vtkRenderer& renderer, const std::vector<LegendEntry>& entries, double unit) {
  if (entries.empty()) return;
  const double left = 0.9 * unit, swatch = 0.62 * unit, border = 0.04 * unit, gap = 0.3 * unit;
  const double bottom = 0.9 * unit, words_at = left + 1.4 * swatch;
  double y = bottom + static_cast<double>(entries.size()) * unit, right = words_at;
  std::vector<vtkNew<vtkTextActor>> words;
  for (const LegendEntry& entry : entries) {
    y -= unit;
    words.push_back(text_at(words_at, y + 0.5 * swatch, 0.66 * unit, entry.text));
    right = std::max(right, words_at + width_of(*words.back()));
  }
  const double height = static_cast<double>(entries.size() - 1) * unit + swatch;
  add_rectangle(renderer, {left - gap, bottom - gap, right - left + 2 * gap, height + 2 * gap},
                {kWhite, 0.75});
  y = bottom + static_cast<double>(entries.size()) * unit;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    y -= unit;
    const Look& look = entries[i].look;
    const Colour seen = mix(kWhite, look.colour, 0.35 + 0.65 * look.opacity);
    const double framed = swatch + 2 * border;
    add_rectangle(renderer, {left - border, y - border, framed, framed}, {kInk, 1});
    add_rectangle(renderer, {left, y, swatch, swatch}, {seen, 1});
    renderer.AddActor2D(words[i]);
  }
}

void add_title(vtkRenderer& renderer, const std::string& words, double unit, double height) {
  renderer.AddActor2D(text_at(0.9 * unit, height - 1.3 * unit, 0.9 * unit, words));
}

}  // namespace tensortopo
