// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tensortopo {

/// The most memory that the process has held since it began, in bytes: resident pages.
std::uint64_t peak_memory();

}  // namespace tensortopo
