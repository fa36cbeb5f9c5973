// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curves/piece_vertices.hpp"

#include <array>
#include <bit>
#include <stdexcept>

#include "tensortopo/extract/meshing_message.hpp"
#include "tensortopo/partition/curve_seam.hpp"

namespace tensortopo {

std::vector<std::uint64_t> lines_around(const CurveMesh& curves,
                                        std::span<const std::int64_t> cell_ids) {
  std::vector<std::uint64_t> result(curves.points.size(), 0);
  for (std::size_t i = 0; i < curves.lines.size(); ++i) {
    const std::uint64_t hash =
        digest_of(std::array{std::bit_cast<double>(cell_ids[as_size(curves.tet[i])])});
    for (const auto v : {curves.lines[i].front(), curves.lines[i].back()})
      result[as_size(v)] += hash;
  }
  return result;
}

std::uint64_t digest_of_vertex(const PieceCurves& piece, std::size_t v) {
  const CurveMesh& curves = piece.curves;
  const auto &p = curves.points[v], &d = curves.dominant_eigenvector[v];
  return digest_of(std::array{p.x, p.y, p.z, d.x, d.y, d.z, curves.mode[v], curves.separation[v],
                              curves.residual[v], static_cast<double>(curves.carrier[v]),
                              static_cast<double>(piece.keys.vertices[v].kind)});
}

template <class Piece>
void require_one_kind(std::span<const Piece> pieces) {
  for (const Piece& piece : pieces)
    if (piece.kind != pieces[0].kind)
      throw std::invalid_argument(
          "pieces: some have linear curves, others planar ones: extract one kind from all");
}

template void require_one_kind(std::span<const PieceCurves> pieces);
template void require_one_kind(std::span<const CurveSeam> seams);

}  // namespace tensortopo
