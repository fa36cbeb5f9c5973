// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/level_surface.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tensortopo::theory {
namespace {

// Sets of numbered elements with, for each element, whether it is turned against its root.
class TurnedSets {
 public:
  std::size_t add() {
    parent_.push_back(parent_.size());
    turned_.push_back(false);
    return parent_.size() - 1;
  }
  std::size_t root(std::size_t x) { return find(x).first; }
  /// False if the elements are known to be turned otherwise.
  bool join(std::size_t x, std::size_t y, bool against) {
    const auto [p, p_turned] = find(x);
    const auto [q, q_turned] = find(y);
    const bool turn = (p_turned != q_turned) != against;
    if (p == q) return !turn;
    parent_[p] = q;
    turned_[p] = turn;
    return true;
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::pair<std::size_t, bool> find(std::size_t x) {
    bool turned = false;
    std::size_t top = x;
    for (; parent_[top] != top; top = parent_[top]) turned = turned != turned_[top];
    // Compressed: everything on the way hangs from the root.
    for (bool rest = turned; parent_[x] != x;) {
      const std::size_t up = parent_[x];
      const bool step = turned_[x];
      parent_[x] = top, turned_[x] = rest;
      rest = rest != step, x = up;
    }
    return {top, turned};
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> turned_;
};

// Of a cell and its twin, one.
bool is_counted(const LevelComplex& complex, const LevelComplex::Cell& cell) {
  if (!complex.is_antipodal()) return true;
  const auto lowest =
      *std::min_element(cell.begin(), cell.end(), [](auto u, auto v) { return u / 2 < v / 2; });
  return lowest % 2 == 0;
}

std::vector<LevelComplex::Index> sides(const LevelComplex& complex, const LevelComplex::Cell& cell,
                                       bool above) {
  std::vector<LevelComplex::Index> result;
  for (const auto v : cell)
    if (complex.is_above(v) == above) result.push_back(v);
  return result;
}

using CellEdge = std::array<LevelComplex::Index, 2>;

// The loop of the level around a cell: points on its edges, in order. Empty if it is not crossed.
std::vector<CellEdge> loop_around(const LevelComplex& complex, const LevelComplex::Cell& cell) {
  const auto up = sides(complex, cell, true), down = sides(complex, cell, false);
  if (up.empty() || down.empty()) return {};
  if (up.size() == 2)
    return {{up[0], down[0]}, {up[1], down[0]}, {up[1], down[1]}, {up[0], down[1]}};
  std::vector<CellEdge> loop;
  for (const auto u : up)
    for (const auto d : down) loop.push_back({u, d});
  return loop;
}

class Counter {
 public:
  explicit Counter(const LevelComplex& complex) : antipodal_(complex.is_antipodal()) {}

  void add_disc(const std::vector<CellEdge>& loop) {
    const std::size_t disc = discs_.add();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t p = point(loop[i]), q = point(loop[(i + 1) % loop.size()]);
      connect(disc, p, q);
    }
  }

  LevelSurface count() {
    LevelSurface surface;
    surface.euler = static_cast<int>(points_.size()) - static_cast<int>(arcs_.size()) +
                    static_cast<int>(discs_.size());
    surface.orientable = orientable_;
    std::vector<bool> has_boundary(discs_.size(), false);
    std::vector<bool> on_boundary(rim_.size(), false);
    for (const auto& [ends, arc] : arcs_) {
      if (arc.discs == 2) continue;
      has_boundary[discs_.root(arc.disc)] = true;
      rim_.join(arc.from, arc.to, false);
      on_boundary[arc.from] = on_boundary[arc.to] = true;
    }
    for (std::size_t d = 0; d < discs_.size(); ++d) {
      if (discs_.root(d) != d) continue;
      ++surface.components;
      if (!has_boundary[d]) ++surface.closed_components;
    }
    for (std::size_t p = 0; p < rim_.size(); ++p)
      if (on_boundary[p] && rim_.root(p) == p) ++surface.boundary_loops;
    return surface;
  }

 private:
  struct Arc {
    std::size_t disc, from, to;
    int discs = 1;
  };

  std::size_t point(const CellEdge& edge) {
    std::uint64_t key = simplex_key(edge);
    if (antipodal_) {
      const CellEdge opposite{LevelComplex::twin(edge[0]), LevelComplex::twin(edge[1])};
      key = std::min(key, simplex_key(opposite));
    }
    const auto [at, added] = points_.try_emplace(key, points_.size());
    if (added) rim_.add();
    return at->second;
  }

  // A face of a cell holds one arc at most, so its ends name it: they name the face.
  void connect(std::size_t disc, std::size_t p, std::size_t q) {
    const auto ends = std::minmax(p, q);
    const std::uint64_t key = static_cast<std::uint64_t>(ends.first) << 32 | ends.second;
    const auto [at, added] = arcs_.try_emplace(key, Arc{disc, p, q});
    if (added) return;
    Arc& arc = at->second;
    ++arc.discs;
    // Neighbours turned alike pass their common arc in opposite directions.
    if (!discs_.join(disc, arc.disc, arc.from == p)) orientable_ = false;
  }

  std::unordered_map<std::uint64_t, std::size_t> points_;
  std::unordered_map<std::uint64_t, Arc> arcs_;
  TurnedSets discs_, rim_;
  bool antipodal_;
  bool orientable_ = true;
};

}  // namespace

LevelSurface level_surface(const LevelComplex& complex) {
  Counter counter(complex);
  for (const auto& cell : complex.cells()) {
    if (!is_counted(complex, cell)) continue;
    const auto loop = loop_around(complex, cell);
    if (!loop.empty()) counter.add_disc(loop);
  }
  return counter.count();
}

std::string text(const LevelSurface& s) {
  return "Euler characteristic " + std::to_string(s.euler) + ", components " +
         std::to_string(s.components) + ", closed ones " + std::to_string(s.closed_components) +
         ", boundary loops " + std::to_string(s.boundary_loops) +
         (s.orientable ? ", orientable" : ", not orientable");
}

}  // namespace tensortopo::theory
