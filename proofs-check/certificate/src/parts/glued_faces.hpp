// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The faces at which meshes of parts become one mesh.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "parts/mesh_border.hpp"
#include "run/ledger.hpp"

namespace certificate {

/// A face as one of the parts has it.
struct FaceOfPart {
  std::array<BorderPlace, 3> places{};
  std::size_t part = 0;
  std::uint32_t face = 0;  ///< of the part's border

  auto operator<=>(const FaceOfPart&) const = default;
};

/// A face that two parts have, with a tetrahedron on each side.
struct GluedFace {
  FaceOfPart one, other;
  std::string name;  ///< for messages
};

/// All of them, in the order of their places. Refuted are points of different parts at one place with
/// different tensors, faces of more than two tetrahedra, and faces with both on one side.
/// @param borders  of all parts
std::vector<GluedFace> glued_faces(std::span<const MeshBorder* const> borders, Ledger& ledger);

}  // namespace certificate
