// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/isotopic_level.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"
#include "extract/topology/cell_topology.hpp"
#include "extract/topology/regions/closed_curves.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo::detail {

namespace {

template <class Scalar>
const Level<Scalar>& isotopic_level(int k, int sign) {
  thread_local std::map<int, Level<Scalar>> made;
  auto& level = made[k * sign];
  if (level.value.sign() == 0) {
    const std::int64_t whole = std::int64_t{1} << k;
    level = make_level<Scalar>(ModeValue::parse((sign < 0 ? "-" : "") + std::to_string(whole - 1) +
                                                "/" + std::to_string(whole)));
  }
  return level;
}

/// The mode curves of another level on the faces of a tetrahedron. No vertex lies between the
/// levels, so its sides stay.
template <class Scalar>
bool curves_at(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, Budget budget,
               std::array<std::vector<FaceArc<Scalar>>, 4>& arcs) {
  std::array<std::vector<EdgeCrossing<Scalar>>, 6> crossings;
  for (std::size_t e = 0; e < 6; ++e) {
    auto from = static_cast<std::uint8_t>(kTetEdges[e][0]);
    auto to = static_cast<std::uint8_t>(kTetEdges[e][1]);
    if (!tet.edge_forward[e]) std::swap(from, to);
    auto found = edge_crossings(part_of_simplex<2>(tet.simplex, {from, to}), level);
    if (!found) return false;
    crossings[e] = std::move(*found);
  }
  Sampling sparse;
  sparse.resolution = 1;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& v = tet.face_vertices[f];
    const auto on = [&](std::size_t i, std::size_t j) {
      return std::span<const EdgeCrossing<Scalar>>(
          crossings[static_cast<std::size_t>(tet_edge(v[i], v[j]))]);
    };
    auto found = face_curves(part_of_simplex<3>(tet.simplex, v), {on(0, 1), on(0, 2), on(1, 2)},
                             level, sparse, budget);
    if (!found) return false;
    arcs[f] = std::move(*found);
  }
  return true;
}

/// For each arc of a face at the near-degenerate level, the one at the thick level.
template <class Scalar>
bool match_arcs(const LevelSimplex<Scalar, 3>& face, std::span<const FaceArc<Scalar>> given_arcs,
                const Level<Scalar>& given, std::span<const FaceArc<Scalar>> isotopic_arcs,
                const Level<Scalar>& isotopic, std::vector<int>& match) {
  if (given_arcs.size() != isotopic_arcs.size()) return false;
  const auto ends = [](const FaceArc<Scalar>& arc) {
    return std::array{arc.begin.edge, arc.begin.crossing, arc.end.edge, arc.end.crossing};
  };
  std::map<std::array<int, 4>, int> by_ends;
  std::vector<int> closed;
  for (std::size_t a = 0; a < isotopic_arcs.size(); ++a)
    if (isotopic_arcs[a].closed)
      closed.push_back(static_cast<int>(a));
    else
      by_ends[ends(isotopic_arcs[a])] = static_cast<int>(a);
  std::optional<ClosedCurves<Scalar>> curves;
  std::size_t open = 0;
  match.assign(given_arcs.size(), -1);
  for (std::size_t a = 0; a < given_arcs.size(); ++a) {
    if (!given_arcs[a].closed) {
      const auto found = by_ends.find(ends(given_arcs[a]));
      if (found == by_ends.end()) return false;
      match[a] = found->second;
      ++open;
    } else if (closed.size() == 1) {
      match[a] = closed[0];
    } else {
      if (!curves) curves.emplace(face, isotopic, isotopic_arcs);
      // A place beyond the near-degenerate level is beyond the thick one, on the same side of the
      // curve.
      const auto place = superlevel_place(face, given_arcs[a], given);
      match[a] = place ? curves->take(*place) : -1;
      if (match[a] < 0) return false;
    }
  }
  return open == by_ends.size();
}

}  // namespace

template <class Scalar>
std::optional<Sheets> sheets_of_isotopic_level(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const BoundaryLoops& loops,
                                               const Level<Scalar>& other, Budget budget) {
  std::array<std::vector<FaceArc<Scalar>>, 4> arcs;
  // Where the regular budget was enough for the faces, it has been tried on the tetrahedron.
  if (is_budget_spent(budget, other.gap()) && curves_at(tet, other, Budget::regular, arcs))
    return std::nullopt;
  if (!curves_at(tet, other, budget, arcs)) return std::nullopt;
  const bool is_wider = other.mu_squared < level.mu_squared;
  auto other_tet = tet;
  std::array<std::vector<int>, 4> match;
  for (std::size_t f = 0; f < 4; ++f) {
    other_tet.arcs[f] = arcs[f];
    const auto face = part_of_simplex<3>(tet.simplex, tet.face_vertices[f]);
    std::vector<int> isotopic;
    if (is_wider ? !match_arcs(face, tet.arcs[f], level, other_tet.arcs[f], other, match[f])
                 : !match_arcs(face, other_tet.arcs[f], other, tet.arcs[f], level, isotopic))
      return std::nullopt;
    if (is_wider) continue;
    match[f].assign(isotopic.size(), -1);
    for (std::size_t a = 0; a < isotopic.size(); ++a)
      match[f][static_cast<std::size_t>(isotopic[a])] = static_cast<int>(a);
  }
  auto proved = prove_cell_by_subdivision(other_tet, other, budget);
  if (!proved || proved->loops.size() != loops.size()) return std::nullopt;
  std::map<std::pair<int, int>, int> loop_of_arc;  // at the other level
  for (std::size_t l = 0; l < proved->loops.size(); ++l)
    for (const auto& piece : proved->loops[l])
      loop_of_arc[{piece.face, piece.arc}] = static_cast<int>(l);
  std::vector<int> own_loop(loops.size(), -1);
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const auto& piece : loops[l]) {
      const int arc =
          match[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)];
      auto& known = own_loop[static_cast<std::size_t>(loop_of_arc.at({piece.face, arc}))];
      if (known >= 0 && known != static_cast<int>(l)) return std::nullopt;
      known = static_cast<int>(l);
    }
  for (auto& sheet : proved->sheets)
    for (int& l : sheet.loops) {
      l = own_loop[static_cast<std::size_t>(l)];
      if (l < 0) return std::nullopt;
    }
  return std::move(proved->sheets);
}

template <class Scalar>
std::optional<Sheets> sheets_of_wider_isotopic_level(const TetWithCurves<Scalar>& tet,
                                                     const Level<Scalar>& level,
                                                     const BoundaryLoops& loops, double open_until,
                                                     Budget budget) {
  int k = kWidest;
  while (k < kNarrowest && kClearance * gap_of(k) > open_until) ++k;
  const auto& isotopic = isotopic_level<Scalar>(k, level.sign);
  // Strictly between the critical value and the near-degenerate level, whatever rounding does.
  if (!(gap_of(k) / 2 > static_cast<double>(Scalar(1) - level.mu_squared))) return std::nullopt;
  return sheets_of_isotopic_level(tet, level, loops, isotopic, budget);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                          \
  template std::optional<Sheets> sheets_of_isotopic_level(                      \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&, \
      const Level<Scalar>&, Budget);                                            \
  template std::optional<Sheets> sheets_of_wider_isotopic_level(                \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&, double, Budget);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
