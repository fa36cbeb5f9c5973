// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/methods.hpp"

#include <algorithm>
#include <utility>

#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo {
namespace {

PreparedField<double> prepared(const TetMesh& mesh, std::span<const ModeValue> modes) {
  using Use = PreparedField<double>::Use;
  return PreparedField<double>(mesh, modes.size() > 1 ? Use::several_modes : Use::one_mode);
}

}  // namespace

std::vector<ModeValue> with_opposites(std::span<const ModeValue> modes) {
  std::vector<ModeValue> all;
  for (const ModeValue& mode : modes)
    for (const ModeValue& either : {mode, mode.opposite()})
      if (std::find(all.begin(), all.end(), either) == all.end()) all.push_back(either);
  return all;
}

std::vector<double> approximations(std::span<const ModeValue> modes) {
  std::vector<double> values;
  for (const ModeValue& mode : modes) values.push_back(mode.approx());
  return values;
}

std::vector<SurfaceMesh> our_surfaces(const TetMesh& mesh, std::span<const ModeValue> modes,
                                      double resolution, std::map<std::string, double>* stages,
                                      MeshingMethod drawing) {
  std::vector<SurfaceMesh> surfaces;
  if (stages != nullptr) stages->clear();
  auto field = prepared(mesh, modes);
  ExtractOptions options;
  options.sampling.resolution = resolution;
  options.meshing = drawing;
  for (const ModeValue& mode : modes) {
    Extraction extraction = &mode != &modes.back()
                                ? extract_mode_surface(field, mode, options)
                                : extract_mode_surface(std::move(field), mode, options);
    surfaces.push_back(std::move(extraction.surface));
    if (stages == nullptr) continue;
    (*stages)["edges"] += extraction.statistics.seconds_edges;
    (*stages)["faces"] += extraction.statistics.seconds_faces;
    (*stages)["tets"] += extraction.statistics.seconds_tets;
    (*stages)["stitch"] += extraction.statistics.seconds_stitch;
  }
  return surfaces;
}

std::size_t certify_all(const TetMesh& mesh, std::span<const ModeValue> modes, double resolution) {
  std::size_t triangles = 0;
  const auto field = prepared(mesh, modes);
  ExtractOptions options;
  options.sampling.resolution = resolution;
  options.keep_topology = true;
  for (const ModeValue& mode : modes) {
    Extraction extraction = extract_mode_surface(field, mode, options);
    triangles += certify(mesh, mode, extraction).triangles;
  }
  return triangles;
}

std::vector<SurfaceMesh> baseline_surfaces(Baseline method, const TetMesh& mesh,
                                           std::span<const ModeValue> modes,
                                           const BaselineOptions& options) {
  std::vector<SurfaceMesh> surfaces;
  for (const ModeValue& mode : modes)
    surfaces.push_back(baseline_surface(method, mesh, mode, options));
  return surfaces;
}

std::size_t triangles_of(std::span<const SurfaceMesh> surfaces) {
  std::size_t triangles = 0;
  for (const SurfaceMesh& surface : surfaces) triangles += surface.triangles.size();
  return triangles;
}

}  // namespace tensortopo
