// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <string>

#include "forgery.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {

using Json = nlohmann::json;

/// Counts what came of the forgeries of one test. The short suite tries one in four of each kind.
class Trial {
 public:
  explicit Trial(const std::string& name) : court_(name) {}
  ~Trial() {
    EXPECT_GT(tried_, 0u);
    std::cout << tried_ << " forgeries\n";
  }

  void expect_not_certified(const Exhibit& e, const std::string& what) {
    if (!share_.has(what)) return;
    ++tried_;
    EXPECT_NE(court_.verdict(e), "certified") << what;
  }
  void expect(const std::string& verdict, const Exhibit& e, const std::string& what) {
    if (!share_.has(what)) return;
    ++tried_;
    EXPECT_EQ(court_.verdict(e), verdict) << what << '\n' << court_.report();
  }

 private:
  Court court_;
  Share share_{4};
  std::size_t tried_ = 0;
};

/// Each level of each exhibit, to be altered by `alter`, which calls back once for each forgery.
using Judge = std::function<void(const Json&, const std::string&)>;
inline void for_levels(Trial& trial, const std::function<void(const Json&, const Judge&)>& forge) {
  for (const Exhibit& honest : honest_exhibits()) {
    for (std::size_t l = 0; l < honest.certificate["levels"].size(); ++l) {
      forge(honest.certificate["levels"][l], [&](const Json& level, const std::string& what) {
        Exhibit forged = honest;
        forged.certificate["levels"][l] = level;
        trial.expect_not_certified(forged, what);
      });
    }
  }
}

/// The list with entry i left out, given twice, or with `change` done to it.
inline void alter_entries(const Json& level, const char* list, const Judge& judge) {
  for (std::size_t i = 0; i < level[list].size(); ++i) {
    Json without = level, twice = level;
    without[list].erase(i);
    twice[list].insert(twice[list].begin() + static_cast<std::ptrdiff_t>(i), level[list][i]);
    judge(without, std::string(list) + " without one");
    judge(twice, std::string(list) + " with one twice");
  }
}

}  // namespace tensortopo::test
