// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/octant_scene.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/scene/drawing.hpp"
#include "render/tet/sphere_scene.hpp"

namespace tensortopo {
namespace {

constexpr int kRows = 500;      // of small triangles
constexpr int kSamples = 2000;  // of the boundary
constexpr double kBall = 0.013, kLift = 0.001;
const double kTriangleHeight = std::sqrt(3.0) / 2;

using Place = std::array<double, 3>;

// Of squares of coordinates that add up to 1, in a triangle of side 1.
Place place_of(double a2, double b2, double lift) { return {a2 + b2 / 2, kTriangleHeight * b2, lift}; }

Place place_of(const TetDirections& directions, const Vector3<double>& v, double lift) {
  const auto& e = directions.manifold().characteristic().eigenvectors;
  const double a = dot(e[0], v), b = dot(e[1], v);
  return place_of(a * a, b * b, lift);
}

vtkSmartPointer<vtkPolyData> line_of(const std::vector<Place>& places) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(places.size()));
  for (const Place& p : places) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetLines(cells);
  return shape;
}

// Rows of triangles, coloured at their corners.
vtkSmartPointer<vtkPolyData> coloured_triangle(const TetDirections& directions) {
  const auto& e = directions.manifold().characteristic().eigenvectors;
  const Colour real = mix(kGrey, kWhite, 0.85);
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  for (int j = 0; j <= kRows; ++j) {
    for (int i = 0; i <= kRows - j; ++i) {
      const double a2 = static_cast<double>(i) / kRows, b2 = static_cast<double>(j) / kRows;
      const double c2 = static_cast<double>(kRows - i - j) / kRows;
      const Vector3<double> v = std::sqrt(a2) * e[0] + std::sqrt(b2) * e[1] + std::sqrt(c2) * e[2];
      const Colour c = directions.manifold().in_real_domain(v) ? real : kComplexGrey;
      const vtkIdType here = points->InsertNextPoint(place_of(a2, b2, 0).data());
      bytes->InsertNextTuple3(std::round(255 * c[0]), std::round(255 * c[1]),
                              std::round(255 * c[2]));
      if (i == kRows - j) continue;
      const vtkIdType above = here + kRows - j + 1;
      const vtkIdType up[3]{here, here + 1, above}, down[3]{here + 1, above + 1, above};
      cells->InsertNextCell(3, up);
      if (i + 1 < kRows - j) cells->InsertNextCell(3, down);
    }
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetPolys(cells);
  shape->GetPointData()->SetScalars(bytes);
  return shape;
}

}  // namespace

void add_octant(vtkRenderer& renderer, const TetDirections& directions, double line) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(coloured_triangle(directions));
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
  const std::array<Place, 3> corners{place_of(0, 0, kLift), place_of(1, 0, kLift),
                                     place_of(0, 1, kLift)};
  add_lines(renderer, line_of({corners[0], corners[1], corners[2], corners[0]}), kInk, line);

  const auto& manifold = directions.manifold();
  if (!manifold.complex_domain_empty()) {
    // One quarter of a loop has the eighth's arc: from b = 0 to a = 0, or where there are two loops
    // from b = 0 to b = 0.
    const double last = std::numbers::pi / (manifold.single_loop() ? 2 : 1);
    std::vector<Place> arc;
    for (int i = 0; i <= kSamples; ++i)
      arc.push_back(
          place_of(directions, manifold.boundary_point(0, last * i / kSamples), 2 * kLift));
    add_lines(renderer, line_of(arc), kInk, 1.5 * line);
    for (const Place& end : {arc.front(), arc.back()}) add_ball(renderer, end, kBall, kYellow);
  }
  const std::array colours{kRed, kGreen, kCyan};
  for (std::size_t k = 0; k < 3; ++k) add_ball(renderer, corners[k], 1.3 * kBall, colours[k]);
}

std::vector<LegendEntry> octant_legend() {
  return {{{kComplexGrey, 1}, "complex domain"},
          {{kYellow, 1}, "its boundary on an edge"},
          {{kRed, 1}, "(0, 0, 1)"},
          {{kGreen, 1}, "(1, 0, 0)"},
          {{kCyan, 1}, "(0, 1, 0)"}};
}

void aim_at_octant(vtkRenderer& renderer, double aspect, double share, double rise) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(0.5, kTriangleHeight / 2, 0);
  camera.SetPosition(0.5, kTriangleHeight / 2, 5);
  camera.SetViewUp(0, 1, 0);
  camera.SetParallelScale(std::max(1 / aspect, kTriangleHeight) / share / 2);
  camera.SetWindowCenter(0, -rise);
  camera.SetClippingRange(1, 9);
}

}  // namespace tensortopo
