// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/subdivision_mesh.hpp"

#include <functional>
#include <map>
#include <unordered_map>
#include <utility>

#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

/// Even permutations (i, j, k, l) of the vertices of a tetrahedron, one for each i.
constexpr std::array<std::array<std::size_t, 4>, 4> kEven{
    {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};

template <class Scalar>
class Builder {
 public:
  explicit Builder(const Refinement<Scalar, 4>& refinement) : refinement_(refinement) {}

  SubdivisionMesh build() {
    for (std::uint32_t c = 0; c < refinement_.cells().size(); ++c)
      if (refinement_.cells()[c].alive) add_cell(c);
    find_components();
    trace_loops();
    return std::move(mesh_);
  }

 private:
  std::uint32_t node(std::uint32_t u, std::uint32_t v) {
    if (u > v) std::swap(u, v);
    const auto [found, added] = index_.try_emplace(std::uint64_t{u} << 32 | v,
                                                   static_cast<std::uint32_t>(mesh_.nodes.size()));
    if (added) {
      SubdivisionMesh::Node n{u, v, 0};
      const auto &a = refinement_.vertices()[u].weights, &b = refinement_.vertices()[v].weights;
      for (std::size_t f = 0; f < 4; ++f)
        if (a[f] == 0 && b[f] == 0) n.faces = static_cast<std::uint8_t>(n.faces | (1u << f));
      mesh_.nodes.push_back(n);
    }
    return found->second;
  }

  void add_cell(std::uint32_t c) {
    const auto& v = refinement_.cells()[c].vertices;
    std::array<bool, 4> above;
    int count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      above[i] = refinement_.vertices()[v[i]].above;
      count += above[i] ? 1 : 0;
    }
    if (count == 0 || count == 4) return;
    SubdivisionMesh::Polygon polygon;
    polygon.cell = c;
    if (count == 2) {
      // Even permutation with the two above first.
      std::array<std::size_t, 4> p{};
      std::size_t a = 0, b = 2;
      for (std::size_t i = 0; i < 4; ++i) p[above[i] ? a++ : b++] = i;
      int inversions = 0;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) inversions += p[i] > p[j] ? 1 : 0;
      if (inversions % 2) std::swap(p[2], p[3]);
      polygon.size = 4;
      polygon.nodes = {node(v[p[0]], v[p[2]]), node(v[p[1]], v[p[2]]), node(v[p[1]], v[p[3]]),
                       node(v[p[0]], v[p[3]])};
    } else {
      std::size_t lone = 0;
      while (above[lone] != (count == 1)) ++lone;
      auto p = kEven[lone];
      if (count == 1) std::swap(p[2], p[3]);  // normal towards the lone vertex, which is above
      polygon.size = 3;
      polygon.nodes = {node(v[lone], v[p[1]]), node(v[lone], v[p[2]]), node(v[lone], v[p[3]]), 0};
    }
    mesh_.polygons.push_back(polygon);
  }

  void find_components() {
    UnionFind classes(mesh_.nodes.size());
    std::unordered_map<std::uint64_t, int> edges;  // undirected
    for (const auto& polygon : mesh_.polygons)
      for (int i = 0; i < polygon.size; ++i) {
        const auto p = polygon.nodes[static_cast<std::size_t>(i)];
        const auto q = polygon.nodes[static_cast<std::size_t>((i + 1) % polygon.size)];
        ++edges[std::uint64_t{std::min(p, q)} << 32 | std::max(p, q)];
        classes.unite(p, q);
        const bool on_face = (mesh_.nodes[p].faces & mesh_.nodes[q].faces) != 0;
        if (on_face) next_on_boundary_[p] = q;
      }
    std::map<std::uint32_t, int> number;
    for (auto& polygon : mesh_.polygons) {
      const auto root = classes.find(polygon.nodes[0]);
      const auto [found, added] = number.try_emplace(root, static_cast<int>(number.size()));
      if (added) mesh_.components.emplace_back();
      polygon.component = found->second;
      ++mesh_.components[static_cast<std::size_t>(found->second)].euler_characteristic;
    }
    const auto of_node = [&](std::uint32_t n) -> SubdivisionMesh::Component& {
      return mesh_.components[static_cast<std::size_t>(number.at(classes.find(n)))];
    };
    for (std::uint32_t n = 0; n < mesh_.nodes.size(); ++n) ++of_node(n).euler_characteristic;
    for (const auto& [edge, uses] : edges)
      --of_node(static_cast<std::uint32_t>(edge >> 32)).euler_characteristic;
    component_of_ = [number, classes](std::uint32_t n) mutable {
      return number.at(classes.find(n));
    };
  }

  void trace_loops() {
    std::vector<char> seen(mesh_.nodes.size(), 0);
    for (std::uint32_t start = 0; start < mesh_.nodes.size(); ++start) {
      if (seen[start] || !next_on_boundary_.contains(start)) continue;
      std::vector<std::uint32_t> loop;
      for (auto n = start; !seen[n]; n = next_on_boundary_.at(n)) {
        seen[n] = 1;
        loop.push_back(n);
      }
      mesh_.components[static_cast<std::size_t>(component_of_(start))].boundary_loops.push_back(
          static_cast<int>(mesh_.boundary_loops.size()));
      mesh_.boundary_loops.push_back(std::move(loop));
    }
  }

  const Refinement<Scalar, 4>& refinement_;
  SubdivisionMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;
  std::unordered_map<std::uint32_t, std::uint32_t> next_on_boundary_;
  std::function<int(std::uint32_t)> component_of_;
};

}  // namespace

template <class Scalar>
SubdivisionMesh subdivision_mesh(const Refinement<Scalar, 4>& refinement) {
  return Builder<Scalar>(refinement).build();
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template SubdivisionMesh subdivision_mesh<Scalar>(const Refinement<Scalar, 4>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
