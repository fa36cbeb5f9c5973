// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace tensortopo::detail {

/// Appends bytes as base64, padded. Large ones are encoded in parallel.
void append_base64(std::span<const std::byte> bytes, std::string& text);

}  // namespace tensortopo::detail
