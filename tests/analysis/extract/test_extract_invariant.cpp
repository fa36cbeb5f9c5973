// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/analysis/invariant_command.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

TEST(ExtractInvariant, SurfacesOfARealFieldAreManifoldAndComplete) {
  const Folder folder;
  for (const char* invariant : {"magnitude", "deviator-magnitude", "anisotropy"}) {
    // Of the order of what the fields hold.
    std::vector<std::string> words{"--invariant", invariant, "--json"};
    const bool is_ratio = std::string(invariant) == "anisotropy";
    for (const char* value : {is_ratio ? "0.7" : "0.25", is_ratio ? "9/10" : "1/2"})
      words.insert(words.end(), {"--value", value});
    const Outcome run = extract_slab(folder, words);
    ASSERT_EQ(run.status, 0) << run.err;
    const Json report = Json::parse(run.out);
    ASSERT_EQ(report["surfaces"].size(), 2u);
    EXPECT_TRUE(report["unresolved"].empty());
    EXPECT_EQ(report["surfaces"][1]["value_exact"], is_ratio ? "9/10" : "1/2");
    for (const auto& surface : report["surfaces"]) {
      EXPECT_EQ(surface["invariant"], invariant);
      EXPECT_TRUE(surface["manifold"]);
      EXPECT_TRUE(surface["orientable"]);
      EXPECT_GT(surface["triangles"], 0) << surface["value"];
      EXPECT_LT(surface["max_abs_residual"], 1e-11);
    }
  }
}

TEST(ExtractInvariant, WritesTheSameBytesWithAnyNumberOfThreads) {
  const Folder folder;
  const std::vector<std::string> words{"--invariant", "anisotropy", "--value", "0.8"};
  ASSERT_EQ(extract_slab(folder, words).status, 0);
  const std::string first = contents(folder / "s.vtp");
  auto alone = words;
  alone.insert(alone.end(), {"--threads", "1"});
  ASSERT_EQ(extract_slab(folder, alone).status, 0);
  EXPECT_EQ(contents(folder / "s.vtp"), first);
}

TEST(ExtractInvariant, NamesZeroTensorsAndIsStrictAboutThem) {
  const Folder folder;
  auto mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  mesh.tensors[13] = {};
  write_mesh(mesh, folder / "m.vtu");
  const std::vector<std::string> words{"extract",     folder / "m.vtu", "-o",      folder / "s.vtp",
                                       "--invariant", "anisotropy",     "--value", "0.9",
                                       "--json"};
  auto strict = words;
  strict.emplace_back("--strict");
  const Outcome refused = run_program(strict);
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"m.vtu"});
  const Outcome run = run_program(words);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("zero_tensor"), std::string::npos) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_GT(report["unresolved"]["zero_tensor"], 0);
  EXPECT_EQ(report["unresolved_cells"].size(), report["unresolved"]["zero_tensor"]);
}

TEST(ExtractInvariant, BadUsageIsTwoAndLeavesNoFile) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--invariant", "magnitude"}, "--value"},
      {{"--invariant", "trace", "--value", "1"}, "--invariant"},
      {{"--value", "1", "--mode", "0"}, "--invariant"},
      {{"--invariant", "magnitude", "--value", "1", "--mode", "0"}, "--mode"},
      {{"--invariant", "magnitude", "--value", "1", "--resolution", "8"}, "--resolution"},
      {{"--invariant", "magnitude", "--value", "1", "--max-error", "8"}, "--max-error"},
      {{"--invariant", "magnitude", "--value", "1", "--certify", "c.json", "--cell-to-point"},
       "--certify"},
      {{"--invariant", "magnitude", "--value", "0"}, "--value 0"},
      {{"--invariant", "magnitude", "--value", "-1"}, "--value -1"},
      {{"--invariant", "anisotropy", "--value", "1"}, "--value 1"},
      {{"--invariant", "anisotropy", "--value", "x"}, "--value x"},
      {{"--invariant", "anisotropy", "--value", "0.5", "--edge-parts", "0"}, "--edge-parts"},
  };
  for (const auto& [words, about] : cases) {
    const Folder folder;
    const Outcome run = extract_slab(folder, words);
    EXPECT_EQ(run.status, 2) << about << run.err;
    EXPECT_NE(run.err.find(about), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(folder.files().empty());
  }
}

}  // namespace
}  // namespace tensortopo::test
