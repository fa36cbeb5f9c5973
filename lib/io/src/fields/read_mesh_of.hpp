// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "bytes/input_file.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::detail {

/// `read_mesh` of a file that is in memory. (The pieces of a .pvtu are not.)
ReadResult read_mesh_of(const std::shared_ptr<const InputFile>& file, const ReadOptions& options);

}  // namespace tensortopo::detail
