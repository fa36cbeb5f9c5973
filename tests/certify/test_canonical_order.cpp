// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// However a mesh is numbered, what is computed of it is the same, bit for bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "certify_case.hpp"
#include "support/compared.hpp"
#include "support/fields/field_of_any_kind.hpp"
#include "support/fields/renumbered_mesh.hpp"
#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/validate.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <std::size_t Count>
std::array<Index, Count> in_order_of(std::array<Index, Count> simplex,
                                     const std::vector<Index>& vertices) {
  const auto end = std::find(simplex.begin(), simplex.end(), -1);
  for (auto v = simplex.begin(); v != end; ++v) *v = vertices[as_size(*v)];
  std::sort(simplex.begin(), end);
  return simplex;
}

std::vector<Index> mapped(std::vector<Index> cells, const std::vector<Index>& tets) {
  for (Index& t : cells) t = tets[as_size(t)];
  return cells;
}

/// What differs between a surface and that of the mesh in other numbers; "" if nothing does.
std::string difference(const SurfaceMesh& a, const SurfaceMesh& b, const RenumberedMesh& other) {
  if (!same_bits(a.points, b.points)) return "points";
  if (a.triangles != b.triangles) return "triangles";
  if (!same_bits(a.medium_eigenvector, b.medium_eigenvector)) return "medium eigenvectors";
  if (!same_bits(a.dominant_eigenvector, b.dominant_eigenvector)) return "dominant eigenvectors";
  if (!same_bits(a.normal, b.normal)) return "normals";
  if (!same_bits(a.residual, b.residual)) return "residuals";
  if (a.component != b.component) return "components";
  if (a.carrier != b.carrier) return "carriers";
  if (a.tet != mapped(b.tet, other.tets)) return "tetrahedra";
  for (std::size_t v = 0; v < a.points.size(); ++v)
    if (a.carrier_vertices[v] != in_order_of(b.carrier_vertices[v], other.vertices))
      return "carriers' vertices";
  return "";
}

std::string difference(const CurveMesh& a, const CurveMesh& b, const RenumberedMesh& other) {
  if (!same_bits(a.points, b.points)) return "points";
  if (a.lines != b.lines) return "lines";
  if (!same_bits(a.dominant_eigenvector, b.dominant_eigenvector)) return "eigenvectors";
  if (!same_bits(a.separation, b.separation)) return "separation";
  if (!same_bits(a.residual, b.residual)) return "residuals";
  if (a.component != b.component) return "components";
  if (a.tet != mapped(b.tet, other.tets)) return "tetrahedra";
  for (std::size_t v = 0; v < a.points.size(); ++v)
    if (a.carrier_vertices[v] != in_order_of(b.carrier_vertices[v], other.vertices))
      return "carriers' vertices";
  return "";
}

/// The claims about edges as text, each from the lower to the higher number of the mesh given.
std::set<std::string> edge_claims(const CertifiedLevel& level, const std::vector<Index>& vertices) {
  std::set<std::string> claims;
  for (std::size_t e = 0; e < level.topology.edges.size(); ++e) {
    const auto& edge = level.topology.edges[e];
    const Index a = vertices[as_size(edge.vertices[0])], b = vertices[as_size(edge.vertices[1])];
    std::vector<std::string> crossings;
    for (std::size_t k = 0; k < edge.crossings.size(); ++k) {
      auto [place, depth] = level.brackets[e][k];
      if (a > b) place = (std::uint64_t{1} << depth) - 1 - place;
      crossings.push_back(std::to_string(place) + "/2^" + std::to_string(depth) + " vertex " +
                          std::to_string(edge.crossings[k].vertex) +
                          (edge.crossings[k].rising == (a < b) ? " rising" : " falling"));
    }
    if (a > b) std::reverse(crossings.begin(), crossings.end());
    std::string text = std::to_string(std::min(a, b)) + " " + std::to_string(std::max(a, b)) + ":";
    for (const auto& crossing : crossings) text += " " + crossing;
    claims.insert(text);
  }
  return claims;
}

std::set<std::tuple<Index, int, std::vector<std::vector<LevelTopology::BoundaryArc>>>> sheet_claims(
    const CertifiedLevel& level, const std::vector<Index>& vertices,
    const std::vector<Index>& tets) {
  std::set<std::tuple<Index, int, std::vector<std::vector<LevelTopology::BoundaryArc>>>> claims;
  for (const auto& tet : level.topology.tets)
    for (const auto& sheet : tet.sheets) {
      auto loops = sheet.loops;
      for (auto& loop : loops)
        for (auto& arc : loop) arc.opposite = vertices[as_size(arc.opposite)];
      claims.insert({tets[as_size(tet.tet)], sheet.euler_characteristic, loops});
    }
  return claims;
}

std::string difference(const CertifiedLevel& a, const CertifiedLevel& b,
                       const RenumberedMesh& other) {
  std::vector<Index> vertices(other.vertices.size()), tets(other.tets.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = static_cast<Index>(v);
  for (std::size_t t = 0; t < tets.size(); ++t) tets[t] = static_cast<Index>(t);
  if (edge_claims(a, vertices) != edge_claims(b, other.vertices)) return "edges";
  if (sheet_claims(a, vertices, tets) != sheet_claims(b, other.vertices, other.tets))
    return "sheets";
  std::map<std::array<Index, 3>, std::pair<std::vector<std::array<Index, 2>>, std::vector<Index>>>
      faces;
  for (const auto& face : a.topology.faces) faces[face.vertices] = {face.arcs, face.loops};
  for (const auto& face : b.topology.faces) {
    const auto found = faces.find(in_order_of(face.vertices, other.vertices));
    if (found == faces.end() || found->second != std::pair(face.arcs, face.loops)) return "faces";
  }
  if (a.topology.faces.size() != b.topology.faces.size()) return "number of faces";
  std::map<Index, std::vector<LevelTopology::ConeSheet>> cones;
  for (const auto& cone : a.topology.cones) cones[cone.tet] = cone.sheets;
  for (const auto& cone : b.topology.cones)
    if (cones[other.tets[as_size(cone.tet)]] != cone.sheets) return "cones";
  if (a.topology.cones.size() != b.topology.cones.size()) return "number of cones";
  if (a.topology.copies != b.topology.copies) return "copies";
  std::map<Index, std::string> undecided;
  for (const auto& cell : a.undecided) undecided[cell.tet] = cell.reason;
  for (const auto& cell : b.undecided)
    if (undecided[other.tets[as_size(cell.tet)]] != cell.reason) return "undecided";
  if (a.undecided.size() != b.undecided.size()) return "number of undecided";
  if (a.distance.reach != b.distance.reach || a.distance.bound != b.distance.bound ||
      a.distance.coarse_bound != b.distance.coarse_bound)
    return "distances";
  auto coarse = mapped(b.distance.coarse, other.tets);
  std::sort(coarse.begin(), coarse.end());
  return coarse == a.distance.coarse ? "" : "coarse";
}

/// A field of any kind on cubes whose vertices are moved a little.
TetMesh moved_field(Random& random, int most_cubes = 3) {
  TetMesh mesh = field_of_any_kind(random, random.integer(1, most_cubes), 10);
  const auto shift = [&] { return 0.2 * random.uniform() - 0.1; };
  for (auto& p : mesh.points) p = {p.x + shift(), p.y + shift(), p.z + shift()};
  return mesh;
}

std::string arbitrary_mode() {
  return *rc::gen::element<std::string>("0", "1/10", "-1/10", "1/2", "-1/2", "9/10", "-9/10",
                                        "99/100", "-9999/10000");
}

RC_GTEST_PROP(CanonicalOrder, IsAnOrderOfTheSameMesh, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random);
  const CanonicalMesh canonical = canonical_mesh(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto given = as_size(canonical.vertices[v]);
    RC_ASSERT(canonical.mesh.points[v] == mesh.points[given]);
    RC_ASSERT(canonical.mesh.tensors[v] == mesh.tensors[given]);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    auto corners = in_order_of(canonical.mesh.tets[t], canonical.vertices);
    auto given = mesh.tets[as_size(canonical.tets[t])];
    std::sort(given.begin(), given.end());
    RC_ASSERT(corners == given);
  }
  const TetMesh ordered = in_canonical_order(mesh);
  RC_ASSERT(ordered.tets == canonical.mesh.tets);
  RC_ASSERT(ordered.cell_ids.size() == mesh.cell_ids.size());
  for (std::size_t t = 0; t < ordered.cell_ids.size(); ++t)
    RC_ASSERT(ordered.cell_ids[t] == mesh.cell_ids[as_size(canonical.tets[t])]);
  TetMesh numbered = canonical.mesh;
  numbered.cell_ids = mesh.cell_ids;
  RC_ASSERT(validate(numbered).empty());
}

RC_GTEST_PROP(CanonicalOrder, IsTheSameFromAnyOther, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random);
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const CanonicalMesh a = canonical_mesh(mesh), b = canonical_mesh(other.mesh);
  RC_ASSERT(same_bits(a.mesh.points, b.mesh.points));
  RC_ASSERT(same_bits(a.mesh.tensors, b.mesh.tensors));
  RC_ASSERT(a.mesh.tets == b.mesh.tets);
}

RC_GTEST_PROP(AnyNumbering, GivesTheSameSurfaceAndTheSameClaims, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random);
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const std::string mode = arbitrary_mode();
  const Certified a = certified(mesh, mode), b = certified(other.mesh, mode);
  RC_CLASSIFY(!a.extraction.surface.triangles.empty());
  RC_ASSERT(difference(a.extraction.surface, b.extraction.surface, other) == "");
  RC_ASSERT(difference(a.level, b.level, other) == "");
  RC_ASSERT(a.extraction.unresolved.size() == b.extraction.unresolved.size());
}

RC_GTEST_PROP(AnyNumbering, GivesTheSameSurfaceWithDenserCellsAndImprovedTriangles, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random, 2);
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const ModeValue mode = ModeValue::parse(arbitrary_mode());
  ExtractOptions options, moved;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    options.density.push_back(static_cast<float>(random.integer(1, 2)));
  for (const Index t : other.tets) moved.density.push_back(options.density[as_size(t)]);
  auto a = extract_mode_surface<double>(mesh, mode, options).surface;
  auto b = extract_mode_surface<double>(other.mesh, mode, moved).surface;
  RC_ASSERT(difference(a, b, other) == "");
  improve_triangles(mesh, mode, a);
  improve_triangles(other.mesh, mode, b);
  RC_ASSERT(difference(a, b, other) == "");
}

RC_GTEST_PROP(AnyNumbering, GivesTheSameCurves, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random);
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const auto kind = *rc::gen::element(Degeneracy::linear, Degeneracy::planar);
  const auto a = extract_degenerate_curves(mesh, kind);
  const auto b = extract_degenerate_curves(other.mesh, kind);
  RC_CLASSIFY(!a.curves.lines.empty());
  RC_ASSERT(difference(a.curves, b.curves, other) == "");
  RC_ASSERT(a.unresolved.size() == b.unresolved.size());
  const auto p = certify(mesh, kind, a), q = certify(other.mesh, kind, b);
  RC_ASSERT(p.claims() == q.claims());
  RC_ASSERT(p.undecided.size() == q.undecided.size());
  std::map<Index, std::vector<std::array<Index, 2>>> pieces;
  for (const auto& tet : p.tets) pieces[tet.tet] = tet.pieces;
  for (const auto& tet : q.tets) RC_ASSERT(pieces[other.tets[as_size(tet.tet)]] == tet.pieces);
}

RC_GTEST_PROP(AnyNumbering, GivesTheSameCriticalValues, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const TetMesh mesh = moved_field(random);
  const RenumberedMesh other = renumbered_mesh(mesh, random);
  const auto a = mesh_critical_values(mesh, -1, 1), b = mesh_critical_values(other.mesh, -1, 1);
  RC_ASSERT(a.looked_at == b.looked_at);
  RC_ASSERT(a.points.size() == b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    RC_ASSERT(a.points[i].low == b.points[i].low);
    RC_ASSERT(a.points[i].high == b.points[i].high);
    RC_ASSERT(a.points[i].point == b.points[i].point);
    RC_ASSERT(a.points[i].weights == b.points[i].weights);
    RC_ASSERT(a.points[i].around == mapped(b.points[i].around, other.vertices));
    for (std::size_t k = 0; k < 4; ++k) {
      const Index v = b.points[i].vertices[k];
      RC_ASSERT(a.points[i].vertices[k] == (v < 0 ? v : other.vertices[as_size(v)]));
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
