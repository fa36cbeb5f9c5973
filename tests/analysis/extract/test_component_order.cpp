// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// One tetrahedron and its tensors, components in VTK's or in Abaqus' order, named or not.
std::string ordered_field(const Folder& folder, const std::string& name, bool abaqus,
                  const std::string& names) {
  const std::vector<std::array<int, 6>> tensors{// XX YY ZZ XY YZ XZ
                                                {3, -1, -2, 5, 0, 2},
                                                {1, -1, 5, 2, 3, 0},
                                                {0, 1, -2, 1, 2, 4},
                                                {5, -3, -2, 0, 2, 7}};
  const std::string path = folder / name;
  std::ofstream file(path);
  file << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
          "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
          "FIELD data 1\nstress 6 4 double\n";
  for (const auto& t : tensors)
    for (const std::size_t i : abaqus ? std::array<std::size_t, 6>{0, 1, 2, 3, 5, 4}
                                      : std::array<std::size_t, 6>{0, 1, 2, 3, 4, 5})
      file << t[i] << ' ';
  if (!names.empty()) file << "\nMETADATA\nCOMPONENT_NAMES\n" << names << "\n";
  return path;
}

TEST(ComponentOrder, NamesInTheFileAreObeyedReportedAndCertified) {
  const Folder folder;
  const std::string s = folder / "s.vtp", c = folder / "c.json";
  struct Case {
    std::string file;
    std::vector<std::string> options;
    std::string order, why;
  };
  const std::vector<Case> cases{
      {ordered_field(folder, "v.vtk", false, ""), {}, "vtk", "assumed"},
      {ordered_field(folder, "a.vtk", true, ""), {"--components", "mrtrix"}, "abaqus", "as given"},
      {ordered_field(folder, "n.vtk", true, "S11\nS22\nS33\nS12\nS13\nS23\n"),
       {},
       "abaqus",
       "named in the file"},
      {ordered_field(folder, "x.vtk", true, "SXX\nSYY\nSZZ\nSXY\nSXZ\nSYZ\n"),
       {},
       "abaqus",
       "named in the file"}};
  std::vector<Json> surfaces;
  for (const Case& one : cases) {
    std::vector<std::string> words{"extract", one.file, "-o", s, "--mode", "1/4", "--certify", c};
    words.insert(words.end(), one.options.begin(), one.options.end());
    EXPECT_NE(run_program(words).out.find("(" + one.order + ", " + one.why + ")"),
              std::string::npos);
    words.push_back("--json");
    const Outcome run = run_program(words);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["input"]["components"], one.order);
    surfaces.push_back(json["surfaces"]);
    EXPECT_EQ(surfaces.back(), surfaces.front()) << one.file;
    std::ifstream certificate(c);
    EXPECT_EQ(Json::parse(certificate)["input"]["components"], one.order);
    EXPECT_EQ(run_program({"check", one.file, s, c}).status, 0);
  }
  EXPECT_GT(surfaces.front()[0]["triangles"].get<int>(), 0);
  for (const auto& words : {std::vector<std::string>{"extract", cases[2].file, "-o", s, "--mode",
                                                     "1/4", "--components", "vtk"}}) {
    const Outcome run = run_program(words);
    EXPECT_NE(run.err.find("contradicts"), std::string::npos) << run.err;
    EXPECT_EQ(run.status, 2);
  }
}

}  // namespace
}  // namespace tensortopo::test
