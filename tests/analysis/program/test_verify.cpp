// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

Json without_seconds(Json json) {
  for (Json& row : json.at("statements")) row.erase("seconds");
  return json;
}

TEST(Verify, ReportsEveryStatementAsJson) {
  const Outcome run =
      run_program({"verify", "--fields", std::to_string(trials(12, 6)), "--seed", "3", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Json json = Json::parse(run.out);
  ASSERT_GE(json.at("statements").size(), 10u);
  std::size_t corrected = 0;
  for (const Json& row : json.at("statements")) {
    EXPECT_EQ(row.size(), 11u);
    EXPECT_GE(row.at("configurations"), 1);
    for (const std::string key : {"id", "paper", "claim"}) {
      EXPECT_FALSE(row.at(key).get<std::string>().empty());
    }
    EXPECT_EQ(row.at("scalar"), "rational");
    EXPECT_GT(row.at("tried"), 0);
    EXPECT_GE(row.at("seconds"), 0);
    const bool holds = row.at("verdict") == "holds";
    EXPECT_TRUE(holds || row.at("verdict") == "corrected") << row;
    EXPECT_EQ(row.at("witness").is_null(), holds);
    EXPECT_EQ(row.at("corrected").is_null(), holds);
    corrected += holds ? 0 : 1;
  }
  EXPECT_GE(corrected, 1u);
}

TEST(Verify, TriesTheStatementsAskedFor) {
  const Outcome run = run_program({"verify", "--theorem", "real-domain", "--theorem", "mode-range",
                                   "--fields", "20", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json list = Json::parse(run.out).at("statements");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list.at(0).at("id"), "mode-range");
  EXPECT_EQ(list.at(0).at("tried"), 20);
  EXPECT_EQ(list.at(1).at("id"), "real-domain");
  EXPECT_EQ(list.at(1).at("tried"), 18);
}

TEST(Verify, TakesThePapersNumbersAndEndsWithASummary) {
  const Outcome run = run_program({"verify", "--theorem", "3", "--theorem", "4", "--fields", "60"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("complex-domain-nesting"), std::string::npos);
  EXPECT_NE(run.out.find("boundary-parameter"), std::string::npos);
  const std::string summary =
      "2 statements over rational: 0 hold, 2 hold as corrected, 0 refuted, 0 undecided\n";
  EXPECT_TRUE(run.out.ends_with(summary)) << run.out;
}

TEST(Verify, SaysSoWhereConfigurationsAreFew) {
  const Outcome run = run_program({"verify", "--theorem", "mode-range", "--fields", "6"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("few: the fields are 6 configurations"), std::string::npos) << run.out;
}

TEST(Verify, GivesTheSameAgainForASeed) {
  const auto once = [] {
    const Outcome run =
        run_program({"verify", "--fields", std::to_string(trials(5)), "--seed", "8", "--json"});
    return without_seconds(Json::parse(run.out));
  };
  EXPECT_EQ(once(), once());
}

TEST(Verify, PrintsATable) {
  const Outcome run = run_program({"verify", "--theorem", "mode-range"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("mode-range"), std::string::npos);
  EXPECT_NE(run.out.find("holds"), std::string::npos);
  EXPECT_NE(run.out.find("   100"), std::string::npos);
}

TEST(Verify, LeavesUndecidedWhatNoFieldCouldDecide) {
  // The first fields of a seed have no frame that is known.
  const Outcome run =
      run_program({"verify", "--theorem", "singularities", "--fields", "2", "--json"});
  EXPECT_EQ(run.status, 1);
  const Json row = Json::parse(run.out).at("statements").at(0);
  EXPECT_EQ(row.at("verdict"), "undecided");
  EXPECT_FALSE(row.at("witness").is_null());
}

TEST(Verify, NamesTheStatementsIfAnIdIsUnknown) {
  const Outcome run = run_program({"verify", "--theorem", "nine"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("'nine'"), std::string::npos);
  EXPECT_NE(run.err.find("real-domain"), std::string::npos);
}

TEST(Verify, RefusesUnknownScalarsAndNoFields) {
  const Outcome run = run_program({"verify", "--scalar", "float"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("rational"), std::string::npos);
  EXPECT_EQ(run_program({"verify", "--fields", "0"}).status, 2);
  EXPECT_EQ(run_program({"verify", "--fields", "many"}).status, 2);
}

TEST(Verify, RefutesNothingInOtherArithmetics) {
  for (const std::string scalar : {"interval", "real100", "double"}) {
    const Outcome run = run_program({"verify", "--scalar", scalar, "--fields", "20", "--json"});
    // Equalities stay open: that is not certain.
    EXPECT_EQ(run.status, 1) << scalar;
    for (const Json& row : Json::parse(run.out).at("statements")) {
      EXPECT_EQ(row.at("scalar"), scalar);
      EXPECT_NE(row.at("verdict"), "refuted") << row;
    }
  }
}

TEST(Verify, CertifiesStrictSignsInIntervals) {
  const Outcome run = run_program({"verify", "--theorem", "real-domain", "--scalar", "interval"});
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(Verify, TriesTheTetrahedraOfAMesh) {
  const Outcome run = run_program({"verify", "--theorem", "real-domain", "--input",
                                   field("s3_three"), "--fields", "50", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = Json::parse(run.out);
  const Json& input = json.at("input");
  std::size_t sum = 0;
  for (const Json& count : input.at("of_rank")) sum += count.get<std::size_t>();
  EXPECT_EQ(sum, input.at("tetrahedra"));
  EXPECT_EQ(input.at("tried"), 50);
  EXPECT_EQ(input.at("sha256").get<std::string>().size(), 64u);
  const Json& row = json.at("statements").at(0);
  EXPECT_EQ(row.at("verdict"), "corrected");
  std::size_t lacking = 0;
  for (const auto& [why, count] : row.at("not_applicable").items()) {
    lacking += count.get<std::size_t>();
  }
  EXPECT_EQ(row.at("tried").get<std::size_t>() + lacking, 50u);
}

TEST(Verify, EstablishesWhatNeedsAFrameOnMovedTetrahedra) {
  const Outcome run =
      run_program({"verify", "--theorem", "bifurcation-mode", "--theorem", "complex-domain-nesting",
                   "--input", field("s2_pushpull"), "--fields", "40", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const Json& row : Json::parse(run.out).at("statements")) {
    EXPECT_GE(row.at("tried"), 15) << row;
    EXPECT_LE(row.at("tried"), 20) << row;
  }
}

TEST(Verify, NamesAMeshThatIsNotThere) {
  const Outcome run = run_program({"verify", "--input", "no-such.vtu"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("no-such.vtu"), std::string::npos);
}

}  // namespace
}  // namespace tensortopo::test
