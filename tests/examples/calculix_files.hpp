// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reactions.hpp"
#include "restart_file.hpp"
#include "support/folder.hpp"

namespace tensortopo::test {

/// The bytes of a .rout file, laid out as by CalculiX 2.20: 14 records of counts, then some of
/// other lengths around those that matter.
std::string restart_bytes(const scenarios::RestartFile& content);

/// One Fortran record.
std::string record(const std::string& bytes);

/// The bytes of a binary .frd file of hexahedra.
std::string frd_bytes(const scenarios::HexMesh& mesh,
                      const std::vector<Vector3<double>>& displacements,
                      const std::vector<SymmetricTensor<double>>& stresses);

/// The text of a .dat file.
std::string dat_text(const scenarios::Reactions& reactions);

/// A stress at the integration points of each hexahedron.
std::vector<scenarios::RestartFile::HexStress> sampled(
    const scenarios::HexMesh& mesh,
    const std::function<SymmetricTensor<double>(const Vector3<double>&)>& stress);

/// Writes bytes to a file.
void put(const std::filesystem::path& file, const std::string& bytes);

}  // namespace tensortopo::test
