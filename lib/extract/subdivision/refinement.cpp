// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/subdivision/refinement.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"
#include "extract/subdivision/refinement_vertex.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

/// An edge with several crossings is cut unless its cell has one that is longer by this factor:
/// cells that only ever have their other edges cut do not become small. (Two such edges, cut by
/// turns, close in on the longest at a third and two thirds of it.)
constexpr double kLonger = 1.2 * 1.2;

/// Cells in the proof that a face of a cell holds no closed curve.
constexpr std::size_t kFaceBudget = 2000;

/// How often an edge is halved in counting its crossings.
constexpr int kEdgeDepth = 12;

/// A face of a cell.
std::array<std::uint32_t, 3> without(const std::array<std::uint32_t, 4>& cell,
                                     std::size_t omitted) {
  std::array<std::uint32_t, 3> face;
  for (std::size_t i = 0, k = 0; i < 4; ++i)
    if (i != omitted) face[k++] = cell[i];
  return face;
}

/// The first vertices of a simplex.
template <std::size_t Corners, class Scalar, std::size_t Vertices>
std::array<RefinementVertex<Scalar, Vertices>, Corners> corners_of(
    const LevelSimplex<Scalar, Vertices>& simplex) {
  std::array<RefinementVertex<Scalar, Vertices>, Corners> corners;
  for (std::size_t i = 0; i < Corners; ++i) corners[i] = detail::corner_vertex(simplex, i);
  return corners;
}

/// Connected pieces of the level in a triangle whose cells are proved: each holds one arc or none,
/// and arcs meet on the edges that the level crosses.
template <class Scalar, std::size_t Vertices>
std::size_t pieces_of_level(const Refinement<Scalar, Vertices, 3>& triangle) {
  std::unordered_map<std::uint64_t, std::uint32_t> nodes;
  UnionFind arcs;
  for (const auto& cell : triangle.cells()) {
    if (!cell.alive) continue;
    std::array<std::uint32_t, 2> ends{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto u = cell.vertices[i], v = cell.vertices[(i + 1) % 3];
      if (triangle.vertices()[u].above == triangle.vertices()[v].above) continue;
      const auto [at, added] = nodes.try_emplace(edge_key(u, v), 0);
      if (added) at->second = arcs.add();
      ends[count++] = at->second;
    }
    if (count > 0) arcs.unite(ends[0], ends[1]);
  }
  return arcs.count();
}

}  // namespace

template <class Scalar, std::size_t Vertices, std::size_t Corners>
Refinement<Scalar, Vertices, Corners>::Refinement(const LevelSimplex<Scalar, Vertices>& simplex,
                                                  const Level<Scalar>& level) requires(Vertices ==
                                                                                       Corners) {
  reset(simplex, level, corners_of<Corners>(simplex));
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
void Refinement<Scalar, Vertices, Corners>::reset(const LevelSimplex<Scalar, Vertices>& simplex,
                                                  const Level<Scalar>& level) requires(Vertices ==
                                                                                       Corners) {
  reset(simplex, level, corners_of<Corners>(simplex));
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
Refinement<Scalar, Vertices, Corners>::Refinement(const LevelSimplex<Scalar, Vertices>& simplex,
                                                  const Level<Scalar>& level,
                                                  const std::array<Vertex, Corners>& corners) {
  reset(simplex, level, corners);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
void Refinement<Scalar, Vertices, Corners>::reset(const LevelSimplex<Scalar, Vertices>& simplex,
                                                  const Level<Scalar>& level,
                                                  const std::array<Vertex, Corners>& corners) {
  simplex_ = &simplex;
  level_ = &level;
  vertices_.clear();
  offsets_.clear();
  cells_.clear();
  edges_.clear();
  faces_.clear();
  face_cells_ = 0;
  first_cut_ = 0;
  by_hessian_metric_ = false;
  Cell root;
  for (std::size_t i = 0; i < Corners; ++i) root.vertices[i] = add_vertex(corners[i]);
  add_cell(root);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::uint32_t Refinement<Scalar, Vertices, Corners>::add_vertex(const Vertex& v) {
  vertices_.push_back(v);
  if (is_near_degenerate(*level_)) {
    const auto t = rounded(std::array{v.tensor})[0];
    offsets_.push_back(norm_form(t) > 0 ? detail::degenerate_offset(t, level_->sign) : t);
  }
  if (cells_at_.size() < vertices_.size()) cells_at_.emplace_back();
  cells_at_[vertices_.size() - 1].clear();
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
void Refinement<Scalar, Vertices, Corners>::add_cell(const Cell& cell) {
  for (const auto v : cell.vertices)
    cells_at_[v].push_back(static_cast<std::uint32_t>(cells_.size()));
  cells_.push_back(cell);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::run(std::size_t budget, double smallest) {
  // The largest first: a large cell must not be worn down from its sides by cuts of small ones.
  std::priority_queue<std::pair<double, std::uint32_t>> waiting;
  std::size_t next = 0;
  while (true) {
    for (; next < cells_.size(); ++next)
      waiting.emplace(longest_edge(cells_[next].vertices).squared_length,
                      static_cast<std::uint32_t>(next));
    if (waiting.empty()) return true;
    const auto [size, c] = waiting.top();
    waiting.pop();
    if (!cells_[c].alive) continue;
    auto edge = edge_to_cut(cells_[c]);
    if (!edge) continue;
    if (cells_.size() + face_cells_ / 4 > budget || size < smallest) return false;
    while (const auto longer = much_longer_edge(*edge)) edge = longer;
    auto is_cut = cut_at_small_field(edge->ends);
    if (!is_cut) is_cut = cut_between_crossings(edge->ends);
    if (!is_cut) is_cut = cut_edge(edge->ends);
    if (!*is_cut) return restart() && run(budget, smallest);
    if (cells_[c].alive) waiting.emplace(std::numeric_limits<double>::infinity(), c);
  }
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::cut_cells(const LevelSimplex<Scalar, Vertices>& simplex,
                                                      const Level<Scalar>& level,
                                                      std::span<const std::uint32_t> cells,
                                                      std::size_t budget) {
  simplex_ = &simplex;
  level_ = &level;
  for (const auto c : cells) {
    if (!cells_[c].alive) continue;
    if (!cut_edge(longest_edge(cells_[c].vertices).ends)) return false;
  }
  return run(budget);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::run_along_saddles(
    std::size_t budget,
    std::span<const std::array<std::int64_t, 4>> saddles) requires(Vertices == 4 && Corners == 4) {
  by_hessian_metric_ = true;
  const auto cut_at = [&]<std::size_t Part>(const std::array<std::int64_t, 4>& place) {
    std::array<std::uint32_t, Part> part;
    detail::Shares<Part> shares;
    for (std::uint32_t i = 0, k = 0; i < 4; ++i)
      if (place[i] != 0) part[k] = i, shares[k++] = place[i];
    return cut<Part>(part, shares);
  };
  for (const auto& place : saddles)
    if (!(std::count(place.begin(), place.end(), 0) == 2 ? cut_at.template operator()<2>(place)
                                                         : cut_at.template operator()<3>(place)))
      return false;
  return run(budget);
}

/// Begins again with other first cuts, once: by chance a side of a cell may touch the level
/// exactly, and stays however small its parts. (Next to modes 1 and -1 cells are small for other
/// reasons.)
template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::restart() {
  if (first_cut_ != 0 || by_hessian_metric_ || is_near_degenerate(*level_)) return false;
  std::array<Vertex, Corners> corners;
  std::copy_n(vertices_.begin(), Corners, corners.begin());
  reset(*simplex_, *level_, corners);
  first_cut_ = 1;
  return true;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
auto Refinement<Scalar, Vertices, Corners>::edge_to_cut(Cell& cell) -> std::optional<Edge> {
  using Kind = typename SimplexProof<Scalar, Corners>::Kind;
  if (cell.proof.kind == Kind::none) cell.proof = prove(cell.vertices);
  if (cell.proof.kind == Kind::empty) return std::nullopt;
  const auto in_the_way = edge_in_the_way(cell.vertices);
  bool is_simple = !in_the_way && cell.proof.kind == Kind::monotone;
  if constexpr (Corners == 4)
    for (std::size_t omitted = 0; omitted < 4 && is_simple; ++omitted)
      is_simple = is_simple_face(without(cell.vertices, omitted));
  if (is_simple) return std::nullopt;
  const auto edges = edges_of(cell.vertices);
  const Edge longest = *std::max_element(edges.begin(), edges.end());
  if (in_the_way && kLonger * edges[*in_the_way].squared_length >= longest.squared_length)
    return edges[*in_the_way];
  return longest;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
template <std::size_t Part>
SimplexProof<Scalar, Part> Refinement<Scalar, Vertices, Corners>::prove(
    const std::array<std::uint32_t, Part>& part) const {
  std::array<ExactPlace<Vertices>, Part> places;
  std::array<Deviator<Scalar>, Part> tensors;
  double total = 0;
  for (std::size_t i = 0; i < Part; ++i) {
    const Vertex& v = vertices_[part[i]];
    places[i] = v.exact();
    tensors[i] = v.tensor;
    total = std::max(total, v.total);
  }
  return prove_part(*simplex_, places, tensors, *level_, total);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
int Refinement<Scalar, Vertices, Corners>::crossings_between(const Vertex& u, const Vertex& v,
                                                             int depth) const {
  if (edge_is_simple<Scalar, Vertices>(*simplex_, {u.exact(), v.exact()}, {u.tensor, v.tensor},
                                       *level_, std::max(u.total, v.total)))
    return u.above != v.above ? 1 : 0;
  if (depth == kEdgeDepth) return 2;
  const auto middle =
      detail::place_among<Scalar, Vertices, 2>(*simplex_, *level_, {1, 1}, {&u, &v});
  if (!middle) return 2;
  const auto& m = middle->vertex;
  const int first = crossings_between(u, m, depth + 1);
  return first >= 2 ? first : first + crossings_between(m, v, depth + 1);
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::is_simple_edge(const Ends& ends) {
  const auto [u, v] = ends;
  signed char& simple = edges_[edge_key(u, v)];
  if (simple == 0) simple = crossings_between(vertices_[u], vertices_[v], 0) < 2 ? 1 : -1;
  return simple > 0;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<std::size_t> Refinement<Scalar, Vertices, Corners>::edge_in_the_way(
    const std::array<std::uint32_t, Corners>& cell) {
  std::size_t e = 0;  // as in `edges_of`
  for (std::size_t i = 0; i < Corners; ++i)
    for (std::size_t j = i + 1; j < Corners; ++j, ++e)
      if (!is_simple_edge({cell[i], cell[j]})) return e;
  return std::nullopt;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::is_simple_face(
    const std::array<std::uint32_t, 3>& face) {
  signed char& simple = faces_[face_key(face[0], face[1], face[2])];
  if (simple == 0)
    simple = prove(face).kind != SimplexProof<Scalar, 3>::Kind::none || has_no_loop(face) ? 1 : -1;
  return simple > 0;
}

/// For a face whose edges are simple: whether a refinement of its own shows that the level makes
/// one arc in it if it crosses the edges, and nothing otherwise.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::has_no_loop(const std::array<std::uint32_t, 3>& face) {
  if constexpr (Corners == 4) {
    const std::array<Vertex, 3> corners{vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]};
    thread_local Refinement<Scalar, Vertices, 3> triangle;
    triangle.reset(*simplex_, *level_, corners);
    const bool is_refined = triangle.run(kFaceBudget);
    face_cells_ += triangle.cells().size();
    if (!is_refined) return false;
    const auto pieces = pieces_of_level(triangle);
    const bool crossed =
        corners[0].above != corners[1].above || corners[1].above != corners[2].above;
    return pieces == (crossed ? 1 : 0);
  }
  return false;
}

#define TENSORTOPO_INSTANTIATE(Scalar)  \
  template class Refinement<Scalar, 3>; \
  template class Refinement<Scalar, 4>; \
  template class Refinement<Scalar, 4, 3>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
