// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_checks.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <tuple>
#include <utility>

#include "support/oracles/lattice_counter.hpp"
#include "surface_check_parts.hpp"

namespace tensortopo::test {

namespace {

using Index = SurfaceMesh::Index;

// One side of one triangle, as it runs around the triangle.
struct Side {
  Index from, to;
  std::size_t triangle;
  std::pair<Index, Index> key() const { return std::minmax(from, to); }
};

// All sides, those of one edge next to each other.
std::vector<Side> sorted_sides(const SurfaceMesh& surface) {
  std::vector<Side> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({corners[i], corners[(i + 1) % 3], t});
  }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& s, const Side& u) { return s.key() < u.key(); });
  return sides;
}

// Calls visit(first, last) for the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].key() == sides[begin].key()) ++end;
    visit(begin, end);
    begin = end;
  }
}

bool check_arrays(const SurfaceMesh& surface, const TetMesh& mesh, Complaints& complaints) {
  const std::size_t vertices = surface.points.size(), triangles = surface.triangles.size();
  const std::array<std::pair<const char*, std::size_t>, 7> per_vertex{
      {{"carrier", surface.carrier.size()},
       {"carrier_id", surface.carrier_id.size()},
       {"medium_eigenvector", surface.medium_eigenvector.size()},
       {"dominant_eigenvector", surface.dominant_eigenvector.size()},
       {"normal", surface.normal.size()},
       {"mode", surface.mode.size()},
       {"residual", surface.residual.size()}}};
  bool usable = true;
  for (const auto& [name, size] : per_vertex) {
    if (size == vertices) continue;
    complaints.add("array length", name, " has ", size, " entries for ", vertices, " vertices");
    usable = false;
  }
  if (surface.tet.size() != triangles || surface.component.size() != triangles) {
    complaints.add("array length", "tet has ", surface.tet.size(), " and component ",
                   surface.component.size(), " entries for ", triangles, " triangles");
    return false;
  }
  std::set<std::array<Index, 3>> seen;
  std::vector<char> used(vertices, 0);
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<Index, 3> corners = surface.triangles[t];
    if (surface.tet[t] < 0 || as_size(surface.tet[t]) >= mesh.tets.size()) {
      complaints.add("index", "triangle ", t, " names tetrahedron ", surface.tet[t]);
      usable = false;
    }
    std::sort(corners.begin(), corners.end());
    if (corners[0] < 0 || as_size(corners[2]) >= vertices) {
      complaints.add("index", "triangle ", t, " names a vertex that does not exist");
      usable = false;
      continue;
    }
    if (corners[0] == corners[1] || corners[1] == corners[2]) {
      complaints.add("degenerate triangle", "triangle ", t, " repeats vertex ", corners[1]);
      usable = false;
    }
    if (!seen.insert(corners).second) {
      complaints.add("repeated triangle", "triangle ", t, " has the vertices of an earlier one");
    }
    for (const Index v : corners) used[as_size(v)] = 1;
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    if (used[v] == 0) complaints.add("unused vertex", "vertex ", v, " has no triangle");
  }
  return usable;
}

void check_edges(const SurfaceMesh& surface, const std::vector<Side>& sides,
                 const BoundaryOracle& on_boundary, Complaints& complaints, SurfaceReport& report) {
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    const Side& side = sides[begin];
    const auto [u, v] = side.key();
    if (end - begin > 2) {
      complaints.add("edge", "edge ", u, "-", v, " has ", end - begin, " triangles");
    } else if (end - begin == 2) {
      if (side.from == sides[begin + 1].from) {
        complaints.add("orientation", "triangles ", side.triangle, " and ",
                       sides[begin + 1].triangle, " run along edge ", u, "-", v, " the same way");
      }
    } else {
      ++report.boundary_edges;
      if (!on_boundary(u, v, surface.tet[side.triangle])) {
        complaints.add("open edge", "edge ", u, "-", v, " of triangle ", side.triangle,
                       " has one triangle and is not on the boundary of the domain");
      }
    }
  });
}

void check_links(const SurfaceMesh& surface, Complaints& complaints) {
  std::vector<std::vector<std::pair<Index, Index>>> links(surface.points.size());
  for (const auto& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      links[as_size(t[i])].emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
    }
  }
  for (std::size_t v = 0; v < links.size(); ++v) {
    std::map<Index, int> node;  // of the link, with its number in `sets`
    UnionFind sets;
    std::vector<int> degree;
    const auto number = [&](Index w) {
      const auto [entry, is_new] = node.try_emplace(w, sets.size());
      if (is_new) sets.add(), degree.push_back(0);
      return entry->second;
    };
    for (const auto& [p, q] : links[v]) {
      const int i = number(p), j = number(q);
      sets.unite(i, j);
      ++degree[static_cast<std::size_t>(i)], ++degree[static_cast<std::size_t>(j)];
    }
    int parts = 0, ends = 0, branches = 0;
    for (int i = 0; i < sets.size(); ++i) {
      parts += sets.find(i) == i;
      ends += degree[static_cast<std::size_t>(i)] == 1;
      branches += degree[static_cast<std::size_t>(i)] > 2;
    }
    if (parts > 1 || branches > 0 || (ends != 0 && ends != 2)) {
      complaints.add("vertex link", "the link of vertex ", v, " has ", parts, " parts, ", ends,
                     " ends and ", branches, " branchings");
    }
  }
}

// Components of the union of the triangles, each triangle given its component's root.
std::vector<int> roots_of_triangles(const SurfaceMesh& surface) {
  UnionFind sets;
  for (std::size_t v = 0; v < surface.points.size(); ++v) sets.add();
  for (const auto& t : surface.triangles) sets.unite(t[0], t[1]), sets.unite(t[0], t[2]);
  std::vector<int> roots;
  for (const auto& t : surface.triangles) roots.push_back(sets.find(t[0]));
  return roots;
}

void check_labels(const SurfaceMesh& surface, Complaints& complaints) {
  const std::vector<int> roots = roots_of_triangles(surface);
  std::map<int, Index> label;
  for (std::size_t t = 0; t < roots.size(); ++t) {
    const Index expected =
        label.try_emplace(roots[t], static_cast<Index>(label.size())).first->second;
    if (surface.component[t] != expected) {
      complaints.add("component label", "triangle ", t, " is labelled ", surface.component[t],
                     " but lies in component ", expected);
    }
  }
}

void check_coincidence(const SurfaceMesh& surface, const TetMesh& mesh, Complaints& complaints) {
  std::map<std::tuple<double, double, double>, std::size_t> seen;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    if (has_no_mode(surface, mesh, v)) continue;  // one vertex for each fan
    const auto& p = surface.points[v];
    const auto [entry, is_new] = seen.try_emplace({p.x, p.y, p.z}, v);
    if (!is_new) {
      complaints.add("coincident vertices", "vertices ", entry->second, " and ", v,
                     " are one point");
    }
  }
}

}  // namespace

std::vector<ComponentTopology> surface_topology(const SurfaceMesh& surface) {
  const std::vector<int> roots = roots_of_triangles(surface);
  std::map<int, ComponentTopology> components;
  std::set<Index> counted;
  for (std::size_t t = 0; t < roots.size(); ++t) {
    ComponentTopology& component = components[roots[t]];
    component.euler += 1;
    for (const Index v : surface.triangles[t]) component.euler += counted.insert(v).second;
  }
  const std::vector<Side> sides = sorted_sides(surface);
  UnionFind boundary;
  for (std::size_t v = 0; v < surface.points.size(); ++v) boundary.add();
  std::map<Index, int> on_boundary;  // vertices, with the root of their component
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    const int root = roots[sides[begin].triangle];
    components[root].euler -= 1;
    if (end - begin != 1) return;
    boundary.unite(sides[begin].from, sides[begin].to);
    on_boundary[sides[begin].from] = on_boundary[sides[begin].to] = root;
  });
  for (const auto& [v, root] : on_boundary) components[root].loops += boundary.find(v) == v;
  std::vector<ComponentTopology> result;
  for (const auto& [root, component] : components) result.push_back(component);
  std::sort(result.begin(), result.end());
  return result;
}

SurfaceReport check_surface(const SurfaceMesh& surface, const TetMesh& mesh,
                            const SurfaceCheckOptions& options) {
  SurfaceReport report;
  Complaints complaints(options.spelled_out);
  if (check_arrays(surface, mesh, complaints)) {
    const BoundaryOracle on_boundary(surface, mesh, options);
    check_edges(surface, sorted_sides(surface), on_boundary, complaints, report);
    check_links(surface, complaints);
    check_labels(surface, complaints);
    if (check_finite(surface, mesh, complaints)) {
      check_coincidence(surface, mesh, complaints);
      check_normals(surface, options, complaints, report);
      if (options.check_residuals) check_modes(surface, mesh, options, complaints, report);
    }
    report.components = surface_topology(surface);
  }
  report.violations = complaints.take();
  return report;
}

std::ostream& operator<<(std::ostream& out, const SurfaceReport& report) {
  for (const auto& violation : report.violations) out << violation << '\n';
  out << report.components.size() << " components:";
  for (const auto& c : report.components) out << ' ' << c;
  const auto& r = report.residuals;
  return out << "\n"
             << report.boundary_edges << " boundary edges, " << report.opposed_normals
             << " opposed normals; residual at most " << r.largest << " on " << r.evaluated
             << " corners, " << r.above << " above tolerance, " << r.explained
             << " of them explained\n";
}

}  // namespace tensortopo::test
