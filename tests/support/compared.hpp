// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace tensortopo::test {

/// Counts what a test compares, for tests whose assertions are behind a condition: fails when it
/// ends with fewer comparisons than it asks for, unless the test failed or was skipped before.
class Compared {
 public:
  /// @param what  is compared, as messages say it
  explicit Compared(std::string what, std::size_t at_least = 1)
      : what_(std::move(what)), at_least_(at_least) {}
  ~Compared() {
    if (testing::Test::IsSkipped() || testing::Test::HasFatalFailure()) return;
    EXPECT_GE(count_, at_least_) << "too few comparisons: " << what_;
  }
  Compared(const Compared&) = delete;
  Compared& operator=(const Compared&) = delete;

  void count(bool really = true) { count_ += really; }
  void operator++() { ++count_; }
  std::size_t so_far() const { return count_; }

 private:
  std::string what_;
  std::size_t at_least_, count_ = 0;
};

}  // namespace tensortopo::test
