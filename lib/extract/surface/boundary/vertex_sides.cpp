// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/boundary/vertex_sides.hpp"

#include <atomic>

#include "extract/level/exact_side.hpp"
#include "extract/level/proofs/screen.hpp"
#include "extract/run/count_predicate.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

template <class Scalar>
VertexSides classify_vertices(const SurfaceInput<Scalar>& input) {
  const std::size_t count = input.mesh.points.size();
  VertexSides sides;
  sides.above.assign(count, 0);
  sides.on_level.assign(count, OnLevel::no);
  sides.as_meshed.assign(count, 0);
  std::atomic<std::size_t> on_level{0};
  parallel_stage(input.options, "vertices", count, 4096, [&](std::size_t v) {
    if (input.field.is_zero[v]) return;
    const Verdict verdict = side_of_level(input.field.tensors[v], input.level);
    count_predicate(verdict == Verdict::unknown ? Tier::exact : Tier::fast);
    if (verdict != Verdict::unknown) {
      sides.above[v] = verdict == Verdict::positive;
      return;
    }
    const double one = 1;
    const Sign sign = exact_side_of_level(
        {&input.mesh.tensors[v], 1}, {&input.field.exponents[v], 1}, {&one, 1}, input.level.value);
    sides.above[v] = sign == Sign::positive;
    if (sign != Sign::zero) return;
    sides.on_level[v] = OnLevel::meshed_through;
    ++on_level;
  });
  sides.count_on_level = on_level;
  sides.clearance.assign(count, 2);
  parallel_stage(input.options, "screen", count, 4096, [&](std::size_t v) {
    if (!input.field.is_zero[v])
      sides.clearance[v] =
          screen::clearance_cosine(input.prepared.lode_angles[v], input.level.lode_angle);
  });
  return sides;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template VertexSides classify_vertices(const SurfaceInput<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
