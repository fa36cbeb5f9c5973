// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace tensortopo {

/// What tells a file's format: the extension of its name, with the dot, its ASCII letters in lower
/// case. ".vtp" of `S.VTP`; nothing if the name has none.
std::string lower_extension(const std::filesystem::path& file);

}  // namespace tensortopo
