// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "calculix_files.hpp"
#include "deck.hpp"
#include "field_difference.hpp"
#include "solution.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

bool run(const std::string& command) { return std::system(command.c_str()) == 0; }

class Solve : public testing::TestWithParam<std::string> {};

// The whole way: deck, CalculiX, program, field; and that field is the bundled one.
TEST_P(Solve, GivesTheBundledField) {
  if (!run("command -v ccx > /dev/null")) GTEST_SKIP() << "CalculiX is not installed";
  const std::string program = TENSORTOPO_SCENARIO, name = GetParam();
  const Folder folder;
  const std::string job = folder / "job", field = folder / "field.vtu";
  ASSERT_TRUE(run(program + " deck " + name + " --small -o " + job + ".inp > /dev/null"));
  ASSERT_TRUE(run("cd " + job.substr(0, job.size() - 4) +
                  " && OMP_NUM_THREADS=1 ccx -i job > job.log 2>&1"));
  ASSERT_TRUE(
      run(program + " field " + name + " --small --job " + job + " -o " + field + " > /dev/null"));

  const auto bundled = read_mesh(std::string(TENSORTOPO_DATA) + "/" + name + "_small_C3D8I.vtu");
  const auto d = compare_fields(bundled.mesh, read_mesh(field).mesh);
  EXPECT_TRUE(d.same_tetrahedra);
  EXPECT_EQ(d.moved_points, 0u);
  // Two solves, of which one had two threads, differ in their last digits.
  EXPECT_LT(d.largest, 1e-12 * d.largest_component);

  const auto checks = read_solution(make_scenario(name, Size::small), job).checks;
  EXPECT_LT(checks.force_imbalance, 1e-6);
  EXPECT_LT(checks.moment_imbalance, 1e-6);
  // What the .frd file would have lost.
  EXPECT_GT(checks.weights, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Bundled, Solve,
                         testing::Values("s1_compress_off", "s2_pushpull", "s3_three", "s4_slab"),
                         [](const auto& test) { return test.param; });

// Deck and results in a new folder.
class OwnSolve {
 public:
  OwnSolve(const Scenario& scenario, const std::string& solver) : scenario_(scenario) {
    std::string text = deck(scenario, Solver::direct);
    text.replace(text.find("SPOOLES"), 7, solver);
    put(folder_ / "job.inp", text);
    solved_ =
        run("cd " + folder_ / "" + " && OMP_NUM_THREADS=1 ccx -i job > job.log 2>&1");
  }
  bool solved() const { return solved_; }
  Solution read() const { return read_solution(scenario_, folder_ / "job"); }

 private:
  Scenario scenario_;
  Folder folder_;
  bool solved_ = false;
};

// Without lateral contraction a uniform pressure makes a uniform stress, whatever the mesh.
TEST(Solve, OfABlockUnderUniformPressureIsUniform) {
  if (!run("command -v ccx > /dev/null")) GTEST_SKIP() << "CalculiX is not installed";
  const OwnSolve own({"uniform",
                      box_mesh({5, 4, 3}, {20, 12, 9}),
                      {{1000, 0}},
                      {{Load::Shape::everywhere, 0, 0, 0, 3 * 20 * 12}}},
                     "SPOOLES");
  ASSERT_TRUE(own.solved());
  for (const auto& t : own.read().field.tensors) {
    EXPECT_NEAR(t.zz, -3, 1e-11);
    for (const double x : {t.xx, t.yy, t.xy, t.yz, t.xz}) EXPECT_NEAR(x, 0, 1e-11);
  }
}

// CalculiX's ITERATIVE CHOLESKY ends here as if all were well, and reactions are a percent off.
TEST(Solve, WithoutConvergenceIsRefused) {
  if (!run("command -v ccx > /dev/null")) GTEST_SKIP() << "CalculiX is not installed";
  const OwnSolve own(make_scenario("s3_three", Size::small), "ITERATIVE CHOLESKY");
  ASSERT_TRUE(own.solved());
  EXPECT_THROW(own.read(), BadSolution);
}

TEST(FieldDifference, CountsWhatDiffers) {
  TetMesh a;
  a.points = {{0, 0, 0}, {1, 0, 0}};
  a.tensors = {{1, 2, 3, 4, 5, -8}, {}};
  TetMesh b = a;
  EXPECT_EQ(compare_fields(a, b).different_tensors, 0u);
  b.points[1].y = 0.25;
  b.tensors[0].xz = -7;
  const auto d = compare_fields(a, b);
  EXPECT_EQ(d.moved_points, 1u);
  EXPECT_EQ(d.largest_move, 0.25);
  EXPECT_EQ(d.different_tensors, 1u);
  EXPECT_EQ(d.largest, 1);
  EXPECT_EQ(d.largest_component, 8);
  b.points.pop_back();
  EXPECT_THROW(compare_fields(a, b), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
