// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "extract/curves/arcs/isolated_zeros.hpp"

namespace tensortopo::test {
namespace {

using E = MultiprecisionInterval;

/// The product of (t - root / 1001) over eight roots, times a sign.
std::array<E, 9> with_roots(const std::vector<int>& roots, double sign) {
  std::array<E, 9> p;
  p.fill(E(0.0));
  p[0] = E(sign);
  // Times (1001 t - root) = (1001 - root) t - root (1 - t); coefficients of t^k (1 - t)^(n - k).
  for (std::size_t n = 0; n < roots.size(); ++n)
    for (std::size_t k = n + 2; k-- > 0;) {
      E value(0.0);
      if (k <= n) value = value - E(static_cast<double>(roots[n])) * p[k];
      if (k > 0) value = value + E(static_cast<double>(1001 - roots[n])) * p[k - 1];
      p[k] = value;
    }
  return p;
}

RC_GTEST_PROP(IsolatedZeros, AreTheSimpleRoots, ()) {
  const auto roots = *rc::gen::container<std::vector<int>>(8, rc::gen::inRange(-600, 1600));
  const double sign = *rc::gen::element(1.0, -1.0);
  const IsolatedZeros found = ZeroIsolation<E, 9>(with_roots(roots, sign)).zeros();
  const auto sign_at = [&](int t) {
    int result = sign > 0 ? 1 : -1;
    for (const int root : roots) result *= t > root ? 1 : t < root ? -1 : 0;
    return result;
  };
  RC_ASSERT(found.begin == sign_at(0));
  RC_ASSERT(found.end == sign_at(1001));
  const std::multiset<int> all(roots.begin(), roots.end());
  const std::set<int> different(roots.begin(), roots.end());
  const auto holds = [](const DyadicInterval& part, int root) {
    const double width = std::ldexp(1.0, -part.depth);
    const double low = static_cast<double>(part.index) * width;
    return 1001 * low <= root && root <= 1001 * (low + width);
  };
  std::size_t simple = 0;
  for (const int root : different) {
    if (root < 0 || root > 1001) continue;
    const auto count = std::count_if(found.simple.begin(), found.simple.end(),
                                     [&](const auto& part) { return holds(part, root); });
    const bool is_open = std::any_of(found.open.begin(), found.open.end(),
                                     [&](const auto& part) { return holds(part, root); });
    const bool is_simple = all.count(root) == 1 && root > 0 && root < 1001;
    RC_ASSERT(count == (is_simple ? 1 : 0));
    // Double roots, and those at the ends, are left open and never counted.
    RC_ASSERT(is_open == !is_simple);
    simple += is_simple;
  }
  RC_ASSERT(found.simple.size() == simple);
  RC_TAG(simple);
}

TEST(IsolatedZeros, OfNothingAreOpen) {
  std::array<E, 9> zero;
  zero.fill(E(0.0));
  const IsolatedZeros found = ZeroIsolation<E, 9>(zero).zeros();
  EXPECT_TRUE(found.simple.empty());
  EXPECT_EQ(found.open.size(), 1u);
  EXPECT_EQ(found.begin, 0);
  EXPECT_EQ(found.end, 0);
}

}  // namespace
}  // namespace tensortopo::test
