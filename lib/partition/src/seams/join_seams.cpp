// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>
#include <utility>

#include "crossed_cells.hpp"
#include "differing_pieces.hpp"
#include "piece_messages.hpp"
#include "seams/joined_vertices.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/union_find.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;

void add(JoinedSeams::Component& sum, const JoinedSeams::Component& more) {
  sum.vertices += more.vertices, sum.triangles += more.triangles;
  sum.euler_characteristic += more.euler_characteristic;
  sum.boundary_loops += more.boundary_loops;
}

class Joiner {
 public:
  explicit Joiner(std::span<const SurfaceSeam> seams) : seams_(seams), components_(seams) {
    std::uint32_t borders = 0;
    for (const SurfaceSeam& seam : seams) {
      first_border_.push_back(borders);
      for (const auto& vertex : seam.vertices)
        borders =
            std::max(borders, first_border_.back() + static_cast<std::uint32_t>(vertex.border + 1));
    }
    all_borders_ = borders;
  }

  JoinedSeams run() {
    add_components();
    joined_ = join_vertices(seams_, components_, [&](std::uint32_t component) {
      --counts_[component].vertices, --counts_[component].euler_characteristic;
    });
    borders_ = UnionFind(all_borders_ + joined_.vertices.size());
    has_border_.assign(borders_.size(), 0);
    join_sides();
    count_loops();
    number_components();
    return std::move(result_);
  }

 private:
  using Component = JoinedSeams::Component;

  const SurfaceSeam::Vertex& vertex(const InSeam& at) const {
    return seams_[at.seam].vertices[at.place];
  }
  const SurfaceSeam::Side& side(const InSeam& at) const { return seams_[at.seam].sides[at.place]; }

  /// As if they had nothing in common.
  void add_components() {
    for (const SurfaceSeam& seam : seams_)
      for (const auto& own : seam.components)
        counts_.push_back(
            {own.vertices, own.triangles, own.euler_characteristic, own.closed_borders});
  }

  /// The ends of a side, in `joined_`.
  std::array<std::uint32_t, 2> ends(const InSeam& at) const {
    const auto& vertex = joined_.of_seam[at.seam];
    return {vertex[as_size(side(at).from)], vertex[as_size(side(at).to)]};
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
    return components_.at(at.seam, seams_[at.seam].vertices[as_size(side(at).from)].component);
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
        const auto at = all_borders_ + joined_.of_seam[s][v];
        borders_.unite(first_border_[s] + static_cast<std::uint32_t>(border), at);
        has_border_[at] = 1;
      }
    std::vector<char> is_counted(borders_.size(), 0);
    for (std::uint32_t v = 0; v < joined_.vertices.size(); ++v) {
      if (has_border_[all_borders_ + v] == 0) continue;
      if (std::exchange(is_counted[borders_.find(all_borders_ + v)], 1) != 0) continue;
      const InSeam& at = joined_.vertices[v];
      ++counts_[components_.at(at.seam, vertex(at).component)].boundary_loops;
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
                           components_.at(s, static_cast<Index>(c)));
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> in_order;
    for (const auto& [place, c] : order) in_order.push_back(c);
    components_.number(in_order);
    result_.components.resize(components_.count());
    for (std::uint32_t c = 0; c < counts_.size(); ++c)
      add(result_.components[as_size(components_.number_of(c))], counts_[c]);
    result_.numbers = components_.numbers();
  }

  std::span<const SurfaceSeam> seams_;
  SeamComponents<SurfaceSeam> components_;
  std::vector<std::uint32_t> first_border_;  ///< of each seam
  std::uint32_t all_borders_ = 0;            ///< how many all seams have
  std::vector<Component> counts_;            ///< of each component, less what was counted before
  JoinedVertices joined_;
  UnionFind borders_;                     ///< of the seams' borders, then of `joined_`
  std::vector<char> has_border_;          ///< of the same
  std::vector<std::int64_t> unresolved_;  ///< of all seams, ascending
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
