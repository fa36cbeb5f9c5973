// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "analysis/run_program.hpp"

namespace tensortopo::test {

/// One line, starting with the program's name, and naming what it is about.
inline void expect_error_line(const Outcome& run, const std::string& about) {
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(run.err.starts_with("tensortopo: ")) << run.err;
  EXPECT_NE(run.err.find(about), std::string::npos) << run.err;
}

inline void expect_line(const Outcome& run, int status, const std::string& about) {
  EXPECT_EQ(run.status, status) << run.err;
  expect_error_line(run, about);
}

}  // namespace tensortopo::test
