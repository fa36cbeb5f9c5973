// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace tensortopo {

/// All bytes of a regular file. Throws IoError (`unreadable`), also for a folder, a pipe or a device.
std::string read_text(const std::filesystem::path& file);

}  // namespace tensortopo
