// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "crossed_cells.hpp"
#include "differing_pieces.hpp"
#include "piece_messages.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

/// A vertex or side of one of the seams.
struct InSeam {
  std::size_t seam, place;
};

void add(JoinedSeams::Component& sum, const JoinedSeams::Component& more) {
  sum.vertices += more.vertices, sum.triangles += more.triangles;
  sum.euler_characteristic += more.euler_characteristic;
  sum.boundary_loops += more.boundary_loops;
}

class Joiner {
 public:
  explicit Joiner(std::span<const SurfaceSeam> seams) : seams_(seams) {
    std::uint32_t components = 0, borders = 0;
    for (const SurfaceSeam& seam : seams) {
      first_component_.push_back(components), first_border_.push_back(borders);
      components += static_cast<std::uint32_t>(seam.components.size());
      for (const auto& vertex : seam.vertices)
        borders =
            std::max(borders, first_border_.back() + static_cast<std::uint32_t>(vertex.border + 1));
      vertex_.emplace_back(seam.vertices.size(), 0u);
    }
    classes_ = UnionFind(components);
    counts_.resize(components);
    all_borders_ = borders;
  }

  JoinedSeams run() {
    add_components();
    join_vertices();
    borders_ = UnionFind(all_borders_ + vertices_.size());
    has_border_.assign(borders_.size(), 0);
    join_sides();
    count_loops();
    number_components();
    return std::move(result_);
  }

 private:
  using Component = JoinedSeams::Component;

  std::uint32_t component(std::size_t seam, Index number) const {
    return first_component_[seam] + static_cast<std::uint32_t>(number);
  }
  const SurfaceSeam::Vertex& vertex(const InSeam& at) const {
    return seams_[at.seam].vertices[at.place];
  }
  const SurfaceSeam::Side& side(const InSeam& at) const { return seams_[at.seam].sides[at.place]; }

  /// As if they had nothing in common.
  void add_components() {
    for (std::size_t s = 0; s < seams_.size(); ++s)
      for (std::size_t c = 0; c < seams_[s].components.size(); ++c) {
        const auto& own = seams_[s].components[c];
        counts_[first_component_[s] + c] = {own.vertices, own.triangles, own.euler_characteristic,
                                            own.closed_borders};
      }
  }

  /// Finds which vertices are one. These are in one component, and are counted once.
  void join_vertices() {
    std::vector<InSeam> all;
    for (std::size_t s = 0; s < seams_.size(); ++s)
      for (std::size_t v = 0; v < seams_[s].vertices.size(); ++v) all.push_back({s, v});
    const auto key = [&](const InSeam& at) {
      return std::tie(vertex(at).carrier_ids, vertex(at).ordinal);
    };
    std::sort(all.begin(), all.end(), [&](const InSeam& a, const InSeam& b) {
      return std::tuple_cat(key(a), std::tie(a.seam)) < std::tuple_cat(key(b), std::tie(b.seam));
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
      const InSeam& at = all[i];
      if (i == 0 || key(all[i - 1]) != key(at)) {
        vertices_.push_back(at);
      } else {
        const InSeam& first = vertices_.back();
        if (vertex(first).digest != vertex(at).digest)
          refuse_simplex("they differ", vertex(at).carrier_ids);
        const auto own = component(at.seam, vertex(at).component);
        classes_.unite(component(first.seam, vertex(first).component), own);
        --counts_[own].vertices, --counts_[own].euler_characteristic;
      }
      vertex_[at.seam][at.place] = static_cast<std::uint32_t>(vertices_.size() - 1);
    }
  }

  /// The ends of a side, in `vertices_`.
  std::array<std::uint32_t, 2> ends(const InSeam& at) const {
    return {vertex_[at.seam][as_size(side(at).from)], vertex_[at.seam][as_size(side(at).to)]};
  }

  /// Edges that several pieces have are counted once; those with one triangle are on a border.
  void join_sides() {
    std::vector<InSeam> all;
    for (std::size_t s = 0; s < seams_.size(); ++s) {
      unresolved_.insert(unresolved_.end(), seams_[s].unresolved.begin(),
                         seams_[s].unresolved.end());
      for (std::size_t i = 0; i < seams_[s].sides.size(); ++i) all.push_back({s, i});
    }
    std::sort(unresolved_.begin(), unresolved_.end());
    const auto edge = [&](const InSeam& at) {
      const auto [from, to] = ends(at);
      return std::pair(std::min(from, to), std::max(from, to));
    };
    std::sort(all.begin(), all.end(), [&](const InSeam& a, const InSeam& b) {
      return std::tuple(edge(a), a.seam, a.place) < std::tuple(edge(b), b.seam, b.place);
    });
    for (std::size_t i = 0; i < all.size();) {
      std::size_t next = i + 1;
      while (next < all.size() && edge(all[next]) == edge(all[i])) {
        if (all[next].seam != all[next - 1].seam)
          ++counts_[component_of(all[next])].euler_characteristic;
        ++next;
      }
      const std::span edges(all.data() + i, next - i);
      for (const InSeam& at : edges) require_partner(at, edges);
      if (edges.size() == 1) add_border(edges.front());
      i = next;
    }
  }

  std::uint32_t component_of(const InSeam& at) const {
    return component(at.seam, seams_[at.seam].vertices[as_size(side(at).from)].component);
  }

  /// @param edges  all sides with these ends
  void require_partner(const InSeam& at, std::span<const InSeam> edges) const {
    const std::int64_t ghost = side(at).ghost_id;
    if (ghost < 0 || std::binary_search(unresolved_.begin(), unresolved_.end(), ghost)) return;
    const auto from = ends(at)[0];
    if (std::none_of(edges.begin(), edges.end(),
                     [&](const InSeam& other) { return ends(other)[1] == from; }))
      refuse_sides(side(at).cell_id, ghost);
  }

  void add_border(const InSeam& at) {
    const auto [from, to] = ends(at);
    borders_.unite(all_borders_ + from, all_borders_ + to);
    has_border_[all_borders_ + from] = has_border_[all_borders_ + to] = 1;
  }

  void count_loops() {
    for (std::size_t s = 0; s < seams_.size(); ++s)
      for (std::size_t v = 0; v < seams_[s].vertices.size(); ++v) {
        const Index border = seams_[s].vertices[v].border;
        if (border < 0) continue;
        const auto at = all_borders_ + vertex_[s][v];
        borders_.unite(first_border_[s] + static_cast<std::uint32_t>(border), at);
        has_border_[at] = 1;
      }
    std::vector<char> is_counted(borders_.size(), 0);
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (has_border_[all_borders_ + v] == 0) continue;
      if (std::exchange(is_counted[borders_.find(all_borders_ + v)], 1) != 0) continue;
      const InSeam& at = vertices_[v];
      ++counts_[component(at.seam, vertex(at).component)].boundary_loops;
    }
  }

  /// By the canonical order of the tetrahedra of first triangles; those of one tetrahedron are
  /// in one piece, in order.
  void number_components() {
    const CrossedCells cells = crossed_cells(seams_);
    const auto rank = inverse_permutation(canonical_mesh(cells.mesh).tets);
    std::vector<std::pair<Index, std::uint32_t>> order;
    for (std::size_t s = 0; s < seams_.size(); ++s)
      for (std::size_t c = 0; c < seams_[s].components.size(); ++c)
        order.emplace_back(rank[cells.first_tet[s] + as_size(seams_[s].components[c].first_tet)],
                           component(s, static_cast<Index>(c)));
    std::sort(order.begin(), order.end());
    std::vector<Index> number(counts_.size(), -1);  // of classes
    for (const auto& [place, c] : order) {
      Index& known = number[classes_.find(c)];
      if (known < 0) {
        known = static_cast<Index>(result_.components.size());
        result_.components.emplace_back();
      }
      add(result_.components[as_size(known)], counts_[c]);
    }
    for (std::size_t s = 0; s < seams_.size(); ++s) {
      auto& numbers = result_.numbers.emplace_back();
      for (std::size_t c = 0; c < seams_[s].components.size(); ++c)
        numbers.push_back(number[classes_.find(component(s, static_cast<Index>(c)))]);
    }
  }

  std::span<const SurfaceSeam> seams_;
  std::vector<std::uint32_t> first_component_, first_border_;  ///< of each seam
  std::uint32_t all_borders_ = 0;                              ///< how many all seams have
  UnionFind classes_;                                          ///< of components
  std::vector<Component> counts_;                   ///< of each, less what was counted before
  std::vector<InSeam> vertices_;                    ///< of the whole surface, once each
  std::vector<std::vector<std::uint32_t>> vertex_;  ///< of each seam, of its vertices: in these
  UnionFind borders_;                               ///< of the seams' borders, then of `vertices_`
  std::vector<char> has_border_;                    ///< of the same
  std::vector<std::int64_t> unresolved_;            ///< of all seams, ascending
  JoinedSeams result_;
};

}  // namespace

JoinedSeams::Component JoinedSeams::total() const {
  Component sum;
  for (const Component& component : components) add(sum, component);
  return sum;
}

JoinedSeams join_seams(std::span<const SurfaceSeam> seams) {
  require_all_cells(seams);
  require_same_messages(seams);
  return Joiner(seams).run();
}

}  // namespace tensortopo
