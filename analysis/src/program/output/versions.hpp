// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tensortopo {

/// The program's version alone.
std::string program_version();

/// The program's version, and those of the libraries that it was built on. Ends without newline.
std::string version_text();

}  // namespace tensortopo
