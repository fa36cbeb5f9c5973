// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/extract_within.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "distances/coarse_tets.hpp"

namespace tensortopo {

namespace {

/// A tetrahedron is given up after so many doublings in a row without much effect.
constexpr int kPatience = 2;
constexpr double kEffect = 0.8;
/// Or when it has more triangles than this, some four times as many at most: one more doubling would
/// take as long as all the others did.
constexpr int kMostTriangles = 5000;
/// As long as it has fewer triangles, and gets more, denser samples count as an effect: sampling
/// may have begun too coarsely.
constexpr int kFewTriangles = 500;
/// Or when so many samples were asked for, of which few were of use.
constexpr float kDensest = 0x1p20F;

/// Below this no distance is proved in a tetrahedron, as coordinates are rounded.
double least_distance(const TetMesh& mesh, std::size_t tet) {
  double largest = 0, longest = 0;
  for (const auto v : mesh.tets[tet]) {
    const auto& p = mesh.points[as_size(v)];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    for (const auto w : mesh.tets[tet])
      longest = std::max(longest, length(mesh.points[as_size(w)] - p));
  }
  return 0x1p-48 * (largest + longest);
}

/// For each tetrahedron the bound on its distances, 0 where nothing is claimed or there.
std::vector<double> distance_bounds(const TetMesh& mesh, const SurfaceMesh& surface,
                                    const CertifiedLevel& level) {
  const auto& claim = level.distance;
  std::vector<double> bounds(mesh.tets.size(), 0);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    double& bound = bounds[as_size(surface.tet[i])];
    for (const auto v : surface.triangles[i])
      bound = std::max(bound, (1 + 0x1p-20) * reach_length(claim.reach[as_size(v)]));
  }
  for (std::size_t i = 0; i < claim.coarse.size(); ++i)
    bounds[as_size(claim.coarse[i])] = claim.coarse_bounds[i];
  for (const auto& cell : level.undecided) bounds[as_size(cell.tet)] = 0;
  return bounds;
}

}  // namespace

ExtractionWithin extract_within(const TetMesh& mesh, const ModeValue& mode,
                                double largest_distance, const ExtractOptions& options) {
  if (!(largest_distance > 0)) throw std::invalid_argument("the distance must be positive");
  ExtractOptions current = options;
  current.keep_topology = true;
  if (current.density.empty()) current.density.assign(mesh.tets.size(), 1);
  const PreparedField<double> field(mesh);
  ExtractionWithin result;
  LevelTopology topology;  // of the extraction, which gives its own to the certificate
  std::vector<double> best(mesh.tets.size(), std::numeric_limits<double>::infinity());
  std::vector<int> without_effect(mesh.tets.size(), 0), triangles_before(mesh.tets.size(), 0);
  for (bool is_denser = true; is_denser;) {
    result.extraction = extract_mode_surface(field, mode, current);
    topology = result.extraction.topology;
    result.level = certify(field, mode, result.extraction, largest_distance);
    ++result.rounds;
    const auto bounds = distance_bounds(mesh, result.extraction.surface, result.level);
    std::vector<int> triangles(mesh.tets.size(), 0);
    for (const auto t : result.extraction.surface.tet) ++triangles[as_size(t)];
    result.farther.clear();
    is_denser = false;
    for (std::size_t t = 0; t < bounds.size(); ++t) {
      if (bounds[t] <= largest_distance) continue;
      result.farther.push_back(static_cast<TetMesh::Index>(t));
      const bool has_grown = triangles[t] <= kFewTriangles && triangles[t] > triangles_before[t];
      const bool has_effect = bounds[t] < kEffect * best[t] || has_grown;
      without_effect[t] = has_effect ? 0 : without_effect[t] + 1;
      best[t] = std::min(best[t], bounds[t]);
      triangles_before[t] = triangles[t];
      if (without_effect[t] > kPatience || triangles[t] > kMostTriangles ||
          current.density[t] >= kDensest || largest_distance < least_distance(mesh, t))
        continue;
      current.density[t] *= 2;
      is_denser = true;
    }
  }
  // What is asked for is too small to be proved by parts: a bound that is not.
  const double provable = 1.01 * detail::kSmallestShare * result.level.distance.coarse_bound;
  if (largest_distance < provable) {
    result.extraction.topology = topology;
    result.level = certify(field, mode, result.extraction, provable);
  }
  if (options.keep_topology) result.extraction.topology = std::move(topology);
  return result;
}

}  // namespace tensortopo
