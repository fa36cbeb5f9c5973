// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tensortopo::detail {

/// The bytes of base64 text, which may be several encodings in a row, each with its own padding
/// (VTK encodes a block's header by itself). White space is skipped; the text may stop at any
/// character of another kind if `prefix` is set. Throws FormatError.
std::string from_base64(std::string_view text, bool prefix = false);

}  // namespace tensortopo::detail
