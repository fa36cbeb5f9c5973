// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include "lies.hpp"

namespace tensortopo::test {

using Json = nlohmann::json;

Json& any_level(Exhibit& e, Pick& pick) {
  Json& levels = e.certificate["levels"];
  return levels[pick.below(levels.size())];
}

namespace {

/// Any entry of a list of a level; null if it is empty.
Json* any_entry(Json& list, Pick& pick) {
  return list.empty() ? nullptr : &list[pick.below(list.size())];
}

bool change_digit(Json& text, Pick& pick) {
  auto& digits = text.get_ref<std::string&>();
  char& c = digits[pick.below(digits.size())];
  c = c == '0' ? '1' : '0';
  return true;
}

LieRow top(const char* name, const char* object, const char* key, Json lie) {
  return {name, [=](Exhibit& e, Pick&) {
            Json& value = (*object != 0 ? e.certificate[object] : e.certificate)[key];
            return std::exchange(value, lie) != lie;
          }};
}

LieRow counted(const char* name, const char* object, const char* key) {
  return {name, [=](Exhibit& e, Pick& pick) {
            return add(e.certificate[object][key], pick.step()), true;
          }};
}

/// A lie about any entry of a list of any level.
LieRow entry(const std::string& name, const char* list,
             const std::function<bool(Json& entry, Json& level, Pick&)>& tell) {
  return {name, [=](Exhibit& e, Pick& pick) {
            Json& level = any_level(e, pick);
            Json* const found = any_entry(level[list], pick);
            return found != nullptr && tell(*found, level, pick);
          }};
}

/// An entry left out, or given twice.
LieRow whole(const std::string& name, const char* list) {
  return {name + ": an entry", [=](Exhibit& e, Pick& pick) {
            Json& entries = any_level(e, pick)[list];
            if (entries.empty()) return false;
            const std::size_t i = pick.below(entries.size());
            if (pick.coin()) return entries.erase(i), true;
            const Json copy = entries[i];
            return entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(i), copy), true;
          }};
}

std::set<std::int64_t> vertices_of_crossings(const Json& level) {
  std::set<std::int64_t> result;
  for (const Json& edge : level["edges"])
    for (std::size_t n = 2; n < edge.size(); ++n)
      for (std::size_t i = 2; i < edge[n].size(); ++i)
        result.insert(edge[n][i].get<std::int64_t>());
  return result;
}

bool tell_other_mode(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["edges"].empty()) return false;
  if (!level.contains("mode")) {
    level["value"] = level["invariant"] == "anisotropy" ? "1/100" : "1000";
    return true;
  }
  const std::vector<std::string> modes{"0", "1/4", "-1/2", "9/10", "-9/10"};
  const std::string mode = modes[pick.below(modes.size())];
  return std::exchange(level["mode"], mode) != mode;
}

bool tell_range(Exhibit& e, Pick& pick) {
  Json& range = any_level(e, pick)[pick.coin() ? "vertices" : "triangles"];
  return add(range[pick.below(2)], pick.step()), true;
}

bool tell_undecided(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  if (level["tets"].empty()) return false;
  const Json tet = level["tets"][pick.below(level["tets"].size())][0];
  level["undecided"].push_back({tet, pick.coin() ? "budget_exhausted" : "no_reason"});
  if (pick.coin()) level["undecided"].back()[0] = 1000000;
  return true;
}

bool tell_interval(Json& edge, Json&, Pick& pick) {
  Json& crossing = edge[2 + pick.below(edge.size() - 2)];
  if (crossing[0].is_string()) return false;
  switch (pick.below(3)) {
    case 0:
      return add(crossing[0], pick.step()), true;
    case 1:
      return crossing[0] != 0 && (add(crossing[1], 1), true);
    default:
      return crossing[0] != 0 && crossing[0] != (1LL << crossing[1].get<int>()) - 1 &&
             (crossing[0] = 0, true);
  }
}

bool tell_vertex_of_crossing(Json& edge, Json& level, Pick& pick) {
  Json& crossing = edge[2 + pick.below(edge.size() - 2)];
  const std::int64_t count = level["vertices"][1], first = level["vertices"][0];
  const std::int64_t other =
      first + static_cast<std::int64_t>(pick.below(static_cast<std::size_t>(count)));
  return std::exchange(crossing[2], other) != other;
}

/// A vertex inside a piece, or on an arc, given to a crossing as if fans met there.
bool tell_further_vertex(Json& edge, Json& level, Pick& pick) {
  const auto crossings = vertices_of_crossings(level);
  const std::int64_t count = level["vertices"][1], first = level["vertices"][0];
  const std::int64_t other =
      first + static_cast<std::int64_t>(pick.below(static_cast<std::size_t>(count)));
  Json& crossing = edge[2 + pick.below(edge.size() - 2)];
  if (crossings.contains(other) || other <= crossing.back()) return false;
  return crossing.push_back(other), true;
}

bool tell_crossed_edge(Exhibit& e, Pick& pick) {
  Json& level = any_level(e, pick);
  const auto& tet = e.mesh.tets[pick.below(e.mesh.tets.size())];
  std::array<std::int64_t, 2> ends{tet[pick.below(4)], tet[pick.below(4)]};
  std::sort(ends.begin(), ends.end());
  Json& edges = level["edges"];
  const auto place =
      std::lower_bound(edges.begin(), edges.end(), ends, [](const Json& x, const auto& y) {
        return std::array{x[0].get<std::int64_t>(), x[1].get<std::int64_t>()} < y;
      });
  if (ends[0] == ends[1] || level["vertices"][1] == 0) return false;
  if (place != edges.end() && (*place)[0] == ends[0] && (*place)[1] == ends[1]) return false;
  return edges.insert(place, Json{ends[0], ends[1], {0, 0, level["vertices"][0]}}), true;
}

bool tell_arc(Json& face, Json& level, Pick& pick) {
  Json& arcs = face[3];
  if (arcs.empty()) return false;
  const std::size_t i = pick.below(arcs.size());
  if (arcs.size() > 1 && pick.coin()) {
    const Json before = arcs;
    std::swap(arcs[i][1], arcs[(i + 1) % arcs.size()][pick.below(2)]);
    for (Json& arc : arcs) std::sort(arc.begin(), arc.end());
    std::sort(arcs.begin(), arcs.end());
    return arcs != before;
  }
  if (pick.coin()) return arcs.erase(i), true;
  const auto crossings = vertices_of_crossings(level);
  auto other = crossings.begin();
  std::advance(other, pick.below(crossings.size()));
  const Json before = arcs[i];
  arcs[i][pick.below(2)] = *other;
  std::sort(arcs[i].begin(), arcs[i].end());
  return arcs[i] != before;
}

bool tell_closed_curve(Json& face, Json& level, Pick& pick) {
  Json& loops = face[4];
  const std::int64_t first = level["vertices"][0], count = level["vertices"][1];
  const std::int64_t other =
      first + static_cast<std::int64_t>(pick.below(static_cast<std::size_t>(count)));
  if (!loops.empty() && pick.coin()) return loops.erase(pick.below(loops.size())), true;
  if (std::find(loops.begin(), loops.end(), other) != loops.end()) return false;
  if (!loops.empty() && pick.coin())
    loops[pick.below(loops.size())] = other;
  else
    loops.push_back(other);
  return std::sort(loops.begin(), loops.end()), true;
}

Json* any_sheet(Json& tet, Pick& pick) { return &tet[1 + pick.below(tet.size() - 1)]; }

bool tell_characteristic(Json& tet, Json&, Pick& pick) {
  add((*any_sheet(tet, pick))[0], pick.step() * static_cast<int>(1 + pick.below(2)));
  return true;
}

bool tell_loop(Json& tet, Json&, Pick& pick) {
  Json& sheet = *any_sheet(tet, pick);
  if (sheet.size() < 2) return sheet.push_back(Json{0, tet[0]}), true;
  const std::size_t l = 1 + pick.below(sheet.size() - 1);
  Json& loop = sheet[l];
  switch (pick.below(3)) {
    case 0:
      return sheet.erase(l), true;
    case 1: {  // the other way round
      if (loop.size() < 4) return false;
      Json turned = Json::array({loop[0]});
      for (std::size_t i = loop.size() - 1; i > 0; --i) turned.push_back(loop[i]);
      return std::exchange(loop, turned) != turned;
    }
    default: {
      Json& face = loop[1 + 2 * pick.below(loop.size() / 2)];
      return add(face, 1 + static_cast<int>(pick.below(3))), true;
    }
  }
}

bool tell_sheets(Json& tet, Json&, Pick& pick) {
  if (tet.size() < 3) return tet.push_back(Json{2}), true;
  if (pick.coin()) {  // two sheets as one, the sum of characteristics or an annulus
    Json merged = tet[1];
    for (std::size_t l = 1; l < tet[2].size(); ++l) merged.push_back(tet[2][l]);
    std::sort(merged.begin() + 1, merged.end());
    add(merged[0], tet[2][0].get<std::int64_t>() - (pick.coin() ? 2 : 0));
    tet.erase(2);
    return tet[1] = merged, true;
  }
  if (tet[1].size() < 2 || tet[2].size() < 2) return false;
  std::swap(tet[1].back(), tet[2].back());  // loops of other sheets
  return tet[1].size() > 2 || tet[2].size() > 2;
}

bool tell_cone(Json& tet, Json& level, Pick& pick) {
  Json& sheet = *any_sheet(tet, pick);
  Json& any = sheet[pick.below(sheet.size())];
  const std::int64_t other =
      level["vertices"][0].get<std::int64_t>() +
      static_cast<std::int64_t>(pick.below(level["vertices"][1].get<std::size_t>()));
  if (sheet.size() == 4 && pick.coin()) return std::swap(sheet[1], sheet[3]), true;
  return std::exchange(any, other) != other;
}

bool tell_component(Json& component, Json&, Pick& pick) {
  constexpr std::array kKeys{"euler_characteristic", "boundary_loops", "triangles", "first_vertex"};
  if (pick.below(5) == 0) return component["orientable"] = false, true;
  return add(component[kKeys[pick.below(4)]], pick.step()), true;
}

bool tell_array(Exhibit& e, Pick& pick) {
  Json& surface = e.certificate["surface"];
  if (!surface.contains("arrays") || surface["arrays"].empty()) return false;
  Json& arrays = surface["arrays"];
  Json& array = arrays[pick.below(arrays.size())];
  switch (pick.below(4)) {
    case 0:
      return change_digit(array[3], pick);
    case 1:
      return arrays.erase(pick.below(arrays.size())), true;
    case 2:
      return add(array[2], 1), true;
    default:
      array[1] = array[1].get<std::string>() + "_";
      return true;
  }
}

}  // namespace

std::vector<LieRow> lies_of_claims() {
  return {
      top("format", "", "format", "certificate"),
      top("version", "", "version", 2),
      top("input.tensor", "input", "tensor", "strain"),
      {"input.components",
       [](Exhibit& e, Pick& pick) {
         constexpr std::array kOrders{"voigt", "abaqus", "nifti", "fsl", "full", "nye"};
         return e.certificate["input"]["components"] = kOrders[pick.below(6)], true;
       }},
      counted("input.points", "input", "points"),
      counted("input.tetrahedra", "input", "tetrahedra"),
      {"input.sha256",
       [](Exhibit& e, Pick& p) { return change_digit(e.certificate["input"]["sha256"], p); }},
      counted("surface.vertices", "surface", "vertices"),
      counted("surface.triangles", "surface", "triangles"),
      {"surface.sha256",
       [](Exhibit& e, Pick& p) { return change_digit(e.certificate["surface"]["sha256"], p); }},
      {"surface.arrays", tell_array},
      {"levels: none",
       [](Exhibit& e, Pick&) { return e.certificate["levels"] = Json::array(), true; }},
      {"mode, invariant, value", tell_other_mode},
      {"vertices, triangles", tell_range},
      {"on_level", [](Exhibit& e, Pick& p) { return add(any_level(e, p)["on_level"], 1), true; }},
      {"undecided", tell_undecided},
      whole("edges", "edges"),
      entry("edges: interval", "edges", tell_interval),
      entry("edges: vertex", "edges", tell_vertex_of_crossing),
      entry("edges: further vertices", "edges", tell_further_vertex),
      {"edges: one more", tell_crossed_edge},
      whole("faces", "faces"),
      entry("faces: arcs", "faces", tell_arc),
      entry("faces: closed curves", "faces", tell_closed_curve),
      whole("tets", "tets"),
      entry("tets: Euler characteristic", "tets", tell_characteristic),
      entry("tets: loops", "tets", tell_loop),
      entry("tets: sheets", "tets", tell_sheets),
      whole("cones", "cones"),
      entry("cones: vertices", "cones", tell_cone),
      whole("components", "components"),
      entry("components: numbers", "components", tell_component),
  };
}

}  // namespace tensortopo::test
