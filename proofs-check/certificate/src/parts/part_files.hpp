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

/// A file that another one names.
std::string beside(const std::string& file, const std::string& name);

}  // namespace certificate
