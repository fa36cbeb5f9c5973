// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/graph_arcs.hpp"

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <utility>

#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// Edges in the order of `ArcEnd`; edge e is opposite vertex 2 - e.
constexpr std::array<std::array<std::size_t, 2>, 3> kEnds{{{0, 1}, {0, 2}, {1, 2}}};

/// More are left to a refinement: few faces have them, and not all can be joined in one way only.
constexpr std::size_t kMostCrossings = 8;

/// How the crossings of the sides on which lines enter and leave come one after the other.
class Sweep {
 public:
  using Arcs = boost::container::small_vector<std::array<ArcEnd, 2>, 1>;

  Sweep(std::vector<ArcEnd> entering, std::vector<ArcEnd> leaving, bool above)
      : sides_{std::move(entering), std::move(leaving)}, above_{above, above} {
    extend();
  }

  bool is_unique() const { return found_ == 1; }
  const Arcs& arcs() const { return result_; }

 private:
  bool meets_graph() const { return !above_[0] && above_[1]; }

  void extend() {
    if (found_ > 1) return;
    if (next_[0] == sides_[0].size() && next_[1] == sides_[1].size()) {
      if (!meets_graph() && ++found_ == 1) result_ = arcs_;
      return;
    }
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (next_[side] == sides_[side].size()) continue;
      const bool met = meets_graph();
      above_[side] = !above_[side];
      if (!above_[0] || above_[1]) {
        const ArcEnd end = sides_[side][next_[side]++];
        if (met)
          arcs_.back()[1] = end;
        else
          arcs_.push_back({end, end});
        extend();
        if (!met) arcs_.pop_back();
        --next_[side];
      }
      above_[side] = !above_[side];
    }
  }

  std::array<std::vector<ArcEnd>, 2> sides_;  ///< where lines enter, where they leave
  std::array<bool, 2> above_;                 ///< on them, at the line
  std::array<std::size_t, 2> next_{};
  Arcs arcs_, result_;
  int found_ = 0;
};

/// The crossings of the edges from vertex `from` to vertex `to` along one side of the face.
template <class Crossings>
std::vector<ArcEnd> side_between(const Crossings& crossings, std::size_t from, std::size_t to,
                                 bool straight) {
  std::vector<ArcEnd> side;
  const auto add = [&](std::size_t u, std::size_t v) {
    const std::size_t e = u + v - 1;
    const int count = static_cast<int>(crossings[e].size());
    for (int k = 0; k < count; ++k)
      side.push_back({static_cast<int>(e), u < v ? k : count - 1 - k});
  };
  if (straight) {
    add(from, to);
  } else {
    const std::size_t over = 3 - from - to;
    add(from, over), add(over, to);
  }
  return side;
}

/// Which crossings of a graph across the direction are joined; nothing if that is not certain.
template <class Scalar>
Sweep::Arcs joined(const LevelSimplex<Scalar, 3>& triangle,
                   const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
                   const std::array<Scalar, 3>& direction, std::size_t count) {
  if (count == 2) {
    Sweep::Arcs one(1);
    for (std::size_t e = 0, k = 0; e < 3; ++e)
      for (int c = 0; c < static_cast<int>(crossings[e].size()); ++c)
        one[0][k++] = {static_cast<int>(e), c};
    return one;
  }
  // A line enters through the edge opposite vertex i if its weight grows from 0.
  std::size_t alone = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (direction[i] == Scalar(0)) return {};
    const bool enters = direction[i] > Scalar(0), next = direction[(i + 1) % 3] > Scalar(0),
               last = direction[(i + 2) % 3] > Scalar(0);
    if (enters != next && enters != last) alone = i;
  }
  // That edge is one side, from one end to the other, the two others are the other side.
  const std::size_t from = (alone + 1) % 3, to = (alone + 2) % 3;
  auto straight = side_between(crossings, from, to, true),
       around = side_between(crossings, from, to, false);
  if (!(direction[alone] > Scalar(0))) std::swap(straight, around);
  const Sweep sweep(std::move(straight), std::move(around), triangle.above[from]);
  return sweep.is_unique() ? sweep.arcs() : Sweep::Arcs{};
}

}  // namespace

template <class Scalar>
bool arcs_of_graph(const LevelSimplex<Scalar, 3>& triangle,
                   const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
                   const Level<Scalar>& level, std::vector<FaceArc<Scalar>>& arcs,
                   const SimplexProof<Scalar, 3>* known) {
  std::size_t count = 0;
  for (const auto& edge : crossings) count += edge.size();
  if (count % 2 != 0 || count > kMostCrossings) return false;
  const auto proof = known != nullptr ? *known : prove_simplex(triangle.tensors, level);
  using Kind = typename SimplexProof<Scalar, 3>::Kind;
  if (proof.kind == Kind::none) return false;
  if (count == 0) return true;
  if (proof.kind == Kind::empty) return false;
  const auto pairs = joined(triangle, crossings, proof.direction, count);
  if (pairs.size() != count / 2) return false;

  ArcPiece<Scalar> piece;
  piece.direction = proof.direction;
  for (const auto& ends : pairs) {
    FaceArc<Scalar> arc;
    int begins = 0;
    for (const auto& end : ends) {
      const auto e = static_cast<std::size_t>(end.edge), k = static_cast<std::size_t>(end.crossing);
      const auto [a, b] = kEnds[e];
      std::array<Scalar, 3> place{Scalar(0), Scalar(0), Scalar(0)};
      place[a] = Scalar(1) - crossings[e][k].weight;
      place[b] = crossings[e][k].weight;
      // The larger mode is to the left of a piece, so it leaves an edge on which the mode,
      // counter-clockwise, falls. Edge (0, 2) runs clockwise.
      const bool rises = triangle.above[a] == (k % 2 != 0);
      const bool falls = (e == 1) == rises;
      begins += falls;
      (falls ? arc.begin : arc.end) = end;
      (falls ? piece.begin : piece.end) = place;
    }
    if (begins != 1) {
      arcs.clear();
      return false;
    }
    arc.pieces.push_back(piece);
    arcs.push_back(std::move(arc));
  }
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                             \
  template bool arcs_of_graph(                                                                     \
      const LevelSimplex<Scalar, 3>&, const std::array<std::span<const EdgeCrossing<Scalar>>, 3>&, \
      const Level<Scalar>&, std::vector<FaceArc<Scalar>>&, const SimplexProof<Scalar, 3>*);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
