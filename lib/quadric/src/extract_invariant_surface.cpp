// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/quadric/extract_invariant_surface.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "assemble_invariant_surface.hpp"
#include "cell_subdivision.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"
#include "vertex_fans.hpp"

namespace tensortopo {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The vertices in ascending order, and whether that is an even permutation.
std::pair<std::array<TetMesh::Index, 4>, bool> sorted(std::array<TetMesh::Index, 4> v) {
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) even ^= v[i] > v[j];
  std::sort(v.begin(), v.end());
  return {v, even};
}

/// Vertices whose tensor is exactly on the level.
std::size_t count_on_level(const TetMesh& mesh, const InvariantLevel& level) {
  const int nappe = level.invariant() == Invariant::anisotropy ? 1 : 0;
  const ConvexLevel body(level, nappe);
  std::atomic<std::size_t> count{0};
  const tbb::blocked_range<std::size_t> vertices(0, mesh.tensors.size(), 1024);
  tbb::parallel_for(vertices, [&](const auto& r) {
    const FloatingPointEnvironment environment;
    for (std::size_t v = r.begin(); v != r.end(); ++v) {
      const auto* t = &mesh.tensors[v];
      if (CellForm(body, {t, t, t, t}).is_on_level({1, 0, 0, 0})) ++count;
    }
  });
  return count;
}

}  // namespace

InvariantExtraction extract_invariant_surface(const TetMesh& mesh, const InvariantLevel& level,
                                              const InvariantOptions& options) {
  if (options.pieces < 1 || options.pieces > 256)
    throw std::invalid_argument("extract_invariant_surface: pieces must be in [1, 256]");
  InvariantExtraction result;
  auto start = std::chrono::steady_clock::now();
  std::vector<ConvexLevel> bodies;
  if (level.invariant() == Invariant::anisotropy) {
    bodies = {ConvexLevel(level, 1), ConvexLevel(level, -1)};
  } else {
    bodies = {ConvexLevel(level, 0)};
  }
  const std::size_t count = mesh.tets.size() * bodies.size();
  std::vector<CellLevel> cells(count);
  std::atomic<std::size_t> done{0};
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const auto [nodes, is_even] = sorted(mesh.tets[i / bodies.size()]);
      cells[i] = level_in_cell(bodies[i % bodies.size()], level.invariant(), mesh, nodes, is_even,
                               options.pieces);
    }
    if (!options.progress) return;
    done += range.size();
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock)
      options.progress("tetrahedra", static_cast<double>(done) / static_cast<double>(count));
  });
  std::vector<TetMesh::Index> tets(count);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    bool zero = false, crossed = false, refined = false;
    for (std::size_t i = t * bodies.size(); i < (t + 1) * bodies.size(); ++i) {
      tets[i] = static_cast<TetMesh::Index>(t);
      zero |= cells[i].meets_zero;
      crossed |= !cells[i].triangles.empty();
      refined |= cells[i].met_inside;
      result.statistics.signs_exact += cells[i].exact_answers;
    }
    if (zero) {
      // Of both nappes: what is left out is whole tetrahedra.
      for (std::size_t i = t * bodies.size(); i < (t + 1) * bodies.size(); ++i) cells[i] = {};
      result.zero_tensor.push_back(static_cast<TetMesh::Index>(t));
    } else {
      result.statistics.tets_crossed += crossed;
      result.statistics.tets_refined += refined;
    }
  }
  result.statistics.vertices_on_level = count_on_level(mesh, level);
  result.statistics.seconds_tets = seconds_since(start);
  start = std::chrono::steady_clock::now();
  result.surface = assemble_invariant_surface(cells, tets, level.approx());
  if (!surface_invariants(result.surface).manifold) {
    result.copies = separate_fans(result.surface);
    result.surface.component = surface_components(result.surface);
  }
  add_normals(cells, result.surface);
  result.statistics.seconds_stitch = seconds_since(start);
  return result;
}

}  // namespace tensortopo
