// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/extract_mode_surface.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/surface/assemble.hpp"
#include "extract/surface/boundary/active_cells.hpp"
#include "extract/surface/cells/coarsen_face_curves.hpp"
#include "extract/surface/mesh_around.hpp"
#include "extract/surface/mesh_level.hpp"
#include "extract/surface/renumber_extraction.hpp"

namespace tensortopo {

namespace {

/// The options, with what they say of single tetrahedra in the order of these.
ExtractOptions in_canonical_order(const ExtractOptions& options, const CanonicalMesh& canonical) {
  ExtractOptions result = options;
  for (std::size_t t = 0; t < result.density.size(); ++t)
    result.density[t] = options.density[as_size(canonical.tets[t])];
  for (std::size_t t = 0; t < result.part.size(); ++t)
    result.part[t] = options.part[as_size(canonical.tets[t])];
  return result;
}

/// The stages from the edges to the triangles, and again around vertices where tetrahedra are meshed
/// otherwise.
template <class Scalar>
MeshedLevel<Scalar> mesh_with_passes(const SurfaceInput<Scalar>& input, VertexSides& sides,
                                        const TetComplex& cells, StageSeconds& seconds) {
  MeshedLevel<Scalar> level = mesh_level(input, sides, cells, seconds);
  for (;;) {
    auto changed = keep_off_pinched(input, cells, level.meshes, sides);
    if (changed.empty()) changed = keep_as_meshed(input, cells, level.meshes, sides);
    if (changed.empty()) return level;
    mesh_around(input, sides, cells, changed, level, seconds);
  }
}

/// @param last_use  the field again if nobody reads it afterwards
template <class Scalar>
Extraction extract(const PreparedField<Scalar>& prepared, const ModeValue& mu,
                   const ExtractOptions& given_options, PreparedField<Scalar>* last_use) {
  if (std::abs(mu.approx()) >= 1)
    throw std::invalid_argument(
        "mode surfaces exist for |mode| < 1, and are computed where a "
        "double tells it from 1, not for " +
        mu.text());
  require_fitting(given_options, prepared.canonical->mesh.tets.size());
  const auto level = make_level<Scalar>(mu);
  NearbyLevels<Scalar> nearby_levels(mu);
  const CanonicalMesh& canonical = *prepared.canonical;
  const ExtractOptions options = in_canonical_order(given_options, canonical);
  const SurfaceInput<Scalar> input{canonical.mesh, prepared, prepared.field,
                                   options,        level,    nearby_levels};
  Stopwatch watch;
  StageSeconds seconds;
  VertexSides sides = classify_vertices(input);
  ActiveCells active = active_cells(input, sides);
  if (last_use != nullptr) release(last_use->lode_ranges, last_use->lode_angles);
  const TetComplex& cells = active.complex;
  seconds.edges += watch.lap();
  auto [proofs, meshes] = mesh_with_passes(input, sides, cells, seconds);
  watch.lap();
  // What meshing needed is half of all that a tetrahedron holds; only proofs ask for it later.
  if (!options.keep_topology)
    parallel_stage(options, "tetrahedra", proofs.size(), 1024,
                   [&](std::size_t t) { proofs[t].topology.reset(); });
  if (!options.keep_samples) coarsen_face_curves<Scalar>(input, sides, cells, proofs, meshes);
  seconds.tets += watch.lap();
  auto messages = std::move(meshes.messages);
  for (MeshingMessage& message : messages) {
    message.from = cells.tets[as_size(message.from)];
    message.to = cells.tets[as_size(message.to)];
  }
  Extraction result =
      assemble(input, sides, std::move(active), std::move(proofs), std::move(meshes));
  result.messages = std::move(messages);
  renumber(result, canonical.vertices, canonical.tets);
  auto& statistics = result.statistics;
  statistics.vertices_on_level = sides.count_on_level;
  statistics.seconds_edges = seconds.edges;
  statistics.seconds_faces = seconds.faces;
  statistics.seconds_tets = seconds.tets;
  statistics.seconds_stitch = watch.lap();
  return result;
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
