// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "lies.hpp"
#include "tensortopo/hash/number_hash.hpp"

namespace tensortopo::test {

using Json = nlohmann::json;
using Index = SurfaceMesh::Index;
using Triangle = std::array<Index, 3>;

namespace {

/// Components of some triangles: which one each belongs to, by its smallest vertex.
std::vector<Index> components_of(const std::vector<Triangle>& triangles, std::size_t points) {
  std::vector<Index> root(points);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](Index i) {
    while (root[static_cast<std::size_t>(i)] != i) i = root[static_cast<std::size_t>(i)];
    return i;
  };
  for (const Triangle& t : triangles)
    for (const Index v : t) {
      const Index a = find(t[0]), b = find(v);
      root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  std::vector<Index> result;
  for (const Triangle& t : triangles) result.push_back(find(t[0]));
  return result;
}

/// The claims about the components of some triangles.
Json component_claims(const std::vector<Triangle>& triangles, std::size_t points) {
  struct Counts {
    std::set<Index> vertices;
    std::set<std::array<Index, 2>> edges, directed;
    std::size_t triangles = 0;
  };
  const auto of = components_of(triangles, points);
  std::map<Index, Counts> all;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Counts& c = all[of[t]];
    ++c.triangles;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      c.vertices.insert(a);
      c.edges.insert({std::min(a, b), std::max(a, b)});
      c.directed.insert({a, b});
    }
  }
  Json result = Json::array();
  for (const auto& [first, c] : all) {
    std::map<Index, Index> next;
    for (const auto& [a, b] : c.directed)
      if (!c.directed.contains({b, a})) next[a] = b;
    std::size_t loops = 0;
    while (!next.empty()) {
      ++loops;
      for (auto at = next.begin(); at != next.end();) {
        const Index to = at->second;
        next.erase(at);
        at = next.find(to);
      }
    }
    result.push_back({{"euler_characteristic", static_cast<long>(c.vertices.size() + c.triangles) -
                                                   static_cast<long>(c.edges.size())},
                      {"boundary_loops", loops},
                      {"orientable", true},
                      {"triangles", c.triangles},
                      {"first_vertex", first}});
  }
  return result;
}

}  // namespace

void make_consistent(Exhibit& e) {
  Json& levels = e.certificate["levels"];
  const std::size_t points = e.surface.points.size();
  Json& last = levels.back();
  last["vertices"][1] = points - last["vertices"][0].get<std::size_t>();
  last["triangles"][1] = e.surface.triangles.size() - last["triangles"][0].get<std::size_t>();
  for (Json& level : levels) {
    const std::size_t first = level["triangles"][0], count = level["triangles"][1];
    const auto begin = e.surface.triangles.begin() + static_cast<std::ptrdiff_t>(first);
    level["components"] =
        component_claims({begin, begin + static_cast<std::ptrdiff_t>(count)}, points);
    if (!level["distance"].is_null()) {
      Json& reach = level["distance"]["reach"];
      while (reach.size() < level["vertices"][1].get<std::size_t>()) reach.push_back(0);
    }
  }
  e.certificate["surface"]["vertices"] = points;
  e.certificate["surface"]["triangles"] = e.surface.triangles.size();
  e.rehash();
}

void drop_distances(Exhibit& e) {
  for (Json& level : e.certificate["levels"]) level["distance"] = nullptr, level.erase("isotopic");
}

namespace {

std::size_t any_triangle(const Exhibit& e, Pick& pick) {
  return pick.below(e.surface.triangles.size());
}

bool move_far(Exhibit& e, Pick& pick) {
  drop_distances(e);
  Vector3<double>& p = e.surface.points[pick.below(e.surface.points.size())];
  double size = 0;  // farther than anything in the mesh is from anything else
  for (const auto& q : e.mesh.points)
    size = std::max({size, 4 * std::abs(q.x), 4 * std::abs(q.y), 4 * std::abs(q.z)});
  const std::array kFar{1e300, 100 * size, size};
  (pick.coin() ? p.x : pick.coin() ? p.y : p.z) += pick.step() * kFar[pick.below(3)];
  return make_consistent(e), true;
}

/// A crossing off its edge, or out of its interval.
bool move_crossing(Exhibit& e, Pick& pick) {
  drop_distances(e);
  const Json& edges = any_level(e, pick)["edges"];
  if (edges.empty()) return false;
  const Json& edge = edges[pick.below(edges.size())];
  const Json& crossing = edge[2 + pick.below(edge.size() - 2)];
  const auto at = [&](const Json& i) -> const Vector3<double>& {
    return e.mesh.points[i.get<std::size_t>()];
  };
  const Vector3<double>&a = at(edge[0]), &b = at(edge[1]);
  Vector3<double>& p = e.surface.points[crossing[2].get<std::size_t>()];
  if (pick.coin()) {  // across the edge
    const double size = 1e-9 * (std::abs(b.x - a.x) + std::abs(b.y - a.y) + std::abs(b.z - a.z));
    p.x += size * (b.y - a.y + 0.3), p.y += size * (b.z - a.z + 0.7),
        p.z += size * (b.x - a.x + 1.1);
    return make_consistent(e), true;
  }
  if (crossing[1].get<int>() < 4) return false;
  const double t = pick.coin() ? 0 : 1;  // as far from the interval as one can get
  const Vector3<double> end = t == 0 ? a : b;
  if (crossing[0].is_string() || crossing[0] == 0 ||
      crossing[0] == (std::int64_t{1} << crossing[1].get<int>()) - 1)
    return false;
  return p = end, make_consistent(e), true;
}

/// A vertex on a curve of a face, off that.
bool move_off_face(Exhibit& e, Pick& pick) {
  drop_distances(e);
  const std::size_t t = any_triangle(e, pick);
  const Index v = e.surface.triangles[t][pick.below(3)];
  std::set<Index> tets;  // around it
  for (std::size_t i = 0; i < e.surface.triangles.size(); ++i)
    for (const Index w : e.surface.triangles[i])
      if (w == v) tets.insert(e.surface.tet[i]);
  if (tets.size() != 2) return false;  // crossings inside the mesh have more
  for (const Json& level : e.certificate["levels"]) {
    if (!level["cones"].empty()) return false;
    for (const Json& edge : level["edges"])
      for (std::size_t n = 2; n < edge.size(); ++n)
        if (edge[n][2] == v) return false;
  }
  const auto& tet = e.mesh.tets[static_cast<std::size_t>(e.surface.tet[t])];
  Vector3<double> middle{};
  for (const auto i : tet) {
    const Vector3<double>& q = e.mesh.points[static_cast<std::size_t>(i)];
    middle.x += q.x / 4, middle.y += q.y / 4, middle.z += q.z / 4;
  }
  Vector3<double>& p = e.surface.points[static_cast<std::size_t>(v)];
  p.x += 1e-9 * (middle.x - p.x), p.y += 1e-9 * (middle.y - p.y), p.z += 1e-9 * (middle.z - p.z);
  return make_consistent(e), true;
}

bool reverse_all(Exhibit& e, Pick& pick) {
  drop_distances(e);
  if (pick.coin()) {
    for (Triangle& t : e.surface.triangles) std::swap(t[1], t[2]);
  } else {
    const auto of = components_of(e.surface.triangles, e.surface.points.size());
    const Index which = of[any_triangle(e, pick)];
    for (std::size_t t = 0; t < of.size(); ++t)
      if (of[t] == which) std::swap(e.surface.triangles[t][1], e.surface.triangles[t][2]);
  }
  return make_consistent(e), true;
}

bool other_tet(Exhibit& e, Pick& pick) {
  drop_distances(e);
  const std::size_t t = any_triangle(e, pick);
  const auto other = static_cast<Index>(pick.below(e.mesh.tets.size() + 1));
  if (std::exchange(e.surface.tet[t], other) == other) return false;
  return make_consistent(e), true;
}

/// A hole: a triangle amid others of its tetrahedron.
bool remove_triangle(Exhibit& e, Pick& pick) {
  drop_distances(e);
  const std::size_t which = any_triangle(e, pick);
  std::size_t neighbours = 0;
  for (std::size_t s = 0; s < e.surface.triangles.size(); ++s) {
    std::size_t common = 0;
    for (const Index v : e.surface.triangles[s])
      common += static_cast<std::size_t>(
          std::count(e.surface.triangles[which].begin(), e.surface.triangles[which].end(), v));
    if (common == 2 && e.surface.tet[s] == e.surface.tet[which]) ++neighbours;
  }
  if (neighbours != 3) return false;
  const auto t = static_cast<std::ptrdiff_t>(which);
  e.surface.triangles.erase(e.surface.triangles.begin() + t);
  e.surface.tet.erase(e.surface.tet.begin() + t);
  for (Json& level : e.certificate["levels"]) {
    const std::ptrdiff_t first = level["triangles"][0], count = level["triangles"][1];
    if (t < first)
      level["triangles"][0] = first - 1;
    else if (t < first + count)
      level["triangles"][1] = count - 1;
  }
  return make_consistent(e), true;
}

bool turn_triangle(Exhibit& e, Pick& pick) {
  drop_distances(e);
  Triangle& t = e.surface.triangles[any_triangle(e, pick)];
  const Triangle before = t;
  switch (pick.below(3)) {
    case 0:
      std::swap(t[0], t[1]);
      break;
    case 1:
      t = e.surface.triangles[any_triangle(e, pick)];
      break;
    default:
      t[pick.below(3)] = static_cast<Index>(pick.below(e.surface.points.size()));
  }
  if (t == before) return false;
  return make_consistent(e), true;
}

/// One number of the field, its hash as it was.
bool change_field(Exhibit& e, Pick& pick) {
  const std::size_t v = pick.below(e.mesh.points.size());
  if (pick.coin()) return e.mesh.points[v].x = std::nextafter(e.mesh.points[v].x, 1e9), true;
  return e.mesh.tensors[v].xy += 0.5, true;
}

/// The tensors of two vertices at different sides exchanged, with the hash made right: other edges
/// of theirs are crossed an even number of times more.
bool exchange_tensors(Exhibit& e, Pick& pick) {
  const Json& edges = any_level(e, pick)["edges"];
  if (edges.empty()) return false;
  const Json& edge = edges[pick.below(edges.size())];
  if (edge.size() % 2 == 0) return false;
  std::swap(e.mesh.tensors[edge[0].get<std::size_t>()], e.mesh.tensors[edge[1].get<std::size_t>()]);
  return e.rehash(), true;
}

/// Wrong numbers in arrays that are claims, with the hashes made right.
bool change_array(Exhibit& e, Pick& pick) {
  if (!e.certificate["surface"].contains("arrays")) return false;
  if (pick.coin()) {
    auto& numbers = e.surface.mode.empty() ? e.surface.value : e.surface.mode;
    double& x = numbers[pick.below(numbers.size())];
    x = std::nextafter(x, pick.coin() ? 1e9 : -1e9);
  } else {
    e.surface.component[pick.below(e.surface.component.size())] += 1;
  }
  return e.rehash(), true;
}

/// Another vector of unit length, with the hash made right: a normal the other way round, or
/// across; an eigenvector of another eigenvalue, or of none.
bool change_vector(Exhibit& e, Pick& pick) {
  if (!e.certificate["surface"].contains("arrays") || e.surface.normal.empty()) return false;
  const std::size_t v = pick.below(e.surface.points.size());
  auto& normal = e.surface.normal[v];
  if (e.surface.medium_eigenvector.empty() || pick.coin()) {
    const Vector3<double> across{normal.y, normal.z, -normal.x};
    normal = pick.coin() ? -1.0 * normal : unit(cross(normal, across));
    return e.rehash(), true;
  }
  auto &medium = e.surface.medium_eigenvector[v], &dominant = e.surface.dominant_eigenvector[v];
  switch (pick.below(4)) {
    case 0:
      medium = unit(medium + dominant);
      break;
    case 1:
      medium = cross(medium, dominant);
      break;
    case 2:
      dominant = cross(medium, dominant);
      break;
    default:
      std::swap(medium, dominant);
  }
  return e.rehash(), true;
}

/// An array of a vector's name that is of the triangles, or has one number each; its hash is
/// listed.
bool misplace_vector(Exhibit& e, Pick& pick) {
  if (!e.certificate["surface"].contains("arrays")) return false;
  constexpr std::array kVectors{"normal", "medium_eigenvector", "dominant_eigenvector"};
  const std::string name = kVectors[pick.below(3)];
  const bool is_of_triangles = pick.coin();
  Json& hashes = e.certificate["surface"]["arrays"];
  if (!is_of_triangles) {
    const auto is_it = [&](const auto& a) { return a.of == "points" && a.name == name; };
    std::erase_if(e.arrays, is_it);
    for (std::size_t i = hashes.size(); i-- > 0;)
      if (hashes[i][0] == "points" && hashes[i][1] == name) hashes.erase(i);
  }
  const std::string of = is_of_triangles ? "triangles" : "points";
  const int width = is_of_triangles && pick.coin() ? 3 : 1;
  const std::size_t count = is_of_triangles ? e.surface.triangles.size() : e.surface.points.size();
  const std::vector<double> numbers(static_cast<std::size_t>(width) * count, 0.25);
  e.arrays.push_back({of, "Float64", name, width, numbers});
  hashes.push_back({of, name, width, numbers_sha256(numbers)});
  std::sort(hashes.begin(), hashes.end());
  return true;
}

}  // namespace

std::vector<LieRow> lies_of_files() {
  return {
      {"surface: a point far away", move_far},
      {"surface: a crossing elsewhere", move_crossing},
      {"surface: a vertex off its face", move_off_face},
      {"surface: orientation", reverse_all},
      {"surface: tet", other_tet},
      {"surface: a triangle less", remove_triangle},
      {"surface: a triangle otherwise", turn_triangle},
      {"surface: arrays mode, value, component", change_array},
      {"surface: eigenvectors, normals", change_vector},
      {"surface: vectors of triangles, or of one number", misplace_vector},
      {"field: a number", change_field},
      {"field: two tensors", exchange_tensors},
  };
}

}  // namespace tensortopo::test
