// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "hex_mesh.hpp"

namespace tensortopo::scenarios {

/// What CalculiX knows at the end of a step, in float64.
struct RestartFile {
  using HexStress = std::array<SymmetricTensor<double>, 8>;

  /// Nodes as in the deck; then those that C3D8I elements add for their incompatible modes.
  std::vector<Vector3<double>> points;
  std::vector<Vector3<double>> displacements;  ///< one per node
  /// Cauchy stress at the 2 x 2 x 2 integration points of each hexahedron, x fastest.
  std::vector<HexStress> stresses;
};

/// Reads a .rout file of CalculiX 2.20, which has hexahedra with 8 integration points only.
///
/// The file is a sequence of Fortran records. The counts are single numbers at its beginning:
/// nodes and elements four and three records before the one of three integers (integration points
/// and degrees of freedom). Coordinates are the first record that is long enough; stresses and
/// strains are the last two neighbours of the length that stresses have, and displacements the last
/// record of theirs before. CalculiX lists xx yy zz xy XZ YZ; the order here is ours. Throws
/// IoError (`unreadable`, `invalid`).
RestartFile read_restart_file(const std::filesystem::path& file);

/// The same of bytes that are at hand; `file` is for messages.
RestartFile parse_restart_file(std::string bytes, const std::filesystem::path& file);

}  // namespace tensortopo::scenarios
