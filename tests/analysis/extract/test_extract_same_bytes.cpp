// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"

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

TEST_P(ExtractSameBytes, WhateverTheNumberOfPieces) {
  const Folder folder;
  const std::string whole = folder / (std::string("whole") + GetParam());
  const std::string pieces = folder / (std::string("pieces") + GetParam());
  // What is written is alike in all formats: one of them is tried on the larger surface.
  const std::string mesh = field(std::string(GetParam()) == ".vtp" ? "s2_pushpull" : "s4_slab");
  for (const auto& file : {whole, pieces}) {
    const Outcome run = run_program({"extract", mesh, "-o", file, "--mode", "0.5", "--generalized",
                                     "--pieces", file == whole ? "1" : "3", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  const std::string bytes = contents(whole);
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == contents(pieces));
}

TEST(ExtractCertificate, IsTheSameBytesWhateverTheNumberOfPieces) {
  const Folder folder;
  const std::string field_file = field("s2_pushpull");
  std::vector<std::string> certificates, surfaces;
  for (const char* pieces : {"1", "4"}) {
    surfaces.push_back(folder / (std::string(pieces) + ".vtp"));
    certificates.push_back(folder / (std::string(pieces) + ".json"));
    const Outcome run =
        run_program({"extract", field_file, "-o", surfaces.back(), "--mode", "0.5", "--generalized",
                     "--improve", "--pieces", pieces, "--certify", certificates.back(), "--json"});
    ASSERT_LE(run.status, 1) << run.err;
    const auto beyond = nlohmann::json::parse(run.out).at("certificate").at("beyond_checker");
    EXPECT_EQ(beyond.is_null(), *pieces == '4');
  }
  const std::string bytes = contents(certificates[0]);
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == contents(certificates[1]));
  EXPECT_TRUE(contents(surfaces[0]) == contents(surfaces[1]));
}

TEST(ExtractCurves, GivesTheSameBytesWhateverTheNumberOfPieces) {
  for (const char* mode : {"1", "-1"}) {
    const Folder folder;
    std::vector<std::string> files;
    for (const char* pieces : {"1", "2", "9"}) {
      files.push_back(folder / (std::string(pieces) + ".vtp"));
      const Outcome run = run_program({"extract", field("s1_compress_off"), "-o", files.back(),
                                       std::string("--mode=") + mode, "--mode", "0.5", "--pieces",
                                       pieces, "--quiet"});
      ASSERT_EQ(run.status, 0) << run.err;
    }
    const std::string bytes = contents(files[0]);
    EXPECT_GT(bytes.size(), 10000u);
    EXPECT_TRUE(bytes == contents(files[1]));
    EXPECT_TRUE(bytes == contents(files[2]));
  }
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

TEST(ExtractModes, OfARangeAreThoseGivenOneByOne) {
  const Folder folder;
  const auto extract = [&](const std::string& file, const std::vector<std::string>& modes) {
    std::vector<std::string> words{"extract", field("s4_slab"), "-o", file, "--json"};
    for (const auto& mode : modes) words.insert(words.end(), {"--mode", mode});
    return run_program(words);
  };
  const Outcome range = extract(folder / "range.ply", {"-1/3:0.5:6"}),
                each = extract(folder / "each.ply", {"-1/3", "-1/6", "0", "1/6", "1/3", "1/2"});
  ASSERT_EQ(range.status, 0) << range.err;
  ASSERT_EQ(each.status, 0) << each.err;
  const std::string bytes = contents(folder / "range.ply");
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == contents(folder / "each.ply"));
  const auto surfaces = [](const Outcome& run) {
    return nlohmann::json::parse(run.out).at("surfaces");
  };
  EXPECT_EQ(surfaces(range).size(), 6u);
  EXPECT_EQ(surfaces(range), surfaces(each));
  for (const std::string text : {"0:0.5", "0:0.5:1", "0:2:3", "0:0.5:x", "0:0.5:3:4", ":0.5:3"}) {
    const Outcome wrong = extract(folder / "none.ply", {text});
    EXPECT_EQ(wrong.status, 2) << text;
    EXPECT_NE(wrong.err.find("--mode " + text), std::string::npos) << wrong.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ExtractSameBytes,
                         testing::Values(".vtp", ".ply", ".obj", ".off", ".stl"),
                         [](const auto& format) { return std::string(format.param + 1); });

}  // namespace
}  // namespace tensortopo::test
