// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/surface/surface_command.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "analyze/analyzed_mesh.hpp"
#include "analyze/poly_data_output.hpp"
#include "origin_notes.hpp"
#include "render/input/surface_input.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {
namespace {

using Curvatures = std::vector<std::optional<LevelCurvature<double>>>;

Quantiles quantiles_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {quantile(0), quantile(0.05), quantile(0.5), quantile(0.95), quantile(1)};
}

std::array<Quantiles, 2> strengths_of(const RidgeLines& ridges) {
  std::array<std::vector<double>, 2> values;
  for (const auto& line : ridges.lines)
    values[static_cast<std::size_t>(line.kind)].push_back(line.strength);
  return {quantiles_of(std::move(values[0])), quantiles_of(std::move(values[1]))};
}

CurvatureReport report_of(const SurfaceMesh& surface, const Curvatures& curvatures) {
  CurvatureReport report;
  std::array<std::vector<double>, 4> values;
  for (const auto& c : curvatures) {
    if (!c) continue;
    ++report.vertices;
    values[0].push_back(c->principal[0]);
    values[1].push_back(c->principal[1]);
    values[2].push_back(c->mean());
    values[3].push_back(c->gauss());
  }
  report.first = quantiles_of(values[0]);
  report.second = quantiles_of(values[1]);
  report.mean = quantiles_of(values[2]);
  report.gauss = quantiles_of(values[3]);
  for (const auto& t : surface.triangles) {
    const auto &p = surface.points[as_size(t[0])], &q = surface.points[as_size(t[1])],
               &r = surface.points[as_size(t[2])];
    const Vector3<double> normal = cross(q - p, r - p);
    for (const auto v : t)
      if (curvatures[as_size(v)])
        report.total_gauss += length(normal) / 6 * curvatures[as_size(v)]->gauss();
  }
  return report;
}

/// The normals of the triangles around each vertex, by area, if the file has none.
std::vector<Vector3<double>> normals_of(const SurfaceMesh& surface) {
  std::vector<Vector3<double>> normals(surface.points.size());
  for (const auto& t : surface.triangles) {
    const Vector3<double> normal =
        cross(surface.points[as_size(t[1])] - surface.points[as_size(t[0])],
              surface.points[as_size(t[2])] - surface.points[as_size(t[0])]);
    for (const auto v : t) normals[as_size(v)] += normal;
  }
  return normals;
}

void add_curvature(vtkPolyData& data, const std::string& prefix, const Curvatures& curvatures) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto add = [&](const std::string& name, int components, const auto& value) {
    add_array(data, prefix + name, components, curvatures.size(), [&](std::size_t i) {
      return curvatures[i] ? std::array<double, 3>(value(*curvatures[i]))
                           : std::array{kNone, kNone, kNone};
    });
  };
  using Curvature = LevelCurvature<double>;
  add("principal_curvatures", 2, [](const Curvature& c) {
    return std::array{c.principal[0], c.principal[1], 0.0};
  });
  for (const std::size_t k : {0u, 1u})
    add("principal_direction_" + std::to_string(k + 1), 3, [&](const Curvature& c) {
      const auto& d = c.directions[k];
      return std::array{d.x, d.y, d.z};
    });
  add("mean_curvature", 1, [](const Curvature& c) { return std::array{c.mean(), 0.0, 0.0}; });
  add("gauss_curvature", 1, [](const Curvature& c) { return std::array{c.gauss(), 0.0, 0.0}; });
}

std::vector<FileNote> notes_of_ridges(const SurfaceCommand& command, const ReadResult& read) {
  AnalyzedMesh mesh;
  mesh.provenance = command.provenance;
  mesh.sha256 = read.sha256;
  mesh.tensor_name = read.report.tensor_name;
  mesh.components = read.report.components;
  return origin_notes(mesh);
}

void require_sense(const SurfaceCommand& command) {
  if (command.smooth) require_jets();
  for (const auto& file : {command.output, command.ridges})
    if (!file.empty() && lower_extension(file) != ".vtp")
      throw UsageError(file.string() + ": the name must end in .vtp");
  if ((!command.ridges.empty() || command.recover) && command.mesh.empty())
    throw UsageError("--ridges and --recover need the field's derivatives (--mesh)");
  if (!command.ridges.empty() && command.ridges == command.output)
    throw UsageError("--ridges and -o: the same file");
  const RidgeFilter& filter = command.ridge_filter;
  for (const double least : {filter.least_strength, filter.least_length})
    if (!(std::isfinite(least) && least >= 0))
      throw UsageError("--ridge-strength, --ridge-length: must be a number, not negative");
  if (command.ridges.empty() && (filter.least_strength > 0 || filter.least_length > 0))
    throw UsageError("--ridge-strength and --ridge-length go with --ridges");
  if (command.output.empty()) return;
  if (command.mesh.empty() && !command.smooth)
    throw UsageError("-o: nothing to write without --mesh or --smooth");
}

}  // namespace

SurfaceAnalysis run_surface_analysis(const SurfaceCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  require_sense(command);
  for (const auto& file : {command.output, command.ridges})
    if (!file.empty()) require_folder(file);
  const auto tell = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  tell("reading", 0);
  FileGroup files;
  SurfaceInput input = read_surface(command.surface);
  SurfaceMesh& surface = input.surface;
  SurfaceAnalysis analysis;
  analysis.surface = command.surface;
  analysis.triangles = surface.triangles.size();
  analysis.invariants = surface_invariants(surface);
  analysis.vertices = analysis.invariants.vertices;
  const auto of_parts = [&](const std::vector<double>& of_vertices) {
    std::vector<double> numbers(of_vertices.empty() ? 0 : analysis.invariants.parts.size());
    for (std::size_t i = 0; i < surface.triangles.size() && !numbers.empty(); ++i)
      numbers[as_size(analysis.invariants.component[i])] =
          of_vertices[as_size(surface.triangles[i][0])];
    return numbers;
  };
  analysis.part_modes = of_parts(surface.mode);
  analysis.part_values = of_parts(surface.value);
  analysis.quality = triangle_quality(surface);

  Curvatures of_field, of_triangles;
  if (!command.mesh.empty()) {
    tell("curvature", 0.2);
    const ReadResult read = read_mesh(command.mesh, command.read);
    analysis.mesh_notes = read.report.all_notes();
    require_modes(input, command.surface);
    locate_in_mesh(input, read.mesh, {read.sha256, read.report.tensor_name}, command.surface);
    SurfaceCurvature curvature = surface_curvature(surface, read.mesh);
    analysis.curvature = report_of(surface, curvature.vertices);
    analysis.normal_jump = quantiles_of(curvature.normal_jump);
    analysis.umbilics = std::move(curvature.umbilics);
    add_curvature(*input.file, "", curvature.vertices);
    add_array(*input.file, "normal_jump", 1, curvature.normal_jump.size(), [&](std::size_t i) {
      return std::array{curvature.normal_jump[i], 0.0, 0.0};
    });
    of_field = std::move(curvature.vertices);
    Curvatures recovered;
    if (command.recover) {
      tell("recovering", 0.3);
      recovered = recovered_curvature(surface, read.mesh);
      analysis.recovered = report_of(surface, recovered);
      analysis.recovered_umbilics = umbilics_of(surface, at_corners(surface, recovered));
      add_curvature(*input.file, "recovered_", recovered);
    }
    if (!command.ridges.empty()) {
      tell("ridges", 0.4);
      const RidgeLines ridges =
          command.recover ? ridges_of(surface, recovered) : surface_ridges(surface, read.mesh);
      const RidgeLines kept = filtered(ridges, command.ridge_filter);
      write_ridges(kept, command.ridges, notes_of_ridges(command, read));
      analysis.ridges =
          RidgeReport{command.ridges,       command.ridge_filter,   kept.sums,
                      strengths_of(ridges), kept.umbilic_triangles, kept.undefined_triangles};
    }
  }
  if (command.smooth) {
    tell("fitting", 0.5);
    if (surface.normal.empty()) surface.normal = normals_of(surface);
    of_triangles = jet_curvature(surface);
    analysis.smooth = report_of(surface, of_triangles);
    add_curvature(*input.file, "smooth_", of_triangles);
  }
  if (!of_field.empty() && !of_triangles.empty()) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < of_field.size(); ++i)
      if (of_field[i] && of_triangles[i])
        differences.push_back(std::abs(of_field[i]->mean() - of_triangles[i]->mean()));
    analysis.median_difference = quantiles_of(std::move(differences)).median;
  }
  if (!command.against.empty()) {
    tell("distances", 0.7);
    const SurfaceInput other = read_surface(command.against);
    analysis.against = command.against;
    analysis.forth = sampled_distance(surface, other.surface);
    analysis.back = sampled_distance(other.surface, surface);
  }
  if (!command.output.empty()) {
    tell("writing", 0.9);
    write_poly_data(*input.file, command.output, {});
    analysis.output = command.output;
  }
  files.commit();
  analysis.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return analysis;
}

}  // namespace tensortopo
