// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/options/common_options.hpp"

namespace tensortopo {

/// Throws UsageError if a file would be written that is also read, or twice. Links are followed.
void require_distinct_files(const CommonOptions& common);

}  // namespace tensortopo
