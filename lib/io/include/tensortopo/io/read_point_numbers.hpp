// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// One number at each vertex of a field: an array of one component on the points of its file.
///
/// Throws IoError: `inapplicable` if vertices of the field are not the points of the file, in its
/// order (points merged, added or doubled; files in pieces), or if the file has no such array, or
/// two of the name; `invalid` if a number is not finite, or if the file is another than was read.
/// @param file     a field's, as `read_mesh` takes it
/// @param array    the array's name
/// @param options  with which the field was read
/// @param read     the field
std::vector<double> read_point_numbers(const std::filesystem::path& file, const std::string& array,
                                       const ReadOptions& options, const ReadResult& read);

}  // namespace tensortopo
