// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Meshes that are no complex in space. No claim tells of tetrahedra that the level misses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "forgery_trial.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

TEST(Forgeries, TetrahedraThatAreThereTwice) {
  Trial trial("twice");
  for (const Exhibit& honest : honest_exhibits())
    for (std::size_t t = 0; t < honest.mesh.tets.size(); t += honest.mesh.tets.size() / 7 + 1) {
      Exhibit forged = honest;
      forged.mesh.tets.push_back(honest.mesh.tets[t]);
      forged.certificate["input"]["tetrahedra"] = forged.mesh.tets.size();
      forged.rehash();
      trial.expect_not_certified(forged, "tetrahedron " + std::to_string(t));
    }
}

/// Tetrahedra without volume, and such that lie in others, are no part of a mesh in space, wherever
/// the level is.
TEST(Forgeries, TetrahedraThatAreFlatOrOnOneSideOfAFace) {
  Trial trial("overlap");
  for (const Exhibit& honest : honest_exhibits()) {
    std::map<std::array<Index, 3>, std::vector<Index>> opposite;  // of each face
    for (auto tet : honest.mesh.tets) {
      std::sort(tet.begin(), tet.end());
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<Index, 3> face{};
        std::copy_if(tet.begin(), tet.end(), face.begin(), [&](Index v) { return v != tet[i]; });
        opposite[face].push_back(tet[i]);
      }
    }
    std::size_t tried = 0;
    for (const auto& [face, apexes] : opposite) {
      if (apexes.size() != 1 || tried++ % 7 != 0) continue;
      const auto added = [&](const Vector3<double>& point) {
        Exhibit forged = honest;
        forged.mesh.tets.push_back(
            {face[0], face[1], face[2], static_cast<Index>(forged.mesh.points.size())});
        forged.mesh.points.push_back(point);
        forged.mesh.tensors.push_back(honest.mesh.tensors[static_cast<std::size_t>(apexes[0])]);
        forged.certificate["input"]["tetrahedra"] = forged.mesh.tets.size();
        forged.certificate["input"]["points"] = forged.mesh.points.size();
        forged.rehash();
        return forged;
      };
      const auto at = [&](Index v) { return honest.mesh.points[static_cast<std::size_t>(v)]; };
      const Vector3<double> inside =
          0.125 * (at(face[0]) + at(face[1]) + at(face[2])) + 0.625 * at(apexes[0]);
      trial.expect("malformed", added(inside), "in another");
      trial.expect("malformed", added(at(face[0])), "flat");
    }
  }
}

/// Below the longest edge of a coarse tetrahedron a bound is shown by its parts, as far as it is
/// one: each bound is certified or not, and below the first that is not, down to nothing, none is.
TEST(Forgeries, BoundsOfCoarseTetrahedraBelowTheirLongestEdge) {
  Court court("coarse_bound");
  std::size_t certified = 0, refuted = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Exhibit e = exhibit(reference_tet_mesh(Random(seed).tet_tensors()), {"1/2"});
    Json& distance = e.certificate["levels"][0]["distance"];
    if (distance["coarse"].empty()) continue;
    ASSERT_EQ(court.verdict(e), "certified") << court.report();
    distance["coarse_bound"] = "0x1.6a09e667f3be0p+0";  // the root of two, and 2^-48
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    bool is_bound = true;
    for (const char* bound :
         {"0x1p+0", "0x1p-1", "0x1p-2", "0x1p-4", "0x1p-6", "0x1p-9", "0x1p-30"}) {
      distance["coarse_bound"] = bound;
      const std::string verdict = court.verdict(e);
      EXPECT_TRUE(is_bound || verdict != "certified") << bound << court.report();
      is_bound = verdict == "certified";
      if (is_bound) ++certified;
      if (verdict == "refuted") ++refuted;
    }
    EXPECT_FALSE(is_bound) << court.report();
  }
  EXPECT_GT(certified, 5u);
  EXPECT_GT(refuted, 5u);
}

/// Of a tetrahedron that is undecided no distance is claimed, however large: the level may be
/// empty.
TEST(Forgeries, UndecidedTetrahedraThatAreCoarse) {
  Court court("undecided_coarse");
  std::size_t tried = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    TetTensors tensors = Random(seed).tet_tensors();
    tensors[3] = -1.0 * (tensors[0] + tensors[1] + tensors[2]);
    Exhibit e = exhibit(reference_tet_mesh(tensors), {"1/2"});
    Json& level = e.certificate["levels"][0];
    if (level["undecided"].empty()) continue;
    ASSERT_EQ(court.verdict(e), "undecided") << court.report();
    const Json cell = level["undecided"][0][0];
    level["distance"] = {{"reach", Json::array()},
                         {"bound", "0x0p+0"},
                         {"coarse", {cell}},
                         {"coarse_bound", "0x1p+10"}};
    for (std::size_t v = 0; v < e.surface.points.size(); ++v)
      level["distance"]["reach"].push_back(0);
    EXPECT_EQ(court.verdict(e), "refuted") << court.report();
    EXPECT_NE(court.report().find("is undecided: "), std::string::npos) << court.report();
    level["distance"]["coarse"] = Json::array();
    EXPECT_EQ(court.verdict(e), "undecided") << court.report();
    ++tried;
  }
  EXPECT_GE(tried, 3u);
}

}  // namespace
}  // namespace tensortopo::test
