// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/time_budget.hpp"

#include <algorithm>

namespace tensortopo {

double TimeBudget::take(double weight) {
  const double left = seconds_ - std::chrono::duration<double>(Clock::now() - start_).count();
  const double share = weights_ > weight ? weight / weights_ : 1;
  weights_ -= weight;
  return std::max(0.0, left) * share;
}

}  // namespace tensortopo
