// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "tensortopo/io/read_surface_file.hpp"

namespace tensortopo::test {
namespace {

std::string surface_in(const Folder& folder) {
  const std::string surface = folder / "surface.vtp";
  const Outcome run = run_program(
      {"extract", field("s4_slab"), "-o", surface, "--mode", "0.9", "--resolution", "1"});
  EXPECT_EQ(run.status, 0) << run.err;
  return surface;
}

// What an analysis writes says which field it is of, and by which options.
TEST(OutputOrigin, IsInAllFilesThatAnalyzeWrites) {
  const Folder folder;
  const std::string surface = surface_in(folder), input = field("s4_slab");
  const auto texts_of = [&](std::vector<std::string> words, const std::string& file) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return read_surface_file(file).texts;
  };
  const auto wanted = texts_of({"analyze", surface, "--json"}, surface);
  const std::string pairs = folder / "pairs.vtp", tree = folder / "tree.vtp",
                    ridges = folder / "ridges.vtp", curved = folder / "curved.vtp";
  const std::map<std::string, std::vector<std::string>> runs{
      {pairs, {"analyze", input, "--persistence", "-o", pairs}},
      {tree, {"analyze", input, "--graph", "-o", tree}},
      {ridges, {"analyze", surface, "--mesh", input, "--ridges", ridges}},
      {curved, {"analyze", surface, "--mesh", input, "-o", curved}}};
  for (const auto& [file, words] : runs) {
    const auto texts = texts_of(words, file);
    for (const std::string name : {"tensortopo_version", "input_sha256", "tensor", "components"})
      EXPECT_EQ(texts.at(name), wanted.at(name)) << file << ": " << name;
  }
  EXPECT_EQ(read_surface_file(pairs).texts.at("options"), "--persistence");
  EXPECT_EQ(read_surface_file(tree).texts.at("options"), "--graph");
  // The surface with its curvature is still the one that was extracted by these options.
  EXPECT_EQ(read_surface_file(curved).texts, wanted);
}

TEST(OutputOrigin, ArraysKeepTheirTypesAndMarks) {
  const Folder folder;
  const std::string surface = surface_in(folder), curved = folder / "curved.vtp";
  const Outcome run = run_program({"analyze", surface, "--mesh", field("s4_slab"), "-o", curved});
  ASSERT_EQ(run.status, 0) << run.err;
  const SurfaceFile before = read_surface_file(surface), after = read_surface_file(curved);
  EXPECT_EQ(after.scalars, "mode");
  EXPECT_EQ(after.normals, "normal");
  EXPECT_EQ(after.scalars, before.scalars);
  EXPECT_EQ(after.normals, before.normals);
  for (const std::string name : {"tet", "component"}) {
    const SurfaceArray *one = before.find_cell_data(name), *other = after.find_cell_data(name);
    ASSERT_TRUE(one != nullptr && other != nullptr) << name;
    EXPECT_TRUE(one->is_integer && other->is_integer) << name;
    EXPECT_EQ(one->values, other->values) << name;
  }
  EXPECT_FALSE(after.find_point_data("mode")->is_integer);
}

}  // namespace
}  // namespace tensortopo::test
