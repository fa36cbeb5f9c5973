// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Options that make no sense are refused, by name.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(Usage, OptionsWithoutEffectAreRefused) {
  const std::vector<std::vector<std::string>> cases{
      {"--improve", "--mode", "1"},
      {"--improve", "--invariant", "magnitude", "--value", "1"},
      {"--improve", "--mode", "0.5", "--method", "marching"},
      {"--method", "--mode", "1", "--method", "manifold"},
      {"--max-error", "--mode", "-1", "--max-error", "0.1"},
      {"--max-error", "--mode", "0.5", "--mode", "1", "--max-error", "0.1"},
      {"--patch-samples", "--mode", "0.5", "--patch-samples", "3"},
      {"--flatness", "--mode", "0.5", "--flatness", "0.1"},
      {"--resolution", "--mode", "0.5", "--method", "marching", "--resolution", "8"},
      {"--resolution", "--mode", "0.5", "--method", "vtk-contour-grid", "--resolution", "8"},
      {"--subdivide", "--mode", "0.5", "--subdivide", "1"},
      {"--certify", "--mode", "0.5", "--method", "vtk-contour-grid", "--certify", "c.json"},
      {"--all-samples", "--mode", "1", "--all-samples"},
      {"--pieces", "--mode", "0.5", "--method", "marching", "--pieces", "2"},
      {"--pieces", "--mode", "0.5", "--max-error", "0.1", "--pieces", "2"},
      {"--memory", "--mode", "1", "--memory", "8G"},
      {"--memory", "--mode", "0.5", "--memory", "8G", "--pieces", "2"},
      {"--memory", "--mode", "0.5", "--memory", "8G", "--improve"},
      {"--all-samples", "--mode", "0.5", "--method", "marching", "--all-samples"},
      {"--all-samples", "--invariant", "magnitude", "--value", "1", "--all-samples"},
      {"--resolution", "--mode", "0.5", "--resolution", "1e9"}};
  for (auto words : cases) {
    const Folder folder;
    const std::string about = words[0];
    if (about != "--improve") words.erase(words.begin());
    words.insert(words.begin(), {"extract", field("s4_slab"), "-o", folder / "s.vtp"});
    expect_line(run_program(words), 2, about);
    EXPECT_TRUE(folder.files().empty());
  }
}

// As a script writes them whose variable is not set.
TEST(Usage, EmptyTextsAreNoValues) {
  const Folder folder;
  const std::string in = field("s4_slab"), out = folder / "s.vtp";
  for (const std::string option : {"--certify", "--where", "--tensor", "--mask", "--materials",
                                   "--uncertainty", "--mode", "--threads"})
    expect_line(run_program({"extract", in, "-o", out, "--mode", "0.5", option, ""}), 2, option);
  expect_line(run_program({"extract", in, "-o", "", "--mode", "0.5"}), 2, "--output");
  expect_line(run_program({"extract", "", "-o", out, "--mode", "0.5"}), 2, "INPUT");
  expect_line(run_program({"analyze", in, "--persistence", "-o", ""}), 2, "--output");
  expect_line(run_program({"check", in, "", out}), 2, "OUTPUT");
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, OptionsOfAnotherTaskAreRefused) {
  const Folder folder;
  const std::string in = field("s4_slab"), s = folder / "s.vtp", g = folder / "g.vtu";
  ASSERT_EQ(run_program({"extract", in, "-o", s, "--mode", "0.5", "--method", "marching"}).status,
            0);
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"--levels", {"analyze", s, "--levels", "3"}},
      {"--tensor", {"analyze", s, "--tensor", "a"}},
      {"--symmetrize", {"render", s, "-o", folder / "p.png", "--symmetrize"}},
      {"--components", {"verify", "--components", "voigt"}},
      {"--mode", {"conformance", "--suite", "l.json", "--mode", "0"}},
      {"--tensor", {"conformance", "--suite", "l.json", "--tensor", "a"}},
      {"--largest", {"bench", "--input", in, "--mode", "0", "--largest", "10000"}},
      {"--input", {"bench", "--scaling", "size", "--input", in, "--mode", "0"}},
      {"--only", {"bench", "--scaling", "mode", "--input", in, "--only", "none"}},
      {".png", {"bench", "--input", in, "--mode", "0", "--curves", folder / "c.jpg"}},
      {"--field-only", {"generate", "linear", "-o", g, "--field-only", "--mode", "0"}},
      {"--no-reference", {"generate", "linear", "-o", g, "--field-only", "--no-reference"}},
      {"--reference", {"generate", "linear", "-o", g, "--reference", "--no-reference"}}};
  for (const auto& [about, words] : cases) expect_line(run_program(words), 2, about);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"s.vtp"});
}

TEST(Usage, WhatIsNotANumberIsBadUsage) {
  const Folder folder;
  const std::string in = field("s4_slab"), s = folder / "s.vtp";
  for (const char* bad : {"nan", "-nan", "inf", "-1", "x", ""}) {
    expect_line(run_program({"extract", in, "-o", s, "--mode", "0.5", "--max-error", bad}), 2,
                "--max-error");
    expect_line(run_program({"extract", in, "-o", s, "--mode", "0", "--method", "hybrid",
                             "--flatness", bad}),
                2, "--flatness");
    for (const std::string option : {"--merge", "--resolution"})
      expect_line(
          run_program({"conformance", "--surface", s, "--input", in, "--mode", "0.5", option, bad}),
          2, option);
  }
  EXPECT_TRUE(folder.files().empty());
}

/// Doubles round them to 1 or -1, where there are curves and no surfaces.
TEST(Usage, ModesThatDoublesDoNotTellFromOneAreRefused) {
  const Folder folder;
  const std::string in = field("s4_slab"), s = folder / "s.vtp", g = folder / "g.vtu";
  for (const std::string mode : {"0.99999999999999999", "-0.99999999999999999999"}) {
    expect_line(run_program({"extract", in, "-o", s, "--mode", mode}), 2, mode);
    expect_line(run_program({"render", in, "-o", folder / "p.png", "--mode", mode}), 2, mode);
    expect_line(
        run_program({"render", in, "-o", folder / "p.png", "--animate", "0:" + mode + ":2"}), 2,
        mode);
    expect_line(run_program({"generate", "linear", "-o", g, "--mode", mode}), 2, mode);
    expect_line(run_program({"bench", "--input", in, "--mode", mode}), 2, mode);
    expect_line(run_program({"conformance", "--surface", s, "--input", in, "--mode", mode}), 2,
                mode);
    expect_line(run_program({"analyze", in, "--sweep", "0:" + mode + ":2"}), 2, mode);
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, SeedsAreWholeNumbers) {
  const Folder folder;
  for (const char* seed : {"-3", "18446744073709551616", "1.5", "0x1"}) {
    expect_line(run_program({"generate", "linear", "-o", folder / "g.vtu", "--seed", seed}), 2,
                "--seed");
    expect_line(run_program({"verify", "--fields", "1", "--seed", seed}), 2, "--seed");
  }
  expect_line(run_program({"generate", "linear", "-o", folder / "g.vtu", "--tets", "5"}), 2,
              "--tets");
  EXPECT_TRUE(folder.files().empty());
  EXPECT_EQ(run_program({"generate", "linear", "-o", folder / "g.vtu", "--field-only", "--seed",
                         "18446744073709551615"})
                .status,
            0);
}

}  // namespace
}  // namespace tensortopo::test
