// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>

#include "mesh_difference.hpp"
#include "support/compared.hpp"
#include "support/folder.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/read_point_numbers.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {
namespace {

using scenarios::deviator_differences;

TetMesh smooth(int cells, std::uint64_t seed) {
  TetMesh mesh = cube_mesh(cells);
  // In the same cube, whatever the number of cells.
  for (auto& p : mesh.points) p = (4.0 / cells) * p;
  fill_with_smooth_tensors(mesh, seed, 3, 8);
  return mesh;
}

TEST(MeshDifference, OfALinearFieldIsNoneAndOfASpherePartToo) {
  TetMesh coarse = cube_mesh(2), fine = cube_mesh(5);
  for (auto& p : fine.points) p = 0.4 * p;
  const auto fill = [](TetMesh& mesh, double shift, double pressure) {
    mesh.tensors.clear();
    for (const auto& p : mesh.points)
      mesh.tensors.push_back({p.x + shift + pressure, 2 * p.y + pressure, p.z - p.x + pressure,
                              p.x + p.y, 1 - p.z, p.y});
  };
  fill(coarse, 0, 0), fill(fine, 0, 17);
  Compared compared("points", 20);
  for (const double d : deviator_differences(coarse, fine)) {
    ++compared;
    EXPECT_NEAR(d, 0, 1e-12);
  }
  fill(fine, 0.5, 0);  // of diag(1/2, 0, 0) the deviator has the norm sqrt(1/6)
  for (const double d : deviator_differences(coarse, fine))
    EXPECT_NEAR(d, std::sqrt(1.0 / 6), 1e-12);
  for (auto& p : coarse.points) p.x += 0.01;
  EXPECT_THROW(deviator_differences(coarse, fine), std::invalid_argument);
}

using Found = std::multiset<std::tuple<std::set<SurfaceMesh::Index>, long, long>>;

/// The tetrahedra of components, and what they are.
Found components_of(const SurfaceMesh& surface, const std::vector<char>& which) {
  const auto invariants = surface_invariants(surface);
  std::vector<std::set<SurfaceMesh::Index>> tets(invariants.components);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    tets[as_size(surface.component[i])].insert(surface.tet[i]);
  Found found;
  for (std::size_t c = 0; c < tets.size(); ++c)
    if (which.empty() || which[c])
      found.emplace(tets[c], invariants.parts[c].euler_characteristic,
                    invariants.parts[c].boundary_loops);
  return found;
}

// What survives the difference of two discretizations is the same in both.
TEST(MeshDifference, LeavesTheSameStableComponentsInBothFields) {
  Compared compared("components that survive");
  const Folder folder;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const TetMesh mesh = smooth(6, seed), other = smooth(7, seed);
    const auto mu = ModeValue::parse(seed % 2 == 0 ? "1/2" : "-3/10");
    write_mesh(mesh, folder / "field.vtu", "stress",
               {{"difference", deviator_differences(mesh, other)}});
    const ReadResult read = read_mesh(folder / "field.vtu");
    const auto radii = read_point_numbers(folder / "field.vtu", "difference", {}, read);
    EXPECT_GT(*std::max_element(radii.begin(), radii.end()), 0);
    const auto surface = extract_mode_surface<double>(mesh, mu).surface;
    const auto stability = level_stability(UncertainField(mesh, radii), mu);
    const auto stable =
        components_of(surface, surface_stability(mesh, surface, stability).components);
    TetMesh member = mesh;  // on the surfaces of the balls
    member.tensors = scenarios::tensors_at(mesh.points, other);
    const auto others = components_of(extract_mode_surface<double>(member, mu).surface, {});
    for (const auto& component : stable) {
      ++compared;
      EXPECT_GE(others.count(component), stable.count(component)) << "field " << seed;
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
