// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is said of a field's persistence does not depend on how its mesh is numbered.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/run_program.hpp"
#include "support/compared.hpp"
#include "support/fields/renumbered_mesh.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// The report with the tetrahedra of a renumbered mesh named as in the mesh given.
Json renamed(const Json& report, const std::vector<TetMesh::Index>& tets) {
  if (!report.is_structured()) return report;
  Json result = report;
  for (auto& [key, value] : result.items()) {
    const bool is_tet = key == "tet" || key == "birth_tet" || key == "death_tet";
    if (is_tet && value.is_number())
      value = tets[value.get<std::size_t>()];
    else if (key == "tets")
      for (Json& tet : value) tet = tets[tet.get<std::size_t>()];
    else
      value = renamed(value, tets);
  }
  return result;
}

/// A file of a bundled field with other numbers.
/// @return of each of its tetrahedra the number in the bundled mesh
std::vector<TetMesh::Index> write_renumbered(const std::string& name, const std::string& file) {
  Random random(5);
  const RenumberedMesh other = renumbered_mesh(read_mesh(field(name)).mesh, random);
  write_mesh(other.mesh, file);
  return other.tets;
}

class Renumbered : public testing::TestWithParam<const char*> {};

TEST_P(Renumbered, FieldsHaveTheSamePersistence) {
  const Folder folder;
  const auto tets = write_renumbered("s2_pushpull", folder / "other.vtu");
  const std::string option = GetParam();
  const auto report_of = [&](const std::string& input) {
    const Outcome run = run_program({"analyze", input, option, "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    Json report = Json::parse(run.out, nullptr, false);
    for (const char* key : {"input", "options", "seconds"}) report.erase(key);
    return report;
  };
  const Json expected = report_of(field("s2_pushpull")),
             found = renamed(report_of(folder / "other.vtu"), tets);
  Compared compared("keys of the report", 5);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [key, value] : expected.items()) {
    EXPECT_EQ(found.at(key), value) << key;
    ++compared;
  }
}

INSTANTIATE_TEST_SUITE_P(Reports, Renumbered, testing::Values("--persistence", "--graph"),
                         [](const auto& of) { return std::string(of.param).substr(2); });

TEST(RenumberedSurface, KeepsTheSameComponents) {
  const Folder folder;
  write_renumbered("s1_compress_off", folder / "other.vtu");
  const auto filter_of = [&](const std::string& input) {
    const Outcome run = run_program({"extract", input, "-o", folder / "s.vtp", "--mode=-9/10",
                                     "--min-persistence", "0.05", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    return Json::parse(run.out, nullptr, false).at("surfaces").at(0).at("filter");
  };
  const Json expected = filter_of(field("s1_compress_off"));
  EXPECT_EQ(filter_of(folder / "other.vtu"), expected) << expected;
  EXPECT_GT(expected.at("left_out"), 0);
}

}  // namespace
}  // namespace tensortopo::test
