// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/certificate.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace tensortopo {

namespace {

using Json = nlohmann::ordered_json;

std::string exact(double x) { return fmt::format("{:a}", x); }

/// What the file calls vertices and tetrahedra of the mesh.
struct Ids {
  const std::vector<std::int64_t>& vertices;  ///< empty: their numbers
  const std::vector<std::int64_t>& cells;

  Ids(const CertifiedLevel& level, const TetMesh& mesh)
      : vertices(level.vertex_ids), cells(level.cell_ids.empty() ? mesh.cell_ids : level.cell_ids) {}

  std::int64_t vertex(TetMesh::Index v) const { return vertices.empty() ? v : vertices[as_size(v)]; }
  std::int64_t cell(TetMesh::Index t) const { return cells[as_size(t)]; }
};

Json edges_json(const CertifiedLevel& level, std::size_t first_vertex, const Ids& ids) {
  Json edges = Json::array();
  std::multimap<SurfaceMesh::Index, SurfaceMesh::Index> copies;
  for (const auto& [vertex, copy] : level.topology.copies) copies.emplace(vertex, copy);
  for (std::size_t e = 0; e < level.topology.edges.size(); ++e) {
    const auto& edge = level.topology.edges[e];
    Json item{ids.vertex(edge.vertices[0]), ids.vertex(edge.vertices[1])};
    for (std::size_t k = 0; k < edge.crossings.size(); ++k) {
      const auto vertex = edge.crossings[k].vertex;
      item.push_back({level.brackets[e][k].place, level.brackets[e][k].depth,
                      first_vertex + as_size(vertex)});
      const auto [begin, end] = copies.equal_range(vertex);
      for (auto copy = begin; copy != end; ++copy)
        item.back().push_back(first_vertex + as_size(copy->second));
    }
    edges.push_back(std::move(item));
  }
  return edges;
}

Json faces_json(const CertifiedLevel& level, std::size_t first_vertex, const Ids& ids) {
  Json faces = Json::array();
  for (const auto& face : level.topology.faces) {
    Json arcs = Json::array(), loops = Json::array();
    for (const auto& arc : face.arcs)
      arcs.push_back({first_vertex + as_size(arc[0]), first_vertex + as_size(arc[1])});
    for (const auto v : face.loops) loops.push_back(first_vertex + as_size(v));
    faces.push_back({ids.vertex(face.vertices[0]), ids.vertex(face.vertices[1]),
                     ids.vertex(face.vertices[2]), std::move(arcs), std::move(loops)});
  }
  return faces;
}

Json tets_json(const CertifiedLevel& level, std::size_t first_vertex, const Ids& ids) {
  Json tets = Json::array();
  for (const auto& tet : level.topology.tets) {
    Json item{ids.cell(tet.tet)};
    for (const auto& sheet : tet.sheets) {
      Json sheet_json{sheet.euler_characteristic};
      for (const auto& loop : sheet.loops) {
        Json arcs = Json::array();
        for (const auto& arc : loop) {
          arcs.push_back(first_vertex + as_size(arc.from));
          arcs.push_back(ids.vertex(arc.opposite));
        }
        sheet_json.push_back(std::move(arcs));
      }
      item.push_back(std::move(sheet_json));
    }
    tets.push_back(std::move(item));
  }
  return tets;
}

Json cones_json(const CertifiedLevel& level, std::size_t first_vertex, const Ids& ids) {
  Json cones = Json::array();
  for (const auto& cone : level.topology.cones) {
    Json item{ids.cell(cone.tet)};
    for (const auto& sheet : cone.sheets) {
      Json vertices = Json::array();
      for (const auto v : sheet) vertices.push_back(first_vertex + as_size(v));
      item.push_back(std::move(vertices));
    }
    cones.push_back(std::move(item));
  }
  return cones;
}

Json cells_json(const std::vector<TetMesh::Index>& tets, const Ids& ids) {
  Json cells = Json::array();
  for (const auto t : tets) cells.push_back(ids.cell(t));
  return cells;
}

Json distance_json(const DistanceClaim& claim, const Ids& ids) {
  return {{"reach", claim.reach},
          {"bound", exact(claim.bound)},
          {"coarse", cells_json(claim.coarse, ids)},
          {"coarse_bound", exact(claim.coarse_bound)}};
}

Json stability_json(const StabilityClaim& claim, std::size_t first_vertex) {
  Json components = Json::array();
  for (const auto v : claim.components) components.push_back(first_vertex + as_size(v));
  if (!claim.array.empty())
    return {{"array", claim.array},
            {"sha256", claim.radii_sha256},
            {"of", "array"},
            {"components", std::move(components)}};
  return {{"radius", exact(claim.radius)},
          {"of", claim.of_deviator ? "deviator" : "tensor"},
          {"components", std::move(components)}};
}

Json undecided_json(const std::vector<UndecidedCell>& cells,
                    const std::vector<std::int64_t>& cell_ids) {
  Json undecided = Json::array();
  for (const auto& cell : cells)
    undecided.push_back(Json::array({cell_ids[as_size(cell.tet)], cell.reason}));
  return undecided;
}

Json level_json(const CertifiedLevel& level, std::size_t first_vertex, std::size_t first_triangle,
                const TetMesh& mesh) {
  const Ids ids(level, mesh);
  Json components = Json::array();
  for (const auto& c : level.components)
    components.push_back({{"euler_characteristic", c.euler_characteristic},
                          {"boundary_loops", c.boundary_loops},
                          {"orientable", c.orientable},
                          {"triangles", c.triangles},
                          {"first_vertex", first_vertex + as_size(c.first_vertex)}});
  Json json;
  if (const auto* invariant = std::get_if<InvariantLevel>(&level.value)) {
    json["invariant"] = name_of(invariant->invariant());
    json["value"] = invariant->text();
  } else {
    json["mode"] = std::get<ModeValue>(level.value).text();
  }
  json["vertices"] = {first_vertex, level.vertices};
  json["triangles"] = {first_triangle, level.triangles};
  json["on_level"] = level.on_level;
  json["undecided"] = undecided_json(level.undecided, ids.cells);
  json["edges"] = edges_json(level, first_vertex, ids);
  json["faces"] = faces_json(level, first_vertex, ids);
  json["tets"] = tets_json(level, first_vertex, ids);
  json["cones"] = cones_json(level, first_vertex, ids);
  json["components"] = std::move(components);
  json["distance"] = distance_json(level.distance, ids);
  if (level.stability) json["stability"] = stability_json(*level.stability, first_vertex);
  if (level.embedded) json["embedded"] = true;
  if (level.not_isotopic)
    json["isotopic"] = {{"except", cells_json(*level.not_isotopic, ids)}};
  return json;
}

Json curve_faces_json(const CertifiedCurves& kind, std::size_t first_vertex) {
  Json faces = Json::array();
  for (const auto& face : kind.faces) {
    Json item{face.vertices[0], face.vertices[1], face.vertices[2]};
    for (const auto& point : face.points)
      item.push_back({first_vertex + as_size(point.vertex), point.place[0], point.place[1],
                      point.depth});
    faces.push_back(std::move(item));
  }
  return faces;
}

Json pieces_json(const CertifiedCurves& kind, std::size_t first_vertex, const TetMesh& mesh) {
  Json tets = Json::array();
  for (const auto& tet : kind.tets) {
    Json item = Json::array({mesh.cell_ids[as_size(tet.tet)]});
    for (const auto& [v, w] : tet.pieces)
      item.push_back({first_vertex + as_size(v), first_vertex + as_size(w)});
    tets.push_back(std::move(item));
  }
  return tets;
}

Json curves_json(const CertifiedCurves& kind, std::size_t first_vertex, std::size_t first_line,
                 const TetMesh& mesh) {
  Json curves = Json::array();
  for (const auto& c : kind.curves)
    curves.push_back({{"closed", c.closed},
                      {"lines", c.lines},
                      {"first_vertex", first_vertex + as_size(c.first_vertex)}});
  Json json;
  json["mode"] = kind.kind == Degeneracy::linear ? "1" : "-1";
  json["vertices"] = {first_vertex, kind.vertices};
  json["lines"] = {first_line, kind.lines};
  json["undecided"] = undecided_json(kind.undecided, mesh.cell_ids);
  json["faces"] = curve_faces_json(kind, first_vertex);
  json["tets"] = pieces_json(kind, first_vertex, mesh);
  json["curves"] = std::move(curves);
  if (kind.stability) json["stability"] = stability_json(*kind.stability, first_vertex);
  return json;
}

/// All but the levels.
/// @param output  "surface" or "polylines"
/// @param cells  "triangles" or "lines"
Json head_json(const CertificateSubject& subject, const char* output, const char* cells) {
  Json json;
  json["format"] = "tensortopo certificate";
  json["version"] = 1;
  json["input"] = {{"tensor", subject.tensor},
                   {"components", subject.components},
                   {"points", subject.points},
                   {"tetrahedra", subject.tetrahedra},
                   {"sha256", subject.field_sha256}};
  Json& file = json[output];
  file = {{"vertices", subject.vertices}, {cells, subject.cells}, {"sha256", subject.output_sha256}};
  if (!subject.arrays.empty()) file["arrays"] = Json::array();
  for (const auto& array : subject.arrays)
    file["arrays"].push_back({array.of, array.name, array.components, array.sha256});
  json["levels"] = Json::array();
  return json;
}

std::string bytes_of(const Json& json, CertificateEncoding encoding) {
  if (encoding == CertificateEncoding::json) return json.dump() + '\n';
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

}  // namespace

std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedLevel> levels, const TetMesh& mesh,
                              CertificateEncoding encoding) {
  Json json = head_json(subject, "surface", "triangles");
  std::size_t vertices = 0, triangles = 0;
  for (const auto& level : levels) {
    json["levels"].push_back(level_json(level, vertices, triangles, mesh));
    vertices += level.vertices;
    triangles += level.triangles;
  }
  return bytes_of(json, encoding);
}

std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedCurves> kinds, const TetMesh& mesh,
                              CertificateEncoding encoding) {
  Json json = head_json(subject, "polylines", "lines");
  std::size_t vertices = 0, lines = 0;
  for (const auto& kind : kinds) {
    json["levels"].push_back(curves_json(kind, vertices, lines, mesh));
    vertices += kind.vertices;
    lines += kind.lines;
  }
  return bytes_of(json, encoding);
}

}  // namespace tensortopo
