// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/boundary/active_cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "extract/level/proofs/screen.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/simd/proof_block.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Whether the level may meet a tetrahedron that has isotropic vertices: what decides is the
/// opposite face or edge. With one other vertex the mode is constant.
template <class Scalar>
bool may_be_crossed_from_zero(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                              const std::array<Index, 4>& tet) {
  const unsigned zeros = input.zero_corners(tet);
  if (std::popcount(zeros) > 2) return false;
  // Also where the edge is free of crossings: they tell which stretches belong together.
  if (std::popcount(zeros) == 2) return true;
  std::array<Deviator<Scalar>, 3> corners;
  bool some_above = false, some_below = false;
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    if (zeros >> i & 1) continue;
    corners[k++] = input.field.tensors[as_size(tet[i])];
    (sides.above[as_size(tet[i])] ? some_above : some_below) = true;
  }
  if (some_above && some_below) return true;
  return !screen::excludes(rounded(corners), input.level.lode_angle) &&
         !is_proved_empty(corners, input.level);
}

}  // namespace

template <class Scalar>
ActiveCells active_cells(const SurfaceInput<Scalar>& input, const VertexSides& sides) {
  const auto& mesh = input.mesh;
  const auto& tensors = input.prepared.tensors();
  const auto& ranges = input.prepared.lode_ranges;
  const auto& level = input.level;
  std::vector<char> active(mesh.tets.size(), 0);
  // Whether the level may meet a tetrahedron; where signs of coefficients have to tell, `unsure`.
  const auto screened = [&](std::size_t t, bool& unsure) {
    if (!ranges.empty() && (level.lode_angle < static_cast<double>(ranges[t][0]) ||
                            level.lode_angle > static_cast<double>(ranges[t][1])))
      return false;
    const auto& v = mesh.tets[t];
    if (input.zero_corners(v) != 0) return may_be_crossed_from_zero(input, sides, v);
    for (const Index w : v)
      if (sides.above[as_size(w)] != sides.above[as_size(v[0])]) return true;
    if (is_clear(input, sides, v)) return false;
    const std::array<Deviator<double>, 4> corners{tensors[as_size(v[0])], tensors[as_size(v[1])],
                                                  tensors[as_size(v[2])], tensors[as_size(v[3])]};
    unsure = !screen::excludes(corners, level.lode_angle);
    return unsure;
  };
  parallel_blocks(input.options, "screen", mesh.tets.size(), 4096, EmptyBlock<Scalar, 4>::size,
                  [&](std::size_t begin, std::size_t end) {
                    EmptyBlock<Scalar, 4> empty;
                    for (std::size_t t = begin; t < end; ++t) {
                      bool unsure = false;
                      active[t] = screened(t, unsure);
                      if (unsure) empty.want(t - begin, mesh.tets[t], input.field.tensors);
                    }
                    empty.make(level);
                    for (std::size_t t = begin; t < end; ++t)
                      if (empty.is_empty(t - begin)) active[t] = 0;
                  });
  ActiveCells result;
  std::vector<Index> tets;
  for (std::size_t t = 0; t < active.size(); ++t)
    if (active[t]) tets.push_back(static_cast<Index>(t));
  const auto& is_zero = input.field.is_zero;
  if (std::find(is_zero.begin(), is_zero.end(), 1) != is_zero.end()) {
    std::vector<char> zero(mesh.points.size(), 0);
    for (const auto& tet : mesh.tets) {
      const unsigned corners = input.zero_corners(tet);
      if (corners == 15u) ++result.undefined;
      for (std::size_t i = 0; corners != 0 && i < 4; ++i)
        if (corners >> i & 1) zero[as_size(tet[i])] = 1;
    }
    for (const char z : zero) result.zero_vertices += z != 0;
  }
  result.screened_out = mesh.tets.size() - tets.size() - result.undefined;
  result.complex = tet_complex(mesh, tets);
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template ActiveCells active_cells(const SurfaceInput<Scalar>&, const VertexSides&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
