// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/torn_faces.hpp"

#include <algorithm>
#include <vector>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {

std::string TornFaces::text() const {
  if (count == 0) return {};
  const auto face = [&](std::size_t side) {
    std::string text;
    for (const std::int64_t v : vertices[side]) text += std::to_string(v) + " ";
    return text + "of cell " + std::to_string(cells[side]);
  };
  return std::to_string(count) + (count == 1 ? " face lies on another" : " faces lie on others") +
         " without being shared (vertices " + face(0) + ", on " + face(1) +
         "): surfaces are torn there";
}

TornFaces torn_faces(std::span<const std::array<std::size_t, 2>> pairs, const TetMesh& mesh,
                     std::span<const OuterFace> outer) {
  TornFaces torn;
  if (pairs.empty()) return torn;
  std::vector<char> is_torn(outer.size(), 0);
  for (const auto& pair : pairs) is_torn[pair[0]] = is_torn[pair[1]] = 1;
  torn.count = static_cast<std::size_t>(std::count(is_torn.begin(), is_torn.end(), 1));
  const auto& first = *std::min_element(pairs.begin(), pairs.end());
  for (const std::size_t side : {0u, 1u}) {
    const OuterFace& face = outer[first[side]];
    std::copy(face.vertices.begin(), face.vertices.end(), torn.vertices[side].begin());
    std::sort(torn.vertices[side].begin(), torn.vertices[side].end());
    torn.cells[side] = mesh.cell_ids[as_size(face.tet)];
  }
  return torn;
}

}  // namespace tensortopo
