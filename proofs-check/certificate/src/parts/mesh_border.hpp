// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The border of a part's mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "input.hpp"

namespace certificate {

using BorderPlace = std::array<double, 3>;  ///< without negative zeros

/// A vertex of the part's mesh on its border.
struct BorderPoint {
  BorderPlace place{};
  std::array<double, 6> tensor{};
};

/// A face of one tetrahedron of the part.
struct BorderFace {
  std::array<std::uint32_t, 3> points{};  ///< of the border's, ascending by place
  int side = 0;                           ///< of these three, on which the tetrahedron is: 1 or -1
};

struct MeshBorder {
  std::vector<BorderPoint> points;
  std::vector<BorderFace> faces;  ///< in the order of `outer_faces`
};

/// Both zeros are one.
BorderPlace place_of(const std::array<double, 3>& point);

/// For messages.
std::string place_text(const BorderPlace& place);

using FaceCorners = std::array<std::uint32_t, 3>;

/// Faces of one tetrahedron, ascending, with the vertex opposite.
std::vector<std::pair<FaceCorners, std::uint32_t>> outer_faces(const Input& input);

MeshBorder border_of(const Input& input);

}  // namespace certificate
