// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCamera.h>
#include <vtkLightKit.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "render/scene/drawing.hpp"

namespace tensortopo {
namespace {

constexpr int kPeels = 16;
// How much of the frame the scene takes.
constexpr double kFill = 0.93;

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

}  // namespace

vtkSmartPointer<vtkRenderer> new_scene(const std::array<double, 4>& part) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(part[0], part[1], part[2], part[3]);
  renderer->SetBackground(1, 1, 1);
  renderer->SetUseDepthPeeling(1);
  renderer->SetMaximumNumberOfPeels(kPeels);
  renderer->SetOcclusionRatio(0);
  add_lights(*renderer);
  return renderer;
}

void aim(vtkRenderer& renderer, const double* bounds, const View& view, const Frame& frame) {
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
  vtkMatrix4x4& projection = *camera.GetCompositeProjectionTransformMatrix(frame.aspect, -1, 1);
  const auto seen_at = [&](const std::array<double, 3>& point) {
    const double place[4]{point[0], point[1], point[2], 1};
    double seen[4];
    projection.MultiplyPoint(place, seen);
    return std::array{seen[0] / seen[3], seen[1] / seen[3]};
  };
  double low[2]{HUGE_VAL, HUGE_VAL}, high[2]{-HUGE_VAL, -HUGE_VAL};
  std::vector<std::array<double, 3>> points = frame.points;
  for (int corner = 0; frame.points.empty() && corner < 8; ++corner)
    points.push_back(
        {bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2)]});
  for (const auto& point : points) {
    const auto seen = seen_at(point);
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], seen[k]);
      high[k] = std::max(high[k], seen[k]);
    }
  }
  const double reach =
      std::max(high[0] - low[0], (high[1] - low[1]) / (1 - frame.rise - frame.margin)) / 2;
  if (reach > 0) {
    const double zoom = view.zoom * kFill / reach;
    std::array<double, 2> centre{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
    if (view.focus) centre = seen_at(*view.focus);
    // Not camera.Zoom, which divides the angle and not its tangent. (The angle is what ResetCamera
    // leaves.)
    const double angle = camera.GetViewAngle() * degree;
    camera.SetViewAngle(2 * std::atan(std::tan(angle / 2) / zoom) / degree);
    camera.SetWindowCenter(zoom * centre[0], zoom * centre[1] - frame.rise);
  }
  renderer.ResetCameraClippingRange(bounds);
}

vtkSmartPointer<vtkImageData> grab(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers,
                                   int width, int height) {
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(width * kOversampling, height * kOversampling);
  for (const auto& renderer : renderers) window->AddRenderer(renderer);
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
  if (size[0] != width * kOversampling || size[1] != height * kOversampling) {
    throw std::runtime_error("the renderer gives no picture of this size");
  }
  return average(image, width, height);
}

}  // namespace tensortopo
