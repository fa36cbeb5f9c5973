// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0

// Which edge of a refinement is cut next, and where: `refinement.cpp` says when a cell need not be.
#include <algorithm>
#include <cmath>
#include <utility>

#include "extract/level/multiprecision_level.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/hessian_metric.hpp"
#include "extract/subdivision/refinement.hpp"
#include "extract/subdivision/refinement_vertex.hpp"
#include "extract/subdivision/small_field.hpp"

namespace tensortopo {

namespace {

/// How many edges of a refinement are cut off the middle. Each such cut along a chain takes five
/// bits of the weights, which have 52. Levels that are hidden in doubles want them for cells
/// that are small across their tubes.
constexpr std::size_t kUnevenCuts = 12, kUnevenCutsNearDegenerate = 4;

/// Next to the degenerate curve two tensors are apart by their offsets from it, and by this times
/// the square of their chord, by which the curve leaves it: cells are long along the curve.
constexpr double kHessian = 1;

/// Lengths are squared chords, 4 at most; this is for what has no length.
constexpr double kLongest = 5;

/// No cell is cut across an edge when it has another that is longer by this factor: it would become
/// a needle.
constexpr double kMuchLonger = 2 * 2;

}  // namespace

template <class Scalar, std::size_t Vertices, std::size_t Corners>
template <std::size_t Part>
auto Refinement<Scalar, Vertices, Corners>::pointers_to(
    const std::array<std::uint32_t, Part>& part) const -> std::array<const Vertex*, Part> {
  std::array<const Vertex*, Part> pointers;
  for (std::size_t i = 0; i < Part; ++i) pointers[i] = &vertices_[part[i]];
  return pointers;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
double Refinement<Scalar, Vertices, Corners>::squared_length(std::uint32_t u,
                                                             std::uint32_t v) const {
  const auto &s = vertices_[u].tensor, &t = vertices_[v].tensor;
  const Scalar scale = norm_form(s) * norm_form(t);
  if (!(scale > Scalar(0))) return kLongest;
  const double cosine =
      static_cast<double>(norm_form(s, t)) / std::sqrt(static_cast<double>(scale));
  // Not below zero, where the search for a longer edge around one would never end.
  const double square = std::max(2 - 2 * cosine, 0.0);
  if (offsets_.empty()) return square;
  return norm_form(offsets_[u] - offsets_[v]) / 3 + kHessian * square * square;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
auto Refinement<Scalar, Vertices, Corners>::edges_of(
    const std::array<std::uint32_t, Corners>& cell) const
    -> std::array<Edge, Corners*(Corners - 1) / 2> {
  std::array<Edge, Corners*(Corners - 1) / 2> edges;
  std::size_t e = 0;
  for (std::size_t i = 0; i < Corners; ++i)
    for (std::size_t j = i + 1; j < Corners; ++j) edges[e++].ends = {cell[i], cell[j]};
  if constexpr (Corners == 4 && Vertices == 4)
    if (by_hessian_metric_) {
      const auto lengths = detail::hessian_lengths<Scalar>(pointers_to(cell));
      for (e = 0; e < 6; ++e) edges[e].squared_length = lengths[e];
      return edges;
    }
  for (Edge& edge : edges) edge.squared_length = squared_length(edge.ends[0], edge.ends[1]);
  return edges;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
auto Refinement<Scalar, Vertices, Corners>::much_longer_edge(const Edge& edge) const
    -> std::optional<Edge> {
  const auto [u, v] = edge.ends;
  for (const auto c : cells_at_[u]) {
    const auto& cell = cells_[c];
    if (!cell.alive ||
        std::find(cell.vertices.begin(), cell.vertices.end(), v) == cell.vertices.end())
      continue;
    const auto longest = longest_edge(cell.vertices);
    // Lengths grow on the way, also where each cell measures them in its own way.
    if (longest.squared_length > kMuchLonger * edge.squared_length) return longest;
  }
  return std::nullopt;
}

/// Where the field nearly vanishes in a cell around an edge or in a face around it, a vertex is put
/// there before the edge is cut.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<bool> Refinement<Scalar, Vertices, Corners>::cut_at_small_field(const Ends& ends) {
  const auto [u, v] = ends;
  for (const auto c : cells_at_[u]) {
    const auto cell = cells_[c].vertices;
    if (!cells_[c].alive || std::find(cell.begin(), cell.end(), v) == cell.end()) continue;
    if (const auto shares = shares_of_small_field(cell)) return cut(cell, *shares);
    if constexpr (Corners == 4)
      for (const auto w : cell) {
        if (w == u || w == v) continue;
        const std::array<std::uint32_t, 3> face{u, v, w};
        if (const auto shares = shares_of_small_field(face)) return cut(face, *shares);
      }
  }
  return std::nullopt;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
template <std::size_t Part>
std::optional<detail::Shares<Part>> Refinement<Scalar, Vertices, Corners>::shares_of_small_field(
    const std::array<std::uint32_t, Part>& part) const {
  return detail::shares_of_small_field<Scalar, Vertices, Part>(pointers_to(part));
}

/// The first cuts are off the middle. Real fields have symmetries, and middles would put sides of
/// cells on their axes and planes, where a level can touch a side exactly.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::is_next_cut_uneven() const {
  return vertices_.size() - Vertices <
         (is_inconclusive_in_double(*level_) ? kUnevenCutsNearDegenerate : kUnevenCuts);
}

/// How much of its ends the place has where an edge is cut, the same whichever comes first.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
detail::Shares<2> Refinement<Scalar, Vertices, Corners>::shares_on(
    const Ends& ends, const detail::Shares<2>& usual) const {
  const auto [lower, upper] = std::minmax(ends[0], ends[1]);
  auto shares = detail::shares_of_cut(vertices_[lower], vertices_[upper], usual);
  if (ends[0] != lower) std::swap(shares[0], shares[1]);
  return shares;
}

/// An edge that enters the level and leaves it again: its parts have one crossing each if it is cut
/// inside. Elsewhere a cut would leave both crossings in one part. (Not in a face of the mesh next to
/// the degenerate curve: arcs run close beside each other there, and even cells give them samples at
/// the same places, with which the patches between them have fewer triangles.)
template <class Scalar, std::size_t Vertices, std::size_t Corners>
std::optional<bool> Refinement<Scalar, Vertices, Corners>::cut_between_crossings(
    const Ends& ends) {
  const auto [u, v] = ends;
  if (Vertices == 3 && is_near_degenerate(*level_)) return std::nullopt;
  if (vertices_[u].above != vertices_[v].above || is_simple_edge(ends)) return std::nullopt;
  const int off_middle = is_next_cut_uneven() ? 1 : 0;
  for (const int even : {16, 12, 20, 8, 24, 4, 28}) {
    const int share = even - off_middle;
    const auto shares = shares_on(ends, {share, 32 - share});
    const auto place = detail::place_among<Scalar, Vertices, 2>(*simplex_, *level_, shares,
                                                                pointers_to(ends));
    if (place && place->vertex.above != vertices_[u].above) return cut(ends, shares);
  }
  return std::nullopt;
}

template <class Scalar, std::size_t Vertices, std::size_t Corners>
bool Refinement<Scalar, Vertices, Corners>::cut_edge(const Ends& ends) {
  constexpr std::array<int, 5> thirty_seconds{13, 17, 15, 19, 14};
  const std::size_t cuts = vertices_.size() - Vertices;
  const bool uneven = is_next_cut_uneven();
  const int share = uneven ? thirty_seconds[(first_cut_ + cuts) % thirty_seconds.size()] : 1;
  return cut(ends, shares_on(ends, {share, uneven ? 32 - share : 1}));
}

/// Puts a vertex into an edge, a face or a cell. All cells that have it are cut at once: none is
/// ever left with a vertex on its side.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
template <std::size_t Part>
bool Refinement<Scalar, Vertices, Corners>::cut(const std::array<std::uint32_t, Part>& part,
                                                const detail::Shares<Part>& shares) {
  const auto place =
      detail::place_among<Scalar, Vertices, Part>(*simplex_, *level_, shares, pointers_to(part));
  if (!place) return false;
  const auto m = add_vertex(place->vertex);
  // What is proved of an edge or a face is proved of its parts.
  if constexpr (Part == 2)
    if (edges_[edge_key(part[0], part[1])] > 0)
      for (const auto u : part) edges_[edge_key(u, m)] = 1;
  if constexpr (Part == 3)
    if (faces_[face_key(part[0], part[1], part[2])] > 0)
      for (std::size_t lost = 0; lost < 3; ++lost)
        faces_[face_key(m, part[(lost + 1) % 3], part[(lost + 2) % 3])] = 1;
  auto& list = cells_at_[part[0]];
  const auto around = std::move(list);
  list.clear();
  for (const auto c : around) {
    if (!cells_[c].alive) continue;
    const Cell cell = cells_[c];
    std::array<std::size_t, Part> at;
    for (std::size_t i = 0; i < Part; ++i)
      at[i] = static_cast<std::size_t>(
          std::find(cell.vertices.begin(), cell.vertices.end(), part[i]) - cell.vertices.begin());
    if (*std::max_element(at.begin(), at.end()) == Corners) {
      cells_at_[part[0]].push_back(c);
      continue;
    }
    cells_[c].alive = false;
    if constexpr (Corners == 4 && Part == 2)
      for (const auto w : cell.vertices) {
        if (w == part[0] || w == part[1]) continue;
        if (faces_[face_key(part[0], part[1], w)] <= 0) continue;
        for (const auto u : part) faces_[face_key(u, m, w)] = 1;
      }
    for (std::size_t lost = Part; lost-- > 0;) add_child(cell, at, lost, m, place->parts);
  }
  return true;
}

/// The part of a cell that has the place m instead of corner at[lost], where m is the sum of its
/// corners `at` times `parts`. What is proved of the cell is proved of its parts.
template <class Scalar, std::size_t Vertices, std::size_t Corners>
template <std::size_t Part>
void Refinement<Scalar, Vertices, Corners>::add_child(const Cell& cell,
                                                      const std::array<std::size_t, Part>& at,
                                                      std::size_t lost, std::uint32_t m,
                                                      const std::array<double, Part>& parts) {
  Cell child = cell;
  child.alive = true;
  child.vertices[at[lost]] = m;
  auto& d = child.proof.direction;
  const Scalar share(parts[lost]), of_lost = d[at[lost]];
  for (std::size_t i = 0; i < Part; ++i)
    if (i != lost) d[at[i]] = d[at[i]] - of_lost * (Scalar(parts[i]) / share);
  d[at[lost]] = of_lost / share;
  Scalar largest(0);
  for (const auto& x : d) largest = std::max(largest, x < Scalar(0) ? Scalar(-x) : x);
  if (largest > Scalar(0))
    for (auto& x : d) x = x / largest;
  add_cell(child);
}

#define TENSORTOPO_INSTANTIATE_CUTS(Scalar, Vertices, Corners)                                     \
  template auto Refinement<Scalar, Vertices, Corners>::edges_of(                                   \
      const std::array<std::uint32_t, Corners>&) const                                             \
      ->std::array<Edge, Corners*(Corners - 1) / 2>;                                               \
  template auto Refinement<Scalar, Vertices, Corners>::much_longer_edge(const Edge&) const         \
      ->std::optional<Edge>;                                                                       \
  template std::optional<bool> Refinement<Scalar, Vertices, Corners>::cut_at_small_field(          \
      const Ends&);                                                                                \
  template std::optional<bool> Refinement<Scalar, Vertices, Corners>::cut_between_crossings(       \
      const Ends&);                                                                                \
  template bool Refinement<Scalar, Vertices, Corners>::cut_edge(const Ends&);                      \
  template bool Refinement<Scalar, Vertices, Corners>::cut<3>(const std::array<std::uint32_t, 3>&, \
                                                              const detail::Shares<3>&);           \
  template bool Refinement<Scalar, Vertices, Corners>::cut<2>(const std::array<std::uint32_t, 2>&, \
                                                              const detail::Shares<2>&);
#define TENSORTOPO_INSTANTIATE(Scalar)      \
  TENSORTOPO_INSTANTIATE_CUTS(Scalar, 3, 3) \
  TENSORTOPO_INSTANTIATE_CUTS(Scalar, 4, 4) \
  TENSORTOPO_INSTANTIATE_CUTS(Scalar, 4, 3)
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE
#undef TENSORTOPO_INSTANTIATE_CUTS

}  // namespace tensortopo
