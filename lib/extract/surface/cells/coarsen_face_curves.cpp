// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cells/coarsen_face_curves.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "extract/patch/quality/cell_patch.hpp"
#include "extract/patch/quality/cell_thinning.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/boundary/trace_faces.hpp"
#include "extract/surface/cells/part_seam.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// How far the level may be from where a sample was taken out, in longest edges of the tetrahedron.
/// On the bundled fields the mean distance from the level grows by one hundredth, or less.
double flatness(const Sampling& sampling) {
  return 1 / (16 * sampling.resolution * sampling.resolution);
}

/// By how much triangles may turn away from the level there: a thin tube keeps its corners.
double least_cosine(const Sampling& sampling) {
  return elementary::cos(std::min(3 / sampling.resolution, 0.75));
}

/// Which samples go is decided by each face from what its two tetrahedra say, and what a
/// tetrahedron says depends on itself and its neighbours only: on what is at most three faces away
/// from a tetrahedron, unless a neighbour refuses what was decided.
template <class Scalar>
class FaceCurveCoarsening {
 public:
  FaceCurveCoarsening(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                      const TetComplex& cells, std::span<const CellProof<Scalar>> proofs,
                      CellMeshes<Scalar>& meshes)
      : input_(input),
        sides_(sides),
        cells_(cells),
        proofs_(proofs),
        meshes_(meshes),
        seam_(input.options, cells),
        level_(make_level<double>(input.level.value)),
        states_(meshes.cells.size()),
        may_go_(meshes.vertices.position.size(), 0),
        at_needle_(may_go_.size(), 0),
        is_going_(may_go_.size(), 0),
        is_staying_(may_go_.size(), 0) {}

  void run() {
    const auto cells = cells_at_needles();
    for_each_of(cells, [&](std::size_t t) { look(t); });
    for_each_of(cells, [&](std::size_t t) { propose(t); });
    for (const auto t : cells) {
      const State& state = *states_[t];
      note(t, MeshingMessage::kProposal,
           {&state.at_needles, &state.proposal.accepted, &state.proposal.wanted});
    }
    std::vector<std::size_t> changing = cells;
    for (std::int32_t step = 0; !changing.empty(); ++step) {
      for (const auto t : changing)
        for (const Index f : cells_.tet_faces[t]) decide(as_size(f));
      for_each_of(changing, [&](std::size_t t) { carry_out(t); });
      for (const auto t : changing)
        note(t, MeshingMessage::kFirstRefusal + step, {&states_[t]->refused});
      changing = cells_of_refused(changing);
    }
    for_each_of(cells, [&](std::size_t t) {
      meshes_.cells[t].patch.triangles = std::move(states_[t]->triangles);
      states_[t].reset();
    });
  }

 private:
  /// A tetrahedron whose samples may go.
  struct State {
    std::vector<CurveChain> chains;
    std::unique_ptr<CellPatch> patch;  ///< until the proposal is made
    std::vector<CellPatch::Id> at_needles;
    ThinningProposal proposal;
    std::vector<std::array<Index, 3>> triangles;
    std::vector<CellPatch::Id> taken_out;  ///< of `triangles`
    std::vector<CellPatch::Id> refused;
  };

  template <class Body>
  void for_each_of(const std::vector<std::size_t>& cells, const Body& body) {
    parallel_stage(input_.options, "tetrahedra", cells.size(), 64,
                   [&](std::size_t i) { body(cells[i]); });
  }

  /// Marks the samples that may go and are corners of needles of a tetrahedron.
  void mark_samples_at_needles(std::size_t t) {
    const auto& triangles = meshes_.cells[t].patch.triangles;
    const auto may_go = [&](Index v) { return v >= 0 && may_go_[as_size(v)] != 0; };
    double unit = 0;  // not known yet
    for (const auto& triangle : triangles) {
      if (std::none_of(triangle.begin(), triangle.end(), may_go)) continue;
      if (unit == 0) {
        std::array<Vector3<double>, 4> points;
        for (std::size_t i = 0; i < 4; ++i)
          points[i] = input_.mesh.points[as_size(input_.vertices_of(cells_, t)[i])];
        unit = unit_of(points);
      }
      if (!may_be_needle(triangle, unit)) continue;
      // Both tetrahedra of a face may mark a sample.
      for (const Index v : triangle)
        if (may_go(v)) std::atomic_ref(at_needle_[as_size(v)]).store(1, std::memory_order_relaxed);
    }
  }

  bool may_be_needle(const std::array<Index, 3>& triangle, double unit) const {
    if (std::any_of(triangle.begin(), triangle.end(), [](Index v) { return v < 0; }))
      return true;  // the position of a vertex inside is not known yet
    const auto at = [&](std::size_t i) {
      return unit * meshes_.vertices.position[as_size(triangle[i])];
    };
    const auto p = at(0), q = at(1), r = at(2);
    const auto n = cross(q - p, r - p);
    return !(least_sine(p, q, r, length(n)) > kSineOfNeedle);
  }

  bool may_change(std::size_t t) const {
    const auto& mesh = meshes_.cells[t];
    return !mesh.unresolved && !mesh.has_defects && mesh.mesher != Mesher::cone &&
           proofs_[t].level == nullptr;
  }

  /// Whether samples of a face may go; for that both its tetrahedra may change.
  bool may_change_on(std::size_t f) const {
    const auto arcs = meshes_.boundary.arcs[f];
    if (meshes_.boundary.moved[f] ||
        std::all_of(arcs.begin(), arcs.end(), [](const auto& arc) { return arc.samples.empty(); }))
      return false;
    const auto& tets = cells_.face_tets[f];
    return std::all_of(tets.begin(), tets.end(),
                       [&](Index t) { return t < 0 || may_change(as_size(t)); });
  }

  /// The samples of a face, as numbers of vertices: the first, and the one after the last.
  std::array<std::size_t, 2> samples_of(std::size_t f) const {
    const auto first = as_size(meshes_.vertices.of_face[f]);
    std::size_t count = 0;
    for (const auto& arc : meshes_.boundary.arcs[f]) count += arc.samples.size();
    return {first, first + count};
  }

  /// The tetrahedra of the faces that have a sample at a needle which may go.
  std::vector<std::size_t> cells_at_needles() {
    const std::size_t faces = cells_.faces.size();
    may_change_on_.assign(faces, 0);
    // Samples belong to one face each, so that no two threads write to one.
    parallel_stage(input_.options, "faces", faces, 1024, [&](std::size_t f) {
      may_change_on_[f] = may_change_on(f);
      if (!may_change_on_[f]) return;
      const auto [first, last] = samples_of(f);
      std::fill(may_go_.data() + first, may_go_.data() + last, 1);
    });
    parallel_stage(input_.options, "tetrahedra", meshes_.cells.size(), 256,
                   [&](std::size_t t) { mark_samples_at_needles(t); });
    std::vector<std::size_t> cells;
    for (std::size_t f = 0; f < faces; ++f) {
      if (!may_change_on_[f]) continue;
      const auto [first, last] = samples_of(f);
      const auto is_marked = [](char mark) { return mark != 0; };
      if (std::none_of(at_needle_.data() + first, at_needle_.data() + last, is_marked)) continue;
      for (const Index t : cells_.face_tets[f])
        if (t >= 0) cells.push_back(as_size(t));
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  void add_chains(std::size_t f, std::vector<CurveChain>& chains) const {
    const auto sampling = input_.sampling_on(cells_, f);
    auto next = meshes_.vertices.of_face[f];
    for (const auto& arc : meshes_.boundary.arcs[f]) {
      const auto end = [&](const ArcEnd& e) {
        const auto edge = as_size(cells_.face_edges[f][as_size(e.edge)]);
        return static_cast<Index>(meshes_.boundary.crossings.rows.first(edge)) + e.crossing;
      };
      CurveChain chain;
      chain.is_closed = arc.closed;
      // Two curves never share both ends, so that one without samples is an edge of its own.
      chain.least = arc.closed ? 3 : arc.begin.edge == arc.end.edge ? 1 : 0;
      chain.flatness = flatness(sampling);
      chain.least_cosine = least_cosine(sampling);
      chain.stays_embedded = input_.options.embedded;
      if (!arc.closed) chain.vertices.push_back(end(arc.begin));
      for (std::size_t i = 0; i < arc.samples.size(); ++i) chain.vertices.push_back(next++);
      if (!arc.closed) chain.vertices.push_back(end(arc.end));
      chains.push_back(std::move(chain));
    }
  }

  std::unique_ptr<CellPatch> patch_of(std::size_t t) const {
    const auto tet = tet_with_curves(input_, sides_, cells_, meshes_.boundary, t);
    const CellSurroundings<Scalar> around{cells_, meshes_.boundary, meshes_.vertices, t};
    return std::make_unique<CellPatch>(tet, level_, around.arc_vertices(tet),
                                       meshes_.cells[t].patch);
  }

  void look(std::size_t t) {
    auto state = std::make_unique<State>();
    for (const Index f : cells_.tet_faces[t])
      if (may_change_on_[as_size(f)]) add_chains(as_size(f), state->chains);
    state->patch = patch_of(t);
    state->at_needles = samples_at_needles(*state->patch, state->chains);
    states_[t] = std::move(state);
  }

  /// The tetrahedra of a face that were looked at.
  std::array<const State*, 2> states_of(std::size_t f) const {
    std::array<const State*, 2> states{};
    for (std::size_t i = 0; i < 2; ++i)
      if (const Index t = cells_.face_tets[f][i]; t >= 0) states[i] = states_[as_size(t)].get();
    return states;
  }

  void propose(std::size_t t) {
    std::vector<CellPatch::Id> candidates;
    for (const Index f : cells_.tet_faces[t])
      for (const State* state : states_of(as_size(f)))
        if (state != nullptr)
          candidates.insert(candidates.end(), state->at_needles.begin(), state->at_needles.end());
    std::sort(candidates.begin(), candidates.end());
    State& state = *states_[t];
    state.proposal = propose_thinning(*state.patch, state.chains, candidates);
    state.triangles = state.patch->triangles();
    state.taken_out = state.proposal.accepted;
    state.patch.reset();
  }

  /// A sample goes if both tetrahedra accept that and one wants it.
  void decide(std::size_t f) {
    if (!may_change_on_[f]) return;
    const auto states = states_of(f);
    const auto& tets = cells_.face_tets[f];
    auto v = meshes_.vertices.of_face[f];
    for (const auto& arc : meshes_.boundary.arcs[f])
      for (std::size_t i = 0; i < arc.samples.size(); ++i, ++v) {
        bool is_accepted = is_staying_[as_size(v)] == 0, is_wanted = false;
        for (std::size_t k = 0; k < 2; ++k) {
          if (tets[k] < 0) continue;
          const auto holds = [&](const std::vector<CellPatch::Id>& list) {
            return std::binary_search(list.begin(), list.end(), v);
          };
          is_accepted = is_accepted && states[k] != nullptr && holds(states[k]->proposal.accepted);
          is_wanted = is_wanted || (states[k] != nullptr && holds(states[k]->proposal.wanted));
        }
        is_going_[as_size(v)] = is_accepted && is_wanted;
      }
  }

  void carry_out(std::size_t t) {
    State& state = *states_[t];
    std::vector<CellPatch::Id> going;
    for (const CurveChain& chain : state.chains)
      std::copy_if(chain.vertices.begin(), chain.vertices.end(), std::back_inserter(going),
                   [&](CellPatch::Id v) { return is_going_[as_size(v)] != 0; });
    std::sort(going.begin(), going.end());
    if (going == state.taken_out) return;
    const auto patch = patch_of(t);
    state.refused = take_out(*patch, state.chains, going);
    state.triangles = patch->triangles();
    state.taken_out = std::move(going);
  }

  /// Notes what a tetrahedron says of the samples on faces between parts.
  void note(std::size_t t, std::int32_t round,
            std::initializer_list<const std::vector<CellPatch::Id>*> lists) {
    if (!seam_.exists()) return;
    for (std::size_t face = 0; face < 4; ++face) {
      const Index other = seam_.across(t, face);
      const auto f = as_size(cells_.tet_faces[t][face]);
      if (other < 0 || !may_change_on_[f]) continue;
      const auto [first, last] = samples_of(f);
      bool any = round == MeshingMessage::kProposal;
      std::uint64_t digest = 0;
      double kind = 0;
      for (const auto* list : lists) {
        kind += 1;
        for (const auto v : *list) {
          if (as_size(v) < first || as_size(v) >= last) continue;
          any = true;
          const auto& p = meshes_.vertices.position[as_size(v)];
          digest += digest_of(std::array{kind, p.x, p.y, p.z});
        }
      }
      if (any) meshes_.messages.push_back({static_cast<Index>(t), other, 0, round, digest});
    }
  }

  /// Keeps in place what was refused; the tetrahedra that this concerns.
  std::vector<std::size_t> cells_of_refused(const std::vector<std::size_t>& changed) {
    std::vector<std::size_t> result;
    for (const auto t : changed) {
      auto& refused = states_[t]->refused;
      if (refused.empty()) continue;
      for (const auto v : std::exchange(refused, {})) is_staying_[as_size(v)] = 1;
      states_[t]->taken_out.assign(1, -1);  // not what the triangles are
      for (const Index f : cells_.tet_faces[t])
        for (const Index u : cells_.face_tets[as_size(f)])
          if (u >= 0 && states_[as_size(u)]) result.push_back(as_size(u));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const SurfaceInput<Scalar>& input_;
  const VertexSides& sides_;
  const TetComplex& cells_;
  std::span<const CellProof<Scalar>> proofs_;
  CellMeshes<Scalar>& meshes_;
  const PartSeam seam_;
  const Level<double> level_;
  std::vector<char> may_change_on_;             ///< of each face
  std::vector<std::unique_ptr<State>> states_;  ///< of the tetrahedra that are looked at
  std::vector<char> may_go_;                    ///< of each vertex: a sample that may go
  std::vector<char> at_needle_;                 ///< of these, those at which a needle may be
  std::vector<char> is_going_;                  ///< of each vertex
  std::vector<char> is_staying_;  ///< of each vertex: a tetrahedron refused to let it go
};

}  // namespace

template <class Scalar>
void coarsen_face_curves(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                         const TetComplex& cells, std::span<const CellProof<Scalar>> proofs,
                         CellMeshes<Scalar>& meshes) {
  FaceCurveCoarsening<Scalar>(input, sides, cells, proofs, meshes).run();
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                     \
  template void coarsen_face_curves(const SurfaceInput<Scalar>&, const VertexSides&,       \
                                    const TetComplex&, std::span<const CellProof<Scalar>>, \
                                    CellMeshes<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
