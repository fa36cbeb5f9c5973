// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/cell_topology.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "extract/level/critical/saddle_level.hpp"
#include "extract/level/critical/zero_inside.hpp"
#include "extract/level/exact_tensors.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/segment_root.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/refine_tet.hpp"
#include "extract/topology/graph_sheets.hpp"
#include "extract/topology/isotopic_level.hpp"
#include "extract/topology/near_degenerate_sheets.hpp"
#include "extract/topology/regions/counted_sheets.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

template <class Scalar>
std::map<std::uint32_t, CrossingKey> crossings_of_subdivision(const TetWithCurves<Scalar>& tet,
                                                              const CellTopology<Scalar>& proved) {
  const auto& vertices = proved.subdivision->refinement.vertices();
  const auto& nodes = proved.subdivision->mesh.nodes;
  std::map<int, std::vector<std::uint32_t>> on_edge;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    if ((nodes[n].faces & (nodes[n].faces - 1)) == 0) continue;  // fewer than two faces
    int ends[2] = {-1, -1};
    for (int i = 0, k = 0; i < 4; ++i)
      if (!(nodes[n].faces >> i & 1)) ends[k++] = i;
    on_edge[tet_edge(ends[0], ends[1])].push_back(n);
  }
  std::map<std::uint32_t, CrossingKey> result;
  for (auto& [edge, list] : on_edge) {
    // Two sides of cells on an edge have at most an end in common.
    const auto from = static_cast<std::size_t>(kTetEdges[static_cast<std::size_t>(edge)][0]);
    const auto to = static_cast<std::size_t>(kTetEdges[static_cast<std::size_t>(edge)][1]);
    const auto first = [&](std::uint32_t n) -> const ExactWeights<4>& {
      const auto &u = vertices[nodes[n].first].place, &v = vertices[nodes[n].second].place;
      return u.comes_before(v, from, to) ? u : v;
    };
    std::sort(list.begin(), list.end(), [&](std::uint32_t m, std::uint32_t n) {
      return first(m).comes_before(first(n), from, to);
    });
    const int count = static_cast<int>(list.size());
    for (int k = 0; k < count; ++k)
      result[list[static_cast<std::size_t>(k)]] = {
          edge, tet.edge_forward[static_cast<std::size_t>(edge)] ? k : count - 1 - k};
  }
  return result;
}

template <class Scalar>
InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>& refinement,
                               const SubdivisionMesh::Node& node, const Level<Scalar>& level) {
  const auto &u = refinement.vertices()[node.first], &v = refinement.vertices()[node.second];
  const Scalar f = segment_root(u.tensor, v.tensor, v.above, level);
  InnerVertex<Scalar> point;
  for (std::size_t i = 0; i < 4; ++i)
    point.weights[i] = Scalar(u.weights[i]) + f * Scalar(v.weights[i] - u.weights[i]);
  point.tensor = u.tensor + f * (v.tensor - u.tensor);
  return point;
}

namespace {

template <class Scalar>
std::pair<int, Scalar> locate(const TetWithCurves<Scalar>& tet, int face,
                              const InnerVertex<Scalar>& point) {
  const auto f = static_cast<std::size_t>(face);
  std::array<Scalar, 3> weights;
  std::array<Deviator<Scalar>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = point.weights[tet.face_vertices[f][i]];
    corners[i] = tet.simplex.tensors[tet.face_vertices[f][i]];
  }
  return locate_on_arcs(tet.arcs[f], corners, weights, point.tensor);
}

int face_of(std::uint8_t faces) {
  int f = 0;
  while (!(faces >> f & 1)) ++f;
  return f;
}

/// Finds which loop of the faces each boundary cycle of the subdivision mesh is, and lists the
/// sheets.
template <class Scalar>
bool sheets_from_subdivision(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                             CellTopology<Scalar>& proved) {
  const auto& mesh = proved.subdivision->mesh;
  if (mesh.boundary_loops.size() != proved.loops.size()) return false;
  std::map<CrossingKey, int> loop_of_crossing;
  std::map<std::pair<int, int>, int> loop_of_arc;
  for (std::size_t l = 0; l < proved.loops.size(); ++l)
    for (const auto& piece : proved.loops[l]) {
      const auto& arc =
          tet.arcs[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)];
      loop_of_arc[{piece.face, piece.arc}] = static_cast<int>(l);
      if (arc.closed) continue;
      for (const auto& end : {arc.begin, arc.end})
        loop_of_crossing[crossing_of(tet, piece.face, end)] = static_cast<int>(l);
    }
  const auto crossings = crossings_of_subdivision(tet, proved);
  if (crossings.size() != loop_of_crossing.size()) return false;
  std::vector<int> loop(mesh.boundary_loops.size(), -1);
  std::vector<char> taken(proved.loops.size(), 0);
  for (std::size_t r = 0; r < mesh.boundary_loops.size(); ++r) {
    for (const auto n : mesh.boundary_loops[r]) {
      const auto found = crossings.find(n);
      if (found == crossings.end()) continue;
      const auto known = loop_of_crossing.find(found->second);
      if (known == loop_of_crossing.end()) return false;
      if (loop[r] >= 0 && loop[r] != known->second) return false;
      loop[r] = known->second;
    }
    if (loop[r] < 0) {  // touches no edge: a closed curve of one face
      const auto n = mesh.boundary_loops[r][0];
      const int face = face_of(mesh.nodes[n].faces);
      const auto [arc, place] =
          locate(tet, face, node_point(proved.subdivision->refinement, mesh.nodes[n], level));
      if (arc < 0) return false;
      loop[r] = loop_of_arc.at({face, arc});
    }
    if (taken[static_cast<std::size_t>(loop[r])]++) return false;
  }
  proved.sheets.clear();
  for (std::size_t c = 0; c < mesh.components.size(); ++c) {
    SheetTopology sheet;
    sheet.component = static_cast<int>(c);
    sheet.euler_characteristic = mesh.components[c].euler_characteristic;
    for (const int r : mesh.components[c].boundary_loops)
      sheet.loops.push_back(loop[static_cast<std::size_t>(r)]);
    proved.sheets.push_back(std::move(sheet));
  }
  return true;
}

/// Whether no refinement can end: the deviator vanishes inside, or the level is that of a saddle.
template <class Scalar>
bool cannot_end(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level) {
  const auto corners = rounded(tet.simplex.tensors);
  const bool may_vanish = may_have_zero_inside(corners),
             may_be_critical = may_be_level_at_saddle(corners, level.parameter.mu);
  if (!may_vanish && !may_be_critical) return false;
  const auto tensors = detail::exact_tensors(tet.simplex);
  return (may_vanish && has_zero_inside(tensors)) ||
         (may_be_critical && is_level_at_saddle(tensors, level.value));
}

/// One for each thread, to be filled again: refinements are short, their memory is not.
template <class Scalar>
std::unique_ptr<typename CellTopology<Scalar>::Subdivision>& spare_subdivision() {
  thread_local std::unique_ptr<typename CellTopology<Scalar>::Subdivision> spare;
  return spare;
}

}  // namespace

template <class Scalar>
bool add_subdivision(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                     CellTopology<Scalar>& proved, Budget budget) {
  if (proved.subdivision) return true;
  auto& spare = spare_subdivision<Scalar>();
  proved.subdivision =
      spare ? std::move(spare) : std::make_unique<typename CellTopology<Scalar>::Subdivision>();
  if (!detail::refine_tet(proved.subdivision->refinement, tet.simplex, level, budget)) {
    spare = std::move(proved.subdivision);
    return false;
  }
  proved.subdivision->mesh = subdivision_mesh(proved.subdivision->refinement);
  return sheets_from_subdivision(tet, level, proved);
}

template <class Scalar>
bool refine_subdivision(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                        std::span<const std::uint32_t> cells, CellTopology<Scalar>& proved) {
  auto& refinement = proved.subdivision->refinement;
  constexpr std::size_t kMostAdded = 20000;
  bool is_proved =
      refinement.cut_cells(tet.simplex, level, cells, refinement.cells().size() + kMostAdded);
  if (is_proved) {
    proved.subdivision->mesh = subdivision_mesh(refinement);
    is_proved = sheets_from_subdivision(tet, level, proved);
  }
  if (!is_proved) proved.subdivision.reset();
  return is_proved;
}

namespace {

/// The loops, and the sheets if the level is a graph in the whole tetrahedron.
template <class Scalar>
std::optional<CellTopology<Scalar>> topology_at_once(
    const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
    const SimplexProof<Scalar, 4>* known = nullptr) {
  CellTopology<Scalar> proved;
  if (!join_arcs(tet, proved.loops)) return std::nullopt;
  if (proved.loops.empty()) return proved;
  const auto proof = known != nullptr ? *known : prove_simplex(tet.simplex.tensors, level);
  if (proof.kind == SimplexProof<Scalar, 4>::Kind::monotone)
    if (auto sheets = sheets_of_graph<Scalar>(tet, proved.loops, proof.direction)) {
      proved.sheets = std::move(*sheets);
      proved.direction = proof.direction;
    }
  return proved;
}

/// Whether there is no more to find: every sheet of a linear field reaches a face.
template <class Scalar>
bool is_complete(const CellTopology<Scalar>& proved) {
  return proved.loops.empty() || !proved.sheets.empty();
}

template <class Scalar>
bool refine(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, Budget budget,
            CellTopology<Scalar>& proved) {
  if (cannot_end(tet, level)) return false;
  proved.refined = true;
  if (!add_subdivision(tet, level, proved, budget)) return false;
  // Multiprecision may have proved what doubles did not: a graph in the whole tetrahedron.
  const auto& cells = proved.subdivision->refinement.cells();
  if (cells.size() == 1 && cells[0].proof.kind == SimplexProof<Scalar, 4>::Kind::monotone)
    proved.direction = cells[0].proof.direction;
  // Hardly any sheet is meshed from its subdivision, which are large.
  spare_subdivision<Scalar>() = std::move(proved.subdivision);
  return true;
}

}  // namespace

template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell_by_subdivision(const TetWithCurves<Scalar>& tet,
                                                              const Level<Scalar>& level,
                                                              Budget budget) {
  auto proved = topology_at_once(tet, level);
  if (proved && !is_complete(*proved) && !refine(tet, level, budget, *proved)) return std::nullopt;
  return proved;
}

template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell(const TetWithCurves<Scalar>& tet,
                                               const Level<Scalar>& level,
                                               const Level<Scalar>* isotopic, Budget budget) {
  return prove_cell_from<Scalar>(nullptr, tet, level, isotopic, budget);
}

template <class Scalar>
std::optional<CellTopology<Scalar>> prove_cell_from(const SimplexProof<Scalar, 4>* known,
                                                    const TetWithCurves<Scalar>& tet,
                                                    const Level<Scalar>& level,
                                                    const Level<Scalar>* isotopic, Budget budget) {
  auto proved = topology_at_once(tet, level, known);
  if (!proved || is_complete(*proved)) return proved;
  if (isotopic != nullptr)
    if (auto sheets =
            detail::sheets_of_isotopic_level(tet, level, proved->loops, *isotopic, budget)) {
      proved->sheets = std::move(*sheets);
      proved->refined = true;
      return proved;
    }
  if (is_near_degenerate(level))
    if (auto given = sheets_of_near_degenerate_level(tet, level, proved->loops, budget)) {
      proved->sheets = std::move(given->sheets);
      proved->tubes = std::move(given->tubes);
      proved->refined = true;
      return proved;
    }
  if (is_budget_spent(budget, level.gap())) return std::nullopt;
  if (refine(tet, level, budget, *proved)) return proved;
  if (budget == Budget::regular || !is_near_degenerate(level)) return std::nullopt;
  auto sheets = detail::sheets_counted_from_distant_level(tet, level, proved->loops);
  if (!sheets) return std::nullopt;
  proved->sheets = std::move(*sheets);
  proved->subdivision.reset();
  return proved;
}

template <class Scalar>
std::vector<SampleRequest<Scalar>> subdivision_requests(const TetWithCurves<Scalar>& tet,
                                                        const Level<Scalar>& level,
                                                        const CellTopology<Scalar>& proved) {
  const auto& mesh = proved.subdivision->mesh;
  std::vector<SampleRequest<Scalar>> requests(mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    requests[n].arc = -1;
    const auto faces = mesh.nodes[n].faces;
    if (faces == 0 || (faces & (faces - 1)) != 0) continue;
    const int face = face_of(faces);
    const auto [arc, place] =
        locate(tet, face, node_point(proved.subdivision->refinement, mesh.nodes[n], level));
    requests[n] = {face, arc, place};
  }
  return requests;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                         \
  template std::map<std::uint32_t, CrossingKey> crossings_of_subdivision(                      \
      const TetWithCurves<Scalar>&, const CellTopology<Scalar>&);                              \
  template InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>&,                        \
                                          const SubdivisionMesh::Node&, const Level<Scalar>&); \
  template bool refine_subdivision(const TetWithCurves<Scalar>&, const Level<Scalar>&,         \
                                   std::span<const std::uint32_t>, CellTopology<Scalar>&);     \
  template bool add_subdivision(const TetWithCurves<Scalar>&, const Level<Scalar>&,            \
                                CellTopology<Scalar>&, Budget);                                \
  template std::optional<CellTopology<Scalar>> prove_cell_by_subdivision(                      \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, Budget);                             \
  template std::optional<CellTopology<Scalar>> prove_cell_from(                                \
      const SimplexProof<Scalar, 4>*, const TetWithCurves<Scalar>&, const Level<Scalar>&,      \
      const Level<Scalar>*, Budget);                                                           \
  template std::optional<CellTopology<Scalar>> prove_cell(                                     \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const Level<Scalar>*, Budget);       \
  template std::vector<SampleRequest<Scalar>> subdivision_requests(                            \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const CellTopology<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
