// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include "claims/claims.hpp"
#include "claims/crossed_part.hpp"
#include "claims/crossing_brackets.hpp"
#include "distances/distance_proof.hpp"
#include "distances/isotopic_tets.hpp"
#include "extract/level/level.hpp"
#include "extract/surface/renumber_extraction.hpp"
#include "run/for_each.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/embedded.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

Brackets brackets_of(const LevelTopology& topology, const ScaledField<double>& field,
                     const Level<double>& level) {
  Brackets brackets(topology.edges.size());
  detail::for_each(brackets.size(), [&](std::size_t e) {
    brackets[e] = crossing_brackets(topology.edges[e], field, level);
  });
  return brackets;
}

/// The claims in the mesh's own numbers. Brackets of an edge that is reversed are mirrored, which
/// is exact.
void renumber(CertifiedLevel& claims, Extraction& extraction, std::span<const Index> vertices,
              std::span<const Index> tets) {
  std::swap(claims.topology, extraction.topology);
  const auto moved = renumber(extraction, vertices, tets);
  std::swap(claims.topology, extraction.topology);
  std::vector<std::vector<DyadicBracket>> brackets(moved.size());
  for (std::size_t e = 0; e < moved.size(); ++e) {
    brackets[e] = std::move(claims.brackets[moved[e].from]);
    if (!moved[e].is_reversed) continue;
    std::reverse(brackets[e].begin(), brackets[e].end());
    for (DyadicBracket& b : brackets[e]) b.place = (std::uint64_t{1} << b.depth) - 1 - b.place;
  }
  claims.brackets = std::move(brackets);
  for (auto& cell : claims.undecided) cell.tet = tets[as_size(cell.tet)];
  std::sort(claims.undecided.begin(), claims.undecided.end(),
            [](const auto& p, const auto& q) { return p.tet < q.tet; });
  auto& distance = claims.distance;
  std::map<Index, double> bounds;
  for (std::size_t i = 0; i < distance.coarse.size(); ++i)
    bounds.emplace(tets[as_size(distance.coarse[i])], distance.coarse_bounds[i]);
  distance.coarse.clear();
  distance.coarse_bounds.clear();
  for (const auto& [tet, bound] : bounds) {
    distance.coarse.push_back(tet);
    distance.coarse_bounds.push_back(bound);
  }
  if (claims.not_isotopic) {
    for (Index& t : *claims.not_isotopic) t = tets[as_size(t)];
    std::sort(claims.not_isotopic->begin(), claims.not_isotopic->end());
  }
}

/// @param extraction  in the numbers of the field's mesh
CertifiedLevel certify_in_order(const ScaledField<double>& field, const ModeValue& mode,
                                Extraction& extraction, double wanted) {
  const TetMesh& mesh = *field.mesh;
  const SurfaceMesh& surface = extraction.surface;
  const auto level = make_level<double>(mode);
  CertifiedLevel result;
  result.value = mode;
  result.vertices = surface.points.size();
  result.triangles = surface.triangles.size();
  result.on_level = extraction.statistics.vertices_on_level;
  result.topology = std::move(extraction.topology);

  for (const auto& cell : extraction.unresolved)
    result.undecided.push_back({cell.tet, std::string(name_of(cell.reason))});
  drop_cells(mesh, result, brackets_of(result.topology, field, level),
             [](Index) { return std::string(); });
  result.components = components_of(surface);
  result.embedded = is_embedded(surface);
  const auto decided = decided_triangles(mesh, surface, result);
  result.distance = prove_distance(mesh, surface, decided, result.topology, field, level, wanted);
  if (result.embedded)
    result.not_isotopic =
        tets_not_isotopic(mesh, surface, decided, result.topology, result.distance.coarse,
                          moved_places(mesh, surface, result.distance.reach, field, level));
  return result;
}

/// Throws std::invalid_argument for a surface without what was proved of it.
void require_topology(const Extraction& extraction) {
  const LevelTopology& known = extraction.topology;
  if (!extraction.surface.triangles.empty() && known.edges.empty() && known.tets.empty() &&
      known.cones.empty())
    throw std::invalid_argument(
        "the extraction has no topology to certify: make it with keep_topology, and certify it "
        "once");
}

}  // namespace

CertifiedLevel certify(const PreparedField<double>& field, const ModeValue& mode,
                       Extraction& extraction, double wanted) {
  require_topology(extraction);
  const CanonicalMesh& canonical = *field.canonical;
  renumber(extraction, inverse_permutation(canonical.vertices),
           inverse_permutation(canonical.tets));
  CertifiedLevel result = certify_in_order(field.field, mode, extraction, wanted);
  renumber(result, extraction, canonical.vertices, canonical.tets);
  return result;
}

CertifiedLevel certify(const TetMesh& mesh, const ModeValue& mode, Extraction& extraction) {
  require_topology(extraction);
  const CrossedPart part = crossed_part(mesh, extraction);
  renumber(extraction, inverse_numbers(part.vertices, mesh.points.size()),
           inverse_numbers(part.tets, mesh.tets.size()));
  const PreparedField<double> field(part.mesh, PreparedField<double>::Use::one_mode);
  CertifiedLevel result = certify(field, mode, extraction);
  renumber(result, extraction, part.vertices, part.tets);
  return result;
}

}  // namespace tensortopo
