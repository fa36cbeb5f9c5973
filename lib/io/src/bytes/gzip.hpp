// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tensortopo::detail {

/// Whether bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// The first `count` bytes of what a gzip file holds (of one or several members), or all if there
/// are fewer; checksums of members that end within these are checked. Throws FormatError for damaged
/// bytes. Needs no more memory than the bytes can fill.
std::string gunzip(std::string_view bytes, std::size_t count);

}  // namespace tensortopo::detail
