// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "extractor_scalars.hpp"
#include "tensortopo/extract/polygon.hpp"
#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

std::vector<RimVertex> loop_vertices(std::span<const RimPiece> loop,
                                     const FaceArcVertices& vertices) {
  std::size_t size = 0;
  for (const auto& piece : loop)
    size += vertices[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)]
                .vertices.size();
  std::vector<RimVertex> rim;
  rim.reserve(size);
  for (const auto& piece : loop) {
    const auto& arc =
        vertices[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)]
            .vertices;
    // A closed arc gives all of its vertices, an open one leaves its last to the next piece.
    const bool closed = loop.size() == 1;
    const std::size_t n = arc.size(), count = closed ? n : n - 1;
    for (std::size_t i = 0; i < count; ++i) rim.push_back(arc[piece.forward ? i : n - 1 - i]);
  }
  return rim;
}

bool is_small_disc(const SheetTopology& sheet, std::span<const RimVertex> rim,
                   const Sampling& sampling) {
  if (sheet.euler_characteristic != 1 || rim.size() > kSmallPolygon) return false;
  const double least = std::cos(std::min(1.5 * sampling.largest_turn(), 1.5));
  const double least_dominant = std::cos(std::min(3 * sampling.largest_turn(), 1.5));
  for (const auto& v : rim)
    if (!(line_cosine(v.medium, rim[0].medium) > least) ||
        !(line_cosine(v.dominant, rim[0].dominant) > least_dominant))
      return false;
  return true;
}

template <class Scalar>
bool mesh_within_rim(std::span<const RimVertex> rim, TetTriangles<Scalar>& out) {
  // Nearly all rims are short, and there are very many.
  std::array<PolygonCorner, kSmallPolygon> few;
  std::vector<PolygonCorner> many(rim.size() > few.size() ? rim.size() : 0);
  const auto corners = many.empty() ? std::span(few.data(), rim.size()) : std::span(many);
  for (std::size_t i = 0; i < rim.size(); ++i) corners[i] = {rim[i].position, rim[i].faces};
  const auto triangles = cut_polygon(corners);
  out.triangles.reserve(out.triangles.size() + triangles.size());
  for (const auto& t : triangles)
    out.triangles.push_back({rim[static_cast<std::size_t>(t[0])].id,
                             rim[static_cast<std::size_t>(t[1])].id,
                             rim[static_cast<std::size_t>(t[2])].id});
  return !triangles.empty();
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template bool mesh_within_rim(std::span<const RimVertex>, TetTriangles<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
