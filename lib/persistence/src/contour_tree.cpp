// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/contour_tree.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "homology/mesh_boundary.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// A tree in which each node has one neighbour towards the root at most.
struct Tree {
  explicit Tree(std::size_t count) : towards_root(count, kNone), leaves(count) {}
  void add(std::size_t leaf, std::size_t root) {
    towards_root[leaf] = root;
    leaves[root].insert(leaf);
  }
  /// Takes a node with one neighbour away from the root at most out of the tree.
  void remove(std::size_t node) {
    const std::size_t root = towards_root[node];
    if (root != kNone) leaves[root].erase(node);
    for (const std::size_t leaf : leaves[node]) {
      towards_root[leaf] = root;
      if (root != kNone) leaves[root].insert(leaf);
    }
    leaves[node].clear();
    towards_root[node] = kNone;
  }

  std::vector<std::size_t> towards_root;
  std::vector<std::set<std::size_t>> leaves;
};

class Contours {
 public:
  Contours(const TetMesh& mesh, const PersistenceInput& input) : mesh_(mesh), input_(input) {}

  ContourTree run() {
    for (std::size_t side = 0; side < 2; ++side) {
      tree_.is_complete &= input_.curves[side].unresolved.empty();
      add_extrema(side);
      add_meetings(side);
    }
    for (auto& [point, node] : at_points_) tree_.nodes.push_back(node);
    find_other_sides();
    std::stable_sort(tree_.nodes.begin(), tree_.nodes.end(),
                     [](const ContourNode& a, const ContourNode& b) {
                       return a.mode.middle() > b.mode.middle();
                     });
    tree_.has_loops = persistence::MeshBoundary(mesh_).betti()[1] != 0;
    if (!tree_.has_loops) join_nodes();
    tree_.is_complete &= !tree_.has_loops;
    return std::move(tree_);
  }

 private:
  static ModeRange turned(std::size_t side, const ModeRange& mode) {
    return side == 0 ? mode : ModeRange{-mode.high, -mode.low};
  }

  void add_extrema(std::size_t side) {
    const auto& maxima = input_.trees[side].maxima;
    for (std::size_t i = 0; i < maxima.size(); ++i) {
      ContourNode node;
      node.mode = turned(side, maxima[i].mode);
      node.point = maxima[i].critical_point;
      node.tet = maxima[i].tet;
      node.place = maxima[i].point;
      (side == 0 ? node.maximum : node.minimum) = i;
      (side == 0 ? node.above : node.below) = i;
      tree_.nodes.push_back(node);
    }
  }

  /// Points at which different components meet.
  void add_meetings(std::size_t side) {
    const MergeTree& tree = input_.trees[side];
    UnionFind classes(tree.maxima.size());
    for (const ModeMerge& merge : tree.merges) {
      tree_.is_complete &= merge.is_proved;
      if (!merge.is_proved) continue;
      bool joins = false;
      for (const std::size_t i : merge.reached)
        joins |= classes.unite(static_cast<std::uint32_t>(merge.reached[0]),
                               static_cast<std::uint32_t>(i));
      if (!joins) continue;
      ContourNode& node = at_points_[merge.point];
      node.mode = turned(side, merge.mode);
      node.point = merge.point;
      node.tet = merge.tet;
      node.place = input_.values.points[merge.point].point;
      (side == 0 ? node.above : node.below) = merge.reached[0];
    }
  }

  /// Paths to extrema of the other kind. At mode 1 and -1 all of a part of the mesh is on that
  /// side.
  void find_other_sides() {
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<std::size_t> points, nodes;
      for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        const ContourNode& node = tree_.nodes[i];
        const bool is_end = side == 0 ? node.mode.high <= -1 : node.mode.low >= 1;
        if ((side == 0 ? node.above : node.below) || !node.point || is_end) continue;
        points.push_back(*node.point);
        nodes.push_back(i);
      }
      const auto reached =
          side == 0
              ? maxima_above_points(mesh_, input_.values, input_.curves[0], input_.trees[0], points)
              : maxima_above_points(opposite(mesh_), opposite(input_.values), input_.curves[1],
                                    input_.trees[1], points);
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        ContourNode& node = tree_.nodes[nodes[k]];
        (side == 0 ? node.above : node.below) = reached[k];
        tree_.is_complete &= reached[k].has_value();
      }
    }
  }

  /// Joins each node to the last one of each component that it is in, in the order given.
  Tree merge_tree_of(std::size_t side, const std::vector<std::size_t>& order) {
    const MergeTree& merges = input_.trees[side];
    UnionFind parts(mesh_.points.size());
    for (const auto& tet : mesh_.tets)
      for (const auto v : tet)
        parts.unite(static_cast<std::uint32_t>(tet[0]), static_cast<std::uint32_t>(v));
    std::map<std::size_t, const ModeMerge*> at_point;
    for (const ModeMerge& merge : merges.merges)
      if (merge.is_proved) at_point[merge.point] = &merge;
    std::map<std::uint32_t, std::size_t> of_part;  // a maximum
    for (std::size_t i = 0; i < merges.maxima.size(); ++i)
      of_part.try_emplace(parts.find(static_cast<std::uint32_t>(merges.maxima[i].vertices[0])), i);
    UnionFind classes(merges.maxima.size());
    std::vector<std::size_t> last(merges.maxima.size(), kNone);
    Tree tree(tree_.nodes.size());
    for (const std::size_t n : order) {
      const ContourNode& node = tree_.nodes[n];
      std::vector<std::size_t> reached;
      const auto own = side == 0 ? node.above : node.below;
      const auto at = node.point ? at_point.find(*node.point) : at_point.end();
      if (own && at != at_point.end())
        reached = at->second->reached;
      else if (own)
        reached = {*own};
      else if (const auto part = of_part.find(
                   parts.find(static_cast<std::uint32_t>(mesh_.tets[as_size(node.tet)][0])));
               part != of_part.end())
        reached = {part->second};
      if (reached.empty()) continue;
      for (const std::size_t i : reached) {
        const std::size_t end =
            std::exchange(last[classes.find(static_cast<std::uint32_t>(i))], kNone);
        if (end != kNone) tree.add(end, n);
        classes.unite(static_cast<std::uint32_t>(reached[0]), static_cast<std::uint32_t>(i));
      }
      last[classes.find(static_cast<std::uint32_t>(reached[0]))] = n;
    }
    return tree;
  }

  void join_nodes() {
    std::vector<std::size_t> order(tree_.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Tree falling = merge_tree_of(0, order);
    std::reverse(order.begin(), order.end());
    Tree rising = merge_tree_of(1, order);
    std::vector<std::size_t> leaves;
    const auto look_at = [&](std::size_t n) {
      if (falling.leaves[n].size() + rising.leaves[n].size() == 1) leaves.push_back(n);
    };
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n) look_at(n);
    while (!leaves.empty()) {
      const std::size_t n = leaves.back();
      leaves.pop_back();
      const bool is_upper = falling.leaves[n].empty();
      if (falling.leaves[n].size() + rising.leaves[n].size() != 1) continue;
      const std::size_t next = is_upper ? falling.towards_root[n] : rising.towards_root[n];
      if (next == kNone) continue;
      tree_.arcs.push_back(is_upper ? std::array{n, next} : std::array{next, n});
      falling.remove(n);
      rising.remove(n);
      look_at(next);
    }
    std::sort(tree_.arcs.begin(), tree_.arcs.end());
  }

  const TetMesh& mesh_;
  const PersistenceInput& input_;
  std::map<std::size_t, ContourNode> at_points_;
  ContourTree tree_;
};

}  // namespace

std::vector<std::size_t> ContourTree::arcs_across(double mode) const {
  std::vector<std::size_t> across;
  for (std::size_t i = 0; i < arcs.size(); ++i)
    if (nodes[arcs[i][0]].mode.low > mode && nodes[arcs[i][1]].mode.high < mode)
      across.push_back(i);
  return across;
}

ContourTree contour_tree(const TetMesh& mesh, const PersistenceInput& input) {
  return Contours(mesh, input).run();
}

}  // namespace tensortopo
