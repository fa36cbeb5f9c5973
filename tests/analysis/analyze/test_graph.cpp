// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "persistence/linked_mesh.hpp"
#include "support/compared.hpp"
#include "support/folder.hpp"
#include "tensortopo/extract/curve_arcs.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

// The report counts what the library says of each line, and the file has its points.
TEST(Graph, CountsTransitionsOfTheFile) {
  const Folder folder;
  Compared compared("curves with transitions", 5);
  const std::string input = std::string(TENSORTOPO_DATA) + "/s4_slab_small_C3D8I.vtu";
  const std::string output = folder / "tree.vtp";
  const auto run = run_program({"analyze", input, "--graph", "--json", "-o", output});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  const TetMesh mesh = read_mesh(input).mesh;
  std::size_t zeros = 0, jumps = 0;
  std::map<std::size_t, std::array<std::size_t, 2>> of_curve;
  for (const Json& transition : report.at("transitions")) {
    const bool is_jump = transition.at("kind") == "jump";
    ++(is_jump ? jumps : zeros);
    ++of_curve[transition.at("curve").get<std::size_t>()][is_jump ? 1 : 0];
    EXPECT_EQ(transition.at("tets").size(), is_jump ? 2u : 1u);
    EXPECT_LT(transition.at("within").get<double>(), 1e-6);
  }
  std::array<std::size_t, 2> arcs{}, lines{};
  for (std::size_t i = 0; i < report.at("curves").size(); ++i) {
    const Json& curve = report.at("curves")[i];
    const auto count = [&](const char* key) { return curve.at(key).get<std::size_t>(); };
    arcs[curve.at("mode") == 1 ? 0 : 1] += count("wedge_arcs") + count("trisector_arcs") +
                                           count("mixed_arcs") + count("arcs_not_proved");
    EXPECT_EQ(count("proved_transitions"), of_curve[i][0]);
    EXPECT_EQ(count("jumps"), of_curve[i][1]);
    EXPECT_GE(count("proved_transitions"), count("mixed_arcs"));
    compared.count(of_curve[i][0] + of_curve[i][1] > 0);
  }
  std::array<std::size_t, 2> found{};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto kind = side == 0 ? Degeneracy::linear : Degeneracy::planar;
    const CurveExtraction extraction = extract_degenerate_curves(mesh, kind);
    const auto all = curve_separation(CurveArcs(mesh, kind, extraction.curves));
    lines[side] = all.lines.size();
    for (const LineSeparation& line : all.lines) found[0] += line.zeros.size();
    found[1] += all.jumps.size();
  }
  EXPECT_EQ(arcs, lines);
  EXPECT_EQ(found[0], zeros);
  EXPECT_EQ(found[1], jumps);
  const SurfaceFile file = read_surface_file(output);
  const SurfaceArray* kinds = file.find_point_data("kind");
  ASSERT_NE(kinds, nullptr);
  EXPECT_EQ(file.points.size(), report.at("nodes").size() + zeros + jumps);
  EXPECT_EQ(static_cast<std::size_t>(std::count(kinds->values.begin(), kinds->values.end(), 2.0)),
            zeros);
  EXPECT_EQ(static_cast<std::size_t>(std::count(kinds->values.begin(), kinds->values.end(), 3.0)),
            jumps);
  const auto pairs = report.at("pairs_of_closed_curves").get<std::size_t>();
  std::size_t undecided = 0;
  for (const auto& [reason, count] : report.at("undecided_pairs").items())
    undecided += count.get<std::size_t>();
  EXPECT_EQ(report.at("certified_pairs").get<std::size_t>() + undecided, pairs);
}

TEST(Graph, CertifiesThatTwoCurvesAreLinked) {
  const Folder folder;
  const std::string input = folder / "linked.vtu";
  write_mesh(linked_mesh(7), input);
  const auto run = run_program({"analyze", input, "--graph", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json report = Json::parse(run.out);
  ASSERT_EQ(report.at("links").size(), 1u);
  const Json& link = report.at("links")[0];
  EXPECT_EQ(std::abs(link.at("number").get<int>()), 1);
  EXPECT_EQ(link.at("status"), "certified");
  EXPECT_TRUE(link.at("reason").is_null());
  for (const Json& curve : link.at("curves"))
    EXPECT_TRUE(report.at("curves")[curve.get<std::size_t>()].at("closed").get<bool>());
}

}  // namespace
}  // namespace tensortopo::test
