// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tensortopo {

/// Bytes that a person wrote: a number, which may be followed by k, M, G or T (powers of 1000), by
/// these and B, or by Ki, Mi, Gi or Ti (powers of 1024) and B. Throws UsageError for anything else,
/// and unless it is at least one byte.
std::uint64_t parse_memory(const std::string& text);

}  // namespace tensortopo
