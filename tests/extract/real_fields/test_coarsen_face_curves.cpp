// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "extract/level/level_in_tet.hpp"
#include "extract/patch/quality/least_sine.hpp"

namespace tensortopo::test {
namespace {

using Place = std::array<double, 3>;

Place place(const Vector3<double>& p) { return {p.x, p.y, p.z}; }

struct Two {
  Extraction sparse, all;
};

Two extract_both(const TetMesh& mesh, const std::string& mode) {
  ExtractOptions options;
  options.keep_topology = true;
  Two two;
  two.sparse = extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
  options.keep_samples = true;
  two.all = extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
  return two;
}

/// What triangles are like: how many, those with an angle below six degrees, the sum of least
/// angles' sines, and the mean square distance at middles of edges and centroids.
struct Quality {
  double triangles = 0, needles = 0, sines = 0, area = 0, squares = 0;

  void add(const Quality& other) {
    triangles += other.triangles, needles += other.needles, sines += other.sines;
    area += other.area, squares += other.squares;
  }

  void add(const TetMesh& mesh, const std::string& mode, const SurfaceMesh& surface) {
    const ScaledField<double> field(mesh);
    const auto level = make_level<double>(ModeValue::parse(mode));
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const auto& t = surface.triangles[i];
      const auto &p = surface.points[as_size(t[0])], &q = surface.points[as_size(t[1])],
                 &r = surface.points[as_size(t[2])];
      const auto n = cross(q - p, r - p);
      const double twice_area = std::sqrt(dot(n, n));
      const double sine = least_sine(p, q, r, twice_area);
      triangles += 1;
      needles += sine < 0.1;
      sines += sine;
      const LevelInTet in_tet(mesh, field, surface.tet[i], level);
      double sum = 0;
      for (const auto& x : {0.5 * (p + q), 0.5 * (q + r), 0.5 * (r + p), (1.0 / 3) * (p + q + r)})
        sum += in_tet.distance(x) * in_tet.distance(x) / 4;
      squares += twice_area * sum;
      area += twice_area;
    }
  }
};

std::set<Place> places_on_faces(const SurfaceMesh& surface) {
  std::set<Place> places;
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    if (surface.carrier[v] == Carrier::face) places.insert(place(surface.points[v]));
  return places;
}

/// What does not depend on the vertices' numbers.
std::vector<std::pair<int, std::size_t>> sheets(const LevelTopology& topology) {
  std::vector<std::pair<int, std::size_t>> result;
  for (const auto& tet : topology.tets) {
    std::vector<std::pair<int, std::size_t>> of_tet;
    for (const auto& sheet : tet.sheets)
      of_tet.emplace_back(sheet.euler_characteristic, sheet.loops.size());
    std::sort(of_tet.begin(), of_tet.end());
    result.insert(result.end(), of_tet.begin(), of_tet.end());
  }
  return result;
}

void expect_same_but_for_samples(const Two& two, const TetMesh& mesh) {
  EXPECT_EQ(flaws(two.sparse, mesh), "");
  EXPECT_EQ(summary(two.sparse.surface), summary(two.all.surface));
  EXPECT_EQ(sheets(two.sparse.topology), sheets(two.all.topology));
  const auto few = places_on_faces(two.sparse.surface), many = places_on_faces(two.all.surface);
  EXPECT_TRUE(std::includes(many.begin(), many.end(), few.begin(), few.end()));
  for (const auto& face : two.sparse.topology.faces)
    for (const auto v : face.loops) EXPECT_GE(v, 0);
}

TEST(SparserRims, HaveTheSameTopologyAndFewNeedlesAsCloseToTheLevel) {
  Quality all_sparse, all_dense;
  using Modes = std::vector<const char*>;
  const std::map<std::string, Modes> modes_of{
      {"s2", full_or_short<Modes>({"0", "1/2", "-9/10"}, {"1/2"})},
      {"s4", full_or_short<Modes>({"0", "99/100"}, {"0"})}};
  for (const auto& [name, modes] : modes_of) {
    const auto file = bundled_file(name);
    const TetMesh mesh = read(file);
    for (const char* mode : modes) {
      SCOPED_TRACE(file.filename().string() + " at " + mode);
      const Two two = extract_both(mesh, mode);
      expect_same_but_for_samples(two, mesh);
      Quality sparse, all;
      sparse.add(mesh, mode, two.sparse.surface);
      all.add(mesh, mode, two.all.surface);
      EXPECT_LT(sparse.triangles, all.triangles);
      EXPECT_LT(sparse.needles, all.needles);
      EXPECT_GT(sparse.sines / sparse.triangles, all.sines / all.triangles);
      EXPECT_LT(sparse.squares / sparse.area, 1.2 * all.squares / all.area);
      all_sparse.add(sparse), all_dense.add(all);
    }
  }
  EXPECT_LT(all_sparse.needles, 0.7 * all_dense.needles);
  EXPECT_LT(all_sparse.squares / all_sparse.area, 1.05 * all_dense.squares / all_dense.area);
}

TEST(SparserRims, OfIndependentTensorsHaveTheSameTopology) {
  const std::uint64_t seed = 20261123;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  std::size_t dropped = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    const char* mode = kLevels[static_cast<std::size_t>(trial) % kLevels.size()];
    SCOPED_TRACE(exact_text(tensors) + " at " + mode);
    const Two two = extract_both(mesh, mode);
    expect_same_but_for_samples(two, mesh);
    dropped += two.all.surface.points.size() - two.sparse.surface.points.size();
  }
  EXPECT_GT(dropped, 0u);
}

}  // namespace
}  // namespace tensortopo::test
