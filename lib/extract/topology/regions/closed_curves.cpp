// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/closed_curves.hpp"

#include <utility>

#include "extract/level/proofs/is_above.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
std::optional<std::array<double, 3>> superlevel_place(const LevelSimplex<Scalar, 3>& face,
                                                      const FaceArc<Scalar>& arc,
                                                      const Level<Scalar>& level) {
  const auto& piece = arc.pieces[0];
  const auto& corners = piece.corners();
  const auto& tensors = piece.tensors(face.tensors);
  for (std::size_t i = 0; i < 3; ++i)
    if (is_above(face, tensors[i], corners[i], level) == (level.sign > 0)) return corners[i];
  return std::nullopt;
}

template <class Scalar>
ClosedCurves<Scalar>::ClosedCurves(const LevelSimplex<Scalar, 3>& face, const Level<Scalar>& level,
                                   std::span<const FaceArc<Scalar>> arcs)
    : face_(face) {
  if (!parts_.build(face_, level)) return;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    const auto place = superlevel_place(face_, arcs[a], level);
    if (!place) return;
    const auto part = parts_.part_of(*place);
    if (!part) return;
    const bool alone = !curve_.contains(*part);
    curve_[*part] = alone && arcs[a].closed ? static_cast<int>(a) : -1;
  }
  built_ = true;
}

template <class Scalar>
int ClosedCurves<Scalar>::take(const std::array<double, 3>& place) {
  if (!built_) return -1;
  const auto part = parts_.part_of(place);
  if (!part) return -1;
  const auto found = curve_.find(*part);
  return found == curve_.end() ? -1 : std::exchange(found->second, -1);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                               \
  template std::optional<std::array<double, 3>> superlevel_place(                    \
      const LevelSimplex<Scalar, 3>&, const FaceArc<Scalar>&, const Level<Scalar>&); \
  template class ClosedCurves<Scalar>;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
