// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract_case.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "support/surfaces/surface_check_parts.hpp"
#include "support/surfaces/surface_checks.hpp"

namespace tensortopo::test {

namespace {

using Index = SurfaceMesh::Index;

using FaceKey = std::array<Index, 3>;

// The tetrahedra of each face, leaving out those that are unresolved.
std::map<FaceKey, std::vector<Index>> tets_of_faces(const Extraction& extraction,
                                                    const TetMesh& mesh) {
  std::set<Index> left_out;
  for (const auto& cell : extraction.unresolved) left_out.insert(cell.tet);
  std::map<FaceKey, std::vector<Index>> faces;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (left_out.contains(static_cast<Index>(t))) continue;
    for (std::size_t omitted = 0; omitted < 4; ++omitted) {
      FaceKey face{};
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != omitted) face[k++] = mesh.tets[t][i];
      std::sort(face.begin(), face.end());
      faces[face].push_back(static_cast<Index>(t));
    }
  }
  return faces;
}

// The mesh vertices of the smallest simplex that holds both.
std::vector<Index> common_carrier(const SurfaceMesh& surface, Index u, Index v) {
  std::set<Index> all;
  for (const Index w : {u, v})
    for (const Index k : surface.carrier_vertices[as_size(w)])
      if (k >= 0) all.insert(k);
  return {all.begin(), all.end()};
}

// What is wrong with carriers: names of simplices that hold the vertices.
void check_carriers(const Extraction& extraction, const TetMesh& mesh, std::ostream& out) {
  const SurfaceMesh& surface = extraction.surface;
  if (surface.carrier_vertices.size() != surface.points.size()) {
    out << "carrier_vertices has the wrong length\n";
    return;
  }
  std::vector<std::vector<Index>> tets_at(surface.points.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const Index v : surface.triangles[t]) tets_at[as_size(v)].push_back(surface.tet[t]);
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    const auto& key = surface.carrier_vertices[v];
    const auto count = static_cast<std::size_t>(
        std::count_if(key.begin(), key.end(), [](Index k) { return k >= 0; }));
    const std::size_t expected = surface.carrier[v] == Carrier::vertex ? 1
                                 : surface.carrier[v] == Carrier::edge ? 2
                                 : surface.carrier[v] == Carrier::face ? 3
                                                                       : 4;
    if (expected == 1 && !has_no_mode(surface, mesh, v))
      out << "vertex " << v << " lies at a vertex of the mesh that has a mode\n";
    if (count != expected) out << "vertex " << v << " has a carrier of " << count << " vertices\n";
    if (!std::is_sorted(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(count)))
      out << "the carrier of vertex " << v << " is not in ascending order\n";
    for (const Index t : tets_at[v])
      for (const Index k : key)
        if (k >= 0 && std::find(mesh.tets[as_size(t)].begin(), mesh.tets[as_size(t)].end(), k) ==
                          mesh.tets[as_size(t)].end())
          out << "vertex " << v << " of a triangle in tetrahedron " << t
              << " is carried by another\n";
  }
}

bool is_zero(const TetMesh& mesh, Index v) {
  const auto& t = mesh.tensors[as_size(v)];
  return t.xx == t.yy && t.yy == t.zz && t.xy == 0 && t.yz == 0 && t.xz == 0;
}

// Whether a surface may end at an edge between two vertices isotropic: some face at the edge
// bounds the domain, or has no deviator either.
bool may_end_at(const std::vector<Index>& edge, const std::map<FaceKey, std::vector<Index>>& faces,
                const TetMesh& mesh) {
  for (const auto& [face, tets] : faces) {
    if (std::find(face.begin(), face.end(), edge[0]) == face.end() ||
        std::find(face.begin(), face.end(), edge[1]) == face.end())
      continue;
    if (tets.size() == 1) return true;
    if (is_zero(mesh, face[0]) && is_zero(mesh, face[1]) && is_zero(mesh, face[2])) return true;
  }
  return false;
}

// Edges of the surface that lie in a face: one triangle from each of its tetrahedra.
void check_faces(const Extraction& extraction, const TetMesh& mesh,
                 const std::map<FaceKey, std::vector<Index>>& faces, std::ostream& out) {
  const SurfaceMesh& surface = extraction.surface;
  std::map<std::pair<Index, Index>, std::vector<Index>> tets_of_edge;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      tets_of_edge[std::minmax(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3])]
          .push_back(surface.tet[t]);
  for (auto& [edge, tets] : tets_of_edge) {
    const auto carrier = common_carrier(surface, edge.first, edge.second);
    std::sort(tets.begin(), tets.end());
    if (carrier.size() < 3 && has_no_mode(surface, mesh, as_size(edge.first)) &&
        has_no_mode(surface, mesh, as_size(edge.second))) {
      continue;  // between two vertices isotropic, where any number of sheets may meet
    } else if (carrier.size() < 3) {
      out << "edge " << edge.first << "-" << edge.second << " runs along an edge of the mesh\n";
    } else if (carrier.size() == 3) {
      const auto found = faces.find({carrier[0], carrier[1], carrier[2]});
      if (found == faces.end() || found->second != tets)
        out << "edge " << edge.first << "-" << edge.second
            << " in a face does not have one triangle in each tetrahedron there\n";
    } else if (tets.size() != 2 || tets[0] != tets[1]) {
      out << "edge " << edge.first << "-" << edge.second
          << " inside a tetrahedron does not have two triangles in it\n";
    }
  }
}

// A vertex between two vertices isotropic: on an edge, but no crossing.
bool is_halfway(const SurfaceMesh& surface, std::size_t v) {
  const auto& medium = surface.medium_eigenvector[v];
  return surface.carrier[v] == Carrier::edge && dot(medium, medium) == 0;
}

}  // namespace

std::string announce(std::uint64_t seed) {
  const std::string text = "seed " + std::to_string(seed);
  testing::Test::RecordProperty("seed", std::to_string(seed));
  std::cout << text << '\n';
  return text;
}

ModeValue mode_of(const Fraction& fraction) {
  return ModeValue::parse(std::to_string(fraction.numerator) + "/" +
                          std::to_string(fraction.denominator));
}

std::string unresolved_text(const Extraction& extraction) {
  std::ostringstream out;
  for (const auto& cell : extraction.unresolved)
    out << "tetrahedron " << cell.tet << ": " << name_of(cell.reason) << '\n';
  return out.str();
}

LocalTopology topology_in_tet(const Extraction& extraction) {
  const SurfaceMesh& surface = extraction.surface;
  LocalTopology result;
  result.components = surface_topology(surface);
  constexpr std::array<std::array<Index, 2>, 6> edges{
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (surface.carrier[v] != Carrier::edge || is_halfway(surface, v)) continue;
    const auto& key = surface.carrier_vertices[v];
    for (std::size_t e = 0; e < 6; ++e)
      result.edge_crossings[e] += key[0] == edges[e][0] && key[1] == edges[e][1];
  }
  return result;
}

SurfaceSummary summary(const SurfaceMesh& surface) {
  std::size_t on_edges = 0;
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    on_edges += surface.carrier[v] == Carrier::edge && !is_halfway(surface, v);
  return {surface_topology(surface), on_edges};
}

std::ostream& operator<<(std::ostream& out, const SurfaceSummary& s) {
  out << s.components.size() << " components:";
  for (const auto& c : s.components) out << ' ' << c;
  return out << "; " << s.on_edges << " vertices on edges";
}

std::string flaws(const Extraction& extraction, const TetMesh& mesh,
                  const SoundnessOptions& options) {
  const SurfaceMesh& surface = extraction.surface;
  std::ostringstream out;
  check_carriers(extraction, mesh, out);
  if (!out.str().empty()) return out.str();
  const auto faces = tets_of_faces(extraction, mesh);
  check_faces(extraction, mesh, faces, out);
  SurfaceCheckOptions checks;
  checks.check_residuals = options.residuals;
  checks.on_domain_boundary = [&](Index u, Index v) {
    const auto carrier = common_carrier(surface, u, v);
    if (carrier.size() == 2) return may_end_at(carrier, faces, mesh);
    if (carrier.size() != 3) return false;
    const auto found = faces.find({carrier[0], carrier[1], carrier[2]});
    return found != faces.end() && found->second.size() == 1;
  };
  const SurfaceReport report = check_surface(surface, mesh, checks);
  for (const auto& violation : report.violations)
    if (options.coincidences || violation.rfind("coincident vertices", 0) != 0)
      out << violation << '\n';
  return out.str();
}

}  // namespace tensortopo::test
