// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.hpp"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkLightKit.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "render/legend.hpp"
#include "render/look.hpp"

namespace tensortopo {
namespace {

// The picture is drawn this many times larger each way, and averaged: smooth edges with
// translucent sheets, which multisampling does not give.
constexpr int kOversampling = 2;
constexpr int kPeels = 16;
// How much of the frame the scene takes.
constexpr double kFill = 0.93;
constexpr double kFeatureAngle = 25;

double diagonal(const double* bounds) {
  return std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

vtkSmartPointer<vtkActor> actor_of(vtkAlgorithmOutput* shape) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(shape);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void add_edges(vtkRenderer& renderer, vtkPolyData* shape, bool creases, const Colour& colour,
               double width) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(shape);
  edges->SetBoundaryEdges(!creases);
  edges->SetFeatureEdges(creases);
  edges->SetFeatureAngle(kFeatureAngle);
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  const auto actor = actor_of(edges->GetOutputPort());
  paint(*actor->GetProperty(), colour);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
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
  add_edges(renderer, domain, true, kInk, line);
}

void add_triangles(vtkRenderer& renderer, vtkPolyData* shape, const Look& look, double line) {
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
  vtkProperty& property = *actor->GetProperty();
  paint(property, look.colour);
  property.SetOpacity(look.opacity);
  property.SetAmbient(0.16);
  property.SetDiffuse(0.82);
  property.SetSpecular(0.22);
  property.SetSpecularPower(40);
  renderer.AddActor(actor);
  add_edges(renderer, shape, false, mix(look.colour, kInk, 0.55), line);
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

void add_lights(vtkRenderer& renderer) {
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(1.0);
  lights->SetKeyLightWarmth(0.55);
  lights->SetKeyLightAngle(50, -28);
  lights->SetKeyToFillRatio(2.4);
  lights->SetKeyToHeadRatio(2.6);
  lights->SetKeyToBackRatio(3.2);
  lights->AddLightsToRenderer(&renderer);
}

// Aims at the middle of the scene and comes as near as the frame allows.
void aim(vtkRenderer& renderer, const double* bounds, const View& view) {
  constexpr double degree = std::numbers::pi / 180;
  const double a = view.azimuth * degree, e = view.elevation * degree;
  double middle[3];
  for (int k = 0; k < 3; ++k) middle[k] = (bounds[2 * k] + bounds[2 * k + 1]) / 2;
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.SetFocalPoint(middle);
  camera.SetPosition(middle[0] + std::cos(e) * std::sin(a), middle[1] - std::cos(e) * std::cos(a),
                     middle[2] + std::sin(e));
  const bool from_above = std::abs(std::cos(e)) < 0.01;
  camera.SetViewUp(0, from_above ? 1 : 0, from_above ? 0 : 1);
  camera.SetViewAngle(24);
  renderer.ResetCamera(bounds);
  vtkMatrix4x4& projection = *camera.GetCompositeProjectionTransformMatrix(
      static_cast<double>(view.width) / view.height, -1, 1);
  double low[2]{HUGE_VAL, HUGE_VAL}, high[2]{-HUGE_VAL, -HUGE_VAL};
  for (int corner = 0; corner < 8; ++corner) {
    const double place[4]{bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
                          bounds[4 + (corner >> 2)], 1};
    double seen[4];
    projection.MultiplyPoint(place, seen);
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], seen[k] / seen[3]);
      high[k] = std::max(high[k], seen[k] / seen[3]);
    }
  }
  const double reach = std::max(high[0] - low[0], high[1] - low[1]) / 2;
  if (reach > 0) {
    const double zoom = kFill / reach;
    camera.Zoom(zoom);
    camera.SetWindowCenter(zoom * (low[0] + high[0]) / 2, zoom * (low[1] + high[1]) / 2);
  }
  renderer.ResetCameraClippingRange(bounds);
}

vtkSmartPointer<vtkImageData> average(vtkImageData* large, int width, int height) {
  auto small = vtkSmartPointer<vtkImageData>::New();
  small->SetDimensions(width, height, 1);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* const from = static_cast<const unsigned char*>(large->GetScalarPointer());
  auto* const to = static_cast<unsigned char*>(small->GetScalarPointer());
  constexpr int n = kOversampling;
  const auto row = static_cast<std::ptrdiff_t>(width) * n * 3;
  for (std::ptrdiff_t y = 0; y < height; ++y) {
    for (std::ptrdiff_t x = 0; x < width; ++x) {
      for (std::ptrdiff_t channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (std::ptrdiff_t j = 0; j < n; ++j) {
          for (std::ptrdiff_t i = 0; i < n; ++i) {
            sum += from[(y * n + j) * row + (x * n + i) * 3 + channel];
          }
        }
        to[(y * width + x) * 3 + channel] = static_cast<unsigned char>((sum + n * n / 2) / (n * n));
      }
    }
  }
  return small;
}

vtkSmartPointer<vtkImageData> grab(vtkRenderer& renderer, const View& view) {
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(view.width * kOversampling, view.height * kOversampling);
  window->AddRenderer(&renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  vtkImageData* const image = grabber->GetOutput();
  int size[3];
  image->GetDimensions(size);
  if (size[0] != view.width * kOversampling || size[1] != view.height * kOversampling) {
    throw std::runtime_error("the renderer gives no picture of this size");
  }
  return average(image, view.width, view.height);
}

}  // namespace

vtkSmartPointer<vtkImageData> draw(const std::vector<Sheet>& sheets, vtkPolyData* domain,
                                   const View& view) {
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->SetUseDepthPeeling(1);
  renderer->SetMaximumNumberOfPeels(kPeels);
  renderer->SetOcclusionRatio(0);

  const double unit = 0.036 * view.height * kOversampling;
  const double line = std::max(1.0, 0.0016 * view.height) * kOversampling;
  std::vector<std::optional<double>> modes;
  for (const Sheet& sheet : sheets) modes.push_back(sheet.mode);
  std::vector<LegendEntry> legend;

  if (domain != nullptr) add_domain(*renderer, domain, line);
  double size = domain != nullptr ? diagonal(domain->GetBounds()) : 0;
  for (const Sheet& sheet : sheets) size = std::max(size, diagonal(sheet.shape->GetBounds()));
  for (const Sheet& sheet : sheets) {
    const Look look = look_of(sheet.mode, modes);
    if (sheet.shape->GetNumberOfPolys() > 0) {
      add_triangles(*renderer, sheet.shape, look, 0.7 * line);
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
  add_lights(*renderer);
  add_legend(*renderer, legend, unit);
  aim(*renderer, bounds, view);
  return grab(*renderer, view);
}

}  // namespace tensortopo
