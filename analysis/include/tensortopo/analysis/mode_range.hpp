// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Reads A:B:N, as in "-0.9:0.9:37": N modes from A to B, evenly spaced, exact.
///
/// @param option  that the text is of, for messages
/// @param most    the largest N; the least is 2
/// Throws UsageError with the reason.
std::vector<ModeValue> parse_mode_range(const std::string& option, std::string_view text,
                                        std::size_t most);

}  // namespace tensortopo
