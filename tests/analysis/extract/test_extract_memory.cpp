// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A limit of the memory chooses the number of pieces, and changes no byte of the result.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/run_program.hpp"
#include "extract/memory_plan.hpp"
#include "program/options/memory_option.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// In a process of its own, so that this one stays small: a child's ru_maxrss is at least what its
/// parent held when it was made.
void write_smooth_field(const std::string& file, int cubes, double shortest) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    TetMesh mesh = cube_mesh(cubes);
    fill_with_smooth_tensors(mesh, 7, 6, shortest);
    write_mesh(mesh, file);
    _exit(0);
  }
  int state = -1;
  waitpid(child, &state, 0);
  ASSERT_EQ(state, 0);
}

/// Exit status and peak of resident memory, as the operating system counts it for a child.
std::pair<int, std::uint64_t> status_and_peak(std::vector<std::string> words) {
  words.insert(words.begin(), TENSORTOPO_PROGRAM);
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  int state = -1;
  rusage usage{};
  wait4(child, &state, 0, &usage);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -1,
          static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};  // Linux counts in KiB
}

TEST(MemoryOption, TakesBytesAndUnits) {
  EXPECT_EQ(parse_memory("123456"), 123456u);
  EXPECT_EQ(parse_memory("500M"), 500'000'000u);
  EXPECT_EQ(parse_memory("8G"), 8'000'000'000u);
  EXPECT_EQ(parse_memory("2GiB"), std::uint64_t{2} << 30);
  EXPECT_EQ(parse_memory("1.5kB"), 1500u);
  for (const char* wrong : {"", "G", "8 G", "8X", "1.2.3M", "-1G", "0", "0.5", "1e9", "99999999T"})
    EXPECT_THROW(parse_memory(wrong), UsageError) << wrong;
}

TEST(MemoryPlan, TakesTheFewestPiecesThatFit) {
  for (const std::size_t tets : {1'000u, 300'000u, 100'000'000u})
    for (const std::size_t share : {0u, 10u, 40u, 100u}) {
      const MemorySizes sizes{tets, tets / 100 * share, share % 20 == 0};
      const double least = least_memory(sizes);
      EXPECT_FALSE(pieces_within(sizes, static_cast<std::uint64_t>(least) - 1));
      for (const double factor : {1.0, 1.05, 1.5, 3.0}) {
        const auto limit = static_cast<std::uint64_t>(factor * least) + 1;
        const auto pieces = pieces_within(sizes, limit);
        ASSERT_TRUE(pieces);
        EXPECT_LE(estimated_memory(sizes, *pieces), static_cast<double>(limit));
        if (*pieces > 1) {
          EXPECT_GT(estimated_memory(sizes, *pieces - 1), static_cast<double>(limit));
        }
      }
    }
  EXPECT_EQ(pieces_within({1000, 1000}, 1'000'000'000), 1);
}

TEST(ExtractMemory, StaysBelowALimitThatTheWholeExceeds) {
  const Folder folder;
  const std::string input = folder / "f.vtu", whole = folder / "whole.vtp",
                    limited = folder / "limited.vtp";
  write_smooth_field(input, 36, 6);
  const auto [status, peak] =
      status_and_peak({"extract", input, "-o", whole, "--mode", "1/2", "--quiet"});
  ASSERT_EQ(status, 0);
  const std::uint64_t limit = peak / 100 * 98;
  const std::vector<std::string> words{"extract", input, "-o",       limited,
                                       "--mode",  "1/2", "--memory", std::to_string(limit),
                                       "--quiet"};
  // How threads take turns changes the peak by some percent: where that is too much, nothing is
  // written, which may not happen each time.
  auto [again, less] = status_and_peak(words);
  for (int more = 0; again == 2 && more < 2; ++more) {
    EXPECT_FALSE(std::filesystem::exists(limited));
    std::tie(again, less) = status_and_peak(words);
  }
  ASSERT_EQ(again, 0);
  EXPECT_LT(less, limit) << "whole " << peak;
  EXPECT_TRUE(contents(whole) == contents(limited));
}

/// A certificate takes more memory: it is estimated, and measured.
TEST(ExtractMemory, StaysBelowALimitWithACertificateOrWritesNothing) {
  const Folder folder;
  const std::string input = folder / "f.vtu", whole = folder / "whole.vtp",
                    limited = folder / "limited.vtp";
  const std::string all = folder / "whole.json", some = folder / "limited.json";
  write_smooth_field(input, 24, 6);
  const std::vector<std::string> words{"--mode", "1/2", "--quiet", "--certify"};
  std::vector<std::string> at_once{"extract", input, "-o", whole};
  at_once.insert(at_once.end(), words.begin(), words.end());
  at_once.push_back(all);
  const auto [status, peak] = status_and_peak(at_once);
  ASSERT_LE(status, 1);
  for (const std::uint64_t limit : {peak / 100 * 60, peak / 100 * 95, peak * 2}) {
    std::vector<std::string> below{"extract", input, "-o", limited};
    below.insert(below.end(), words.begin(), words.end());
    below.insert(below.end(), {some, "--memory", std::to_string(limit)});
    const auto [again, less] = status_and_peak(below);
    if (limit < peak && again == 2) {
      EXPECT_FALSE(std::filesystem::exists(limited) || std::filesystem::exists(some));
      continue;
    }
    ASSERT_LE(again, 1) << "limit " << limit << ", whole " << peak << ", peak " << less;
    EXPECT_LT(less, limit) << "whole " << peak;
    EXPECT_TRUE(contents(whole) == contents(limited));
    EXPECT_TRUE(contents(all) == contents(some));
    std::filesystem::remove(limited), std::filesystem::remove(some);
  }
  at_once.insert(at_once.end(), {"--memory", "1M"});
  at_once[3] = limited;
  EXPECT_EQ(status_and_peak(at_once).first, 2);
  EXPECT_FALSE(std::filesystem::exists(limited));
}

TEST(ExtractMemory, SaysHowManyPiecesItTook) {
  const Folder folder;
  const Outcome run = extract_slab(folder, {"--mode", "0.5", "--memory", "2GiB", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report.at("pieces"), 1);
  EXPECT_EQ(report.at("memory").at("limit_bytes"), std::uint64_t{2} << 30);
  EXPECT_GT(report.at("memory").at("peak_bytes"), 10'000'000u);
  const Outcome pieces = extract_slab(folder, {"--mode", "0.5", "--pieces", "3", "--json"});
  EXPECT_EQ(Json::parse(pieces.out).at("pieces"), 3);
  EXPECT_FALSE(Json::parse(pieces.out).contains("memory"));
}

TEST(ExtractMemory, IsRefusedWhereNothingFits) {
  for (const char* memory : {"1M", "8X", "G"}) {
    const Folder folder;
    const Outcome run = extract_slab(folder, {"--mode", "0.5", "--memory", memory, "--quiet"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("--memory"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
    EXPECT_TRUE(folder.files().empty());
  }
}

}  // namespace
}  // namespace tensortopo::test
