// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/extract/face_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/segment_root.hpp"

namespace tensortopo {

namespace {

constexpr std::size_t kFaceBudget = 5000;
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
      const auto [a, b, opposite] = edges[e];
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
        const Scalar f = at_u / (at_u - at_v);
        n.fraction = f < Scalar(0) ? Scalar(0) : f > Scalar(1) ? Scalar(1) : f;
      }
    }
    for (auto& n : nodes_)
      if (n.on_edge.edge < 0) {
        const auto &u = vertices[n.first], &v = vertices[n.second];
        n.fraction = v.above ? segment_root(u.tensor, v.tensor, level_)
                             : Scalar(1) - segment_root(v.tensor, u.tensor, level_);
      }
    return true;
  }

  /// The end of a side, on the edge (a, b) of the face, that is nearer to a.
  const ExactWeights<3>& first_on_edge(const Node<Scalar>& n, std::size_t a, std::size_t b) const {
    const auto &u = refinement_.vertices()[n.first].place, &v = refinement_.vertices()[n.second].place;
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
      ArcPiece<Scalar> piece;
      for (std::size_t i = 0; i < 3; ++i) {
        piece.corners[i] = vertices[raw.cell->vertices[i]].weights;
        piece.tensors[i] = vertices[raw.cell->vertices[i]].tensor;
      }
      piece.direction = raw.cell->proof.direction;
      piece.begin = place_on_side(raw, raw.from, nodes_[raw.begin]);
      piece.end = place_on_side(raw, raw.to, nodes_[raw.end]);
      if (nodes_[raw.begin].leaving != kNone || nodes_[raw.end].arriving != kNone) return false;
      nodes_[raw.begin].leaving = p;
      nodes_[raw.end].arriving = p;
      pieces_.push_back(piece);
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

template <class Scalar>
CurvePoint<Scalar> point_on_piece(const ArcPiece<Scalar>& piece, const Scalar& fraction,
                                  const Level<Scalar>& level) {
  std::array<Scalar, 3> base;
  for (std::size_t i = 0; i < 3; ++i)
    base[i] = piece.begin[i] + fraction * (piece.end[i] - piece.begin[i]);
  if (fraction > Scalar(0) && fraction < Scalar(1)) {
    // Both ends of the line through the triangle.
    Scalar down(0), up(0);
    bool first = true;
    for (std::size_t i = 0; i < 3; ++i) {
      if (piece.direction[i] == Scalar(0)) continue;
      const Scalar k = -base[i] / piece.direction[i];
      if (piece.direction[i] > Scalar(0)) {
        if (first || k > down) down = k;
        first = false;
      }
    }
    first = true;
    for (std::size_t i = 0; i < 3; ++i)
      if (piece.direction[i] < Scalar(0)) {
        const Scalar k = -base[i] / piece.direction[i];
        if (first || k < up) up = k;
        first = false;
      }
    const auto at = [&](const Scalar& k) {
      std::array<Scalar, 3> w;
      for (std::size_t i = 0; i < 3; ++i) w[i] = base[i] + k * piece.direction[i];
      return w;
    };
    const auto lower = tensor_at(piece.tensors, at(down)), upper = tensor_at(piece.tensors, at(up));
    const Scalar root = segment_root(lower, upper, level);
    base = at(down + root * (up - down));
    for (auto& w : base)
      if (w < Scalar(0)) w = Scalar(0);
  }
  CurvePoint<Scalar> point;
  point.tensor = tensor_at(piece.tensors, base);
  Scalar total(0);
  for (std::size_t i = 0; i < 3; ++i) {
    point.weights[i] = Scalar(0);
    for (std::size_t c = 0; c < 3; ++c)
      point.weights[i] = point.weights[i] + base[c] * Scalar(piece.corners[c][i]);
    total = total + point.weights[i];
  }
  for (auto& w : point.weights) w = w / total;
  point.medium = medium_eigenvector(point.tensor, level);
  return point;
}

/// Samples the arc so that neither the medium eigenvector nor the tensor turns too far from one
/// sample to the next.
template <class Scalar>
class Sampler {
 public:
  Sampler(const Level<Scalar>& level, const Sampling& sampling)
      : level_(level),
        turn_(std::cos(std::min(sampling.largest_turn(), 1.5))),
        wide_turn_(std::cos(0.5)) {}

  void sample(FaceArc<Scalar>& arc) {
    std::vector<CurvePoint<Scalar>> points;
    for (std::size_t p = 0; p < arc.pieces.size(); ++p) {
      const auto& piece = arc.pieces[p];
      auto a = at(piece, p, Scalar(0)), b = at(piece, p, Scalar(1));
      points.push_back(a);
      between(piece, p, a, b, 0, points);
      if (p + 1 == arc.pieces.size()) points.push_back(b);
    }
    if (arc.closed) points.pop_back();  // the last point is the first
    thin(arc, points);
  }

 private:
  CurvePoint<Scalar> at(const ArcPiece<Scalar>& piece, std::size_t index, const Scalar& fraction) {
    auto point = point_on_piece(piece, fraction, level_);
    point.place = Scalar(static_cast<double>(index)) + fraction;
    return point;
  }

  bool is_close(const CurvePoint<Scalar>& a, const CurvePoint<Scalar>& b) const {
    if (!(line_cosine(a.medium, b.medium) > turn_)) return false;
    const Scalar product = norm_form(a.tensor, b.tensor);
    return product > Scalar(0) &&
           product * product >
               wide_turn_ * wide_turn_ * norm_form(a.tensor) * norm_form(b.tensor);
  }

  void between(const ArcPiece<Scalar>& piece, std::size_t index, const CurvePoint<Scalar>& a,
               const CurvePoint<Scalar>& b, int depth, std::vector<CurvePoint<Scalar>>& points) {
    if (depth > 12 || is_close(a, b)) return;
    const Scalar middle = (a.place + b.place) / Scalar(2) - Scalar(static_cast<double>(index));
    const auto m = at(piece, index, middle);
    between(piece, index, a, m, depth + 1, points);
    points.push_back(m);
    between(piece, index, m, b, depth + 1, points);
  }

  /// Drops samples (mostly ends of pieces) that are closer than they need be.
  void thin(FaceArc<Scalar>& arc, const std::vector<CurvePoint<Scalar>>& points) {
    const std::size_t n = points.size();
    std::vector<char> keep(n, 1);
    std::size_t kept = n, last = 0;
    const std::size_t least = arc.closed ? 3 : arc.begin.edge == arc.end.edge ? 3 : 2;
    for (std::size_t i = 1; i < n && kept > least; ++i) {
      if (i + 1 == n && !arc.closed) break;
      if (is_close(points[last], points[(i + 1) % n]))
        keep[i] = 0, --kept;
      else
        last = i;
    }
    if (!arc.closed && kept == 2 && least == 3) {  // one piece, both ends on one edge
      arc.samples.push_back(at(arc.pieces[0], 0, Scalar(1) / Scalar(2)));
      return;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (keep[i] && (arc.closed || (i > 0 && i + 1 < n))) arc.samples.push_back(points[i]);
    // A loop is never one piece, since a monotone triangle holds none, but it may be two.
    for (std::size_t p = 0; arc.closed && arc.samples.size() < 3 && p < arc.pieces.size(); ++p) {
      arc.samples.push_back(at(arc.pieces[p], p, Scalar(1) / Scalar(2)));
      std::sort(arc.samples.begin(), arc.samples.end(),
                [](const auto& a, const auto& b) { return a.place < b.place; });
    }
  }

  const Level<Scalar>& level_;
  Scalar turn_, wide_turn_;
};

/// Most faces need no refinement: proved as a whole, they hold nothing or one arc of one piece.
template <class Scalar>
bool is_simple_at_once(const LevelSimplex<Scalar, 3>& triangle,
                       const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
                       const Level<Scalar>& level, std::vector<FaceArc<Scalar>>& arcs) {
  std::size_t count = 0;
  for (const auto& edge : crossings) {
    if (edge.size() > 1) return false;
    count += edge.size();
  }
  if (count % 2 != 0) return false;
  const auto proof = prove_simplex(triangle.tensors, level);
  using Kind = typename SimplexProof<Scalar, 3>::Kind;
  if (proof.kind == Kind::none) return false;
  if (count == 0) return true;
  if (proof.kind == Kind::empty) return false;
  // Edges in the order of `ArcEnd`; the larger mode is to the left of a piece, so it leaves an edge
  // on which the mode, counter-clockwise, falls.
  constexpr std::array<std::array<std::size_t, 2>, 3> ends{{{0, 1}, {0, 2}, {1, 2}}};
  FaceArc<Scalar> arc;
  ArcPiece<Scalar> piece;
  piece.tensors = triangle.tensors;
  piece.direction = proof.direction;
  for (std::size_t i = 0; i < 3; ++i) piece.corners[i] = ExactWeights<3>::at_corner(i).values();
  for (std::size_t e = 0; e < 3; ++e) {
    if (crossings[e].empty()) continue;
    const auto [a, b] = ends[e];
    std::array<Scalar, 3> place{Scalar(0), Scalar(0), Scalar(0)};
    place[a] = Scalar(1) - crossings[e][0].weight;
    place[b] = crossings[e][0].weight;
    const bool falls = (e == 1) == triangle.above[b];  // edge (0, 2) runs clockwise
    (falls ? arc.begin : arc.end) = {static_cast<int>(e), 0};
    (falls ? piece.begin : piece.end) = place;
  }
  arc.pieces.push_back(piece);
  arcs.push_back(std::move(arc));
  return true;
}

}  // namespace

template <class Scalar>
std::optional<std::vector<FaceArc<Scalar>>> face_curves(
    const LevelSimplex<Scalar, 3>& triangle,
    const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
    const Level<Scalar>& level, const Sampling& sampling) {
  std::vector<FaceArc<Scalar>> arcs;
  if (is_simple_at_once(triangle, crossings, level, arcs)) {
    for (auto& arc : arcs) Sampler<Scalar>(level, sampling).sample(arc);
    return arcs;
  }
  thread_local Refinement<Scalar, 3> refinement;
  refinement.reset(triangle, level);
  if (!refinement.run(kFaceBudget)) return std::nullopt;
  if (!Assembly<Scalar>(refinement, crossings, level).build(arcs)) return std::nullopt;
  Sampler<Scalar> sampler(level, sampling);
  for (auto& arc : arcs) sampler.sample(arc);
  return arcs;
}

template <class Scalar>
CurvePoint<Scalar> point_on_arc(const FaceArc<Scalar>& arc, const Scalar& place,
                                const Level<Scalar>& level) {
  auto index = static_cast<std::size_t>(static_cast<double>(place));
  if (index >= arc.pieces.size()) index = arc.pieces.size() - 1;
  auto point = point_on_piece(arc.pieces[index],
                              place - Scalar(static_cast<double>(index)), level);
  point.place = place;
  return point;
}

template <class Scalar>
std::pair<int, Scalar> locate_on_arcs(std::span<const FaceArc<Scalar>> arcs,
                                      const std::array<Scalar, 3>& weights) {
  int best_arc = -1;
  Scalar best_place(0), best_margin(0);
  for (std::size_t a = 0; a < arcs.size(); ++a)
    for (std::size_t p = 0; p < arcs[a].pieces.size(); ++p) {
      const auto& piece = arcs[a].pieces[p];
      // Barycentric coordinates in the monotone triangle, by Cramer's rule.
      std::array<std::array<Scalar, 3>, 3> c;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) c[i][k] = Scalar(piece.corners[i][k]);
      const auto det = [](const std::array<Scalar, 3>& x, const std::array<Scalar, 3>& y,
                          const std::array<Scalar, 3>& z) {
        return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
               x[2] * (y[0] * z[1] - y[1] * z[0]);
      };
      std::array<Scalar, 3> local{det(weights, c[1], c[2]), det(c[0], weights, c[2]),
                                  det(c[0], c[1], weights)};
      const Scalar whole = local[0] + local[1] + local[2];
      for (auto& l : local) l = l / whole;
      const Scalar margin = std::min(local[0], std::min(local[1], local[2]));
      if (best_arc >= 0 && !(margin > best_margin)) continue;
      // Across the direction, how far along from begin to end: begin + f (end - begin), the
      // direction and the place are in one line.
      const Scalar at_begin = det(local, piece.begin, piece.direction);
      const Scalar at_end = det(local, piece.end, piece.direction);
      if (at_begin == at_end) continue;
      Scalar f = at_begin / (at_begin - at_end);
      f = f < Scalar(0) ? Scalar(0) : f > Scalar(1) ? Scalar(1) : f;
      best_arc = static_cast<int>(a);
      best_margin = margin;
      best_place = Scalar(static_cast<double>(p)) + f;
    }
  return {best_arc, best_place};
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                         \
  template std::optional<std::vector<FaceArc<Scalar>>> face_curves(                            \
      const LevelSimplex<Scalar, 3>&,                                                          \
      const std::array<std::span<const EdgeCrossing<Scalar>>, 3>&, const Level<Scalar>&,       \
      const Sampling&);                                                                        \
  template CurvePoint<Scalar> point_on_arc(const FaceArc<Scalar>&, const Scalar&,              \
                                           const Level<Scalar>&);                              \
  template std::pair<int, Scalar> locate_on_arcs(std::span<const FaceArc<Scalar>>,             \
                                                 const std::array<Scalar, 3>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
