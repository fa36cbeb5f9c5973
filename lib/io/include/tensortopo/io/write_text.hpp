// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tensortopo {

/// Writes bytes to a file, whole or not at all (as write_surface does). Throws IoError.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace tensortopo
