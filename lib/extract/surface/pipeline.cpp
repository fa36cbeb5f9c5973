// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/pipeline.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "extract/patch/charts/manifold_crossings.hpp"
#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/critical/degenerate_configuration.hpp"
#include "extract/level/exact_side.hpp"
#include "extract/level/position.hpp"
#include "extract/level/simd/proof_block.hpp"
#include "extract/run/count_predicate.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/run/release.hpp"
#include "extract/topology/boundary/graph_arcs.hpp"
#include "extract/topology/cell_topology.hpp"
#include "extract/topology/near_degenerate_sheets.hpp"

namespace tensortopo {

template <class Scalar>
Pipeline<Scalar>::Pipeline(const PreparedField<Scalar>& prepared, const ModeValue& mu,
                           const ExtractOptions& options, PreparedField<Scalar>* last_use)
    : mesh_(*prepared.mesh),
      options_(options),
      nearby_levels_(mu),
      prepared_(prepared),
      last_use_(last_use),
      field_(prepared.field) {
  if (std::abs(mu.approx()) >= 1)
    throw std::invalid_argument("mode surfaces exist for |mode| < 1, not for " + mu.text());
  level_ = make_level<Scalar>(mu);
}

template <class Scalar>
Extraction Pipeline<Scalar>::run() {
  Stopwatch watch;
  classify_vertices();
  screen();
  do {
    find_crossings();
    statistics_.seconds_edges += watch.lap();
    trace_faces();
    statistics_.seconds_faces += watch.lap();
    prove_cells();
    mesh_cells();
    statistics_.seconds_tets += watch.lap();
  } while (move_from_vertices());
  release_proofs();
  if (!options_.keep_samples) coarsen_face_curves();
  statistics_.seconds_tets += watch.lap();
  Extraction result = assemble();
  statistics_.seconds_stitch = watch.lap();
  result.statistics = statistics_;
  return result;
}

/// Where the level runs through a vertex, samples of its edges fall together there, and a sheet
/// that is a cylinder around the vertex by the rule mu + 0 cannot be told from a cone. Around such
/// vertices a level next to mu is meshed instead, which keeps off them.
template <class Scalar>
bool Pipeline<Scalar>::move_from_vertices() {
  bool any = false;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (tets_[t].unresolved != UnresolvedReason::inconsistent_samples) continue;
    for (const Index v : vertices_of(t)) {
      if (on_level_[as_size(v)] != OnLevel::meshed_through) continue;
      on_level_[as_size(v)] = OnLevel::kept_off;
      any = true;
    }
  }
  if (any) tets_ = std::vector<TetState>(tets_.size());
  return any;
}

/// What meshing needed is half of all that a tetrahedron holds; only proofs ask for it later.
template <class Scalar>
void Pipeline<Scalar>::release_proofs() {
  parallel_stage(options_, "tetrahedra", tets_.size(), 1024, [&](std::size_t t) {
    auto& state = tets_[t];
    release(state.manifold, state.requests);
    if (!state.proved) return;
    state.sheets = static_cast<int>(state.proved->sheets.size());
    state.refined = state.proved->refined;
    if (!options_.keep_topology) state.proved.reset();
  });
}

template <class Scalar>
void Pipeline<Scalar>::classify_vertices() {
  above_.assign(mesh_.points.size(), 0);
  on_level_.assign(mesh_.points.size(), OnLevel::no);
  std::atomic<std::size_t> on_level{0};
  parallel_stage(options_, "vertices", mesh_.points.size(), 4096, [&](std::size_t v) {
    if (field_.is_zero[v]) return;
    const Verdict verdict = side_of_level(field_.tensors[v], level_);
    count_predicate(verdict == Verdict::unknown ? Tier::exact : Tier::fast);
    if (verdict != Verdict::unknown) {
      above_[v] = verdict == Verdict::positive;
      return;
    }
    const double one = 1;
    const Sign sign = exact_side_of_level({&mesh_.tensors[v], 1}, {&field_.exponents[v], 1},
                                          {&one, 1}, level_.value);
    above_[v] = sign == Sign::positive;
    if (sign != Sign::zero) return;
    on_level_[v] = OnLevel::meshed_through;
    ++on_level;
  });
  statistics_.vertices_on_level = on_level;
}

template <class Scalar>
void Pipeline<Scalar>::screen() {
  // By vertex, how far the level is.
  const auto& tensors = prepared_.tensors();
  clearance_.assign(mesh_.points.size(), 2);
  parallel_stage(options_, "screen", mesh_.points.size(), 4096, [&](std::size_t v) {
    if (!field_.is_zero[v])
      clearance_[v] = screen::clearance_cosine(prepared_.lode_angles[v], level_.lode_angle);
  });
  const auto& ranges = prepared_.lode_ranges;
  std::vector<char> active(mesh_.tets.size(), 0);
  parallel_stage(options_, "screen", mesh_.tets.size(), 4096, [&](std::size_t t) {
    if (!ranges.empty() && (level_.lode_angle < static_cast<double>(ranges[t][0]) ||
                            level_.lode_angle > static_cast<double>(ranges[t][1])))
      return;
    const auto& v = mesh_.tets[t];
    if (zero_corners(v) != 0) {
      active[t] = may_be_crossed_from_zero(v);
      return;
    }
    for (const Index w : v) active[t] |= above_[as_size(w)] != above_[as_size(v[0])];
    if (active[t] || is_clear(v)) return;
    const std::array<Deviator<double>, 4> corners{tensors[as_size(v[0])], tensors[as_size(v[1])],
                                                  tensors[as_size(v[2])], tensors[as_size(v[3])]};
    if (screen::excludes(corners, level_.lode_angle)) return;
    std::array<Deviator<Scalar>, 4> own_corners;
    for (std::size_t i = 0; i < 4; ++i) own_corners[i] = field_.tensors[as_size(v[i])];
    active[t] = !is_proved_empty(own_corners, level_);
  });
  if (last_use_ != nullptr) release(last_use_->lode_ranges, last_use_->lode_angles);
  std::vector<Index> tets;
  for (std::size_t t = 0; t < active.size(); ++t)
    if (active[t]) tets.push_back(static_cast<Index>(t));
  std::vector<char> zero(mesh_.points.size(), 0);
  for (const auto& tet : mesh_.tets) {
    const unsigned corners = zero_corners(tet);
    if (corners == 15u) ++statistics_.tets_undefined;
    for (std::size_t i = 0; corners != 0 && i < 4; ++i)
      if (corners >> i & 1) zero[as_size(tet[i])] = 1;
  }
  for (const char z : zero) statistics_.zero_deviator_vertices += z != 0;
  statistics_.tets_screened_out = mesh_.tets.size() - tets.size() - statistics_.tets_undefined;
  complex_ = tet_complex(mesh_, tets);
  tets_ = std::vector<TetState>(tets.size());
}

template <class Scalar>
void Pipeline<Scalar>::find_crossings() {
  crossings_.assign(complex_.edges.size(), std::nullopt);
  edge_moved_.assign(complex_.edges.size(), 0);
  const auto find = [&](std::size_t begin, std::size_t end) {
    CrossingBlock<Scalar> single;
    for (std::size_t e = begin; e < end; ++e) {
      const auto& v = complex_.edges[e];
      if (is_crossed(v) && !keeps_off(v))
        single.want(e - begin, v, field_.tensors, above_[as_size(v[1])]);
    }
    single.make(level_);
    for (std::size_t e = begin; e < end; ++e) {
      const auto crossing = single.of(e - begin);
      if (!crossing) {
        find_crossings_of(e);
        continue;
      }
      count_predicate(Tier::fast);
      crossings_[e].emplace(1, *crossing);
    }
  };
  parallel_blocks(options_, "edges", complex_.edges.size(), 512, CrossingBlock<Scalar>::size, find);
}

template <class Scalar>
bool Pipeline<Scalar>::keeps_off(const std::array<Index, 2>& edge) const {
  return on_level_[as_size(edge[0])] == OnLevel::kept_off ||
         on_level_[as_size(edge[1])] == OnLevel::kept_off;
}

template <class Scalar>
void Pipeline<Scalar>::find_crossings_of(std::size_t e) {
  const auto& v = complex_.edges[e];
  if (field_.is_zero[as_size(v[0])] || field_.is_zero[as_size(v[1])]) {
    crossings_[e].emplace();  // the mode is constant on the edge, or undefined
    return;
  }
  if (is_clear(v)) {
    count_predicate(Tier::fast);
    crossings_[e].emplace();
    return;
  }
  const auto edge = field_.template simplex<2>(v, above_);
  if (!keeps_off(v)) crossings_[e] = edge_crossings(edge, level_);
  if (crossings_[e]) return;
  const auto tensors = tensors_of(v);
  if (keeps_off(v) || nearby_levels_.is_close_to_critical(tensors))
    if (const auto* level = nearby_levels_.level_for(tensors))
      crossings_[e] = edge_crossings(edge, *level);
  edge_moved_[e] = crossings_[e].has_value();
  if (keeps_off(v) && !crossings_[e]) crossings_[e] = edge_crossings(edge, level_);
}

template <class Scalar>
LevelSimplex<Scalar, 3> Pipeline<Scalar>::face_simplex(std::size_t f) const {
  return field_.template simplex<3>(complex_.faces[f], above_);
}

template <class Scalar>
Sampling Pipeline<Scalar>::sampling_in(std::size_t t) const {
  Sampling sampling = options_.sampling;
  if (!options_.density.empty())
    sampling.resolution *= static_cast<double>(options_.density[as_size(complex_.tets[t])]);
  return sampling;
}

template <class Scalar>
Sampling Pipeline<Scalar>::sampling_on(std::size_t f) const {
  Sampling sampling = options_.sampling;
  if (options_.density.empty()) return sampling;
  sampling.resolution = 0;
  for (const Index t : complex_.face_tets[f])
    if (t >= 0)
      sampling.resolution = std::max(sampling.resolution, sampling_in(as_size(t)).resolution);
  return sampling;
}

template <class Scalar>
TetWithCurves<Scalar> Pipeline<Scalar>::tet_with_curves(std::size_t t) const {
  const auto& v = mesh_.tets[as_size(complex_.tets[t])];
  TetWithCurves<Scalar> tet;
  tet.simplex = field_.template simplex<4>(v, above_);
  for (std::size_t i = 0; i < 4; ++i) tet.points[i] = mesh_.points[as_size(v[i])];
  for (std::size_t e = 0; e < 6; ++e)
    tet.edge_forward[e] =
        v[static_cast<std::size_t>(kTetEdges[e][0])] < v[static_cast<std::size_t>(kTetEdges[e][1])];
  // Opposite vertex f, counter-clockwise from outside in a positively oriented tetrahedron.
  constexpr std::array<std::array<std::uint8_t, 3>, 4> outside{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (std::size_t f = 0; f < 4; ++f) {
    auto face = outside[f];
    bool even = true;
    const auto order = [&](std::size_t i, std::size_t j) {
      if (v[face[i]] > v[face[j]]) std::swap(face[i], face[j]), even = !even;
    };
    order(0, 1), order(1, 2), order(0, 1);
    tet.face_vertices[f] = face;
    tet.outward[f] = even;
    const auto& arcs = arcs_[as_size(complex_.tet_faces[t][f])];
    if (arcs) tet.arcs[f] = *arcs;
  }
  return tet;
}

/// The reason why no proof has closed on a tetrahedron.
template <class Scalar>
UnresolvedReason Pipeline<Scalar>::unproved(std::size_t t) const {
  std::vector<SymmetricTensor<double>> tensors;
  for (const Index v : vertices_of(t))
    if (!field_.is_zero[as_size(v)]) tensors.push_back(mesh_.tensors[as_size(v)]);
  return degenerate_configuration(tensors, level_.value);
}

template <class Scalar>
bool Pipeline<Scalar>::prove_one(std::size_t t, const SimplexProof<Scalar, 4>* proof) {
  if (zero_corners(vertices_of(t)) != 0) return prove_cone(t);
  auto& state = tets_[t];
  bool any = false, moved = false;
  for (const Index f : complex_.tet_faces[t]) {
    if (!arcs_[as_size(f)]) {
      state.unresolved = unproved(t);
      return false;
    }
    any |= !arcs_[as_size(f)]->empty();
    moved |= face_moved_[as_size(f)] != 0;
  }
  if (!any) return false;
  const auto tet = tet_with_curves(t);
  const auto take = [&](std::optional<CellTopology<Scalar>> proved) {
    if (proved) state.proved = std::make_unique<CellTopology<Scalar>>(std::move(*proved));
  };
  const auto plan_here = [&](Budget budget) {
    take(prove_cell_from<Scalar>(proof, tet, level_, nullptr, budget));
  };
  if (!moved) plan_here(is_near_degenerate(level_) ? Budget::regular : Budget::small);
  if (!state.proved) {
    const auto tensors = tensors_of(vertices_of(t));
    if (moved || nearby_levels_.is_close_to_critical(tensors))
      state.level = nearby_levels_.level_for(tensors);
    if (state.level != nullptr)
      take(prove_cell(tet, *state.level, nearby_levels_.far_level_for(tensors)));
  }
  if (!state.proved && !moved && (state.level == nullptr || !is_near_degenerate(level_))) {
    plan_here(is_near_degenerate(level_) ? Budget::large : Budget::regular);
    if (state.proved) state.level = nullptr;
  }
  if (!state.proved) state.unresolved = unproved(t);
  if (state.proved && !state.proved->tubes.empty()) {
    state.manifold = tet_manifold(tet, level_of(t));
    if (state.manifold) state.method = Method::tubes;
  }
  return state.proved != nullptr;
}

template <class Scalar>
void Pipeline<Scalar>::prove_cells() {
  const auto proved = [&](std::size_t begin, std::size_t end) {
    ProofBlock<Scalar, 4> proofs;
    for (std::size_t t = begin; t < end; ++t)
      if (is_crossed(vertices_of(t))) proofs.want(t - begin, vertices_of(t), field_.tensors);
    proofs.make(level_);
    for (std::size_t t = begin; t < end; ++t) prove_one(t, proofs.of(t - begin));
  };
  parallel_blocks(options_, "tetrahedra", tets_.size(), 64, ProofBlock<Scalar, 4>::size, proved);
}

template <class Scalar>
Extraction extract_mode_surface(const PreparedField<Scalar>& field, const ModeValue& mu,
                                const ExtractOptions& options) {
  return Pipeline<Scalar>(field, mu, options).run();
}

template <class Scalar>
Extraction extract_mode_surface(PreparedField<Scalar>&& field, const ModeValue& mu,
                                const ExtractOptions& options) {
  return Pipeline<Scalar>(field, mu, options, &field).run();
}

template <class Scalar>
Extraction extract_mode_surface(const TetMesh& mesh, const ModeValue& mu,
                                const ExtractOptions& options) {
  PreparedField<Scalar> field(mesh, PreparedField<Scalar>::Use::one_mode);
  return extract_mode_surface(std::move(field), mu, options);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                             \
  template class Pipeline<Scalar>;                                                                 \
  template Extraction extract_mode_surface<Scalar>(const TetMesh&, const ModeValue&,               \
                                                   const ExtractOptions&);                         \
  template Extraction extract_mode_surface<Scalar>(const PreparedField<Scalar>&, const ModeValue&, \
                                                   const ExtractOptions&);                         \
  template Extraction extract_mode_surface<Scalar>(PreparedField<Scalar>&&, const ModeValue&,      \
                                                   const ExtractOptions&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
