// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/surface_invariants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

/// One side of a triangle, filed under the smaller of its ends.
struct Side {
  Index larger;
  std::uint32_t triangle;
  std::uint8_t corner;  // where the side begins
  bool rising;          // from the smaller end to the larger
};

double area(const Vector3<double>& p, const Vector3<double>& q, const Vector3<double>& r) {
  const Vector3<double> n = cross(q - p, r - p);
  return elementary::hypot(n.x, n.y, n.z) / 2;
}

/// Unites the vertices of each triangle, and numbers the classes in the order of the triangles.
std::vector<Index> label_triangles(const SurfaceMesh& surface, UnionFind& regions,
                                   std::vector<Index>& label_of_region) {
  for (const auto& t : surface.triangles)
    for (std::size_t k = 1; k < 3; ++k)
      regions.unite(static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[k]));
  label_of_region.assign(surface.points.size(), -1);
  std::vector<Index> component;
  component.reserve(surface.triangles.size());
  Index next = 0;
  for (const auto& t : surface.triangles) {
    Index& here = label_of_region[regions.find(static_cast<std::uint32_t>(t[0]))];
    if (here < 0) here = next++;
    component.push_back(here);
  }
  return component;
}

class Survey {
 public:
  explicit Survey(const SurfaceMesh& surface)
      : surface_(surface),
        triangles_(surface.triangles.size()),
        corners_(3 * triangles_),
        regions_(surface.points.size()) {}

  SurfaceInvariants run() {
    check_indices();
    label_components();
    file_sides();
    visit_edges();
    count_fans();
    orient();
    count_loops();
    return finish();
  }

 private:
  using Part = SurfaceInvariants::Part;

  Index vertex(std::size_t triangle, std::size_t corner) const {
    return surface_.triangles[triangle][corner];
  }
  Part& part_of(std::size_t triangle) { return all_.parts[as_size(all_.component[triangle])]; }

  void check_indices() const {
    if (triangles_ > UINT32_MAX / 3)
      throw std::invalid_argument("surface_invariants: too many triangles");
    for (const auto& t : surface_.triangles)
      for (const Index v : t)
        if (v < 0 || as_size(v) >= surface_.points.size())
          throw std::invalid_argument("surface_invariants: a triangle names vertex " +
                                      std::to_string(v) + ", which does not exist");
  }

  void label_components() {
    all_.component = label_triangles(surface_, regions_, label_of_region_);
    for (std::size_t i = 0; i < triangles_; ++i) {
      const auto& t = surface_.triangles[i];
      if (as_size(all_.component[i]) == all_.parts.size()) all_.parts.emplace_back();
      Part& part = part_of(i);
      ++part.triangles, ++part.euler_characteristic;
      part.area += area(surface_.points[as_size(t[0])], surface_.points[as_size(t[1])],
                        surface_.points[as_size(t[2])]);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) part.manifold = false;
    }
  }

  template <class Visit>
  void for_each_side(const Visit& visit) const {
    for (std::size_t t = 0; t < triangles_; ++t)
      for (std::uint8_t k = 0; k < 3; ++k) {
        const Index p = vertex(t, k), q = vertex(t, k == 2 ? 0 : k + 1u);
        if (p != q)
          visit(std::min(p, q), Side{std::max(p, q), static_cast<std::uint32_t>(t), k, p < q});
      }
  }

  void file_sides() {
    drawer_.assign(surface_.points.size() + 1, 0);
    for_each_side([&](Index smaller, const Side&) { ++drawer_[as_size(smaller) + 1]; });
    for (std::size_t v = 1; v < drawer_.size(); ++v) drawer_[v] += drawer_[v - 1];
    sides_.resize(drawer_.back());
    std::vector<std::size_t> next(drawer_.begin(), drawer_.end() - 1);
    for_each_side(
        [&](Index smaller, const Side& side) { sides_[next[as_size(smaller)]++] = side; });
  }

  void visit_edges() {
    twin_.assign(corners_, none);
    for (std::size_t v = 0; v + 1 < drawer_.size(); ++v) {
      Side* first = sides_.data() + drawer_[v];
      Side* const last = sides_.data() + drawer_[v + 1];
      std::sort(first, last, [](const Side& s, const Side& t) {
        return s.larger != t.larger ? s.larger < t.larger : s.triangle < t.triangle;
      });
      while (first != last) {
        Side* end = first + 1;
        while (end != last && end->larger == first->larger) ++end;
        visit_edge(static_cast<Index>(v), first, end);
        first = end;
      }
    }
  }

  void visit_edge(Index smaller, const Side* first, const Side* last) {
    Part& part = part_of(first->triangle);
    --part.euler_characteristic;
    switch (last - first) {
      case 1:
        boundary_.emplace_back(smaller, first->larger);
        return;
      case 2: {
        const Side &s = first[0], &t = first[1];
        if (s.triangle == t.triangle) {  // a triangle that repeats a vertex
          part.manifold = false;
          return;
        }
        twin_[3u * s.triangle + s.corner] = 3u * t.triangle + t.corner;
        twin_[3u * t.triangle + t.corner] = 3u * s.triangle + s.corner;
        if (s.rising == t.rising) all_.consistently_oriented = false;
        if (vertex(s.triangle, (s.corner + 2u) % 3) == vertex(t.triangle, (t.corner + 2u) % 3))
          part.manifold = false;  // the same triangle twice
        return;
      }
      default:
        part.manifold = false;
    }
  }

  /// Unites the corners at a vertex across each inner edge: a vertex with one fan keeps one class.
  void count_fans() {
    UnionFind fans(corners_);
    std::vector<std::uint32_t> fans_at(surface_.points.size(), 0);
    for (const auto& t : surface_.triangles)
      for (const Index v : t) ++fans_at[as_size(v)];
    for (std::uint32_t h = 0; h < corners_; ++h) {
      const std::uint32_t g = twin_[h];
      if (g == none || g < h) continue;
      for (const std::uint32_t end : {h, next(h)}) {
        const Index v = vertex(end / 3, end % 3);
        const std::uint32_t other = vertex(g / 3, g % 3) == v ? g : next(g);
        if (fans.unite(end, other)) --fans_at[as_size(v)];
      }
    }
    for (std::size_t v = 0; v < fans_at.size(); ++v) {
      if (fans_at[v] == 0) continue;
      Part& part =
          all_.parts[as_size(label_of_region_[regions_.find(static_cast<std::uint32_t>(v))])];
      ++all_.vertices, ++part.euler_characteristic;
      if (fans_at[v] > 1) part.manifold = false;
    }
  }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

  /// Walks over inner edges, deciding for each triangle whether to turn it.
  void orient() {
    enum : char { unseen, keep, turn };
    std::vector<char> state(triangles_, unseen);
    std::vector<std::uint32_t> stack;
    for (std::size_t seed = 0; seed < triangles_; ++seed) {
      if (state[seed] != unseen) continue;
      state[seed] = keep;
      stack.push_back(static_cast<std::uint32_t>(seed));
      while (!stack.empty()) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
          const std::uint32_t g = twin_[h];
          if (g == none) continue;
          const bool agree = vertex(h / 3, h % 3) != vertex(g / 3, g % 3);
          const char wanted = (state[t] == keep) == agree ? keep : turn;
          if (state[g / 3] == unseen) {
            state[g / 3] = wanted;
            stack.push_back(g / 3);
          } else if (state[g / 3] != wanted) {
            part_of(t).orientable = false;
          }
        }
      }
    }
  }

  void count_loops() {
    UnionFind ends(surface_.points.size());
    std::vector<char> seen(surface_.points.size(), 0);
    for (const auto& [p, q] : boundary_) {
      const auto joined = ends.unite(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q));
      Part& part =
          all_.parts[as_size(label_of_region_[regions_.find(static_cast<std::uint32_t>(p))])];
      // Pieces of a graph: vertices less the edges that joined two pieces.
      for (const Index v : {p, q})
        if (!seen[as_size(v)]) seen[as_size(v)] = 1, ++part.boundary_loops;
      if (joined) --part.boundary_loops;
    }
  }

  SurfaceInvariants finish() {
    all_.components = all_.parts.size();
    all_.closed = boundary_.empty();
    for (Part& part : all_.parts) {
      all_.boundary_loops += part.boundary_loops;
      all_.euler_characteristic += part.euler_characteristic;
      all_.area += part.area;
      all_.orientable = all_.orientable && part.orientable;
      all_.manifold = all_.manifold && part.manifold;
      const long missing = 2 - part.euler_characteristic - part.boundary_loops;
      part.genus = !part.manifold ? -1 : part.orientable ? missing / 2 : missing;
    }
    return std::move(all_);
  }

  static constexpr std::uint32_t none = UINT32_MAX;

  const SurfaceMesh& surface_;
  std::size_t triangles_, corners_;
  UnionFind regions_;  // of vertices
  std::vector<Index> label_of_region_;
  std::vector<std::size_t> drawer_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t>
      twin_;  // of each side 3 t + k; none where the edge has not two triangles
  std::vector<std::pair<Index, Index>> boundary_;
  SurfaceInvariants all_;
};

}  // namespace

SurfaceInvariants surface_invariants(const SurfaceMesh& surface) { return Survey(surface).run(); }

std::vector<SurfaceMesh::Index> surface_components(const SurfaceMesh& surface) {
  UnionFind regions(surface.points.size());
  std::vector<Index> label_of_region;
  return label_triangles(surface, regions, label_of_region);
}

}  // namespace tensortopo
