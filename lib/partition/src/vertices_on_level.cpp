// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertices_on_level.hpp"

#include <algorithm>

#include "extract/level/exact_side.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

std::vector<std::int64_t> vertices_on_level(const MeshPiece& piece, const ModeValue& mode) {
  enum class Use : char { none, ghosts, owned };
  std::vector<Use> use(piece.mesh.points.size(), Use::none);
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t)
    for (const auto v : piece.mesh.tets[t])
      use[as_size(v)] =
          std::max(use[as_size(v)], piece.is_owned[t] != 0 ? Use::owned : Use::ghosts);
  const FloatingPointEnvironment environment;
  const ScaledField<double> field(piece.mesh);
  const auto level = make_level<double>(mode);
  const double one = 1;
  std::vector<std::int64_t> ids;
  for (std::size_t v = 0; v < use.size(); ++v) {
    if (use[v] == Use::ghosts || field.is_zero[v] != 0 ||
        side_of_level(field.tensors[v], level) != Verdict::unknown)
      continue;
    if (exact_side_of_level({&piece.mesh.tensors[v], 1}, {&field.exponents[v], 1}, {&one, 1},
                            mode) == Sign::zero)
      ids.push_back(piece.vertex_ids[v]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace tensortopo
