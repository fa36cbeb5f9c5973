// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace tensortopo::detail {

/// What is known of an array's bytes: integers have patterns, the digits of computed numbers none.
enum class Patterns { some, none };

/// Appends an array's bytes as files of VTK have them inline: zlib blocks behind a header of 64-bit
/// words, in base64. Blocks are made in parallel; the text does not depend on the number of
/// threads.
void append_block(std::span<const std::byte> bytes, Patterns patterns, std::string& text);

}  // namespace tensortopo::detail
