// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/options/common_options.hpp"

namespace tensortopo {

/// Throws UsageError if an option of the command chosen is given with an empty text as its value:
/// none has a meaning, and a script's variable that is not set must not turn an option off.
void require_given_values(const CommonOptions& common);

}  // namespace tensortopo
