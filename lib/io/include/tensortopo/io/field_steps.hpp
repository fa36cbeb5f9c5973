// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tensortopo {

/// What each step of a file is (`ReadOptions::step` counts them from 1), as its format tells it:
/// number, time, frequency. Throws IoError, also for a format without steps.
std::vector<std::string> field_steps(const std::filesystem::path& file);

}  // namespace tensortopo
