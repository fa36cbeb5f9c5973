// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What reading repaired or skipped is said by whatever reads a mesh.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

/// Two tetrahedra, the first with its vertices in the wrong order, and a triangle.
std::string turned_mesh(const Folder& folder) {
  const std::string file = folder / "turned.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
two tetrahedra and a triangle
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1
CELLS 3 14
4 1 0 2 3
4 1 2 3 4
3 0 1 2
CELL_TYPES 3
10 10 5
POINT_DATA 5
TENSORS6 stress double
3 -1 -2 0.5 0 0.25
1 -1 0.5 2 3 0
0 1 -2 1 2 4
5 -3 -2 0 2 1
-1 2 -3 2 4 1
)";
  return file;
}

TEST(ReadingNotes, AreSaidByAllThatReadAMesh) {
  const Folder folder;
  const std::string mesh = turned_mesh(folder), surface = folder / "s.vtp";
  const std::vector<std::vector<std::string>> commands{
      {"extract", mesh, "-o", surface, "--mode", "0.2"},
      {"extract", mesh, "-o", folder / "m.vtp", "--invariant", "magnitude", "--value", "4"},
      {"render", mesh, "--mode", "0.2", "--size", "32x32", "-o", folder / "r.png"},
      {"render", surface, "--mesh", mesh, "--size", "32x32", "-o", folder / "r.png"},
      {"render", mesh, "--tet", "1", "--mode", "0.2", "--size", "32x32", "-o", folder / "r.png"},
      {"analyze", mesh, "--sweep", "0.1:0.2:2"},
      {"analyze", surface, "--mesh", mesh},
      {"bench", "--input", mesh, "--mode", "0.2", "--only", "none"},
      {"bench", "--input", mesh, "--mode", "0.2", "--scaling", "modes"},
      {"conformance", "--surface", surface, "--input", mesh, "--mode", "0.2"},
      {"verify", "--input", mesh, "--theorem", "mode-range", "--fields", "1"}};
  const std::string begin = "tensortopo: " + mesh + ": ";
  const std::string components =
      begin + "components of `stress`: XX YY ZZ XY YZ XZ (vtk, assumed)\n";
  const std::string repairs = begin + "1 cell of dimension below 3 skipped\n" + begin +
                              "1 tetrahedron of negative volume turned around\n";
  for (auto words : commands) {
    const Outcome run = run_program(words);
    // The reports of extractions have a place for the components; of the mesh around a surface
    // only the outline is drawn, and no tensors are read.
    const bool reports = words[0] == "extract",
               is_outline = words[0] == "render" && words[1] == surface;
    EXPECT_EQ(reports, run.out.find("XX YY ZZ XY YZ XZ (vtk, assumed)") != std::string::npos);
    const std::string notes = (reports || is_outline ? "" : components) + repairs;
    EXPECT_EQ(run.err.substr(0, notes.size()), notes) << words[0] << ' ' << run.err;
    words.push_back("--quiet");
    EXPECT_EQ(run_program(words).err.find("turned around"), std::string::npos) << words[0];
  }
}

// Also by the checker, which skips the triangle: it has no volume, so nothing of the field is left
// out.
TEST(ReadingNotes, AreCountedInTheVerdictOfACheck) {
  const Folder folder;
  const std::string mesh = turned_mesh(folder), surface = folder / "s.vtp",
                    certificate = folder / "s.json";
  const Outcome extract = run_program(
      {"extract", mesh, "-o", surface, "--mode", "0.2", "--certify", certificate, "--quiet"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  const std::vector<std::string> words{"check", mesh, surface, certificate, "--expect-complete"};
  const Outcome text = run_program(words);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("1 cell of two dimensions or fewer skipped"), std::string::npos)
      << text.out;
  auto with_json = words;
  with_json.push_back("--json");
  const auto input = nlohmann::json::parse(run_program(with_json).out).at("input");
  EXPECT_EQ(input.at("flat_cells"), 1);
  EXPECT_EQ(input.at("other_cells"), 0);
}

}  // namespace
}  // namespace tensortopo::test
