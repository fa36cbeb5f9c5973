// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

TEST(Bench, ReportsMediansAndTheirRatios) {
  const Outcome run = run_program(
      {"bench", "--input", field("s4_slab"), "--mode", "0.5", "--threads", "1", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("modes"), Json::array({0.5}));
  EXPECT_EQ(json.at("threads"), 1);
  EXPECT_GT(json.at("peak_memory_bytes"), 1000000);
  const double ours = json.at("times").at("extract");
  for (const std::string name : {"vtk_contour", "vtk_contour_3d_linear_grid"}) {
    const double theirs = json.at("times").at(name);
    EXPECT_GT(theirs, 0);
    EXPECT_DOUBLE_EQ(json.at("ratios").at("extract_over_" + name).get<double>(), ours / theirs);
    EXPECT_EQ(json.at("all_times").at(name).size(), 5u);
    EXPECT_GT(json.at("triangles").at(name), 100);
  }
}

TEST(Bench, FewerThanFiveTimingsAreRefused) {
  EXPECT_EQ(
      run_program({"bench", "--input", field("s4_slab"), "--mode", "0.5", "--repeat", "4"}).status,
      2);
}

}  // namespace
}  // namespace tensortopo::test
