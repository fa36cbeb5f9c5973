// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// One edge, face or tetrahedron of the mesh, cut until the level in each part is as simple as in
// marching tetrahedra.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "level.hpp"

namespace certificate {

/// How often an edge is crossed, and how much work it took to find out.
struct EdgeLevel {
  bool decided = false;
  unsigned crossings = 0;
  std::size_t work = 0;
};
/// @param words_squared  of the integers at its ends
EdgeLevel level_in_edge(const Level& level, const std::array<Corner, 2>& corners,
                        std::size_t words_squared = 1);

/// A conforming subdivision of a simplex (but for parts that are proved empty, which are left as
/// they are) into parts with a proof: of each cell and, in a face, that each of their edges is crossed
/// once at most. See the README for what follows.
class Refinement : public ExactTensors {
 public:
  using Id = std::uint32_t;
  using Weights = std::array<mpz_class, 4>;
  /// A tensor with its place: `weights` are those of the roots' exact tensors in its own, and
  /// ball encloses exact / 2^shift.
  struct Point {
    Tensor<Ball> ball;
    long shift = 0;
    Weights weights;
    double length = 0;     ///< of ball, roughly
    unsigned support = 0;  ///< a bit for each root of nonzero weight
    bool above = false;
  };
  struct Cell {
    std::array<Id, 4> points;  ///< those of the dimension; turned like the roots
    Proof proof = Proof::open;
    bool cut = false;  ///< replaced by others
    /// If it is monotone: along which weights of the roots' exact tensors.
    std::shared_ptr<const Weights> direction;
  };

  /// @pre 2 to 4 roots
  Refinement(const Level& level, std::span<const Corner> roots);

  /// What is already known: of the whole simplex, and whether the edge between two roots of a face is
  /// crossed once at most.
  void assume(const auto& proved) { note(cells_[0], proved.proof, proved.direction); }
  void assume(Id a, Id b, bool is_settled) { settled_[key(a, b)] = is_settled; }
  /// Cuts. False if that takes more cells, or longer integers, than the budget.
  bool run();
  /// Cuts until each part is proved to be on the side of the roots. False if one is not.
  /// @pre 2 or 3 roots of one side; nothing else was called
  bool is_one_sided() { return asks_for_side_ = true, run(); }

  /// Are points of the cell on both sides?
  bool is_crossed(const Cell& cell) const;
  std::size_t work() const { return work_ + cells_.size(); }
  std::size_t corners() const { return roots_.size(); }
  const std::vector<Point>& points() const { return points_; }
  const std::vector<Cell>& cells() const { return cells_; }
  Tensor<mpz_class> exact(std::uint32_t point) const override;
  template <std::size_t V>
  std::array<Corner, V> corners_at(const std::array<Id, V>& ids) const;

  /// A number for an edge (two ids) or face (three), whatever their order.
  static std::uint64_t key(std::span<const Id> ids);
  static std::uint64_t key(Id a, Id b) { return key(std::array{a, b}); }

 private:
  /// The longest edge of a cell: its length, the cell, the edge.
  using Longest = std::tuple<double, std::size_t, std::array<Id, 2>>;
  using Waiting = std::priority_queue<Longest>;
  /// Where to put a point into an edge, a face or a cell: so much of each of its points.
  struct Place {
    std::size_t size;
    std::array<Id, 4> points;
    std::array<double, 4> shares;
    double smallness = 1;  ///< of the tensor there, compared with its terms
  };

  void note(Cell& cell, Proof proof, std::span<const int> along);
  void prove(Cell& cell);
  bool is_settled(Id a, Id b);
  bool is_open(const Cell& cell);
  void wait(std::size_t cell, Waiting& waiting) const;
  Tensor<double> unit(Id a) const;
  void round(Place& place) const;
  Place place_on(Id a, Id b) const;
  std::optional<Place> small_field(std::span<const Id> part) const;
  Id add_point(const Place& place);
  void add_cell(const Cell& cell);
  static bool is_left(const Cell& cell) { return !cell.cut && cell.proof != Proof::empty; }
  std::vector<std::size_t> cells_around(std::span<const Id> part);
  void cut(const Place& place, Waiting& waiting);
  void bisect(const std::array<Id, 2>& edge, Waiting& waiting);

  const Level& level_;
  std::vector<Corner> roots_;
  std::vector<Point> points_;
  std::vector<Cell> cells_;
  std::vector<std::vector<std::size_t>> cells_at_;  ///< for each point those with it
  std::unordered_map<std::uint64_t, bool> settled_;  ///< edges of a face: crossed once at most
  bool asks_for_side_ = false;  ///< not where the level is
  std::size_t work_ = 0, words_squared_ = 1;  ///< so far; of the last point
};

template <std::size_t V>
std::array<Corner, V> Refinement::corners_at(const std::array<Id, V>& ids) const {
  std::array<Corner, V> result;
  for (std::size_t i = 0; i < V; ++i) {
    const Point& p = points_[ids[i]];
    result[i] = {&p.ball, p.shift, this, ids[i], p.above};
  }
  return result;
}

/// All subsets of `size` of the first `count` members.
void for_subsets(std::size_t count, std::size_t size, const auto& f) {
  for (unsigned mask = 1; mask < 1U << count; ++mask) {
    std::array<std::size_t, 4> members{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < count; ++i)
      if ((mask >> i & 1U) != 0) members[n++] = i;
    if (n == size) f(members);
  }
}

}  // namespace certificate
