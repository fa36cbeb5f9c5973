// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/level_complex.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "tensortopo/theory/arithmetic.hpp"

namespace tensortopo::theory {
namespace {

// Lengths are squared chords between unit tensors, 4 at most; this is for what has no length.
constexpr double kNoLength = 5;

// An edge in the way is cut unless its cell has one that is longer by this factor, squared: cells
// of which only the other edges are ever cut do not become small.
constexpr double kLonger = 1.3 * 1.3;

// No cell is cut across an edge if it has another that is longer by this factor, squared: it would
// become a needle.
constexpr double kMuchLonger = 2 * 2;

// The first cuts are off the middle by a sixteenth. Fields have symmetries, and middles would put
// sides of cells on their axes and planes, where a level can touch a side or contain it.
constexpr std::size_t kUnevenCuts = 40;

// Weights of a cut are sixteenths.
constexpr int kParts = 16;

// Far more than any level needs that is not critical.
constexpr std::size_t kMostVertices = std::size_t{1} << 20;

Integer shifted(int number, long places) {
  return Integer(number) << static_cast<unsigned long>(std::max(places, 0L));
}

template <std::size_t N>
bool contains(const std::array<std::uint32_t, N>& simplex, std::uint32_t vertex) {
  return std::find(simplex.begin(), simplex.end(), vertex) != simplex.end();
}

}  // namespace

std::uint64_t simplex_key(const std::array<std::uint32_t, 2>& e) {
  return std::uint64_t{std::min(e[0], e[1])} << 21 | std::max(e[0], e[1]);
}

std::uint64_t simplex_key(const std::array<std::uint32_t, 3>& face) {
  std::array<std::uint32_t, 3> f = face;
  std::sort(f.begin(), f.end());
  return std::uint64_t{f[0]} << 42 | std::uint64_t{f[1]} << 21 | f[2];
}

LevelComplex::LevelComplex(const ModeLevel& level)
    : level_(level), square_(enclosing<Bounded<double>>(level.mu_squared)) {}

LevelComplex::Index LevelComplex::add_vertex(const Deviator<Integer>& tensor) {
  Vertex v;
  v.tensor = primitive(tensor);
  v.size = binary_size(v.tensor);
  v.near = bounded(v.tensor, v.size);
  v.norm = std::sqrt(norm_form(v.near).value);
  const Verdict quick = side(v.near, level_, square_);
  v.above = quick == Verdict::positive ||
            (quick != Verdict::negative && theory::is_above(v.tensor, level_));
  vertices_.push_back(std::move(v));
  pieces_at_.emplace_back();
  return static_cast<Index>(vertices_.size() - 1);
}

LevelComplex LevelComplex::antipodal() {
  LevelComplex complex(ModeLevel::neutral());
  complex.antipodal_ = true;
  return complex;
}

LevelComplex::Index LevelComplex::add_twins(const Deviator<Integer>& tensor) {
  const Index first = add_vertex(tensor), second = add_vertex(Integer(-1) * tensor);
  vertices_[second].above = !vertices_[first].above;
  return first;
}

void LevelComplex::add_cell(const Cell& cell) { add_piece({cell, SimplexProof::none, true}); }

void LevelComplex::add_piece(const Piece& piece) {
  for (const Index v : piece.vertices) pieces_at_[v].push_back(static_cast<Index>(pieces_.size()));
  pieces_.push_back(piece);
}

std::vector<LevelComplex::Cell> LevelComplex::cells() const {
  std::vector<Cell> result;
  for (const Piece& piece : pieces_)
    if (piece.alive) result.push_back(piece.vertices);
  return result;
}

bool LevelComplex::refine(std::size_t budget, const std::function<bool(const Face&)>& is_resolved) {
  // The largest first: a large cell must not be worn down from its sides by cuts of small ones.
  std::priority_queue<std::pair<double, Index>> waiting;
  std::size_t next = 0;
  while (true) {
    for (; next < pieces_.size(); ++next) {
      const Edge longest = longest_edge(pieces_[next].vertices);
      waiting.emplace(squared_chord(longest[0], longest[1]), static_cast<Index>(next));
    }
    if (waiting.empty()) return true;
    const Index at = waiting.top().second;
    waiting.pop();
    if (!pieces_[at].alive) continue;
    auto edge = edge_to_cut(pieces_[at], is_resolved);
    if (!edge) continue;
    while (const auto longer = much_longer_edge(*edge)) edge = longer;
    if (pieces_.size() > budget || !cut(*edge)) return false;
    if (pieces_[at].alive) waiting.emplace(kNoLength, at);
  }
}

double LevelComplex::squared_chord(Index u, Index v) const {
  const Vertex &s = vertices_[u], &t = vertices_[v];
  const double scale = s.norm * t.norm;
  return scale > 0 ? 2 - 2 * norm_form(s.near, t.near).value / scale : kNoLength;
}

LevelComplex::Edge LevelComplex::longest_edge(const Cell& cell) const {
  Edge longest{cell[0], cell[1]};
  double most = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (const double c = squared_chord(cell[i], cell[j]); c > most)
        most = c, longest = {cell[i], cell[j]};
  return longest;
}

std::optional<LevelComplex::Edge> LevelComplex::edge_to_cut(
    Piece& piece, const std::function<bool(const Face&)>& is_resolved) {
  const Cell& c = piece.vertices;
  if (piece.proof == SimplexProof::none) {
    piece.proof = prove<4>(
        {vertices_[c[0]].near, vertices_[c[1]].near, vertices_[c[2]].near, vertices_[c[3]].near},
        level_, square_);
  }
  if (piece.proof == SimplexProof::empty) return std::nullopt;
  const Edge longest = longest_edge(c);
  if (piece.proof == SimplexProof::none) return longest;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Edge edge{c[i], c[j]};
      if (is_simple(edge)) continue;
      const bool short_one =
          kLonger * squared_chord(edge[0], edge[1]) < squared_chord(longest[0], longest[1]);
      return short_one ? longest : edge;
    }
  for (const Face& face : {Face{c[0], c[1], c[2]}, Face{c[0], c[1], c[3]}, Face{c[0], c[2], c[3]},
                           Face{c[1], c[2], c[3]}})
    if (!is_simple(face) || (is_resolved && is_met(face) && !is_resolved(face))) return longest;
  return std::nullopt;
}

bool LevelComplex::is_simple(const Edge& edge) {
  const auto [at, added] = edges_.try_emplace(simplex_key(edge), false);
  if (added) {
    const Vertex &u = vertices_[edge[0]], &v = vertices_[edge[1]];
    at->second = crossings({u.near, v.near}, {u.above, v.above}, level_, square_) < 2;
  }
  return at->second;
}

bool LevelComplex::is_simple(const Face& face) {
  const auto [at, added] = faces_.try_emplace(simplex_key(face), false);
  if (added) {
    at->second =
        prove<3>({vertices_[face[0]].near, vertices_[face[1]].near, vertices_[face[2]].near},
                 level_, square_) != SimplexProof::none;
  }
  return at->second;
}

std::optional<LevelComplex::Edge> LevelComplex::much_longer_edge(const Edge& edge) const {
  const double limit = kMuchLonger * squared_chord(edge[0], edge[1]);
  for (const Index at : pieces_at_[edge[0]]) {
    const Piece& piece = pieces_[at];
    if (!piece.alive || !contains(piece.vertices, edge[1])) continue;
    const Edge longest = longest_edge(piece.vertices);
    if (squared_chord(longest[0], longest[1]) > limit) return longest;
  }
  return std::nullopt;
}

// A simple combination of the ends that about halves the angle between them.
Deviator<Integer> LevelComplex::cut_point(const Edge& edge) const {
  const auto [first, second] = std::minmax(edge[0], edge[1]);
  const Vertex &u = vertices_[first], &v = vertices_[second];
  const double of_u = kParts * v.norm / (u.norm + v.norm);
  int part = std::isfinite(of_u) ? static_cast<int>(std::lround(of_u)) : kParts / 2;
  const std::size_t cuts = vertices_.size();
  if (cuts < kUnevenCuts) part += cuts / 2 % 2 == 0 ? 1 : -1;
  part = std::clamp(part, 1, kParts - 1);
  // The ends as they are near unit size, that is divided by a power of two each.
  const Integer a = shifted(part, v.size - u.size), b = shifted(kParts - part, u.size - v.size);
  return a * u.tensor + b * v.tensor;
}

bool LevelComplex::cut(const Edge& edge) {
  if (vertices_.size() >= kMostVertices) return false;
  const Deviator<Integer> point = cut_point(edge);
  if (!antipodal_) {
    cut(edge, add_vertex(point));
    return true;
  }
  const Index at = add_twins(point);
  cut(edge, at);
  cut({twin(edge[0]), twin(edge[1])}, twin(at));
  return true;
}

void LevelComplex::cut(const Edge& edge, Index at) {
  const auto [u, v] = edge;
  // Parts of what is proved simple are.
  if (const auto known = edges_.find(simplex_key(edge)); known != edges_.end() && known->second) {
    edges_[simplex_key(Edge{u, at})] = true;
    edges_[simplex_key(Edge{at, v})] = true;
  }
  const std::vector<Index> around = std::move(pieces_at_[u]);
  pieces_at_[u].clear();
  for (const Index index : around) {
    if (!pieces_[index].alive) continue;
    if (!contains(pieces_[index].vertices, v)) {
      pieces_at_[u].push_back(index);
      continue;
    }
    pieces_[index].alive = false;
    const Piece whole = pieces_[index];
    for (const Index w : whole.vertices) {
      if (w == u || w == v) continue;
      const auto known = faces_.find(simplex_key(Face{u, v, w}));
      if (known == faces_.end() || !known->second) continue;
      faces_[simplex_key(Face{u, at, w})] = true;
      faces_[simplex_key(Face{at, v, w})] = true;
    }
    for (const Index lost : {u, v}) {
      Piece part = whole;
      part.alive = true;
      std::replace(part.vertices.begin(), part.vertices.end(), lost, at);
      add_piece(part);
    }
  }
}

}  // namespace tensortopo::theory
