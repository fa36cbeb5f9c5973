// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Results of CalculiX: the files in the corpus and the example are CalculiX' own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "field_files.hpp"

namespace tensortopo::test {
namespace {

const std::filesystem::path kCorpus = std::filesystem::path(TENSORTOPO_CORPUS) / "frd";
const std::filesystem::path kPlate =
    std::filesystem::path(TENSORTOPO_EXAMPLES) / "formats" / "plate.frd";

std::string text_of(const std::string& name) { return slurp(kCorpus / name); }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

ReadOptions splitting() {
  ReadOptions options;
  options.tetrahedralize = true;
  return options;
}

TEST(ReadFrd, ElementsOfEachTypeFillTheirBoxWithStraightEdges) {
  const struct {
    const char* name;
    double volume;
  } cases[]{{"C3D4_text", 1. / 6},  {"C3D10_binary", 1. / 6}, {"C3D6_text", 1. / 2},
            {"C3D15_binary", 1. / 2}, {"C3D8_binary", 1},       {"C3D20_text", 1}};
  for (const auto& each : cases) {
    const auto read = read_mesh(put(std::string(each.name) + ".frd", text_of(each.name)), splitting());
    EXPECT_NEAR(volume_of(read.mesh), each.volume, 1e-12) << each.name;
    EXPECT_EQ(read.report.curved_edges, 0u) << each.name;
    EXPECT_EQ(read.report.components.source, ComponentSource::named) << each.name;
    EXPECT_EQ(read.report.components.order, ComponentOrder::vtk) << each.name;
  }
}

TEST(ReadFrd, TheLastStepIsTakenAndSaid) {
  const auto read = read_mesh(kPlate);
  EXPECT_EQ(read.report.tensor_name, "STRESS");
  EXPECT_GT(read.report.quadratic_cells, 400u);
  EXPECT_GT(read.report.curved_edges, 0u);
  EXPECT_EQ(read.report.torn_faces.count, 0u);
  std::string notes;
  for (const auto& note : read.report.notes) notes += note + "\n";
  EXPECT_NE(notes.find("step 2 of 2 taken, the last (number 2, value 2.000000000)"),
            std::string::npos)
      << notes;
  EXPECT_NE(notes.find("of quadratic cells taken as straight"), std::string::npos) << notes;
}

TEST(ReadFrd, AStepThatIsAskedForIsAnother) {
  ReadOptions options;
  options.step = 1;
  const auto first = read_mesh(kPlate, options).mesh;
  options.step = 2;
  const auto second = read_mesh(kPlate, options).mesh;
  ASSERT_EQ(first.tensors.size(), second.tensors.size());
  EXPECT_NE(first.tensors, second.tensors);
  expect_same_field(second, read_mesh(kPlate).mesh);
  for (const std::size_t none : {0u, 3u}) {
    options.step = none;
    expect_error(kPlate, IoError::Kind::inapplicable, {"--step", "steps 1 to 2"}, options);
  }
}

TEST(ReadFrd, AWholeStepOfAFileThatIsCutOffIsTaken) {
  const std::string whole = slurp(kPlate);
  const auto cut = put("cut.frd", whole.substr(0, whole.size() * 19 / 20));
  ReadOptions options;
  options.step = 1;
  const auto read = read_mesh(cut, options);
  expect_same_field(read.mesh, read_mesh(kPlate, options).mesh);
  EXPECT_TRUE(std::any_of(read.report.notes.begin(), read.report.notes.end(), [](const auto& note) {
    return note.find("after the step that is taken") != std::string::npos;
  }));
  expect_error(cut, invalid, {"cut off"});
  options.step = 2;
  expect_error(cut, invalid, {"cut off"}, options);
}

TEST(ReadFrd, NumbersAreThoseOfTheFile) {
  ReadOptions options;
  options.step = 1;
  options.quadratic = QuadraticCells::corners;
  const auto mesh = read_mesh(put("a.frd", text_of("C3D4_text")), options).mesh;
  const std::string text = text_of("C3D4_text");
  const std::size_t at = text.find(" -1        11", text.find("STRESS"));
  ASSERT_NE(at, std::string::npos);
  const auto number = [&](std::size_t i) { return std::stod(text.substr(at + 13 + 12 * i, 12)); };
  const auto& t = mesh.tensors.front();
  EXPECT_EQ(t.xx, number(0));
  EXPECT_EQ(t.yy, number(1));
  EXPECT_EQ(t.zz, number(2));
  EXPECT_EQ(t.xy, number(3));
  EXPECT_EQ(t.yz, number(4));
  EXPECT_EQ(t.xz, number(5));
}

TEST(ReadFrd, NamesOfComponentsAreObeyed) {
  // Abaqus' order, if the file names it so.
  std::string text = text_of("C3D4_text");
  text = replaced(replaced(replaced(text, " -5  SYZ", " -5  S??"), " -5  SZX", " -5  SYZ"),
                  " -5  S??", " -5  SZX");
  ReadOptions options;
  options.step = 1;
  const auto read = read_mesh(put("a.frd", text), options);
  EXPECT_EQ(read.report.components.order, ComponentOrder::abaqus);
  const auto plain = read_mesh(put("b.frd", text_of("C3D4_text")), options);
  EXPECT_EQ(read.mesh.tensors[0].xz, plain.mesh.tensors[0].yz);
}

TEST(ReadFrdRefuses, AStepWithoutTensors) {
  std::string text = text_of("C3D10_binary");
  // The stresses of the second step are called what they are not: of one component each.
  const std::string whole = text_of("C3D20_text");
  const std::size_t begin = whole.rfind("    1PSTEP", whole.rfind(" -4  STRESS"));
  std::string without = whole.substr(0, begin) + " 9999\n";
  expect_error(put("a.frd", without), invalid,
               {"step 2", "no results of 6 components", "DISP", "--step", "these have: 1"});
  const std::size_t first = whole.find("    1PSTEP");
  expect_error(put("b.frd", whole.substr(0, first) + " 9999\n"), invalid, {"holds no results"});
  const std::size_t second = whole.find("    1PSTEP", first + 1);
  expect_error(put("c.frd", whole.substr(0, second) + " 9999\n"), invalid,
               {"no results of 6 components", "*EL FILE"});
}

TEST(ReadFrdRefuses, WhatDoesNotFit) {
  const std::string hex = text_of("C3D20_text"), tet = text_of("C3D4_text");
  const auto refused = [](const std::string& text, const std::vector<std::string>& parts) {
    expect_error(put("a.frd", text), invalid, parts, splitting());
  };
  refused("", {"ends without its last line"});
  refused("hello\n", {"none of a .frd file"});
  refused(hex.substr(0, hex.size() / 2), {"ends"});
  const auto with_count = [&](const std::string& block, int count) {
    std::string text = hex, number = std::to_string(count);
    const std::size_t at = text.find(block);
    return text.replace(at + 36 - number.size(), number.size(), number);
  };
  refused(with_count("    2C", 21), {"holds 20 nodes", "promises 21"});
  refused(with_count("    3C", 2), {"holds 1 elements", "promises 2"});
  refused(replaced(hex, " -1         7    4", " -1         7   77"), {"unknown type 77", "cell 0"});
  refused(replaced(hex, " -2        11        12", " -2        11        99"), {"node 99"});
  refused(replaced(tet, " -1        12 ", " -1        11 "), {"node 11 twice"});
  refused(replaced(tet, " -4  DISP        4", " -4  DISP        5"), {"components", "5 belong"});
  refused(replaced(tet, "    0    1           1\n", "    0    1           7\n"), {"unknown format 7"});
  // A node whose stress is missing.
  const std::size_t at = tet.rfind(" -1        12"), end = tet.find('\n', at) + 1;
  const std::size_t head = tet.rfind("           4  ", at);
  ASSERT_NE(head, std::string::npos);
  std::string less = tet.substr(0, at) + tet.substr(end);
  const std::size_t count = less.rfind("           4   ", at);
  ASSERT_NE(count, std::string::npos);
  less.replace(count, 12, "           3");
  refused(less, {"missing at node 12"});
}

}  // namespace
}  // namespace tensortopo::test
