// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/drawing.hpp"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <unordered_map>

#include "render/scene/texture.hpp"

namespace tensortopo {
namespace {

vtkSmartPointer<vtkActor> actor_of(vtkAlgorithmOutput* shape) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(shape);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

// A file has a line for each tetrahedron; those that follow each other become one tube.
vtkSmartPointer<vtkCellArray> joined(vtkCellArray* lines) {
  const auto result = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> chain;
  const auto end_chain = [&] {
    if (chain.size() > 1)
      result->InsertNextCell(static_cast<vtkIdType>(chain.size()), chain.data());
    chain.clear();
  };
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i) {
    lines->GetCellAtId(i, size, points);
    if (size == 0) continue;
    if (!chain.empty() && chain.back() == points[0]) {
      chain.pop_back();
    } else {
      end_chain();
    }
    chain.insert(chain.end(), points, points + size);
  }
  end_chain();
  return result;
}

void finish(vtkProperty& property, double opacity) {
  property.SetOpacity(opacity);
  property.SetAmbient(0.16);
  property.SetDiffuse(0.82);
  property.SetSpecular(0.22);
  property.SetSpecularPower(40);
}

}  // namespace

double diagonal(const double* bounds) {
  return std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

void add_edges(vtkRenderer& renderer, vtkPolyData* shape, EdgeKind kind, const Colour& colour,
               double width) {
  const SurfaceMesh surface = surface_of(*shape);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::unordered_map<SurfaceMesh::Index, vtkIdType> known;
  const auto number = [&](SurfaceMesh::Index i) {
    const auto [found, is_new] = known.emplace(i, points->GetNumberOfPoints());
    const auto& p = surface.points[static_cast<std::size_t>(i)];
    if (is_new) points->InsertNextPoint(p.x, p.y, p.z);
    return found->second;
  };
  for (const auto& [from, to] : feature_edges(surface, kind)) {
    const vtkIdType ends[2]{number(from), number(to)};
    lines->InsertNextCell(2, ends);
  }
  vtkNew<vtkPolyData> edges;
  edges->SetPoints(points);
  edges->SetLines(lines);
  add_lines(renderer, edges, colour, width);
}

void add_domain(vtkRenderer& renderer, vtkPolyData* domain, double line) {
  vtkNew<vtkPolyDataNormals> flat;
  flat->SetInputData(domain);
  flat->SetFeatureAngle(kFeatureAngle);
  const auto walls = actor_of(flat->GetOutputPort());
  walls->GetProperty()->SetColor(0.72, 0.75, 0.79);
  walls->GetProperty()->SetOpacity(0.13);
  walls->GetProperty()->SetAmbient(0.5);
  walls->GetProperty()->SetDiffuse(0.5);
  renderer.AddActor(walls);
  add_edges(renderer, domain, EdgeKind::crease, kInk, line);
}

void add_triangles(vtkRenderer& renderer, vtkPolyData* shape, const Look& look, double line,
                   double cell) {
  if (!line_field_of(*shape).empty()) {
    const auto texture = textured(*shape, look.colour, cell);
    add_coloured(renderer, texture, false, look.opacity);
  } else {
    vtkNew<vtkPolyDataNormals> smooth;
    smooth->SetInputData(shape);
    smooth->SplittingOff();
    smooth->ConsistencyOff();
    vtkNew<vtkPolyDataMapper> mapper;
    if (shape->GetPointData()->GetNormals() != nullptr) {
      mapper->SetInputData(shape);
    } else {
      mapper->SetInputConnection(smooth->GetOutputPort());
    }
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    paint(*actor->GetProperty(), look.colour);
    finish(*actor->GetProperty(), look.opacity);
    renderer.AddActor(actor);
  }
  add_edges(renderer, shape, EdgeKind::boundary, mix(look.colour, kInk, 0.55), line);
}

void add_curves(vtkRenderer& renderer, vtkPolyData* shape, const Look& look, double radius) {
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(shape->GetPoints());
  lines->SetLines(joined(shape->GetLines()));
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(20);
  tubes->CappingOn();
  const auto actor = actor_of(tubes->GetOutputPort());
  paint(*actor->GetProperty(), look.colour);
  actor->GetProperty()->SetAmbient(0.2);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(30);
  renderer.AddActor(actor);
}

void add_lines(vtkRenderer& renderer, vtkPolyData* shape, const Colour& colour, double width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  paint(*actor->GetProperty(), colour);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

void add_coloured(vtkRenderer& renderer, vtkPolyData* shape, bool soft, double opacity) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOn();
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  finish(*actor->GetProperty(), opacity);
  if (soft) {
    actor->GetProperty()->SetAmbient(0.55);
    actor->GetProperty()->SetDiffuse(0.5);
    actor->GetProperty()->SetSpecular(0);
  }
  renderer.AddActor(actor);
}

void add_ball(vtkRenderer& renderer, const std::array<double, 3>& middle, double radius,
              const Colour& colour) {
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(middle[0], middle[1], middle[2]);
  ball->SetRadius(radius);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(24);
  const auto actor = actor_of(ball->GetOutputPort());
  paint(*actor->GetProperty(), colour);
  actor->GetProperty()->SetAmbient(0.3);
  renderer.AddActor(actor);
}

}  // namespace tensortopo
