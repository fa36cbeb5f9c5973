// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {

/// Adds to each statement the fields that violate it without one of its hypotheses, and which of
/// its hypotheses have none. Requires all statements.
void add_hypotheses(std::vector<Statement>& all);

}  // namespace tensortopo::theory
