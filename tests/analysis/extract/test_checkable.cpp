// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Certificates are made only of files that the checker reads as the program does: what it reads
// otherwise, or not at all, is refused, and nothing is written.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

const std::string kGrid =
    "# vtk DataFile Version 5.1\na field\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
    "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n"
    "0 1 2 3\nCELL_TYPES 1\n10\n";
const std::string kData =
    "POINT_DATA 4\nTENSORS6 stress double\n1 2 3 4 5 6 6 5 4 3 2 1 1 0 0 0 0 1 0 0 1 1 0 0\n";

/// The error; nothing if a certificate was made.
std::string refusal(const std::string& field, const std::vector<std::string>& level) {
  const Folder folder;
  std::vector<std::string> words{"extract", field, "-o", folder / "s.vtp", "--certify",
                                 folder / "s.json"};
  words.insert(words.end(), level.begin(), level.end());
  const Outcome run = run_program(words);
  EXPECT_EQ(std::filesystem::exists(folder / "s.vtp"), run.status == 0) << field;
  EXPECT_EQ(std::filesystem::exists(folder / "s.json"), run.status == 0) << field;
  return run.status == 0 ? "" : run.err;
}

TEST(Checkable, IsWhatTheCheckerReadsAsTheProgramDoes) {
  if (run_program({"check", "none.vtu", "none.vtp", "none.json"}).err.find("built without") !=
      std::string::npos)
    GTEST_SKIP();
  const Folder folder;
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    return std::string(folder / name);
  };
  const std::filesystem::path formats = std::filesystem::path(TENSORTOPO_DATA) / ".." / "formats";
  const std::vector<std::string> mode{"--mode", "1/2"};
  EXPECT_EQ(refusal(put("plain.vtk", kGrid + kData), mode), "");
  const std::string bits = "FIELD f 1\nbits 1 4 bit\n0 1 1 0\n";
  const std::string ghosts = "CELL_DATA 1\nSCALARS vtkGhostType unsigned_char\n"
                             "LOOKUP_TABLE default\n0\n";
  std::size_t refused = 0;
  for (const auto& [file, what] : std::vector<std::pair<std::string, std::string>>{
           {put("bits.vtk", kGrid + kData + bits), "bit"},
           {put("ghosts.vtk", kGrid + ghosts + kData), "ghost"},
           {(formats / "plate.frd").string(), "neither a .vtu nor a .vtk"}})
    for (const std::vector<std::string>& level :
         {mode, {"--mode", "1"}, {"--invariant", "magnitude", "--value", "1"}}) {
      const std::string text = refusal(file, level);
      EXPECT_NE(text.find(what), std::string::npos) << text;
      EXPECT_NE(text.find("tensortopo convert"), std::string::npos) << text;
      ++refused;
    }
  EXPECT_EQ(refused, 9u);
}

TEST(Checkable, FilesThatAreNoneAreNamed) {
  const Folder folder;
  const std::string field = folder / "f.vtk", surface = folder / "s.vtp", file = folder / "c.json",
                    none = folder / "none.vtu", place = std::filesystem::path(surface).parent_path();
  std::ofstream(field, std::ios::binary) << kGrid << kData;
  ASSERT_EQ(run_program({"extract", field, "-o", surface, "--mode", "1/2", "--certify", file}).status, 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", none, surface, file}, {"check", field, none, file},
        {"check", field, surface, none}, {"check", place, surface, file}, {"check", field, place, file}}) {
    const Outcome run = run_program(words);
    if (run.err.find("built without") != std::string::npos) GTEST_SKIP();
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_EQ(run.err.find("internal error"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace tensortopo::test
