// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frd_file.hpp"
#include "nodal_stress.hpp"
#include "reactions.hpp"
#include "restart_file.hpp"

namespace tensortopo::scenarios {

namespace {

double length(const Vector3<double>& v) { return std::hypot(v.x, v.y, v.z); }

double largest(const Vector3<double>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double largest(const SymmetricTensor<double>& t) {
  return std::max({std::abs(t.xx), std::abs(t.yy), std::abs(t.zz), std::abs(t.xy), std::abs(t.yz),
                   std::abs(t.xz)});
}

template <class T>
double largest(const std::vector<T>& values) {
  double all = 0;
  for (const auto& v : values) all = std::max(all, largest(v));
  return all;
}

// The largest difference of the first values, by the largest component.
template <class T>
double relative_difference(const std::vector<T>& a, const std::vector<T>& b, std::size_t first) {
  double difference = 0;
  for (std::size_t i = 0; i < first; ++i) difference = std::max(difference, largest(a[i] - b[i]));
  const double size = largest(a);
  return difference > 0 ? difference / size : 0;
}

void require_same_mesh(const HexMesh& mesh, const RestartFile& restart,
                       const std::filesystem::path& file) {
  if (restart.stresses.size() != mesh.hexes.size() || restart.points.size() < mesh.points.size() ||
      !std::equal(mesh.points.begin(), mesh.points.end(), restart.points.begin()))
    throw BadSolution(file.string() + " is of another mesh");
}

void check_balance(const Scenario& scenario, const Reactions& reactions, SolutionChecks& checks) {
  const auto& points = scenario.mesh.points;
  checks.load = resultant(scenario.mesh, surface_pressures(scenario));
  for (const Load& load : scenario.loads) checks.load_size += std::abs(load.force);
  for (const auto& [point, force] : reactions.nodes) {
    if (static_cast<std::size_t>(point) >= points.size())
      throw BadSolution("there are reactions at nodes that the mesh does not have");
    checks.reaction.force += force;
    checks.reaction.moment += cross(points[static_cast<std::size_t>(point)], force);
  }
  Vector3<double> low = points.front(), high = low;
  for (const auto& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto& load = checks.load;
  const double by_nodes = length(load.force + checks.reaction.force);
  const double by_total = length(load.force + reactions.total);
  checks.force_imbalance = std::max(by_nodes, by_total) / checks.load_size;
  checks.moment_imbalance =
      length(load.moment + checks.reaction.moment) / (checks.load_size * length(high - low));
  const double worst = std::max(checks.force_imbalance, checks.moment_imbalance);
  if (!(worst <= kLargestImbalance))
    throw BadSolution(fmt::format(
        "reactions differ from the loads by {:.2g} % of them ({:.2g} % is the limit): the solver "
        "has not converged, or has solved something else",
        100 * worst, 100 * kLargestImbalance));
}

}  // namespace

Solution read_solution(const Scenario& scenario, const std::filesystem::path& job) {
  const auto with_suffix = [&](const char* suffix) {
    auto file = job;
    return std::filesystem::path(file += suffix);
  };
  const HexMesh& mesh = scenario.mesh;
  const std::size_t nodes = mesh.points.size();
  Solution result{to_tets(mesh), {}};
  SolutionChecks& checks = result.checks;
  const auto restart = read_restart_file(with_suffix(".rout"));
  require_same_mesh(mesh, restart, with_suffix(".rout"));
  check_balance(scenario, read_reactions(with_suffix(".dat")), checks);

  result.field.tensors = nodal_stress(mesh, restart.stresses, Weights::exact);
  checks.largest_stress = largest(result.field.tensors);
  const auto frd = read_frd_file(with_suffix(".frd"));
  if (frd.stresses.size() != nodes || frd.displacements.size() != nodes)
    throw BadSolution(with_suffix(".frd").string() + " is of another mesh");
  const auto rounded = nodal_stress(mesh, restart.stresses, Weights::calculix);
  checks.frd_stress = relative_difference(rounded, frd.stresses, nodes);
  checks.frd_displacement = relative_difference(restart.displacements, frd.displacements, nodes);
  checks.weights = relative_difference(result.field.tensors, rounded, nodes);
  const double worst = std::max(checks.frd_stress, checks.frd_displacement);
  if (!(worst <= kLargestFrdDifference))
    throw BadSolution(fmt::format("{} and {} differ by {:.2g} of the largest component",
                                  with_suffix(".rout").string(), with_suffix(".frd").string(),
                                  worst));
  return result;
}

std::string to_text(const SolutionChecks& c) {
  const auto triple = [](const Vector3<double>& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
  };
  return fmt::format(
      "loads                {} N\n"
      "reactions            {} N\n"
      "imbalance of forces  {:.1e} of {:.6g} N\n"
      "imbalance of moments {:.1e} of that times the diagonal\n"
      "largest component    {:.6g} MPa\n"
      ".rout against .frd   {:.1e} stress, {:.1e} displacement, of the largest component\n"
      "CalculiX's weights   would change the stress by {:.1e}\n",
      triple(c.load.force), triple(c.reaction.force), c.force_imbalance, c.load_size,
      c.moment_imbalance, c.largest_stress, c.frd_stress, c.frd_displacement, c.weights);
}

}  // namespace tensortopo::scenarios
