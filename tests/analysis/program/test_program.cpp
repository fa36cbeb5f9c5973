// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(Program, VersionNamesTheLibraries) {
  const Outcome run = run_program({"--version"});
  EXPECT_EQ(run.status, 0);
  for (const char* name : {"tensortopo ", "VTK", "Eigen", "oneTBB", "MPFR"}) {
    EXPECT_NE(run.out.find(name), std::string::npos) << name;
  }
}

TEST(Program, EverySubcommandHasHelp) {
  EXPECT_EQ(run_program({"--help"}).status, 0);
  for (const char* name : {"extract", "analyze", "report", "render", "bench", "check", "generate",
                           "conformance", "convert", "verify", "proofs"}) {
    const Outcome run = run_program({name, "--help"});
    EXPECT_EQ(run.status, 0) << name;
    for (const char* option : {"--json", "--quiet", "--threads", "--help"}) {
      EXPECT_NE(run.out.find(option), std::string::npos) << name << ' ' << option;
    }
  }
}

TEST(Program, WithoutWordsIsBadUsage) { EXPECT_EQ(run_program({}).status, 2); }

TEST(Program, AWordThatIsNoSubcommandIsNamed) {
  const Outcome run = run_program({"extrude", "a.vtu"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("'extrude'"), std::string::npos) << run.err;
  EXPECT_NE(run_program({"check", "a.vtu"}).err.find("OUTPUT is required"), std::string::npos);
}

}  // namespace
}  // namespace tensortopo::test
