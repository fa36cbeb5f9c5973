// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "extract/level/near_degenerate_level.hpp"
#include "extract/level/simd/proof_block.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/pipeline.hpp"
#include "extract/topology/boundary/graph_arcs.hpp"
#include "extract/topology/near_degenerate_sheets.hpp"

namespace tensortopo {

template <class Scalar>
void Pipeline<Scalar>::trace_faces() {
  arcs_.assign(complex_.faces.size(), std::nullopt);
  face_moved_.assign(complex_.faces.size(), 0);
  const auto trace = [&](std::size_t begin, std::size_t end) {
    ProofBlock<Scalar, 3> proofs;
    for (std::size_t f = begin; f < end; ++f)
      if (is_crossed(complex_.faces[f])) proofs.want(f - begin, complex_.faces[f], field_.tensors);
    proofs.make(level_);
    for (std::size_t f = begin; f < end; ++f) trace_face(f, proofs.of(f - begin));
  };
  parallel_blocks(options_, "faces", complex_.faces.size(), 256, ProofBlock<Scalar, 3>::size,
                  trace);
}

template <class Scalar>
void Pipeline<Scalar>::trace_face(std::size_t f, const SimplexProof<Scalar, 3>* proof) {
  std::array<std::span<const EdgeCrossing<Scalar>>, 3> crossings;
  for (std::size_t e = 0; e < 3; ++e) {
    const auto edge = as_size(complex_.face_edges[f][e]);
    if (!crossings_[edge]) return;
    crossings[e] = *crossings_[edge];
    face_moved_[f] |= edge_moved_[edge];
  }
  const auto& v = complex_.faces[f];
  if (!face_moved_[f] && crossings[0].empty() && crossings[1].empty() && crossings[2].empty() &&
      is_clear(v)) {
    arcs_[f].emplace();
    return;
  }
  if (field_.is_zero[as_size(v[0])] || field_.is_zero[as_size(v[1])] ||
      field_.is_zero[as_size(v[2])]) {
    arcs_[f].emplace();  // straight lines, which their tetrahedra mesh
    return;
  }
  // Where the deviator vanishes no subdivision would end.
  if (vanishes_inside(v)) return;
  if (!face_moved_[f])
    arcs_[f] = face_curves_by(proof, face_simplex(f), crossings, level_, sampling_on(f));
  if (!arcs_[f]) trace_nearby(f);
  // Not next to a critical value: small cells, then.
  if (!arcs_[f] && !face_moved_[f] && is_near_degenerate(level_))
    arcs_[f] =
        face_curves_by(proof, face_simplex(f), crossings, level_, sampling_on(f), Budget::large);
}

/// The curves of a face at a nearby level. Its edges have as many crossings there.
template <class Scalar>
void Pipeline<Scalar>::trace_nearby(std::size_t f) {
  const auto tensors = tensors_of(complex_.faces[f]);
  if (!face_moved_[f] && !nearby_levels_.is_close_to_critical(tensors)) return;
  const auto* level = nearby_levels_.level_for(tensors);
  if (level == nullptr) return;
  std::array<std::vector<EdgeCrossing<Scalar>>, 3> found;
  std::array<std::span<const EdgeCrossing<Scalar>>, 3> crossings;
  for (std::size_t e = 0; e < 3; ++e) {
    const auto edge = as_size(complex_.face_edges[f][e]);
    auto there = edge_crossings(field_.template simplex<2>(complex_.edges[edge], above_), *level);
    if (!there || there->size() != crossings_[edge]->size()) return;
    found[e] = std::move(*there);
    crossings[e] = found[e];
  }
  arcs_[f] = face_curves(face_simplex(f), crossings, *level, sampling_on(f));
  if (!arcs_[f]) return;
  for (auto& arc : *arcs_[f]) arc.level = level;
  face_moved_[f] = 1;
}

#define TENSORTOPO_INSTANTIATE(Scalar) template void Pipeline<Scalar>::trace_faces();
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
