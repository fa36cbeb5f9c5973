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

#include <array>

namespace tensortopo {
namespace {

void add_rectangle(vtkRenderer& renderer, double x, double y, double size, const Colour& colour) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, y, 0);
  points->InsertNextPoint(x + size, y, 0);
  points->InsertNextPoint(x + size, y + size, 0);
  points->InsertNextPoint(x, y + size, 0);
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
  paint(*actor->GetProperty(), colour);
  renderer.AddActor2D(actor);
}

void add_text(vtkRenderer& renderer, double x, double y, double size, const std::string& words) {
  vtkNew<vtkTextActor> text;
  text->SetInput(words.c_str());
  text->GetTextProperty()->SetFontFamilyToArial();
  text->GetTextProperty()->SetFontSize(static_cast<int>(size));
  paint(*text->GetTextProperty(), kInk);
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  text->SetPosition(x, y);
  renderer.AddActor2D(text);
}

}  // namespace

void add_legend(vtkRenderer& renderer, const std::vector<LegendEntry>& entries, double unit) {
  const double left = 0.9 * unit, swatch = 0.62 * unit, border = 0.04 * unit;
  double y = 0.9 * unit + static_cast<double>(entries.size()) * unit;
  for (const LegendEntry& entry : entries) {
    y -= unit;
    const Colour seen = mix(kWhite, entry.look.colour, 0.35 + 0.65 * entry.look.opacity);
    add_rectangle(renderer, left - border, y - border, swatch + 2 * border, kInk);
    add_rectangle(renderer, left, y, swatch, seen);
    add_text(renderer, left + 1.4 * swatch, y + 0.5 * swatch, 0.66 * unit, entry.text);
  }
}

void add_title(vtkRenderer& renderer, const std::string& words, double unit, double height) {
  add_text(renderer, 0.9 * unit, height - 1.3 * unit, 0.9 * unit, words);
}

}  // namespace tensortopo
