// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/judge.hpp"

#include <utility>

namespace tensortopo {

Judge::Judge(const TetMesh& mesh, std::span<const ModeValue> modes)
    : mesh_(mesh), modes_(modes.begin(), modes.end()) {
  for (const ModeValue& mode : modes_)
    standards_.push_back(certified_standard(mesh_, mode, kResolution));
}

LevelDistance Judge::distance(std::span<const SurfaceMesh> surfaces, const TetMesh& mesh) const {
  LevelDistance sum;
  for (std::size_t i = 0; i < modes_.size(); ++i)
    sum += level_distance(mesh, surfaces[i], mesh_, standards_[i].surface, modes_[i]);
  return sum;
}

MethodErrors Judge::errors(std::string method, std::string setting,
                           std::span<const SurfaceMesh> surfaces, const TetMesh& mesh) const {
  MethodErrors result;
  result.method = std::move(method);
  result.setting = std::move(setting);
  result.distance = distance(surfaces, mesh);
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    SurfaceMesh triangles;
    triangles.points = surfaces[i].points;
    triangles.triangles = surfaces[i].triangles;
    result.triangles += triangles.triangles.size();
    const SurfaceScore score = score_surface(mesh_, standards_[i], merge_points(triangles));
    result.components += score.matched.size() + score.extra.size();
    result.true_components += score.matched.size() + score.missed.size();
    result.missed += score.missed.size();
    result.extra += score.extra.size();
    result.wrong_topology += score.wrong_topology();
    for (const MatchedComponent& pair : score.matched) {
      result.euler_characteristic += pair.given.euler_characteristic;
      result.true_euler_characteristic += pair.truth.euler_characteristic;
    }
    for (const ScoredComponent& part : score.extra)
      result.euler_characteristic += part.euler_characteristic;
    for (const ScoredComponent& part : score.missed)
      result.true_euler_characteristic += part.euler_characteristic;
    result.true_crossings += score.crossings;
    result.missed_crossings += score.missed_crossings;
    result.extra_crossings += score.extra_crossings;
    result.holes += score.holes;
    result.seam_edges += score.seam_edges;
  }
  return result;
}

std::size_t Judge::undecided() const {
  std::size_t count = 0;
  for (const Standard& standard : standards_) count += standard.level.undecided.size();
  return count;
}

MethodErrors Judge::reference() const {
  std::vector<SurfaceMesh> surfaces;
  for (const Standard& standard : standards_) surfaces.push_back(standard.surface);
  MethodErrors result;
  result.method = "reference";
  result.setting = "resolution 16, certified";
  for (const SurfaceMesh& surface : surfaces) result.triangles += surface.triangles.size();
  result.distance = distance(surfaces);
  return result;
}

}  // namespace tensortopo
