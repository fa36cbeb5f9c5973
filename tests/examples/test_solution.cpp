// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "calculix_files.hpp"
#include "nodal_stress.hpp"
#include "solution.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

// A block under uniform pressure of 2 MPa, and the results of a solver that is exact.
struct Job {
  Scenario scenario{"block",
                    box_mesh({4, 2, 2}, {8, 4, 2}),
                    {{1000, 0}},
                    {{Load::Shape::everywhere, 0, 0, 0, 64}}};
  RestartFile restart;
  std::vector<SymmetricTensor<double>> frd_stresses;
  Reactions reactions;
  Folder folder;

  Job() {
    restart.points = scenario.mesh.points;
    for (const auto& p : restart.points) restart.displacements.push_back({0, 0, -0.002 * p.z});
    restart.stresses = sampled(
        scenario.mesh, [](const auto&) { return SymmetricTensor<double>{0, 0, -2, 0, 0, 0}; });
    frd_stresses = nodal_stress(scenario.mesh, restart.stresses, Weights::calculix);
    for (const Index i : lowest_points(scenario.mesh)) {
      const auto& p = scenario.mesh.points[static_cast<std::size_t>(i)];
      const double share = (p.x == 0 || p.x == 8 ? 0.5 : 1) * (p.y == 0 || p.y == 4 ? 0.5 : 1);
      reactions.nodes.push_back({i, {0, 0, 8 * share}});
    }
    reactions.total = {0, 0, 64};
  }

  Solution read() const {
    put(folder / "job.rout", restart_bytes(restart));
    put(folder / "job.frd", frd_bytes(scenario.mesh, restart.displacements, frd_stresses));
    put(folder / "job.dat", dat_text(reactions));
    return read_solution(scenario, folder / "job");
  }

  void expect_refused(const std::string& words) const {
    try {
      read();
      ADD_FAILURE() << "took what should be refused: " << words;
    } catch (const BadSolution& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
};

TEST(Solution, OfAnExactSolverIsTaken) {
  const Job job;
  const auto [field, checks] = job.read();
  for (const auto& t : field.tensors) EXPECT_NEAR(t.zz, -2, 1e-14);
  EXPECT_LT(checks.force_imbalance, 1e-12);
  EXPECT_LT(checks.moment_imbalance, 1e-12);
  EXPECT_EQ(checks.load_size, 64);
  EXPECT_NE(to_text(checks).find("64"), std::string::npos);
}

TEST(Solution, WithReactionsOffIsRefused) {
  Job job;
  for (auto& node : job.reactions.nodes) node.force.z *= 1.002;
  job.expect_refused("reactions differ");
}

TEST(Solution, WhoseTotalDiffersFromItsReactionsIsRefused) {
  Job job;
  job.reactions.total.z = 60;
  job.expect_refused("reactions differ");
}

TEST(Solution, WithReactionsAtOtherPlacesIsRefused) {
  Job job;
  // The sum is that of the loads; the moment is not.
  job.reactions.nodes.front().force.z += 10;
  job.reactions.nodes.back().force.z -= 10;
  job.expect_refused("reactions differ");
}

TEST(Solution, WithOtherNumbersForTheViewerIsRefused) {
  Job job;
  job.frd_stresses[5].xy += 1e-4;
  job.expect_refused("differ by");
}

TEST(Solution, OfAnotherMeshIsRefused) {
  Job moved;
  moved.restart.points[7].x += 1e-13;
  moved.expect_refused("another mesh");
  Job smaller;
  smaller.scenario.mesh = box_mesh({2, 2, 2}, {8, 4, 2});
  EXPECT_THROW(smaller.read(), BadSolution);
}

TEST(Solution, WithoutAFileIsRefused) {
  for (const char* suffix : {".rout", ".frd", ".dat"}) {
    const Job job;
    job.read();
    std::filesystem::remove(job.folder / (std::string("job") + suffix));
    EXPECT_THROW(read_solution(job.scenario, job.folder / "job"), IoError);
  }
}

}  // namespace
}  // namespace tensortopo::test
