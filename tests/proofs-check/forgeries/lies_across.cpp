// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "lies.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = SurfaceMesh::Index;
using Triangle = std::array<Index, 3>;

/// A handle: two triangles of a tetrahedron give way to a tube, and all claims are two less.
bool add_handle(Exhibit& e, Pick& pick) {
  Json& level = e.certificate["levels"].back();
  const std::size_t first = level["triangles"][0];
  auto& triangles = e.surface.triangles;
  if (triangles.size() < first + 2) return false;
  const std::size_t s = first + pick.below(triangles.size() - first),
                    t = first + pick.below(triangles.size() - first);
  const Triangle a = triangles[s], b = triangles[t];
  for (const Index v : a)
    if (std::find(b.begin(), b.end(), v) != b.end()) return false;
  if (e.surface.tet[s] != e.surface.tet[t]) return false;
  const auto c = [&](std::size_t i) { return b[(3 - i % 3) % 3]; };
  const Index tet = e.surface.tet[s];
  std::vector<Triangle> tube;
  for (std::size_t i = 0; i < 3; ++i) {
    tube.push_back({a[i], a[(i + 1) % 3], c(i)});
    tube.push_back({c(i + 1), c(i), a[(i + 1) % 3]});
  }
  triangles[s] = tube[0], triangles[t] = tube[1];
  for (std::size_t i = 2; i < 6; ++i) triangles.push_back(tube[i]), e.surface.tet.push_back(tet);
  for (Json& claim : level["tets"])
    if (claim[0] == tet && pick.coin()) claim[1][0] = claim[1][0].get<int>() - 2;
  level["distance"] = nullptr;
  return make_consistent(e), true;
}

/// A small closed surface that the level does not have, and its claim.
bool add_bubble(Exhibit& e, Pick& pick) {
  Json& level = e.certificate["levels"].back();
  const auto first = static_cast<Index>(e.surface.points.size());
  const std::size_t tet = pick.below(e.mesh.tets.size());
  std::array<Vector3<double>, 4> corners;
  Vector3<double> middle{};
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = e.mesh.points[static_cast<std::size_t>(e.mesh.tets[tet][i])];
    middle.x += corners[i].x / 4, middle.y += corners[i].y / 4, middle.z += corners[i].z / 4;
  }
  for (const Vector3<double>& p : corners)
    e.surface.points.push_back({middle.x + (p.x - middle.x) / 8, middle.y + (p.y - middle.y) / 8,
                                middle.z + (p.z - middle.z) / 8});
  const bool turned = pick.coin();
  for (Triangle t : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{0, 3, 2}, Triangle{1, 2, 3}}) {
    if (turned) std::swap(t[0], t[1]);
    for (Index& v : t) v += first;
    e.surface.triangles.push_back(t);
    e.surface.tet.push_back(static_cast<Index>(tet));
  }
  Json* found = nullptr;
  for (Json& claim : level["tets"])
    if (claim[0] == tet) found = &claim;
  if (found != nullptr) found->insert(found->begin() + 1, Json{2});
  level["distance"] = nullptr;
  return make_consistent(e), true;
}

/// A crossing's fan cut in two, inside the mesh, with a vertex for each part.
bool cut_fan(Exhibit& e, Pick& pick) {
  Json& level = e.certificate["levels"].back();
  if (level["edges"].empty()) return false;
  Json& edge = level["edges"][pick.below(level["edges"].size())];
  Json& crossing = edge[2 + pick.below(edge.size() - 2)];
  const Index v = crossing[2].get<Index>(), copy = static_cast<Index>(e.surface.points.size());
  std::vector<std::size_t> around;
  for (std::size_t t = 0; t < e.surface.triangles.size(); ++t)
    for (const Index w : e.surface.triangles[t])
      if (w == v) around.push_back(t);
  if (around.size() < 2) return false;
  const std::size_t t = around[pick.below(around.size())];
  std::replace(e.surface.triangles[t].begin(), e.surface.triangles[t].end(), v, copy);
  e.surface.points.push_back(e.surface.points[static_cast<std::size_t>(v)]);
  crossing.push_back(copy);
  level["distance"] = nullptr;
  return make_consistent(e), true;
}

/// T to -T and mode to -mode, with the hash made right: all true but for the side of larger modes.
bool negate(Exhibit& e, Pick&) {
  for (Json& level : e.certificate["levels"]) {
    if (!level.contains("mode")) return false;
    const std::string mode = level["mode"];
    level["mode"] = mode == "0" ? mode : mode[0] == '-' ? mode.substr(1) : '-' + mode;
    level["distance"] = nullptr;
  }
  for (auto& t : e.mesh.tensors) t = {-t.xx, -t.yy, -t.zz, -t.xy, -t.yz, -t.xz};
  return e.rehash(), true;
}

/// Mesh and surface mirrored: all true but for the triangles' turn.
bool mirror(Exhibit& e, Pick& pick) {
  const std::size_t axis = pick.below(3);
  const auto turn = [&](Vector3<double>& p) {
    double& x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    x = -x;
  };
  for (auto& p : e.mesh.points) turn(p);
  for (auto& p : e.surface.points) turn(p);
  for (Json& level : e.certificate["levels"]) level["distance"] = nullptr;
  return e.rehash(), true;
}

/// The surface outside the mesh, or of another size.
bool move_surface(Exhibit& e, Pick& pick) {
  const double factor = pick.coin() ? 1 : 1e6, by = factor == 1 ? 1e6 * pick.step() : 0;
  for (auto& p : e.surface.points) p = {factor * p.x + by, factor * p.y, factor * p.z};
  for (Json& level : e.certificate["levels"]) level["distance"] = nullptr;
  return e.rehash(), true;
}

bool exchange_levels(Exhibit& e, Pick&) {
  Json& levels = e.certificate["levels"];
  if (levels.size() < 2 || !levels[0].contains("mode") || !levels[1].contains("mode")) return false;
  std::swap(levels[0]["mode"], levels[1]["mode"]);
  return true;
}

/// Numbers of the vertices that stay, where others are taken out.
class Renumbering {
 public:
  explicit Renumbering(std::set<std::int64_t> gone) : gone_(std::move(gone)) {}
  bool is_gone(const Json& v) const { return gone_.contains(v.get<std::int64_t>()); }
  void apply(Json& v) const {
    const auto n = v.get<std::int64_t>();
    v = n - std::distance(gone_.begin(), gone_.lower_bound(n));
  }

 private:
  std::set<std::int64_t> gone_;
};

void erase_if(Json& list, std::size_t first, const std::function<bool(const Json&)>& is_gone) {
  for (std::size_t i = list.size(); i-- > first;)
    if (is_gone(list[i])) list.erase(i);
}

/// The claims without a component, as if it had never been.
void forget(Json& level, const Renumbering& r) {
  for (Json& edge : level["edges"]) {
    erase_if(edge, 2, [&](const Json& crossing) { return r.is_gone(crossing[2]); });
    for (std::size_t n = 2; n < edge.size(); ++n)
      for (std::size_t i = 2; i < edge[n].size(); ++i) r.apply(edge[n][i]);
  }
  erase_if(level["edges"], 0, [](const Json& edge) { return edge.size() == 2; });
  for (Json& face : level["faces"]) {
    erase_if(face[3], 0, [&](const Json& arc) { return r.is_gone(arc[0]); });
    erase_if(face[4], 0, [&](const Json& v) { return r.is_gone(v); });
    for (Json& arc : face[3])
      for (Json& v : arc) r.apply(v);
    for (Json& v : face[4]) r.apply(v);
  }
  erase_if(level["faces"], 0, [](const Json& face) { return face[3].empty() && face[4].empty(); });
  for (Json& tet : level["tets"]) {
    erase_if(tet, 1, [&](const Json& s) { return s.size() > 1 && r.is_gone(s[1][0]); });
    for (std::size_t s = 1; s < tet.size(); ++s)
      for (std::size_t l = 1; l < tet[s].size(); ++l)
        for (std::size_t i = 0; i < tet[s][l].size(); i += 2) r.apply(tet[s][l][i]);
  }
  erase_if(level["tets"], 0, [](const Json& tet) { return tet.size() == 1; });
}

/// A component of the surface left out, with all that is said of it.
bool leave_out_component(Exhibit& e, Pick& pick) {
  if (e.certificate["levels"].size() != 1) return false;
  Json& level = e.certificate["levels"][0];
  if (level["components"].empty() || !level["cones"].empty()) return false;
  std::set<std::int64_t> gone{
      level["components"][pick.below(level["components"].size())]["first_vertex"]
          .get<std::int64_t>()};
  for (std::size_t before = 0; before != gone.size();) {
    before = gone.size();
    for (const Triangle& t : e.surface.triangles)
      if (std::any_of(t.begin(), t.end(), [&](Index v) { return gone.contains(v); }))
        gone.insert(t.begin(), t.end());
  }
  const Renumbering r(gone);
  SurfaceMesh rest;
  for (std::size_t v = 0; v < e.surface.points.size(); ++v)
    if (!gone.contains(static_cast<std::int64_t>(v))) rest.points.push_back(e.surface.points[v]);
  for (std::size_t t = 0; t < e.surface.triangles.size(); ++t) {
    if (gone.contains(e.surface.triangles[t][0])) continue;
    Json corners = e.surface.triangles[t];
    for (Json& v : corners) r.apply(v);
    rest.triangles.push_back(corners.get<Triangle>());
    rest.tet.push_back(e.surface.tet[t]);
  }
  e.surface = std::move(rest);
  level["distance"] = nullptr;
  forget(level, r);
  return make_consistent(e), true;
}

/// Loops in the claims and triangles both the other way round.
bool reverse_with_claims(Exhibit& e, Pick&) {
  for (Triangle& t : e.surface.triangles) std::swap(t[1], t[2]);
  for (Json& level : e.certificate["levels"]) {
    level["distance"] = nullptr;
    for (Json& tet : level["tets"])
      for (std::size_t s = 1; s < tet.size(); ++s)
        for (std::size_t l = 1; l < tet[s].size(); ++l) {
          Json& loop = tet[s][l];
          Json turned = Json::array({loop[0]});
          for (std::size_t i = loop.size() - 1; i > 0; --i) turned.push_back(loop[i]);
          if (loop.size() > 2) loop = turned;
        }
  }
  return make_consistent(e), true;
}

/// All is said to be coarse, and a vertex moved far off.
bool move_under_coarse(Exhibit& e, Pick& pick) {
  for (Json& level : e.certificate["levels"]) {
    Json coarse = Json::array();
    const std::set<Index> tets(e.surface.tet.begin(), e.surface.tet.end());
    for (const Index t : tets) coarse.push_back(t);
    level["distance"] = {{"reach", Json(std::vector<int>(level["vertices"][1].get<std::size_t>()))},
                         {"bound", "0x1p-1"},
                         {"coarse", coarse},
                         {"coarse_bound", "0x1p+100"}};
  }
  auto& p = e.surface.points[pick.below(e.surface.points.size())];
  (pick.coin() ? p.x : p.z) += pick.step() * (pick.coin() ? 1e300 : 1e6);
  return e.rehash(), true;
}

}  // namespace

std::vector<LieRow> lies_across() {
  return {
      {"a handle in triangles and claims", add_handle},
      {"a closed surface in triangles and claims", add_bubble},
      {"a fan cut, and its vertices listed", cut_fan},
      {"field and modes negated", negate},
      {"mesh and surface mirrored", mirror},
      {"surface moved or scaled", move_surface},
      {"levels exchanged", exchange_levels},
      {"a component left out everywhere", leave_out_component},
      {"triangles and loops reversed", reverse_with_claims},
      {"far away, and coarse", move_under_coarse},
  };
}

}  // namespace tensortopo::test
