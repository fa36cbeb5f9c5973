// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tensortopo {

enum class Tier { fast, multiprecision, exact };

/// Counts a predicate for `predicate_counts`.
void count_predicate(Tier tier);

}  // namespace tensortopo
