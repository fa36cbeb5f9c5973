// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

Json without_seconds(Json json) {
  for (Json& row : json.at("statements")) row.erase("seconds");
  return json;
}

TEST(Verify, ReportsEveryStatementAsJson) {
  const Outcome run = run_program({"verify", "--fields", "30", "--seed", "3", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Json json = Json::parse(run.out);
  ASSERT_GE(json.at("statements").size(), 10u);
  std::size_t corrected = 0;
  for (const Json& row : json.at("statements")) {
    EXPECT_EQ(row.size(), 9u);
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

TEST(Verify, GivesTheSameAgainForASeed) {
  const auto once = [] {
    const Outcome run = run_program({"verify", "--fields", "10", "--seed", "8", "--json"});
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

TEST(Verify, RefusesOtherScalarsAndNoFields) {
  const Outcome run = run_program({"verify", "--scalar", "double"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("rational"), std::string::npos);
  EXPECT_EQ(run_program({"verify", "--fields", "0"}).status, 2);
  EXPECT_EQ(run_program({"verify", "--fields", "many"}).status, 2);
}

}  // namespace
}  // namespace tensortopo::test
