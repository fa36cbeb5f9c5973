// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/mesh_border.hpp"

#include <algorithm>
#include <cstdio>
#include <unordered_map>

#include "mesh/exact_signs.hpp"
#include "places.hpp"

namespace certificate {

BorderPlace place_of(const std::array<double, 3>& point) {
  return {point[0] + 0.0, point[1] + 0.0, point[2] + 0.0};
}

std::string place_text(const BorderPlace& place) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.17g %.17g %.17g)", place[0], place[1], place[2]);
  return text;
}

std::vector<std::pair<FaceCorners, std::uint32_t>> outer_faces(const Input& input) {
  std::vector<std::pair<FaceCorners, std::uint32_t>> faces, outer;
  faces.reserve(4 * input.tets.size());
  for (const auto& tet : input.tets)
    for (std::size_t i = 0; i < 4; ++i) faces.emplace_back(without(tet, i), tet[i]);
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i < faces.size(); ++i)
    if ((i == 0 || faces[i - 1].first != faces[i].first) &&
        (i + 1 == faces.size() || faces[i + 1].first != faces[i].first))
      outer.push_back(faces[i]);
  return outer;
}

MeshBorder border_of(const Input& input) {
  MeshBorder border;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (auto& [corners, opposite] : outer_faces(input)) {
    std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(place_of(input.points[a]), a) < std::pair(place_of(input.points[b]), b);
    });
    BorderFace face;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [known, is_new] =
          number.try_emplace(corners[i], static_cast<std::uint32_t>(border.points.size()));
      if (is_new)
        border.points.push_back({place_of(input.points[corners[i]]), input.tensors[corners[i]]});
      face.points[i] = known->second;
    }
    face.side = side_of(input.points[corners[0]], input.points[corners[1]],
                        input.points[corners[2]], input.points[opposite]);
    border.faces.push_back(face);
  }
  return border;
}

}  // namespace certificate
