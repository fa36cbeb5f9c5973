// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What a person expects of a command line: help, suggestions, silence, provenance.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program/output/progress_bar.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CommandLine, AWordNearlyRightIsSuggested) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"extract", "a.vtu", "-o", "b.vtp", "--mod", "0.5"}, "did you mean --mode?"},
      {{"extract", "a.vtu", "-o", "b.vtp", "--generalised"}, "did you mean --generalized?"},
      {{"extract", "a.vtu", "--otuput=b.vtp", "--mode", "0"}, "did you mean --output?"},
      {{"extrcat", "a.vtu"}, "did you mean extract?"},
      {{"--hlp"}, "did you mean --help?"},
      {{"help", "convention"}, "did you mean conventions?"}};
  for (const auto& [words, suggestion] : cases) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 2) << words[0];
    EXPECT_TRUE(contains(run.err, suggestion)) << run.err;
  }
  const Outcome far = run_program({"extract", "a.vtu", "-o", "b.vtp", "--xyzzy"});
  EXPECT_EQ(far.status, 2);
  EXPECT_TRUE(contains(far.err, "no option '--xyzzy'")) << far.err;
  EXPECT_FALSE(contains(far.err, "did you mean")) << far.err;
}

TEST(CommandLine, AValueThatBeginsWithAMinusIsNoOption) {
  const Outcome run = run_program({"extract", "/dev/null/a.vtu", "-o", "b.vtp", "--mode", "-0.5"});
  EXPECT_EQ(run.status, 3) << run.err;
}

TEST(CommandLine, HelpSaysExitStatusesAndNoListsOfExcludedOptions) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--help"}, {"extract", "--help"}, {"help", "extract"}}) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(contains(run.out, "Exit status: 0 done; 1 ")) << run.out;
    EXPECT_TRUE(contains(run.out, "tensortopo help conventions")) << run.out;
    EXPECT_FALSE(contains(run.out, "Excludes:")) << run.out;
  }
  EXPECT_EQ(run_program({"help", "extract"}).out, run_program({"extract", "--help"}).out);
}

TEST(CommandLine, HelpHasTheConventions) {
  const Outcome run = run_program({"help", "conventions"});
  EXPECT_EQ(run.status, 0);
  for (const char* part : {"3 sqrt(6) det(D) / |D|^3", "sqrt(3/2)", "xx yy zz xy yz xz", "gamma_xy"})
    EXPECT_TRUE(contains(run.out, part)) << part;
}

TEST(CommandLine, CompletionAndManualPageKnowEveryOption) {
  const std::string help = run_program({"extract", "--help"}).out,
                    completion = run_program({"help", "completion"}).out,
                    page = run_program({"help", "man"}).out;
  EXPECT_EQ(page.rfind(".TH TENSORTOPO 1", 0), 0u);
  std::istringstream lines(help);
  int options = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find("--");
    if (at > 5) continue;
    const std::string name = line.substr(at, line.find_first_of(" :=", at) - at);
    ++options;
    EXPECT_TRUE(contains(completion, name + ' ') || contains(completion, name + '\'')) << name;
    std::string escaped;
    for (const char c : name) escaped += c == '-' ? "\\-" : std::string(1, c);
    EXPECT_TRUE(contains(page, escaped)) << name;
  }
  EXPECT_GT(options, 15);
}

TEST(CommandLine, QuietWithAFileAsResultIsSilent) {
  const Folder folder;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"generate", "linear", "-o", folder / "g.vtu"},
        {"extract", folder / "g.vtu", "-o", folder / "s.vtp", "--mode", "0.5"},
        {"extract", folder / "g.vtu", "-o", folder / "i.vtp", "--invariant", "magnitude", "--value",
         "1"},
        {"render", folder / "g.vtu", "-o", folder / "p.png", "--size", "32x32"}}) {
    auto quiet = words;
    quiet.push_back("--quiet");
    const Outcome run = run_program(quiet);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "") << words[0];
    EXPECT_NE(run_program(words).out, "") << words[0];
    quiet.push_back("--json");
    EXPECT_TRUE(nlohmann::json::parse(run_program(quiet).out).is_object());
  }
}

TEST(CommandLine, ReportsSayWhatMadeThem) {
  const Folder folder;
  const std::string g = folder / "g.vtu";
  const Outcome run = run_program({"generate", "linear", "-o", g, "--seed", "5", "--mode", "0",
                                   "--mode", "1/2", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["schema"]["name"], "generate");
  EXPECT_TRUE(json["schema"]["number"].is_number_integer());
  EXPECT_TRUE(contains(run_program({"--version"}).out,
                       "tensortopo " + json["version"].get<std::string>() + "\n"));
  const nlohmann::json options{{"KIND", "linear"}, {"output", g},         {"seed", "5"},
                               {"mode", {"0", "1/2"}}};
  EXPECT_EQ(json["options"], options);
}

TEST(CommandLine, ALongRestIsEstimated) {
  EXPECT_EQ(TimeLeft().after(0.5, 1), "");
  EXPECT_EQ(TimeLeft().after(0.001, 100), "");
  EXPECT_EQ(TimeLeft().after(0.5, 40), " (40 s left)");
  EXPECT_EQ(TimeLeft().after(0.25, 300), " (15 min left)");
  EXPECT_EQ(TimeLeft().after(0.1, 3600), " (9 h left)");
}

/// By the pace at which it goes now: here each round fills half of what is left, and takes four times
/// as long as the one before.
TEST(CommandLine, TheRestIsEstimatedByThePresentPace) {
  TimeLeft even, slower;
  for (double second = 1; second < 90; ++second) even.after(second / 100, second);
  EXPECT_EQ(even.after(0.9, 90), " (10 s left)");
  double seconds = 0, length = 1, left = 1;
  std::string said;
  for (int round = 0; round < 4; ++round, length *= 4, left /= 2)
    for (double share = 0; share < 1; share += 1 / (2 * length))
      said = slower.after(1 - left + left / 2 * share, seconds += 0.5);
  EXPECT_EQ(seconds, 85);
  ASSERT_TRUE(said.starts_with(" (") && said.ends_with(" s left)")) << said;
  EXPECT_NEAR(std::stod(said.substr(2)), 64, 2);  // and 6 at the pace of all rounds
}

TEST(CommandLine, NoRestIsEstimatedWhereHardlyAnythingGoesOn) {
  TimeLeft stuck;
  std::string said;
  for (double second = 1; second < 300; ++second)
    said = stuck.after(second < 10 ? second / 20 : 0.5 + 1e-15 * second, second);
  EXPECT_EQ(said, "");
  stuck.after(0.52, 300);
  EXPECT_NE(stuck.after(0.55, 310), "");
}

TEST(CommandLine, WhatIsNotInThePictureIsSaid) {
  const Folder folder;
  const std::string p = folder / "p.png", mesh = field("s4_slab");
  const auto notes = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"render", mesh, "-o", p, "--size", "64x48"});
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.err;
  };
  EXPECT_TRUE(contains(notes({}), "only the mesh's outline"));
  EXPECT_TRUE(contains(notes({"--mode", "0.5", "--focus=-1000,0,0", "--zoom", "100"}),
                       "nothing of the surface is in view"));
  EXPECT_EQ(notes({"--mode", "0.5"}), "");
}

TEST(CommandLine, AnyTetrahedronIsOneThatTheSurfaceMeets) {
  const Folder folder;
  const Outcome run = run_program({"render", field("s4_slab"), "-o", folder / "p.png", "--size",
                                   "64x48", "--mode", "0.5", "--tet", "any"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "--tet any: tetrahedron ")) << run.err;
  EXPECT_FALSE(contains(run.err, "misses tetrahedron")) << run.err;
  EXPECT_EQ(run_program({"render", field("s4_slab"), "-o", folder / "p.png", "--mode", "0.5",
                         "--tet", "some"})
                .status,
            2);
}

// Around each of many tetrahedra of their own the boundary has twelve creases and more.
TEST(CommandLine, ABoundaryOfManyCreasesIsDrawnAsABox) {
  const Folder folder;
  const std::string file = folder / "torn.vtk";
  constexpr int kCount = 1000;
  std::ofstream out(file);
  out << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << 4 * kCount
      << " double\n";
  for (int i = 0; i < kCount; ++i)
    out << 2 * i << " 0 0 " << 2 * i + 1 << " 0 0 " << 2 * i << " 1 0 " << 2 * i << " 0 1\n";
  out << "CELLS " << kCount << ' ' << 5 * kCount << '\n';
  for (int i = 0; i < kCount; ++i)
    out << "4 " << 4 * i << ' ' << 4 * i + 1 << ' ' << 4 * i + 2 << ' ' << 4 * i + 3 << '\n';
  out << "CELL_TYPES " << kCount << '\n';
  for (int i = 0; i < kCount; ++i) out << "10\n";
  out << "POINT_DATA " << 4 * kCount << "\nTENSORS stress double\n";
  for (int i = 0; i < 4 * kCount; ++i) out << i % 4 << " 0 0 0 1 0 0 0 -1\n";
  out.close();
  const Outcome run = run_program({"render", file, "-o", folder / "p.png", "--size", "64x48"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "bounding box is drawn instead")) << run.err;
}

TEST(CommandLine, WhatALargeFieldLacksIsSaid) {
  const Folder folder;
  const std::string g = folder / "g.vtu";
  const Outcome large =
      run_program({"generate", "kelvin", "-o", g, "--tets", "10001", "--mode", "0.9"});
  EXPECT_EQ(large.status, 0) << large.err;
  EXPECT_TRUE(contains(large.err, "no reference surface")) << large.err;
  EXPECT_EQ(run_program({"generate", "linear", "-o", g}).err, "");
}

// Of independent tensors at all vertices, noise.
TEST(CommandLine, ASurfaceThatIsNearlyEverywhereIsRemarkedOn) {
  const Folder folder;
  const std::string g = folder / "g.vtu";
  ASSERT_EQ(run_program({"generate", "rough", "-o", g, "--field-only", "--tets", "1100"}).status, 0);
  const Outcome run = run_program({"extract", g, "-o", folder / "s.vtp", "--mode", "0"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "% of the tetrahedra: the field is noise")) << run.err;
}

TEST(CommandLine, TheShareWithinADistanceIsSaid) {
  const Folder folder;
  const Outcome run = run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode",
                                   "0.5", "--max-error", "5", "--json"});
  ASSERT_TRUE(run.status == 0 || run.status == 1) << run.err;
  const auto surface = nlohmann::json::parse(run.out)["surfaces"][0];
  EXPECT_EQ(run.status == 1, surface["tets_farther"] > 0);
  EXPECT_GT(surface["area_within"], 0.9);
  EXPECT_LE(surface["area_within"], 1);
  EXPECT_EQ(run.status == 1, contains(run.err, "% of the area is within it")) << run.err;
}

}  // namespace
}  // namespace tensortopo::test
