// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/certificate.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "document_writer.hpp"

namespace tensortopo {

namespace {

using Json = nlohmann::ordered_json;
using detail::DocumentWriter;

/// A number that is not negative, in hexadecimal: all of its digits.
std::string exact(double x) {
  std::array<char, 32> digits;
  char* const end = std::to_chars(digits.begin(), digits.end(), x, std::chars_format::hex).ptr;
  return "0x" + std::string(digits.begin(), end);
}

/// What the file calls vertices and tetrahedra of the mesh.
struct Ids {
  const std::vector<std::int64_t>& vertices;  ///< empty: their numbers
  const std::vector<std::int64_t>& cells;

  template <class Level>
  Ids(const Level& level, const TetMesh& mesh)
      : vertices(level.vertex_ids), cells(level.cell_ids.empty() ? mesh.cell_ids : level.cell_ids) {}

  std::int64_t vertex(TetMesh::Index v) const { return vertices.empty() ? v : vertices[as_size(v)]; }
  std::int64_t cell(TetMesh::Index t) const { return cells[as_size(t)]; }
};

void write_edges(DocumentWriter& out, const CertifiedLevel& level, std::size_t first_vertex,
                 const Ids& ids) {
  std::multimap<SurfaceMesh::Index, SurfaceMesh::Index> copies;
  for (const auto& [vertex, copy] : level.topology.copies) copies.emplace(vertex, copy);
  out.list(level.topology.edges, [&](DocumentWriter& item, std::size_t e) {
    const auto& edge = level.topology.edges[e];
    item.array(2 + edge.crossings.size());
    for (const auto v : edge.vertices) item.number(ids.vertex(v));
    for (std::size_t k = 0; k < edge.crossings.size(); ++k) {
      const auto vertex = edge.crossings[k].vertex;
      const auto [begin, end] = copies.equal_range(vertex);
      item.array(3 + static_cast<std::size_t>(std::distance(begin, end)));
      item.number(level.brackets[e][k].place);
      item.number(level.brackets[e][k].depth);
      item.number(first_vertex + as_size(vertex));
      for (auto copy = begin; copy != end; ++copy)
        item.number(first_vertex + as_size(copy->second));
      item.end_array();
    }
    item.end_array();
  });
}

void write_faces(DocumentWriter& out, const CertifiedLevel& level, std::size_t first_vertex,
                 const Ids& ids) {
  out.list(level.topology.faces, [&](DocumentWriter& item, std::size_t f) {
    const auto& face = level.topology.faces[f];
    item.array(5);
    for (const auto v : face.vertices) item.number(ids.vertex(v));
    item.array(face.arcs.size());
    for (const auto& arc : face.arcs) {
      item.array(2);
      for (const auto v : arc) item.number(first_vertex + as_size(v));
      item.end_array();
    }
    item.end_array();
    item.array(face.loops.size());
    for (const auto v : face.loops) item.number(first_vertex + as_size(v));
    item.end_array();
    item.end_array();
  });
}

void write_tets(DocumentWriter& out, const CertifiedLevel& level, std::size_t first_vertex,
                const Ids& ids) {
  out.list(level.topology.tets, [&](DocumentWriter& item, std::size_t t) {
    const auto& tet = level.topology.tets[t];
    item.array(1 + tet.sheets.size());
    item.number(ids.cell(tet.tet));
    for (const auto& sheet : tet.sheets) {
      item.array(1 + sheet.loops.size());
      item.number(sheet.euler_characteristic);
      for (const auto& loop : sheet.loops) {
        item.array(2 * loop.size());
        for (const auto& arc : loop) {
          item.number(first_vertex + as_size(arc.from));
          item.number(ids.vertex(arc.opposite));
        }
        item.end_array();
      }
      item.end_array();
    }
    item.end_array();
  });
}

void write_cones(DocumentWriter& out, const CertifiedLevel& level, std::size_t first_vertex,
                 const Ids& ids) {
  out.list(level.topology.cones, [&](DocumentWriter& item, std::size_t c) {
    const auto& cone = level.topology.cones[c];
    item.array(1 + cone.sheets.size());
    item.number(ids.cell(cone.tet));
    for (const auto& sheet : cone.sheets) {
      item.array(sheet.size());
      for (const auto v : sheet) item.number(first_vertex + as_size(v));
      item.end_array();
    }
    item.end_array();
  });
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

/// @param crossings  indices of edges or faces of the level
Json stability_json(const StabilityClaim& claim, const std::vector<std::size_t>& crossings,
                    std::size_t first_vertex) {
  Json components = Json::array();
  for (const auto v : claim.components) components.push_back(first_vertex + as_size(v));
  Json json;
  if (!claim.array.empty())
    json = {{"array", claim.array}, {"sha256", claim.radii_sha256}, {"of", "array"}};
  else
    json = {{"radius", exact(claim.radius)}, {"of", claim.of_deviator ? "deviator" : "tensor"}};
  json["components"] = std::move(components);
  if (!crossings.empty()) json["crossings"] = crossings;
  return json;
}

Json undecided_json(const std::vector<UndecidedCell>& cells,
                    const std::vector<std::int64_t>& cell_ids) {
  Json undecided = Json::array();
  for (const auto& cell : cells)
    undecided.push_back(Json::array({cell_ids[as_size(cell.tet)], cell.reason}));
  return undecided;
}

/// The claims about a level that are not lists of its simplices: those that come before these lists
/// in the file, and those that come after.
struct LevelFrame {
  Json before, after;
};

LevelFrame level_frame(const CertifiedLevel& level, std::size_t first_vertex,
                       std::size_t first_triangle, const Ids& ids) {
  Json components = Json::array();
  for (const auto& c : level.components)
    components.push_back({{"euler_characteristic", c.euler_characteristic},
                          {"boundary_loops", c.boundary_loops},
                          {"orientable", c.orientable},
                          {"triangles", c.triangles},
                          {"first_vertex", first_vertex + as_size(c.first_vertex)}});
  Json before, after;
  if (const auto* invariant = std::get_if<InvariantLevel>(&level.value)) {
    before["invariant"] = name_of(invariant->invariant());
    before["value"] = invariant->text();
  } else {
    before["mode"] = std::get<ModeValue>(level.value).text();
  }
  before["vertices"] = {first_vertex, level.vertices};
  before["triangles"] = {first_triangle, level.triangles};
  before["on_level"] = level.on_level;
  before["undecided"] = undecided_json(level.undecided, ids.cells);
  after["components"] = std::move(components);
  after["distance"] = distance_json(level.distance, ids);
  if (level.stability)
    after["stability"] =
        stability_json(*level.stability, level.claimed_crossings(), first_vertex);
  if (level.embedded) after["embedded"] = true;
  if (level.not_isotopic) after["isotopic"] = {{"except", cells_json(*level.not_isotopic, ids)}};
  return {std::move(before), std::move(after)};
}

void write_members(DocumentWriter& out, const Json& object) {
  for (const auto& [key, value] : object.items()) {
    out.key(key);
    out.value(value);
  }
}

void write_level(DocumentWriter& out, const CertifiedLevel& level, std::size_t first_vertex,
                 std::size_t first_triangle, const TetMesh& mesh) {
  const Ids ids(level, mesh);
  const LevelFrame frame = level_frame(level, first_vertex, first_triangle, ids);
  out.object(frame.before.size() + 4 + frame.after.size());
  write_members(out, frame.before);
  out.key("edges");
  write_edges(out, level, first_vertex, ids);
  out.key("faces");
  write_faces(out, level, first_vertex, ids);
  out.key("tets");
  write_tets(out, level, first_vertex, ids);
  out.key("cones");
  write_cones(out, level, first_vertex, ids);
  write_members(out, frame.after);
  out.end_object();
}

Json curve_faces_json(const CertifiedCurves& kind, std::size_t first_vertex, const Ids& ids) {
  Json faces = Json::array();
  for (const auto& face : kind.faces) {
    Json item{ids.vertex(face.vertices[0]), ids.vertex(face.vertices[1]),
              ids.vertex(face.vertices[2])};
    for (const auto& point : face.points)
      item.push_back({first_vertex + as_size(point.vertex), point.place[0], point.place[1],
                      point.depth});
    faces.push_back(std::move(item));
  }
  return faces;
}

Json pieces_json(const CertifiedCurves& kind, std::size_t first_vertex, const Ids& ids) {
  Json tets = Json::array();
  for (const auto& tet : kind.tets) {
    Json item = Json::array({ids.cell(tet.tet)});
    for (const auto& [v, w] : tet.pieces)
      item.push_back({first_vertex + as_size(v), first_vertex + as_size(w)});
    tets.push_back(std::move(item));
  }
  return tets;
}

Json curves_json(const CertifiedCurves& kind, std::size_t first_vertex, std::size_t first_line,
                 const TetMesh& mesh) {
  const Ids ids(kind, mesh);
  Json curves = Json::array();
  for (const auto& c : kind.curves)
    curves.push_back({{"closed", c.closed},
                      {"lines", c.lines},
                      {"first_vertex", first_vertex + as_size(c.first_vertex)}});
  Json json;
  json["mode"] = kind.kind == Degeneracy::linear ? "1" : "-1";
  json["vertices"] = {first_vertex, kind.vertices};
  json["lines"] = {first_line, kind.lines};
  json["undecided"] = undecided_json(kind.undecided, ids.cells);
  json["faces"] = curve_faces_json(kind, first_vertex, ids);
  json["tets"] = pieces_json(kind, first_vertex, ids);
  json["curves"] = std::move(curves);
  if (kind.stability)
    json["stability"] =
        stability_json(*kind.stability, kind.claimed_crossings(), first_vertex);
  return json;
}

/// All but the levels, which come last.
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
  return json;
}

/// @param write_level  writes the level of a number
template <class WriteLevel>
std::string document(const Json& head, std::size_t levels, CertificateEncoding encoding,
                     const WriteLevel& write_level) {
  DocumentWriter out(encoding);
  out.object(head.size() + 1);
  write_members(out, head);
  out.key("levels");
  out.array(levels);
  for (std::size_t l = 0; l < levels; ++l) write_level(out, l);
  out.end_array();
  out.end_object();
  return out.take() + (encoding == CertificateEncoding::json ? "\n" : "");
}

}  // namespace

std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedLevel> levels, const TetMesh& mesh,
                              CertificateEncoding encoding) {
  std::size_t vertices = 0, triangles = 0;
  return document(head_json(subject, "surface", "triangles"), levels.size(), encoding,
                  [&](DocumentWriter& out, std::size_t l) {
                    write_level(out, levels[l], vertices, triangles, mesh);
                    vertices += levels[l].vertices;
                    triangles += levels[l].triangles;
                  });
}

std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedCurves> kinds, const TetMesh& mesh,
                              CertificateEncoding encoding) {
  std::size_t vertices = 0, lines = 0;
  return document(head_json(subject, "polylines", "lines"), kinds.size(), encoding,
                  [&](DocumentWriter& out, std::size_t l) {
                    out.value(curves_json(kinds[l], vertices, lines, mesh));
                    vertices += kinds[l].vertices;
                    lines += kinds[l].lines;
                  });
}

}  // namespace tensortopo
