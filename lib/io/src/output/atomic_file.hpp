// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tensortopo::detail {

/// Makes a file of these bytes, whole or not at all: they go to a file of another name in the same
/// folder, which is then renamed (a device or pipe is written as it is). On failure that file is
/// removed; throws IoError (unwritable). While a `FileGroup` lives in this thread, the renaming is
/// left to it.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace tensortopo::detail
