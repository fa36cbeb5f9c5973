// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Inputs of several steps.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(ExtractSeries, AFileForEachStepWhereverItsNumberStands) {
  const Folder folder;
  const std::string field = folder / "k.vtu", series = folder / "series.pvd";
  ASSERT_EQ(run_program({"generate", "complex", "-o", field, "--field-only", "--quiet"}).status, 0);
  std::ofstream(series) << R"(<VTKFile type="Collection"><Collection>
<DataSet timestep="0" file="k.vtu"/><DataSet timestep="1" file="k.vtu"/>
</Collection></VTKFile>)";
  const Outcome run = run_program(
      {"extract", series, "-o", folder / "a{step}_{step}.vtp", "--mode", "1/2", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(folder.files(),
            (std::vector<std::string>{"a1_1.vtp", "a2_2.vtp", "k.vtu", "series.pvd"}));
  const Outcome converted =
      run_program({"convert", series, "-o", folder / "b_{step}.vtu", "--quiet"});
  expect_line(converted, 2, "convert writes one step");
  EXPECT_EQ(folder.files().size(), 4u);
}

}  // namespace
}  // namespace tensortopo::test
