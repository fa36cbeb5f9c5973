// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

TEST(Proofs, ReportsEveryStepAsJson) {
  const Outcome run = run_program({"proofs", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Json steps = Json::parse(run.out).at("steps");
  ASSERT_GE(steps.size(), 100u);
  std::size_t corrected = 0;
  for (const Json& step : steps) {
    EXPECT_EQ(step.size(), 8u);
    for (const std::string key : {"id", "theorem", "claim", "kind"}) {
      EXPECT_FALSE(step.at(key).get<std::string>().empty());
    }
    const bool holds = step.at("verdict") == "holds";
    EXPECT_TRUE(holds || step.at("verdict") == "corrected") << step;
    EXPECT_EQ(step.at("corrected").is_null(), holds) << step;
    EXPECT_EQ(step.at("witness").is_null(), holds) << step;
    EXPECT_GE(step.at("seconds"), 0);
    corrected += holds ? 0 : 1;
  }
  EXPECT_GE(corrected, 20u);
}

TEST(Proofs, ListsWhatCoqHasCheckedWithItsAxioms) {
  const Json theorems = Json::parse(run_program({"proofs", "--json"}).out).at("theorems");
  for (const Json& theorem : theorems) {
    for (const std::string key : {"statement", "file", "theorem", "says"}) {
      EXPECT_FALSE(theorem.at(key).get<std::string>().empty()) << theorem;
    }
    EXPECT_TRUE(theorem.contains("axioms"));
  }
  const Outcome run = run_program({"proofs"});
  EXPECT_NE(run.out.find(std::to_string(theorems.size()) + " theorems on "), std::string::npos);
}

TEST(Proofs, ProvesTheStepsAskedFor) {
  const Outcome run =
      run_program({"proofs", "--step", "bifurcation", "--step", "mode-range", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json steps = Json::parse(run.out).at("steps");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps.at(0).at("id"), "mode-range");
  EXPECT_EQ(steps.at(1).at("id"), "bifurcation");
}

TEST(Proofs, PrintsATable) {
  const Outcome run = run_program({"proofs", "--step", "opposite-rotations"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("holds as corrected"), std::string::npos);
  EXPECT_NE(run.out.find("witness: "), std::string::npos);
}

TEST(Proofs, NamesTheStepsIfAnIdIsUnknown) {
  const Outcome run = run_program({"proofs", "--step", "nine"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("'nine'"), std::string::npos);
  EXPECT_NE(run.err.find("mode-range"), std::string::npos);
}

}  // namespace
}  // namespace tensortopo::test
