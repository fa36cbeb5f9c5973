// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/analysis/extract_command.hpp"

namespace tensortopo {

/// Throws UsageError for options that contradict each other, or that do nothing for these modes:
/// what can be known before anything is read.
void require_sense(const ExtractCommand& command, const std::vector<ModeValue>& modes);

}  // namespace tensortopo
