// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "hex_mesh.hpp"

namespace tensortopo::scenarios {

/// Forces of the clamp on nodes, as a .dat file lists them with seven digits.
struct Reactions {
  struct AtNode {
    Index point = -1;
    Vector3<double> force;
  };
  std::vector<AtNode> nodes;
  Vector3<double> total;  ///< CalculiX's own sum
};

/// Reads the forces on the set BOTTOM from a .dat file that lists each and the total.
/// Throws  IoError (`unreadable`, `invalid`).
Reactions read_reactions(const std::filesystem::path& file);

}  // namespace tensortopo::scenarios
