// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hex_mesh.hpp"

namespace tensortopo::scenarios {

/// What CalculiX writes for its viewer: displacement and stress at the deck's nodes, in float32.
struct FrdFile {
  std::vector<Vector3<double>> displacements;
  std::vector<SymmetricTensor<double>> stresses;
};

/// Reads a binary .frd file whose nodes are numbered 1, 2 and so on, and which has one result
/// block DISP and one STRESS; other blocks are skipped.
/// Throws  IoError (`unreadable`, `invalid`).
FrdFile read_frd_file(const std::filesystem::path& file);

/// The same of bytes that are at hand; `file` is for messages.
FrdFile parse_frd_file(std::string bytes, const std::filesystem::path& file);

}  // namespace tensortopo::scenarios
