// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/tet_surface.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analyze/curvature/surface_curvature.hpp"
#include "render/scene/texture.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo {
namespace {

// Denser samples than an extraction's default, until there are so many triangles: there is one
// tetrahedron to be drawn.
constexpr double kFirstResolution = 14, kLastResolution = 900;
constexpr std::size_t kEnoughTriangles = 1500;

TetMesh one_tet(const TetField& field) {
  TetMesh mesh;
  mesh.points.assign(field.corners.begin(), field.corners.end());
  mesh.tensors.assign(field.tensors.begin(), field.tensors.end());
  mesh.tets = {{0, 1, 2, 3}};
  mesh.cell_ids = {0};
  return mesh;
}

// Six tetrahedra around a diagonal (Kuhn).
TetMesh cube_around(const TetField& field, double beyond) {
  constexpr double huge = std::numeric_limits<double>::max();
  Vector3<double> low{huge, huge, huge}, high = -low;
  for (const auto& p : field.corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector3<double> middle = 0.5 * (low + high), extent = high - low;
  const double half = beyond / 2 * std::max({extent.x, extent.y, extent.z});
  TetMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3<double> p{middle.x + (corner & 1 ? half : -half),
                            middle.y + (corner & 2 ? half : -half),
                            middle.z + (corner & 4 ? half : -half)};
    mesh.points.push_back(p);
    mesh.tensors.push_back(field.at(p));
  }
  std::array<int, 3> axes{0, 1, 2};
  do {
    const int a = 1 << axes[0], b = a | 1 << axes[1];
    const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
    mesh.tets.push_back(even ? std::array{0, a, b, 7} : std::array{0, b, a, 7});
    mesh.cell_ids.push_back(static_cast<std::int64_t>(mesh.tets.size()) - 1);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return mesh;
}

Extraction finely_extracted(const TetMesh& mesh, const ModeValue& mode) {
  ExtractOptions options;
  options.sampling.resolution = kFirstResolution;
  for (;;) {
    Extraction extraction = extract_mode_surface<double>(mesh, mode, options);
    const std::size_t triangles = extraction.surface.triangles.size();
    options.sampling.resolution *= 2;
    if (triangles == 0 || triangles >= kEnoughTriangles ||
        options.sampling.resolution > kLastResolution)
      return extraction;
  }
}

void add_points(vtkPolyData& shape, const std::vector<Vector3<double>>& points) {
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const auto& p : points) places->InsertNextPoint(p.x, p.y, p.z);
  shape.SetPoints(places);
}

}  // namespace

TetSurface tet_surface(const TetField& field, const ModeValue& mode, double beyond) {
  TetSurface result;
  result.mesh = beyond > 1 ? cube_around(field, beyond) : one_tet(field);
  ExtractOptions options;
  options.sampling.resolution = kFirstResolution;
  const bool degenerate = std::abs(mode.approx()) == 1;
  if (!degenerate) {
    std::vector<ModeValue> both{mode.sign() < 0 ? mode.opposite() : mode};
    if (mode.sign() != 0) both.push_back(both[0].opposite());
    for (const ModeValue& one : both) {
      Extraction extraction = finely_extracted(result.mesh, one);
      result.surfaces.push_back(std::move(extraction.surface));
      for (const auto& cell : extraction.unresolved)
        result.notes.push_back(fmt::format("mode {}: part {} of the picture is left out ({})",
                                           one.text(), cell.tet, name_of(cell.reason)));
    }
  }
  for (const Degeneracy kind : {Degeneracy::linear, Degeneracy::planar}) {
    CurveExtraction extraction = extract_degenerate_curves(result.mesh, kind, options);
    result.curves.push_back(std::move(extraction.curves));
    for (const auto& cell : extraction.unresolved)
      result.notes.push_back(
          fmt::format("degenerate curves: part {} of the picture is left out "
                      "({})",
                      cell.tet, name_of(cell.obstacle)));
  }
  return result;
}

LineField surface_lines(const SurfaceMesh& surface, const TetMesh& mesh, Texture texture,
                        bool recover) {
  LineField lines;
  if (texture == Texture::none) return lines;
  if (texture == Texture::dominant) {
    for (const auto& d : surface.dominant_eigenvector) lines.push_back(dyad(d));
    return lines;
  }
  const double sign = texture == Texture::major ? 1 : -1;
  const auto curvatures =
      recover ? recovered_curvature(surface, mesh) : surface_curvature(surface, mesh).vertices;
  for (const auto& curvature : curvatures)
    lines.push_back(curvature ? sign * curvature->tensor : SymmetricTensor<double>{});
  return lines;
}

Sheet sheet_of(const SurfaceMesh& surface, double mode, const LineField& lines) {
  const auto shape = vtkSmartPointer<vtkPolyData>::New();
  add_points(*shape, surface.points);
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : surface.triangles) {
    const vtkIdType ids[3]{t[0], t[1], t[2]};
    triangles->InsertNextCell(3, ids);
  }
  shape->SetPolys(triangles);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const auto& n : surface.normal) normals->InsertNextTuple3(n.x, n.y, n.z);
  shape->GetPointData()->SetNormals(normals);
  if (!lines.empty()) set_line_field(*shape, lines);
  return {mode, shape};
}

Sheet sheet_of(const CurveMesh& curves, double mode) {
  const auto shape = vtkSmartPointer<vtkPolyData>::New();
  add_points(*shape, curves.points);
  vtkNew<vtkCellArray> lines;
  for (const auto& line : curves.lines) {
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (const auto v : line) lines->InsertCellPoint(v);
  }
  shape->SetLines(lines);
  return {mode, shape};
}

std::vector<std::optional<std::array<Vector3<double>, 3>>> triangles_on_sphere(
    const SurfaceMesh& surface, const TetDirections& directions) {
  constexpr double kTorn = 0.5;  // cosine
  const bool neutral = directions.manifold().mode().sign == 0;
  std::vector<std::optional<std::array<Vector3<double>, 3>>> result;
  for (const auto& t : surface.triangles) {
    // Sigma tells which of +-v it is, best where it is farthest from 0: that corner leads.
    std::array<Vector3<double>, 3> v;
    std::size_t leader = 0;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = surface.medium_eigenvector[as_size(t[k])];
      if (neutral) continue;
      const auto& d = surface.dominant_eigenvector[as_size(t[k])];
      const double sigma = directions.manifold().sigma(v[k], d);
      v[k] = directions.canonical(v[k], d);
      if (std::abs(sigma) > most) most = std::abs(sigma), leader = k;
    }
    bool whole = true;
    for (auto& corner : v) {
      if (dot(corner, v[leader]) < 0) corner = -corner;
      whole = whole && dot(corner, v[leader]) > kTorn;
    }
    result.push_back(whole ? std::optional(v) : std::nullopt);
  }
  return result;
}

}  // namespace tensortopo
