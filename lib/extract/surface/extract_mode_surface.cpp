// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/extract_mode_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/assemble.hpp"
#include "extract/surface/boundary/find_crossings.hpp"
#include "extract/surface/boundary/trace_faces.hpp"
#include "extract/surface/cells/coarsen_face_curves.hpp"
#include "extract/surface/renumber_extraction.hpp"

namespace tensortopo {

namespace {

/// Where the level runs through a vertex, samples of its edges fall together there, and a sheet
/// that is a cylinder around the vertex by the rule mu + 0 cannot be told from a cone. Around such
/// vertices a level next to mu is extracted instead, which keeps off them.
/// @return whether there is such a vertex
template <class Scalar>
bool keep_off_pinched(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                      const CellMeshes<Scalar>& meshes, VertexSides& sides) {
  bool any = false;
  for (std::size_t t = 0; t < meshes.cells.size(); ++t) {
    if (meshes.cells[t].unresolved != UnresolvedReason::inconsistent_samples) continue;
    for (const auto v : input.vertices_of(cells, t)) {
      auto& on_level = sides.on_level[as_size(v)];
      if (on_level != OnLevel::meshed_through) continue;
      on_level = OnLevel::kept_off;
      any = true;
    }
  }
  return any;
}

/// Samples that are there only to leave no defects can be too close to each other for a tetrahedron
/// to be meshed with them. Around such a tetrahedron triangles stay as they are meshed first.
/// @return whether there is one
template <class Scalar>
bool keep_as_meshed(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                    const CellMeshes<Scalar>& meshes, VertexSides& sides) {
  std::vector<char> at_mended(sides.as_meshed.size(), 0);
  for (std::size_t t = 0; t < meshes.cells.size(); ++t)
    if (meshes.cells[t].was_mended)
      for (const auto v : input.vertices_of(cells, t)) at_mended[as_size(v)] = 1;
  std::vector<TetMesh::Index> found;
  for (std::size_t t = 0; t < meshes.cells.size(); ++t) {
    if (meshes.cells[t].unresolved != UnresolvedReason::inconsistent_samples) continue;
    const auto& vertices = input.vertices_of(cells, t);
    const auto is_open = [&](auto v) {
      return at_mended[as_size(v)] && !sides.as_meshed[as_size(v)];
    };
    if (std::any_of(vertices.begin(), vertices.end(), is_open))
      found.insert(found.end(), vertices.begin(), vertices.end());
  }
  for (const auto v : found) sides.as_meshed[as_size(v)] = 1;
  return !found.empty();
}

/// The options, with what they say of single tetrahedra in the order of these.
ExtractOptions in_canonical_order(const ExtractOptions& options, const CanonicalMesh& canonical) {
  ExtractOptions result = options;
  for (std::size_t t = 0; t < result.density.size(); ++t)
    result.density[t] = options.density[as_size(canonical.tets[t])];
  return result;
}

/// @param last_use  the field again if nobody reads it afterwards
template <class Scalar>
Extraction extract(const PreparedField<Scalar>& prepared, const ModeValue& mu,
                   const ExtractOptions& given_options, PreparedField<Scalar>* last_use) {
  if (std::abs(mu.approx()) >= 1)
    throw std::invalid_argument("mode surfaces exist for |mode| < 1, not for " + mu.text());
  const auto level = make_level<Scalar>(mu);
  NearbyLevels<Scalar> nearby_levels(mu);
  const CanonicalMesh& canonical = *prepared.canonical;
  const ExtractOptions options = in_canonical_order(given_options, canonical);
  const SurfaceInput<Scalar> input{canonical.mesh, prepared, prepared.field,
                                   options,        level,    nearby_levels};
  Stopwatch watch;
  double seconds_edges = 0, seconds_faces = 0, seconds_tets = 0;
  VertexSides sides = classify_vertices(input);
  ActiveCells active = active_cells(input, sides);
  if (last_use != nullptr) release(last_use->lode_ranges, last_use->lode_angles);
  const TetComplex& cells = active.complex;
  for (;;) {
    auto crossings = find_crossings(input, sides, cells);
    seconds_edges += watch.lap();
    auto boundary = trace_faces(input, sides, cells, std::move(crossings));
    seconds_faces += watch.lap();
    auto proofs = prove_cells(input, sides, cells, boundary);
    auto meshes = mesh_cells(input, sides, cells, std::move(boundary), proofs);
    seconds_tets += watch.lap();
    if (keep_off_pinched(input, cells, meshes, sides) ||
        keep_as_meshed(input, cells, meshes, sides))
      continue;
    // What meshing needed is half of all that a tetrahedron holds; only proofs ask for it later.
    if (!options.keep_topology)
      for (auto& proof : proofs) proof.topology.reset();
    if (!options.keep_samples) coarsen_face_curves<Scalar>(input, sides, cells, proofs, meshes);
    seconds_tets += watch.lap();
    Extraction result =
        assemble(input, sides, std::move(active), std::move(proofs), std::move(meshes));
    renumber(result, canonical.vertices, canonical.tets);
    auto& statistics = result.statistics;
    statistics.vertices_on_level = sides.count_on_level;
    statistics.seconds_edges = seconds_edges;
    statistics.seconds_faces = seconds_faces;
    statistics.seconds_tets = seconds_tets;
    statistics.seconds_stitch = watch.lap();
    return result;
  }
}

}  // namespace

template <class Scalar>
Extraction extract_mode_surface(const PreparedField<Scalar>& field, const ModeValue& mu,
                                const ExtractOptions& options) {
  return extract<Scalar>(field, mu, options, nullptr);
}

template <class Scalar>
Extraction extract_mode_surface(PreparedField<Scalar>&& field, const ModeValue& mu,
                                const ExtractOptions& options) {
  return extract<Scalar>(field, mu, options, &field);
}

template <class Scalar>
Extraction extract_mode_surface(const TetMesh& mesh, const ModeValue& mu,
                                const ExtractOptions& options) {
  PreparedField<Scalar> field(mesh, PreparedField<Scalar>::Use::one_mode);
  return extract_mode_surface(std::move(field), mu, options);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                             \
  template Extraction extract_mode_surface<Scalar>(const TetMesh&, const ModeValue&,               \
                                                   const ExtractOptions&);                         \
  template Extraction extract_mode_surface<Scalar>(const PreparedField<Scalar>&, const ModeValue&, \
                                                   const ExtractOptions&);                         \
  template Extraction extract_mode_surface<Scalar>(PreparedField<Scalar>&&, const ModeValue&,      \
                                                   const ExtractOptions&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
