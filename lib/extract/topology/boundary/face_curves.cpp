// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/boundary/face_curves.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/boundary/arc_samples.hpp"
#include "extract/topology/boundary/graph_arcs.hpp"

namespace tensortopo {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// A crossing of a side of a monotone triangle, and the two triangles that meet there.
template <class Scalar>
struct Node {
  std::uint32_t first, second;  ///< refinement vertices of the side, first < second
  Scalar fraction;              ///< place between them
  ArcEnd on_edge;               ///< if the side lies on an edge of the face
  std::uint32_t leaving = kNone, arriving = kNone;  ///< pieces that start and end here
};

/// The curves of one face, joined from the monotone triangles of a refinement.
template <class Scalar>
class Assembly {
 public:
  Assembly(const Refinement<Scalar, 3>& refinement,
           const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
           const Level<Scalar>& level)
      : refinement_(refinement), crossings_(crossings), level_(level) {}

  bool build(std::vector<FaceArc<Scalar>>& arcs) {
    for (const auto& cell : refinement_.cells())
      if (cell.alive) add_cell(cell);
    return number_edge_crossings() && make_pieces() && chain(arcs);
  }

 private:
  struct RawPiece {
    const typename Refinement<Scalar, 3>::Cell* cell;
    std::array<int, 2> from, to;  ///< local sides, each as two corners
    std::uint32_t begin, end;     ///< nodes
  };

  std::uint32_t node(std::uint32_t u, std::uint32_t v) {
    if (u > v) std::swap(u, v);
    const auto [found, added] =
        index_.try_emplace({u, v}, static_cast<std::uint32_t>(nodes_.size()));
    if (added) {
      Node<Scalar> n;
      n.first = u, n.second = v;
      nodes_.push_back(n);
    }
    return found->second;
  }

  void add_cell(const typename Refinement<Scalar, 3>::Cell& cell) {
    const auto& vertices = refinement_.vertices();
    std::array<bool, 3> above;
    for (std::size_t i = 0; i < 3; ++i) above[i] = vertices[cell.vertices[i]].above;
    if (above[0] == above[1] && above[1] == above[2]) return;
    // The vertex that is alone on its side; the larger mode stays on the left.
    const int lone = above[0] == above[1] ? 2 : above[0] == above[2] ? 1 : 0;
    const int next = (lone + 1) % 3, previous = (lone + 2) % 3;
    RawPiece piece;
    piece.cell = &cell;
    piece.from = {lone, next}, piece.to = {lone, previous};
    if (!above[static_cast<std::size_t>(lone)]) std::swap(piece.from, piece.to);
    const auto id = [&](int local) { return cell.vertices[static_cast<std::size_t>(local)]; };
    piece.begin = node(id(piece.from[0]), id(piece.from[1]));
    piece.end = node(id(piece.to[0]), id(piece.to[1]));
    raw_.push_back(piece);
  }

  /// The crossings of the face's edges were computed once for all: find each among the sides
  /// that lie on the edge, by order.
  bool number_edge_crossings() {
    const auto& vertices = refinement_.vertices();
    constexpr std::array<std::array<std::size_t, 3>, 3> edges{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t a = edges[e][0], b = edges[e][1], opposite = edges[e][2];
      std::vector<std::uint32_t> on_edge;
      for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        const auto &u = vertices[nodes_[n].first], &v = vertices[nodes_[n].second];
        if (u.weights[opposite] == 0 && v.weights[opposite] == 0) on_edge.push_back(n);
      }
      if (on_edge.size() != crossings_[e].size()) return false;
      // Two sides on an edge have at most an end in common.
      std::sort(on_edge.begin(), on_edge.end(), [&](std::uint32_t m, std::uint32_t n) {
        return first_on_edge(nodes_[m], a, b).comes_before(first_on_edge(nodes_[n], a, b), a, b);
      });
      for (std::size_t k = 0; k < on_edge.size(); ++k) {
        auto& n = nodes_[on_edge[k]];
        n.on_edge = {static_cast<int>(e), static_cast<int>(k)};
        // (1 - f) u + f v is proportional to the crossing's weights.
        const auto &u = vertices[n.first].weights, &v = vertices[n.second].weights;
        const Scalar &w = crossings_[e][k].weight, rest = Scalar(1) - w;
        const Scalar at_u = Scalar(u[a]) * w - Scalar(u[b]) * rest;
        const Scalar at_v = Scalar(v[a]) * w - Scalar(v[b]) * rest;
        // All three are one place if the side is shorter than roundings are.
        const Scalar f = at_u == at_v
                             ? segment_root(vertices[n.first].tensor, vertices[n.second].tensor,
                                            vertices[n.second].above, level_)
                             : at_u / (at_u - at_v);
        n.fraction = f < Scalar(0) ? Scalar(0) : f > Scalar(1) ? Scalar(1) : f;
      }
    }
    for (auto& n : nodes_)
      if (n.on_edge.edge < 0) {
        const auto &u = vertices[n.first], &v = vertices[n.second];
        n.fraction = segment_root(u.tensor, v.tensor, v.above, level_);
      }
    return true;
  }

  /// The end of a side, on the edge (a, b) of the face, that is nearer to a.
  const ExactWeights<3>& first_on_edge(const Node<Scalar>& n, std::size_t a, std::size_t b) const {
    const auto &u = refinement_.vertices()[n.first].place,
               &v = refinement_.vertices()[n.second].place;
    return u.comes_before(v, a, b) ? u : v;
  }

  std::array<Scalar, 3> place_on_side(const RawPiece& piece, const std::array<int, 2>& side,
                                      const Node<Scalar>& n) const {
    std::array<Scalar, 3> at{Scalar(0), Scalar(0), Scalar(0)};
    for (const int local : side) {
      const auto i = static_cast<std::size_t>(local);
      at[i] = piece.cell->vertices[i] == n.second ? n.fraction : Scalar(1) - n.fraction;
    }
    return at;
  }

  bool make_pieces() {
    const auto& vertices = refinement_.vertices();
    for (std::uint32_t p = 0; p < raw_.size(); ++p) {
      const auto& raw = raw_[p];
      using Kind = typename SimplexProof<Scalar, 3>::Kind;
      if (raw.cell->proof.kind != Kind::monotone) return false;
      FacePart<Scalar> part;
      for (std::size_t i = 0; i < 3; ++i) {
        part.corners[i] = vertices[raw.cell->vertices[i]].weights;
        part.tensors[i] = vertices[raw.cell->vertices[i]].tensor;
      }
      ArcPiece<Scalar> piece;
      piece.part = std::make_shared<const FacePart<Scalar>>(part);
      piece.direction = raw.cell->proof.direction;
      piece.begin = place_on_side(raw, raw.from, nodes_[raw.begin]);
      piece.end = place_on_side(raw, raw.to, nodes_[raw.end]);
      if (nodes_[raw.begin].leaving != kNone || nodes_[raw.end].arriving != kNone) return false;
      nodes_[raw.begin].leaving = p;
      nodes_[raw.end].arriving = p;
      pieces_.push_back(std::move(piece));
    }
    return true;
  }

  bool chain(std::vector<FaceArc<Scalar>>& arcs) {
    std::vector<char> used(raw_.size(), 0);
    const auto follow = [&](std::uint32_t piece, FaceArc<Scalar>& arc) {
      std::uint32_t last = kNone;
      while (piece != kNone && !used[piece]) {
        used[piece] = 1;
        arc.pieces.push_back(pieces_[piece]);
        last = raw_[piece].end;
        piece = nodes_[last].leaving;
      }
      return last;
    };
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      if (nodes_[n].on_edge.edge < 0) {
        if (nodes_[n].leaving == kNone || nodes_[n].arriving == kNone) return false;
        continue;
      }
      if (nodes_[n].leaving == kNone) continue;
      FaceArc<Scalar> arc;
      arc.begin = nodes_[n].on_edge;
      arc.end = nodes_[follow(nodes_[n].leaving, arc)].on_edge;
      if (arc.end.edge < 0) return false;
      arcs.push_back(std::move(arc));
    }
    for (std::uint32_t p = 0; p < raw_.size(); ++p) {
      if (used[p]) continue;
      FaceArc<Scalar> arc;
      arc.closed = true;
      follow(p, arc);
      arcs.push_back(std::move(arc));
    }
    return true;
  }

  const Refinement<Scalar, 3>& refinement_;
  const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings_;
  const Level<Scalar>& level_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> index_;
  std::vector<Node<Scalar>> nodes_;
  std::vector<RawPiece> raw_;
  std::vector<ArcPiece<Scalar>> pieces_;
};

}  // namespace

template <class Scalar>
std::optional<std::vector<FaceArc<Scalar>>> face_curves(
    const LevelSimplex<Scalar, 3>& triangle,
    const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
    const Level<Scalar>& level, const Sampling& sampling, Budget budget) {
  return face_curves_by<Scalar>(nullptr, triangle, crossings, level, sampling, budget);
}

template <class Scalar>
std::optional<std::vector<FaceArc<Scalar>>> face_curves_by(
    const SimplexProof<Scalar, 3>* known, const LevelSimplex<Scalar, 3>& triangle,
    const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
    const Level<Scalar>& level, const Sampling& sampling, Budget budget) {
  std::vector<FaceArc<Scalar>> arcs;
  const SampleTurns turns(sampling);
  if (arcs_of_graph(triangle, crossings, level, arcs, known)) {
    for (auto& arc : arcs) sample_arc(arc, triangle.tensors, level, turns);
    return arcs;
  }
  thread_local Refinement<Scalar, 3> refinement;
  refinement.reset(triangle, level);
  if (!refinement.run(face_cell_limit(budget, level.gap()))) return std::nullopt;
  if (!Assembly<Scalar>(refinement, crossings, level).build(arcs)) return std::nullopt;
  for (auto& arc : arcs) sample_arc(arc, triangle.tensors, level, turns);
  return arcs;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                             \
  template std::optional<std::vector<FaceArc<Scalar>>> face_curves_by(                             \
      const SimplexProof<Scalar, 3>*, const LevelSimplex<Scalar, 3>&,                              \
      const std::array<std::span<const EdgeCrossing<Scalar>>, 3>&, const Level<Scalar>&,           \
      const Sampling&, Budget);                                                                    \
  template std::optional<std::vector<FaceArc<Scalar>>> face_curves(                                \
      const LevelSimplex<Scalar, 3>&, const std::array<std::span<const EdgeCrossing<Scalar>>, 3>&, \
      const Level<Scalar>&, const Sampling&, Budget);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
