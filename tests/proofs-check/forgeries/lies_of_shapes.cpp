// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "lies.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = SurfaceMesh::Index;
using Triangle = std::array<Index, 3>;

/// What is claimed of triangles as they are in space.
void drop_geometry(Exhibit& e) {
  drop_distances(e);
  for (Json& level : e.certificate["levels"]) level.erase("embedded");
}

/// Vertices of which all triangles are in one tetrahedron, all around: those inside.
std::vector<Index> inner_vertices(const Exhibit& e) {
  std::map<Index, std::set<Index>> tets;
  std::map<Index, std::map<Index, int>>
      turns;  // edges around that lead in, less those that lead out
  for (std::size_t t = 0; t < e.surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& c = e.surface.triangles[t];
      tets[c[i]].insert(e.surface.tet[t]);
      ++turns[c[i]][c[(i + 1) % 3]], --turns[c[i]][c[(i + 2) % 3]];
    }
  std::vector<Index> result;
  for (const auto& [v, of] : tets)
    if (of.size() == 1 && std::all_of(turns[v].begin(), turns[v].end(),
                                      [](const auto& turn) { return turn.second == 0; }))
      result.push_back(v);
  return result;
}

bool is_in_last_level(const Exhibit& e, Index v) {
  return v >= e.certificate["levels"].back()["vertices"][0].get<Index>();
}

/// A vertex inside is two, at one place: a slit, or two fans.
bool open_slit(Exhibit& e, Pick& pick) {
  const auto inner = inner_vertices(e);
  if (inner.empty()) return false;
  const Index v = inner[pick.below(inner.size())];
  if (!is_in_last_level(e, v)) return false;
  const auto copy = static_cast<Index>(e.surface.points.size());
  e.surface.points.push_back(e.surface.points[as_size(v)]);
  bool any = false, all = true;
  for (Triangle& t : e.surface.triangles)
    for (Index& corner : t)
      if (corner == v) pick.coin() ? (corner = copy, any = true) : (all = false, corner);
  if (!any || all) return false;
  drop_geometry(e);
  return make_consistent(e), true;
}

/// Two vertices inside one tetrahedron are one.
bool pinch(Exhibit& e, Pick& pick) {
  if (e.certificate["levels"].size() != 1) return false;
  const auto inner = inner_vertices(e);
  if (inner.size() < 2) return false;
  const Index v = inner[pick.below(inner.size())], w = inner[pick.below(inner.size())];
  if (v == w) return false;
  auto& triangles = e.surface.triangles;
  for (std::size_t t = triangles.size(); t-- > 0;) {
    std::replace(triangles[t].begin(), triangles[t].end(), w, v);
    if (std::count(triangles[t].begin(), triangles[t].end(), v) < 2) continue;
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t));
    e.surface.tet.erase(e.surface.tet.begin() + static_cast<std::ptrdiff_t>(t));
  }
  drop_geometry(e);
  return make_consistent(e), true;
}

/// Two vertices inside one tetrahedron exchange their places.
bool exchange_places(Exhibit& e, Pick& pick) {
  const auto inner = inner_vertices(e);
  if (inner.size() < 8) return false;
  // So many that some triangles meet.
  for (std::size_t i = inner.size(); i-- > 1;)
    std::swap(e.surface.points[as_size(inner[i])],
              e.surface.points[as_size(inner[pick.below(i + 1)])]);
  drop_distances(e);
  bool any = false;
  for (Json& level : e.certificate["levels"]) level["embedded"] = any = true;
  return e.rehash(), any;
}

/// A vertex inside, beyond the sheet's neighbours: near the corner of the tetrahedron that is
/// farthest.
bool pull_out(Exhibit& e, Pick& pick) {
  const auto inner = inner_vertices(e);
  if (inner.empty()) return false;
  const Index v = inner[pick.below(inner.size())];
  for (std::size_t t = 0; t < e.surface.triangles.size(); ++t) {
    const Triangle& c = e.surface.triangles[t];
    if (std::find(c.begin(), c.end(), v) == c.end()) continue;
    Vector3<double>& p = e.surface.points[as_size(v)];
    Vector3<double> corner = p;
    for (const Index m : e.mesh.tets[as_size(e.surface.tet[t])]) {
      const Vector3<double>& q = e.mesh.points[as_size(m)];
      if (length(q - p) > length(corner - p)) corner = q;
    }
    const auto coarse = std::find_if(
        e.certificate["levels"].begin(), e.certificate["levels"].end(), [&](const Json& level) {
          return level["distance"].is_null() ||
                 std::count(level["distance"]["coarse"].begin(), level["distance"]["coarse"].end(),
                            Json(e.surface.tet[t])) > 0;
        });
    if (coarse != e.certificate["levels"].end()) return false;
    p = p + 0.9 * (corner - p);
    for (Json& level : e.certificate["levels"]) level.erase("embedded"), level.erase("isotopic");
    return e.rehash(), true;
  }
  return false;
}

bool add_lone_vertex(Exhibit& e, Pick& pick) {
  e.surface.points.push_back(e.surface.points[pick.below(e.surface.points.size())]);
  drop_geometry(e);
  return make_consistent(e), true;
}

/// A triangle twice, or once more the other way round.
bool double_triangle(Exhibit& e, Pick& pick) {
  const std::size_t first = e.certificate["levels"].back()["triangles"][0];
  if (e.surface.triangles.size() == first) return false;
  const std::size_t t = first + pick.below(e.surface.triangles.size() - first);
  Triangle copy = e.surface.triangles[t];
  if (pick.coin()) std::swap(copy[0], copy[1]);
  e.surface.triangles.push_back(copy), e.surface.tet.push_back(e.surface.tet[t]);
  drop_geometry(e);
  return make_consistent(e), true;
}

/// One more level that is said to be empty.
bool add_empty_level(Exhibit& e, Pick& pick) {
  Json level = any_level(e, pick);
  if (level["edges"].empty()) return false;
  for (const char* list : {"undecided", "edges", "faces", "tets", "cones", "components"})
    level[list] = Json::array();
  const std::size_t points = e.surface.points.size(), triangles = e.surface.triangles.size();
  level["vertices"] = {points, 0}, level["triangles"] = {triangles, 0};
  level["distance"] = nullptr;
  level.erase("embedded"), level.erase("isotopic"), level.erase("stability");
  e.certificate["levels"].push_back(level);
  return true;
}

/// The triangles of a level claimed for the next one as well.
bool claim_twice(Exhibit& e, Pick& pick) {
  Json& levels = e.certificate["levels"];
  const Json copy = levels[pick.below(levels.size())];
  if (copy["edges"].empty()) return false;
  return levels.push_back(copy), true;
}

/// A sheet that crosses no edge says little about where it is: another one may fit its claims.
bool crosses_an_edge(const Exhibit& e) {
  for (const Json& level : e.certificate["levels"])
    if (level.contains("edges") && !level.at("edges").empty()) return true;
  return false;
}

/// Tensors with two components exchanged, such that modes and magnitudes change, with the hash made
/// right.
bool misread_components(Exhibit& e, Pick&) {
  if (!crosses_an_edge(e)) return false;
  for (auto& t : e.mesh.tensors) std::swap(t.xx, t.xy);
  drop_distances(e);
  return e.rehash(), true;
}

/// All vertices a little beside where they are, by more than they may be rounded.
bool shift_surface(Exhibit& e, Pick& pick) {
  if (!crosses_an_edge(e)) return false;
  const double by = std::ldexp(pick.step(), -40);
  for (auto& p : e.surface.points) p.x += by, p.y += 2 * by, p.z -= by;
  drop_distances(e);
  return e.rehash(), true;
}

/// Mesh and surface in a plane.
bool flatten(Exhibit& e, Pick& pick) {
  const auto axis = pick.below(3);
  const auto press = [&](Vector3<double>& p) { (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = 0; };
  for (auto& p : e.mesh.points) press(p);
  for (auto& p : e.surface.points) press(p);
  drop_geometry(e);
  return e.rehash(), true;
}

/// A tetrahedron is in the mesh twice, or has a vertex twice.
bool repeat_in_mesh(Exhibit& e, Pick& pick) {
  auto tet = e.mesh.tets[pick.below(e.mesh.tets.size())];
  if (pick.coin()) tet[0] = tet[1];
  e.mesh.tets.push_back(tet);
  e.certificate["input"]["tetrahedra"] = e.mesh.tets.size();
  return e.rehash(), true;
}

/// Two crossings of an edge exchanged, or both in one interval.
bool exchange_crossings(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  for (Json& edge : level["edges"]) {
    if (edge.size() < 4) continue;
    if (pick.coin()) {
      std::swap(edge[2][2], edge[3][2]);
    } else {
      edge[3][0] = edge[2][0], edge[3][1] = edge[2][1];
    }
    return true;
  }
  return false;
}

/// One loop of a sheet with several the other way round.
bool turn_one_loop(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  for (Json& tet : level["tets"])
    for (std::size_t s = 1; s < tet.size(); ++s) {
      if (tet[s].size() < 3) continue;
      Json& loop = tet[s][1 + pick.below(tet[s].size() - 1)];
      if (loop.size() < 4) continue;
      Json turned = Json::array({loop[0]});
      for (std::size_t i = loop.size() - 1; i > 0; --i) turned.push_back(loop[i]);
      if (std::exchange(loop, turned) != turned) return true;
    }
  return false;
}

/// A sheet that is no disc said to be isotopic, with no distance that shows where the level is.
bool claim_isotopy_without_distance(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (!level.contains("isotopic")) return false;
  const auto is_no_disc = [](const Json& tet) {
    return std::any_of(tet.begin() + 1, tet.end(),
                       [](const Json& sheet) { return sheet.size() > 2 || sheet[0] != 1; });
  };
  if (std::none_of(level["tets"].begin(), level["tets"].end(), is_no_disc)) return false;
  level["distance"] = nullptr;
  return level["isotopic"]["except"] = Json::array(), true;
}

/// The tip of a cone elsewhere.
bool move_tip(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["cones"].empty()) return false;
  const Json& cone = level["cones"][pick.below(level["cones"].size())];
  const Json& sheet = cone[1 + pick.below(cone.size() - 1)];
  auto& p = e.surface.points[sheet.back().get<std::size_t>()];
  p = p + 0x1p-40 * Vector3<double>{1, 2, 3};
  drop_geometry(e);
  return e.rehash(), true;
}

/// A crossing's claim moved to another edge of the mesh that is not crossed.
bool move_claim_of_edge(Exhibit& e, Pick& pick) {
  Json& edges = any_level(e, pick)["edges"];
  if (edges.empty()) return false;
  Json& edge = edges[pick.below(edges.size())];
  const Json before = edge;
  edge[pick.below(2)] = pick.below(e.mesh.points.size());
  if (edge[0] >= edge[1]) std::swap(edge[0], edge[1]);
  std::sort(edges.begin(), edges.end());
  return std::find(edges.begin(), edges.end(), before) == edges.end();
}

}  // namespace

std::vector<LieRow> lies_of_shapes() {
  return {
      {"a slit inside a tetrahedron", open_slit},
      {"two vertices as one", pinch},
      {"vertices inside exchange places", exchange_places},
      {"a vertex inside pulled out of the distance", pull_out},
      {"a vertex without triangles", add_lone_vertex},
      {"a triangle twice", double_triangle},
      {"a level said to be empty", add_empty_level},
      {"triangles claimed for two levels", claim_twice},
      {"tensors misread", misread_components},
      {"surface a little beside", shift_surface},
      {"mesh and surface in a plane", flatten},
      {"mesh: a tetrahedron or vertex twice", repeat_in_mesh},
      {"edges: crossings exchanged", exchange_crossings},
      {"tets: one loop of several turned", turn_one_loop},
      {"isotopic: no disc, and no distance", claim_isotopy_without_distance},
      {"cones: a tip elsewhere", move_tip},
      {"edges: of another edge", move_claim_of_edge},
  };
}

}  // namespace tensortopo::test
