// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace tensortopo::test {
namespace {

class ExtractSameBytes : public testing::TestWithParam<const char*> {};

TEST_P(ExtractSameBytes, WhateverTheNumberOfThreads) {
  const Folder folder;
  std::vector<std::string> files;
  for (const char* threads : {"1", "2"}) {
    files.push_back(folder / (std::string("threads") + threads + GetParam()));
    const Outcome run = run_program({"extract", field("s4_slab"), "-o", files.back(), "--mode",
                                     "0.5", "--generalized", "--threads", threads, "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  const std::string bytes = contents(files[0]);
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == contents(files[1]));
}

TEST(ExtractCurves, GivesTheSameBytesWhateverTheNumberOfThreads) {
  for (const std::string extension : {".vtp", ".ply", ".obj"}) {
    const Folder folder;
    std::vector<std::string> files;
    for (const char* threads : {"1", "2"}) {
      files.push_back(folder / (threads + extension));
      const Outcome run =
          run_program({"extract", field("s1_compress_off"), "-o", files.back(), "--mode", "1",
                       "--generalized", "--threads", threads, "--quiet"});
      ASSERT_EQ(run.status, 0) << run.err;
    }
    const std::string bytes = contents(files[0]);
    EXPECT_GT(bytes.size(), 10000u);
    EXPECT_TRUE(bytes == contents(files[1])) << extension;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ExtractSameBytes,
                         testing::Values(".vtp", ".ply", ".obj", ".off", ".stl"),
                         [](const auto& format) { return std::string(format.param + 1); });

}  // namespace
}  // namespace tensortopo::test
