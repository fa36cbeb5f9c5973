// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// The tetrahedra of a file as `read_mesh` makes them, whatever arrays there are: no tensor is chosen
/// or read, and the mesh's tensors are zero. Throws IoError.
ReadResult read_geometry(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace tensortopo
