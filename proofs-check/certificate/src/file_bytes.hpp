// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace certificate {

/// All bytes of a regular file. Throws Malformed.
std::string file_bytes(const std::string& file);

}  // namespace certificate
