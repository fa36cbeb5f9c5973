// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>

#include "exact_tensors.hpp"
#include "extractor_scalars.hpp"
#include "graph_sheets.hpp"
#include "level_strata.hpp"
#include "plan_by_leaves.hpp"
#include "refine_tet.hpp"
#include "tensortopo/extract/segment_root.hpp"
#include "tensortopo/extract/tet_sheets.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "thin_sheets.hpp"
#include "zero_inside.hpp"

namespace tensortopo {

namespace {

/// Joins arcs to loops: at each crossing of an edge one arc arrives and one leaves.
template <class Scalar>
bool join_arcs(const TetWithCurves<Scalar>& tet, std::vector<std::vector<RimPiece>>& loops) {
  struct Leaving {
    CrossingKey begin, end;
    RimPiece piece;
    bool used;
  };
  std::vector<Leaving> leaving;  // by crossing; few
  std::size_t count = 0;
  for (const auto& arcs : tet.arcs) count += arcs.size();
  leaving.reserve(count);
  for (int f = 0; f < 4; ++f) {
    const auto& arcs = tet.arcs[static_cast<std::size_t>(f)];
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      // On a face seen from outside the larger mode is to the left of an arc; the sheet, whose
      // normal points there, then lies to the left of the arc seen from that normal.
      const RimPiece piece{f, static_cast<int>(a), tet.outward[static_cast<std::size_t>(f)]};
      if (arcs[a].closed) {
        loops.push_back({piece});
        continue;
      }
      leaving.push_back({crossing_of(tet, f, piece.forward ? arcs[a].begin : arcs[a].end),
                         crossing_of(tet, f, piece.forward ? arcs[a].end : arcs[a].begin), piece,
                         false});
    }
  }
  const auto before = [](const Leaving& a, const CrossingKey& key) { return a.begin < key; };
  std::sort(leaving.begin(), leaving.end(),
            [&](const Leaving& a, const Leaving& b) { return before(a, b.begin); });
  const auto next = [&](const CrossingKey& key) {
    const auto found = std::lower_bound(leaving.begin(), leaving.end(), key, before);
    return found != leaving.end() && found->begin == key ? found : leaving.end();
  };
  // As many arrive as leave: one at each crossing, if every end is found and none twice.
  for (std::size_t i = 0; i + 1 < leaving.size(); ++i)
    if (leaving[i].begin == leaving[i + 1].begin) return false;
  for (const auto& arc : leaving) {
    const auto found = next(arc.end);
    if (found == leaving.end() || found->used) return false;
    found->used = true;
  }
  for (auto& arc : leaving) arc.used = false;
  for (auto start = leaving.begin(); start != leaving.end(); ++start) {
    if (start->used) continue;
    std::vector<RimPiece> loop;
    loop.reserve(leaving.size());
    for (auto at = start; !at->used; at = next(at->end)) {
      at->used = true;
      loop.push_back(at->piece);
    }
    loops.push_back(std::move(loop));
  }
  return true;
}

}  // namespace

template <class Scalar>
CrossingKey crossing_of(const TetWithCurves<Scalar>& tet, int face, const ArcEnd& end) {
  constexpr int ends[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  const auto& v = tet.face_vertices[static_cast<std::size_t>(face)];
  return {tet_edge(v[static_cast<std::size_t>(ends[end.edge][0])],
                   v[static_cast<std::size_t>(ends[end.edge][1])]),
          end.crossing};
}

template <class Scalar>
std::map<std::uint32_t, CrossingKey> crossings_of_leaves(const TetWithCurves<Scalar>& tet,
                                                const TetPlan<Scalar>& plan) {
  const auto& vertices = plan.leaves->refinement.vertices();
  const auto& nodes = plan.leaves->mesh.nodes;
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
InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>& refinement, const LeafMesh::Node& node,
                               const Level<Scalar>& level) {
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

/// Finds which loop of the faces each boundary cycle of the leaf mesh is, and lists the sheets.
template <class Scalar>
bool sheets_from_leaves(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                        TetPlan<Scalar>& plan) {
  const auto& mesh = plan.leaves->mesh;
  if (mesh.rim_loops.size() != plan.loops.size()) return false;
  std::map<CrossingKey, int> loop_of_crossing;
  std::map<std::pair<int, int>, int> loop_of_arc;
  for (std::size_t l = 0; l < plan.loops.size(); ++l)
    for (const auto& piece : plan.loops[l]) {
      const auto& arc =
          tet.arcs[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)];
      loop_of_arc[{piece.face, piece.arc}] = static_cast<int>(l);
      if (arc.closed) continue;
      for (const auto& end : {arc.begin, arc.end})
        loop_of_crossing[crossing_of(tet, piece.face, end)] = static_cast<int>(l);
    }
  const auto crossings = crossings_of_leaves(tet, plan);
  if (crossings.size() != loop_of_crossing.size()) return false;
  std::vector<int> loop(mesh.rim_loops.size(), -1);
  std::vector<char> taken(plan.loops.size(), 0);
  for (std::size_t r = 0; r < mesh.rim_loops.size(); ++r) {
    for (const auto n : mesh.rim_loops[r]) {
      const auto found = crossings.find(n);
      if (found == crossings.end()) continue;
      const auto known = loop_of_crossing.find(found->second);
      if (known == loop_of_crossing.end()) return false;
      if (loop[r] >= 0 && loop[r] != known->second) return false;
      loop[r] = known->second;
    }
    if (loop[r] < 0) {  // touches no edge: a closed curve of one face
      const auto n = mesh.rim_loops[r][0];
      const int face = face_of(mesh.nodes[n].faces);
      const auto [arc, place] =
          locate(tet, face, node_point(plan.leaves->refinement, mesh.nodes[n], level));
      if (arc < 0) return false;
      loop[r] = loop_of_arc.at({face, arc});
    }
    if (taken[static_cast<std::size_t>(loop[r])]++) return false;
  }
  plan.sheets.clear();
  for (std::size_t c = 0; c < mesh.components.size(); ++c) {
    SheetTopology sheet;
    sheet.component = static_cast<int>(c);
    sheet.euler_characteristic = mesh.components[c].euler_characteristic;
    for (const int r : mesh.components[c].rim_loops)
      sheet.loops.push_back(loop[static_cast<std::size_t>(r)]);
    plan.sheets.push_back(std::move(sheet));
  }
  return true;
}

/// Whether no refinement can end: the deviator vanishes inside, or the level is that of a saddle.
template <class Scalar>
bool is_hopeless(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level) {
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
std::unique_ptr<typename TetPlan<Scalar>::Leaves>& spare_leaves() {
  thread_local std::unique_ptr<typename TetPlan<Scalar>::Leaves> spare;
  return spare;
}

}  // namespace

template <class Scalar>
bool add_leaves(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, TetPlan<Scalar>& plan,
                Effort effort) {
  if (plan.leaves) return true;
  auto& spare = spare_leaves<Scalar>();
  plan.leaves = spare ? std::move(spare) : std::make_unique<typename TetPlan<Scalar>::Leaves>();
  if (!detail::refine_tet(plan.leaves->refinement, tet.simplex, level, effort)) {
    spare = std::move(plan.leaves);
    return false;
  }
  plan.leaves->mesh = leaf_mesh(plan.leaves->refinement);
  return sheets_from_leaves(tet, level, plan);
}

namespace {

/// The loops, and the sheets if the level is a graph in the whole tetrahedron.
template <class Scalar>
std::optional<TetPlan<Scalar>> plan_at_once(const TetWithCurves<Scalar>& tet,
                                            const Level<Scalar>& level,
                                            const SimplexProof<Scalar, 4>* known = nullptr) {
  TetPlan<Scalar> plan;
  if (!join_arcs(tet, plan.loops)) return std::nullopt;
  if (plan.loops.empty()) return plan;
  const auto proof = known != nullptr ? *known : prove_simplex(tet.simplex.tensors, level);
  if (proof.kind == SimplexProof<Scalar, 4>::Kind::monotone)
    if (auto sheets = sheets_of_graph<Scalar>(tet, plan.loops, proof.direction)) {
      plan.sheets = std::move(*sheets);
      plan.direction = proof.direction;
    }
  return plan;
}

/// Whether there is no more to find: every sheet of a linear field reaches a face.
template <class Scalar>
bool is_complete(const TetPlan<Scalar>& plan) {
  return plan.loops.empty() || !plan.sheets.empty();
}

template <class Scalar>
bool refine(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level, Effort effort,
            TetPlan<Scalar>& plan) {
  if (is_hopeless(tet, level)) return false;
  plan.refined = true;
  if (!add_leaves(tet, level, plan, effort)) return false;
  // Longer numbers may have proved what doubles did not: a graph in the whole tetrahedron.
  const auto& cells = plan.leaves->refinement.cells();
  if (cells.size() == 1 && cells[0].proof.kind == SimplexProof<Scalar, 4>::Kind::monotone)
    plan.direction = cells[0].proof.direction;
  // Hardly any sheet is drawn from its leaves, which are large.
  spare_leaves<Scalar>() = std::move(plan.leaves);
  return true;
}

}  // namespace

template <class Scalar>
std::optional<TetPlan<Scalar>> plan_by_leaves(const TetWithCurves<Scalar>& tet,
                                              const Level<Scalar>& level, Effort effort) {
  auto plan = plan_at_once(tet, level);
  if (plan && !is_complete(*plan) && !refine(tet, level, effort, *plan)) return std::nullopt;
  return plan;
}

template <class Scalar>
std::optional<TetPlan<Scalar>> plan_tet(const TetWithCurves<Scalar>& tet,
                                        const Level<Scalar>& level,
                                        const Level<Scalar>* isotopic, Effort effort) {
  return plan_tet_by<Scalar>(nullptr, tet, level, isotopic, effort);
}

template <class Scalar>
std::optional<TetPlan<Scalar>> plan_tet_by(const SimplexProof<Scalar, 4>* known,
                                           const TetWithCurves<Scalar>& tet,
                                           const Level<Scalar>& level,
                                           const Level<Scalar>* isotopic, Effort effort) {
  auto plan = plan_at_once(tet, level, known);
  if (!plan || is_complete(*plan)) return plan;
  if (isotopic != nullptr)
    if (auto sheets =
            detail::sheets_of_isotopic_level(tet, level, plan->loops, *isotopic, effort)) {
      plan->sheets = std::move(*sheets);
      plan->refined = true;
      return plan;
    }
  if (is_thin(level))
    if (auto thin = sheets_of_thin_level(tet, level, plan->loops, effort)) {
      plan->sheets = std::move(thin->sheets);
      plan->tubes = std::move(thin->tubes);
      plan->refined = true;
      return plan;
    }
  if (is_effort_spent(effort, level)) return std::nullopt;
  if (refine(tet, level, effort, *plan)) return plan;
  if (effort == Effort::usual || !is_thin(level)) return std::nullopt;
  auto sheets = detail::sheets_counted_with_effort(tet, level, plan->loops);
  if (!sheets) return std::nullopt;
  plan->sheets = std::move(*sheets);
  plan->leaves.reset();
  return plan;
}

template <class Scalar>
std::vector<RimRequest<Scalar>> leaf_requests(const TetWithCurves<Scalar>& tet,
                                              const Level<Scalar>& level,
                                              const TetPlan<Scalar>& plan) {
  const auto& mesh = plan.leaves->mesh;
  std::vector<RimRequest<Scalar>> requests(mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    requests[n].arc = -1;
    const auto faces = mesh.nodes[n].faces;
    if (faces == 0 || (faces & (faces - 1)) != 0) continue;
    const int face = face_of(faces);
    const auto [arc, place] =
        locate(tet, face, node_point(plan.leaves->refinement, mesh.nodes[n], level));
    requests[n] = {face, arc, place};
  }
  return requests;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template CrossingKey crossing_of(const TetWithCurves<Scalar>&, int, const ArcEnd&);            \
  template std::map<std::uint32_t, CrossingKey> crossings_of_leaves(                             \
      const TetWithCurves<Scalar>&, const TetPlan<Scalar>&);                                     \
  template InnerVertex<Scalar> node_point(const Refinement<Scalar, 4>&, const LeafMesh::Node&,   \
                                          const Level<Scalar>&);                                 \
  template bool add_leaves(const TetWithCurves<Scalar>&, const Level<Scalar>&, TetPlan<Scalar>&, \
                           Effort);                                                              \
  template std::optional<TetPlan<Scalar>> plan_by_leaves(const TetWithCurves<Scalar>&,           \
                                                         const Level<Scalar>&, Effort);          \
  template std::optional<TetPlan<Scalar>> plan_tet_by(                                           \
      const SimplexProof<Scalar, 4>*, const TetWithCurves<Scalar>&, const Level<Scalar>&,        \
      const Level<Scalar>*, Effort);                                                             \
  template std::optional<TetPlan<Scalar>> plan_tet(                                              \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const Level<Scalar>*, Effort);         \
  template std::vector<RimRequest<Scalar>> leaf_requests(                                        \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const TetPlan<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
