// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/sphere_scene.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

#include "render/scene/fine_surface.hpp"
#include "render/scene/texture.hpp"

namespace tensortopo {
namespace {

using Polyline = std::vector<Vector3<double>>;

constexpr int kGridLines = 12;     // in half a turn
constexpr int kGridSamples = 240;  // of a line of the grid
constexpr int kLatitudes = 96;     // of the triangles that carry the texture's lines
constexpr double kRim = -0.04;     // how far behind the visible half triangles are kept
constexpr double kNearRim = 0.09;  // cosine: lines beyond would stick out
constexpr double kPixels = 2.5;    // of the window: edges of coloured triangles
constexpr double kTexturePixels = 3.4;
constexpr double kGrainPixels = 3;  // of the window
constexpr std::size_t kMostSphereVertices = 2500000;

// Triangles of the visible half, latitudes around the viewer.
SurfaceMesh visible_half(const SphereFrame& frame) {
  SurfaceMesh sphere;
  const double last = std::acos(kRim);
  constexpr int around = 4 * kLatitudes;
  sphere.points.push_back(frame.viewer);
  for (int i = 1; i <= kLatitudes; ++i) {
    const double polar = last * i / kLatitudes;
    for (int j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * j / around;
      sphere.points.push_back(std::cos(polar) * frame.viewer +
                              std::sin(polar) * std::cos(turn) * frame.right +
                              std::sin(polar) * std::sin(turn) * frame.up);
    }
  }
  const auto number = [](int i, int j) {
    return i == 0 ? SurfaceMesh::Index{0}
                  : static_cast<SurfaceMesh::Index>(1 + (i - 1) * around + j % around);
  };
  for (int i = 0; i < kLatitudes; ++i) {
    for (int j = 0; j < around; ++j) {
      sphere.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      if (i > 0) sphere.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  return sphere;
}

Colour plain_colour(const TetDirections& directions, const Vector3<double>& v,
                    const SphereLook& look) {
  const DirectionKind kind = directions.kind(v);
  const Colour colour = colour_of(kind);
  if (!look.inside) return colour;
  const int sign = directions.sign_inside(v);
  if (sign != 0) return sheet_colour(sign * directions.manifold().mode().abs_mu);
  return mix(colour, kWhite, kind == DirectionKind::complex_domain ? kPaleGrey : kPale);
}

// The texture's values at the places; 1/2 where there is no direction.
std::vector<double> texture_values(const TetDirections& directions, const SurfaceMesh& sphere,
                                   const FineSurface& fine, const SphereLook& look) {
  std::vector<double> values(fine.vertices.size(), 0.5);
  if (look.texture == Texture::none) return values;
  LineField field(sphere.points.size());
  tbb::parallel_for(std::size_t{0}, field.size(), [&](std::size_t i) {
    field[i] = dyad(directions.line(sphere.points[i], look.texture));
  });
  LicOptions options;
  options.cell = kGrainPixels / look.radius_pixels;
  std::vector<SurfacePlace> places;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < fine.vertices.size(); ++i) {
    if (!directions.manifold().in_real_domain(unit(fine.vertices[i].point))) continue;
    places.push_back(fine.vertices[i]);
    which.push_back(i);
  }
  const std::vector<double> found =
      stretched(line_integral_convolution(sphere, field, places, options));
  for (std::size_t i = 0; i < which.size(); ++i) values[which[i]] = found[i];
  return values;
}

}  // namespace

Colour colour_of(DirectionKind kind) {
  switch (kind) {
    case DirectionKind::positive:
      return kCyan;
    case DirectionKind::negative:
      return kMagenta;
    case DirectionKind::mixed:
      return kBlue;
    case DirectionKind::complex_domain:
      break;
  }
  return kComplexGrey;
}

Colour sheet_colour(double mode) { return mode > 0 ? kTeal : mode < 0 ? kGold : kChartreuse; }

SphereFrame sphere_frame(const TetDirections& directions, double azimuth, double elevation,
                         bool back) {
  const auto& e = directions.manifold().characteristic().eigenvectors;
  const double side = back ? -1 : 1, a = azimuth * std::numbers::pi / 180,
               b = elevation * std::numbers::pi / 180;
  const Vector3<double> x = side * e[0], y = e[1], z = side * e[2];
  SphereFrame frame;
  frame.viewer = std::cos(b) * (std::cos(a) * z + std::sin(a) * x) + std::sin(b) * y;
  frame.right = std::cos(a) * x - std::sin(a) * z;
  frame.up = cross(frame.viewer, frame.right);
  return frame;
}

std::vector<Vector3<double>> visible_directions(const SphereFrame& frame) {
  constexpr int rows = 200;
  std::vector<Vector3<double>> directions;
  // Rows of equal area.
  for (int i = 0; i < rows; ++i) {
    const double height = (i + 0.5) / rows, radius = std::sqrt(1 - height * height);
    for (int j = 0; j < 2 * rows; ++j) {
      const double turn = std::numbers::pi * j / rows;
      directions.push_back(height * frame.viewer + radius * std::cos(turn) * frame.right +
                           radius * std::sin(turn) * frame.up);
    }
  }
  return directions;
}

bool inside_is_behind(const TetDirections& directions, const SphereFrame& frame) {
  int front = 0, behind = 0;
  for (const Vector3<double>& v : visible_directions(frame)) {
    if (directions.sign_inside(v) != 0) ++front;
    if (directions.sign_inside(-v) != 0) ++behind;
  }
  return behind > front;
}

std::vector<Polyline> boundary_pieces(const TetDirections& directions, bool inside) {
  std::vector<Polyline> out;
  const auto& manifold = directions.manifold();
  if (manifold.complex_domain_empty()) return out;
  constexpr int samples = 6 * kGridSamples;
  for (int loop = 0; loop < manifold.loop_count(); ++loop) {
    Polyline piece;
    const auto end = [&] {
      if (piece.size() > 1) {
        out.push_back(piece);
        for (auto& v : piece) v = -v;
        out.push_back(piece);
      }
      piece.clear();
    };
    for (int i = 0; i <= samples; ++i) {
      const Vector3<double> v = manifold.boundary_point(loop, 2 * std::numbers::pi * i / samples);
      if ((directions.sign_inside_boundary(v) != 0) == inside) {
        piece.push_back(v);
      } else {
        end();
      }
    }
    end();
  }
  return out;
}

void add_sphere_lines(vtkRenderer& renderer, const SphereFrame& frame,
                      const std::vector<Polyline>& lines, const Colour& colour, double width,
                      double height) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> piece;
  const auto end = [&] {
    if (piece.size() > 1) cells->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
    piece.clear();
  };
  for (const Polyline& line : lines) {
    for (const auto& v : line) {
      if (dot(v, frame.viewer) > kNearRim) {
        piece.push_back(points->InsertNextPoint(height * v.x, height * v.y, height * v.z));
      } else {
        end();
      }
    }
    end();
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetLines(cells);
  add_lines(renderer, shape, colour, width);
}

void add_sphere(vtkRenderer& renderer, const TetDirections& directions, const SphereFrame& frame,
                const SphereLook& look) {
  const SurfaceMesh sphere = visible_half(frame);
  const double pixels = look.texture == Texture::none ? kPixels : kTexturePixels;
  const FineSurface fine = fine_surface(sphere, pixels / look.radius_pixels, kMostSphereVertices);
  const std::vector<double> values = texture_values(directions, sphere, fine, look);
  std::vector<Colour> colours(fine.vertices.size());
  tbb::parallel_for(std::size_t{0}, colours.size(), [&](std::size_t i) {
    colours[i] = plain_colour(directions, unit(fine.vertices[i].point), look);
  });
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < fine.vertices.size(); ++i) {
    const Vector3<double> v = unit(fine.vertices[i].point);
    points->InsertNextPoint(v.x, v.y, v.z);
    normals->InsertNextTuple3(v.x, v.y, v.z);
    const Colour c = shaded(colours[i], values[i]);
    bytes->InsertNextTuple3(std::round(255 * c[0]), std::round(255 * c[1]), std::round(255 * c[2]));
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : fine.triangles) {
    const vtkIdType ids[3]{t[0], t[1], t[2]};
    triangles->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(triangles);
  shape->GetPointData()->SetScalars(bytes);
  shape->GetPointData()->SetNormals(normals);
  add_coloured(renderer, shape, true);

  const auto& manifold = directions.manifold();
  if (look.grid) {
    std::vector<Polyline> grid;
    for (int k = 0; k < 2 * kGridLines; ++k) {
      Polyline across, along;
      for (int i = 0; i <= kGridSamples; ++i) {
        across.push_back(manifold.sphere_point(std::numbers::pi * k / kGridLines,
                                               std::numbers::pi * i / kGridSamples));
        if (k <= kGridLines)
          along.push_back(manifold.sphere_point(2 * std::numbers::pi * i / kGridSamples,
                                                std::numbers::pi * k / kGridLines));
      }
      grid.push_back(across);
      if (k <= kGridLines) grid.push_back(along);
    }
    add_sphere_lines(renderer, frame, grid, mix(kInk, kWhite, 0.35), 0.6 * look.line, 1.002);
  }
  add_sphere_lines(renderer, frame, boundary_pieces(directions, false), kInk, 1.3 * look.line);
  add_sphere_lines(renderer, frame, boundary_pieces(directions, true), look.inside ? kGreen : kInk,
                   (look.inside ? 2.6 : 1.3) * look.line);
  for (const auto& s : manifold.singularities())
    for (const double sign : {1.0, -1.0})
      add_ball(renderer, {sign * s.x, sign * s.y, sign * s.z}, 0.022, kYellow);
}

void aim_at_sphere(vtkRenderer& renderer, const SphereFrame& frame, double aspect, double share,
                   double rise) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  const auto& [right, up, viewer] = frame;
  camera.ParallelProjectionOn();
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(5 * viewer.x, 5 * viewer.y, 5 * viewer.z);
  camera.SetViewUp(up.x, up.y, up.z);
  camera.SetParallelScale(1 / share / (aspect < 1 ? aspect : 1));
  camera.SetWindowCenter(0, -rise);
  camera.SetClippingRange(1, 9);
}

}  // namespace tensortopo
