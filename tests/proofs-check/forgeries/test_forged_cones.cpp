// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The claims about sheets around isotropic vertices, altered.
#include "forgery_trial.hpp"

namespace tensortopo::test {
namespace {

TEST(Forgeries, Cones) {
  Trial trial("cones");
  std::size_t closed = 0, arcs = 0, joins = 0;
  for_levels(trial, [&](const Json& level, const Judge& judge) {
    alter_entries(level, "cones", judge);
    const std::uint64_t first = level["vertices"][0], count = level["vertices"][1];
    for (std::size_t t = 0; t < level["cones"].size(); ++t) {
      const Json& cone = level["cones"][t];
      for (std::size_t s = 1; s < cone.size(); ++s) {
        ++(cone[s].size() == 2 ? closed : cone[s].size() == 3 ? arcs : joins);
        const auto forge = [&](const std::string& what, const std::function<void(Json&)>& change) {
          Json forged = level;
          change(forged["cones"][t]);
          if (forged != level) judge(forged, what);
        };
        forge("sheet left out", [&](Json& x) { x.erase(s); });
        forge("sheet doubled", [&](Json& x) { x.push_back(cone[s]); });
        for (std::size_t k = 0; k < cone[s].size(); ++k) {
          forge("without a vertex", [&](Json& x) { x[s].erase(k); });
          forge("a vertex twice", [&](Json& x) { x[s].push_back(cone[s][k]); });
          for (const std::uint64_t v : {std::uint64_t{0}, first, first + count / 2,
                                        first + count - 1, first + count, std::uint64_t{1} << 40})
            forge("another vertex", [&](Json& x) { x[s][k] = v; });
          forge("exchanged", [&](Json& x) { std::swap(x[s][k], x[s][(k + 1) % x[s].size()]); });
          if (s + 1 < cone.size() && k < cone[s + 1].size())
            forge("exchanged with another sheet",
                  [&](Json& x) { std::swap(x[s][k], x[s + 1][k]); });
        }
        forge("reversed", [&](Json& x) { std::reverse(x[s].begin(), x[s].end()); });
        forge("ends reversed", [&](Json& x) { std::reverse(x[s].begin() + 1, x[s].end()); });
      }
    }
  });
  EXPECT_GT(closed, 0u);
  EXPECT_GT(arcs, 0u);
  EXPECT_GT(joins, 0u);
}

}  // namespace
}  // namespace tensortopo::test
