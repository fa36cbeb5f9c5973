// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "certificate_writer.hpp"

#include <openssl/sha.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "support/oracles/level_sign.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = std::int32_t;

class Bytes {
 public:
  void add(std::uint64_t word) { bytes_.append(reinterpret_cast<const char*>(&word), 8); }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const std::vector<Vector3<double>>& points) {
    add(std::uint64_t{points.size()});
    for (const auto& p : points) add(p.x), add(p.y), add(p.z);
  }
  std::string sha256() const {
    std::array<unsigned char, 32> digest;
    SHA256(reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size(), digest.data());
    std::string text;
    for (const unsigned char byte : digest)
      text += "0123456789abcdef"[byte >> 4], text += "0123456789abcdef"[byte & 15];
    return text;
  }

 private:
  std::string bytes_;
};

/// Reads the claims about one level off its triangles.
class Reader {
 public:
  Reader(const TetMesh& mesh, const Extraction& extraction, double mode, Index first)
      : mesh_(mesh), s_(extraction.surface), mode_(mode), first_(first) {}

  Json edges() const {
    std::map<std::array<Index, 2>, std::vector<std::pair<double, Index>>> found;
    for (Index v = 0; v < static_cast<Index>(s_.points.size()); ++v) {
      if (!is_crossing(v)) continue;
      const auto& c = s_.carrier_vertices[as_size(v)];
      const auto a = mesh_.points[as_size(c[0])], b = mesh_.points[as_size(c[1])];
      const auto d = b - a, p = s_.points[as_size(v)] - a;
      found[{c[0], c[1]}].push_back({dot(p, d) / dot(d, d), v});
    }
    Json result = Json::array();
    for (auto& [edge, crossings] : found) {
      std::sort(crossings.begin(), crossings.end());
      Json& entry = result.emplace_back(Json::array({edge[0], edge[1]}));
      constexpr int kPlaces = 36;
      constexpr std::int64_t kAll = std::int64_t{1} << kPlaces;
      const std::array<ExactDeviator, 2> ends{mesh_.tensors[as_size(edge[0])],
                                              mesh_.tensors[as_size(edge[1])]};
      const LevelQuestion question(ends, mode_);
      const auto above = [&](std::int64_t i) { return question.is_above(std::array{kAll - i, i}); };
      for (const auto& [t, v] : crossings) {
        const auto near = static_cast<std::int64_t>(std::floor(std::ldexp(t, kPlaces)));
        std::int64_t i = std::clamp<std::int64_t>(near, 0, kAll - 1);
        for (const std::int64_t other : {near - 1, near + 1})  // rounding may have moved t
          if (other >= 0 && other < kAll && above(i) == above(i + 1)) i = other;
        entry.push_back({i, kPlaces, v + first_});
      }
    }
    return result;
  }

  /// Faces and tetrahedra, from the boundary loops of the triangles in each tetrahedron.
  void read(Json& faces, Json& tets);

  Json components() const {
    const SurfaceInvariants invariants = surface_invariants(s_);
    std::map<Index, Json> parts;
    for (std::size_t c = 0; c < invariants.parts.size(); ++c) {
      Index smallest = -1;
      for (std::size_t t = 0; t < s_.triangles.size(); ++t)
        for (const Index v : s_.triangles[t])
          if (invariants.component[t] == static_cast<Index>(c) && (smallest < 0 || v < smallest))
            smallest = v;
      const auto& part = invariants.parts[c];
      parts[smallest] = {{"euler_characteristic", part.euler_characteristic},
                         {"boundary_loops", part.boundary_loops},
                         {"orientable", part.orientable},
                         {"triangles", part.triangles},
                         {"first_vertex", smallest + first_}};
    }
    Json result = Json::array();
    for (auto& [v, part] : parts) result.push_back(part);
    return result;
  }

 private:
  using Face = std::array<Index, 3>;

  bool is_crossing(Index v) const { return s_.carrier[as_size(v)] == Carrier::edge; }
  std::set<Index> carrier(Index v) const {
    std::set<Index> result;
    for (const Index c : s_.carrier_vertices[as_size(v)])
      if (c >= 0) result.insert(c);
    return result;
  }
  std::pair<long, Json> loop_of(std::map<Index, Index>& boundary, Index tet);

  const TetMesh& mesh_;
  const SurfaceMesh& s_;
  double mode_;
  Index first_;
  std::map<Face, std::set<std::array<Index, 2>>> arcs_;
  std::map<Face, std::set<Index>> loops_;
};

/// Takes one loop out of a boundary. First the smallest vertex of all on it.
std::pair<long, Json> Reader::loop_of(std::map<Index, Index>& boundary, Index tet) {
  std::vector<Index> loop;
  for (Index v = boundary.begin()->first; boundary.contains(v);) {
    loop.push_back(v);
    const Index next = boundary.at(v);
    boundary.erase(v);
    v = next;
  }
  const long any = loop[0];
  std::vector<Index> crossings;
  for (const Index v : loop)
    if (is_crossing(v)) crossings.push_back(v);
  const Index start = crossings.empty() ? *std::min_element(loop.begin(), loop.end())
                                        : *std::min_element(crossings.begin(), crossings.end());
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), start), loop.end());
  Json result = Json::array();
  for (std::size_t i = 0; i < loop.size();) {
    std::set<Index> face = carrier(loop[i]);
    std::size_t end = i + 1;
    face.merge(carrier(loop[end % loop.size()]));
    while (end < loop.size() && (crossings.empty() || !is_crossing(loop[end]))) ++end;
    if (face.size() != 3) throw std::runtime_error("an arc without face");
    Face f{};
    std::copy(face.begin(), face.end(), f.begin());
    Index opposite = -1;
    for (const Index v : mesh_.tets[as_size(tet)])
      if (!face.contains(v)) opposite = v;
    const Index to = loop[end % loop.size()] + first_, from = loop[i] + first_;
    if (crossings.empty()) {
      loops_[f].insert(from);
    } else {
      arcs_[f].insert({std::min(from, to), std::max(from, to)});
    }
    result.push_back(from);
    result.push_back(opposite);
    i = end;
  }
  return {any, result};
}

void Reader::read(Json& faces, Json& tets) {
  std::map<std::int64_t, std::pair<Index, std::vector<std::size_t>>> by_cell;
  for (std::size_t t = 0; t < s_.triangles.size(); ++t) {
    auto& [tet, all] = by_cell[mesh_.cell_ids[as_size(s_.tet[t])]];
    tet = s_.tet[t];
    all.push_back(t);
  }
  tets = Json::array();
  for (const auto& [cell, members] : by_cell) {
    SurfaceMesh part;
    part.points = s_.points;
    std::map<Index, Index> boundary;
    std::set<std::array<Index, 2>> all;
    for (const std::size_t t : members.second) {
      part.triangles.push_back(s_.triangles[t]);
      for (std::size_t i = 0; i < 3; ++i)
        all.insert({s_.triangles[t][i], s_.triangles[t][(i + 1) % 3]});
    }
    for (const auto& [a, b] : all)
      if (!all.contains({b, a})) boundary[a] = b;
    const auto component = surface_components(part);
    std::map<Index, std::pair<long, std::vector<Json>>> sheets;
    std::map<Index, Index> sheet_of;
    std::map<Index, std::set<std::array<Index, 2>>> edges;
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      ++sheets[component[t]].first;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = part.triangles[t][i], b = part.triangles[t][(i + 1) % 3];
        if (sheet_of.emplace(a, component[t]).second) ++sheets[component[t]].first;
        if (edges[component[t]].insert({std::min(a, b), std::max(a, b)}).second)
          --sheets[component[t]].first;
      }
    }
    while (!boundary.empty()) {
      const auto [vertex, loop] = loop_of(boundary, members.first);
      sheets[sheet_of.at(static_cast<Index>(vertex))].second.push_back(loop);
    }
    std::vector<Json> listed;
    for (auto& [id, sheet] : sheets) {
      std::sort(sheet.second.begin(), sheet.second.end());
      Json& out = listed.emplace_back(Json::array({sheet.first}));
      for (const Json& loop : sheet.second) out.push_back(loop);
    }
    std::sort(listed.begin(), listed.end(),
              [](const Json& a, const Json& b) { return a[1][0] < b[1][0]; });
    Json& entry = tets.emplace_back(Json::array({cell}));
    for (const Json& sheet : listed) entry.push_back(sheet);
  }
  faces = Json::array();
  std::set<Face> named;
  for (const auto& [f, unused] : arcs_) named.insert(f);
  for (const auto& [f, unused] : loops_) named.insert(f);
  for (const Face& f : named) faces.push_back({f[0], f[1], f[2], arcs_[f], loops_[f]});
}

}  // namespace

void append_level(SurfaceMesh& all, const SurfaceMesh& level) {
  const Index first = static_cast<Index>(all.points.size());
  all.points.insert(all.points.end(), level.points.begin(), level.points.end());
  all.tet.insert(all.tet.end(), level.tet.begin(), level.tet.end());
  for (auto triangle : level.triangles) {
    for (Index& v : triangle) v += first;
    all.triangles.push_back(triangle);
  }
}

std::string CertifiedSurface::write(const Json& document, const std::string& name) const {
  const std::string file = (folder / name).string();
  std::ofstream stream(file, std::ios::binary);
  if (name.ends_with(".cbor")) {
    const auto bytes = Json::to_cbor(document);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  } else {
    stream << document;
  }
  return file;
}

CertifiedSurface certified_surface(const TetMesh& given, const std::vector<std::string>& modes,
                                   const std::filesystem::path& folder) {
  TetMesh mesh = given;
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  CertifiedSurface result{folder, {}};
  std::filesystem::create_directories(folder);
  SurfaceMesh all;
  Json levels = Json::array();
  for (const std::string& mode : modes) {
    const ModeValue mu = ModeValue::parse(mode);
    const Extraction e = extract_mode_surface<double>(mesh, mu);
    const Index first = static_cast<Index>(all.points.size());
    Json level{{"mode", mu.text()},
               {"vertices", {first, e.surface.points.size()}},
               {"triangles", {all.triangles.size(), e.surface.triangles.size()}},
               {"on_level", e.statistics.vertices_on_level},
               {"undecided", Json::array()},
               {"cones", Json::array()},  // no use is made of fields that have such
               {"distance", nullptr}};
    Reader reader(mesh, e, mu.approx(), first);
    level["edges"] = reader.edges();
    reader.read(level["faces"], level["tets"]);
    level["components"] = reader.components();
    for (const UnresolvedCell& cell : e.unresolved)
      level["undecided"].push_back({cell.tet, name_of(cell.reason)});
    levels.push_back(std::move(level));
    append_level(all, e.surface);
  }
  write_mesh(mesh, result.input());
  write_surface(all, mesh, result.surface());

  Bytes field, triangles;
  field.add(mesh.points);
  for (const auto& t : mesh.tensors)
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) field.add(x);
  field.add(std::uint64_t{mesh.tets.size()});
  for (auto tet : mesh.tets) {
    std::sort(tet.begin(), tet.end());
    for (const Index v : tet) field.add(static_cast<std::uint64_t>(v));
  }
  triangles.add(all.points);
  triangles.add(std::uint64_t{all.triangles.size()});
  for (const auto& triangle : all.triangles)
    for (const Index v : triangle) triangles.add(static_cast<std::uint64_t>(v));
  for (const Index t : all.tet) triangles.add(static_cast<std::uint64_t>(t));
  result.certificate = {{"format", "tensortopo certificate"},
                        {"version", 1},
                        {"input",
                         {{"tensor", "stress"},
                          {"components", "vtk"},
                          {"points", mesh.points.size()},
                          {"tetrahedra", mesh.tets.size()},
                          {"sha256", field.sha256()}}},
                        {"surface",
                         {{"vertices", all.points.size()},
                          {"triangles", all.triangles.size()},
                          {"sha256", triangles.sha256()}}},
                        {"levels", levels}};
  return result;
}

}  // namespace tensortopo::test
