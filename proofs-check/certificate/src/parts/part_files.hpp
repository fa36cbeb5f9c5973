// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The files of a field or surface in parts.
#pragma once

#include <string>
#include <vector>

namespace certificate {

/// The names of the pieces that a .pvtu or .pvtp has, in order, as they are written there. Each is
/// there once. Throws Malformed.
/// @param kind  "UnstructuredGrid" or "PolyData"
std::vector<std::string> piece_names(const std::string& file, const std::string& kind);

/// The path of a file that another one names. The name has folders below that of the other at most:
/// it is refused if it is absolute, or has parts that are empty, `.` or `..`. Throws Malformed.
std::string beside(const std::string& file, const std::string& name);

}  // namespace certificate
