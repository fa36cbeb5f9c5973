// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch.hpp"

namespace tensortopo {

std::vector<BoundaryVertex> loop_vertices(const BoundaryLoop& loop,
                                          const FaceArcVertices& vertices) {
  std::size_t size = 0;
  for (const auto& piece : loop)
    size += vertices[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)]
                .vertices.size();
  std::vector<BoundaryVertex> boundary;
  boundary.reserve(size);
  for (const auto& piece : loop) {
    const auto& arc =
        vertices[static_cast<std::size_t>(piece.face)][static_cast<std::size_t>(piece.arc)]
            .vertices;
    // A closed arc gives all of its vertices, an open one leaves its last to the next piece.
    const bool closed = loop.size() == 1;
    const std::size_t n = arc.size(), count = closed ? n : n - 1;
    for (std::size_t i = 0; i < count; ++i) boundary.push_back(arc[piece.forward ? i : n - 1 - i]);
  }
  return boundary;
}

}  // namespace tensortopo
