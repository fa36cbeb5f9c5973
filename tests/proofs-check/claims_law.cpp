// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "extract/cases/extract_case.hpp"
#include "proofs-check/forgeries/forgery.hpp"
#include "support/oracles/brute_force.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// Tetrahedra of their own side by side; the vertices of the i-th are 4 i and so on.
TetMesh side_by_side(const std::vector<TetTensors>& members) {
  TetMesh mesh;
  for (const TetTensors& tensors : members) {
    const TetMesh one = reference_tet_mesh(tensors);
    const auto first = static_cast<TetMesh::Index>(mesh.points.size());
    for (auto p : one.points) {
      p.x += 0.5 * first;
      mesh.points.push_back(p);
    }
    mesh.tensors.insert(mesh.tensors.end(), tensors.begin(), tensors.end());
    mesh.tets.push_back(one.tets[0]);
    for (auto& v : mesh.tets.back()) v += first;
  }
  return mesh;
}

/// What is claimed of each simplex, by its vertices or number.
struct Claims {
  std::map<std::array<int, 2>, int> crossings;
  std::map<std::array<int, 3>, std::array<int, 2>> curves;  ///< arcs and closed curves
  std::map<int, std::vector<ComponentTopology>> sheets;
  std::map<int, std::size_t> cones;

  explicit Claims(const Json& level) {
    for (const Json& e : level["edges"]) crossings[{e[0], e[1]}] = static_cast<int>(e.size()) - 2;
    for (const Json& f : level["faces"])
      curves[{f[0], f[1], f[2]}] = {static_cast<int>(f[3].size()), static_cast<int>(f[4].size())};
    for (const Json& t : level["tets"]) {
      auto& list = sheets[t[0]];
      for (std::size_t s = 1; s < t.size(); ++s)
        list.push_back({t[s][0], static_cast<int>(t[s].size()) - 1});
      std::sort(list.begin(), list.end());
    }
    for (const Json& t : level["cones"]) cones[t[0]] = t.size() - 1;
  }

  LocalTopology in_tet(int tet) {
    LocalTopology result{sheets[tet], {}};
    constexpr std::array<std::array<int, 2>, 6> kEdges{
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    for (std::size_t e = 0; e < 6; ++e)
      result.edge_crossings[e] = crossings[{4 * tet + kEdges[e][0], 4 * tet + kEdges[e][1]}];
    return result;
  }
  FaceTopology in_face(const std::array<int, 3>& v) {
    return {curves[v][0],
            curves[v][1],
            {crossings[{v[0], v[1]}], crossings[{v[0], v[2]}], crossings[{v[1], v[2]}]}};
  }
};

}  // namespace

void expect_claims_that_brute_force_sees(const std::string& mode, int count, std::uint64_t seed) {
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  const double level = ModeValue::parse(mode).approx();
  Random random(seed);
  std::vector<TetTensors> members;
  for (int i = 0; i < count; ++i) {
    members.push_back(random.tet_tensors());
    if (i % 5 == 4) members.back()[static_cast<std::size_t>(i) % 4] = {7, 7, 7, 0, 0, 0};
  }
  const Exhibit e = exhibit(side_by_side(members), {mode});
  Court court("law");
  EXPECT_EQ(court.verdict(e), "certified") << court.report();
  EXPECT_TRUE(e.certificate["levels"][0]["undecided"].empty());
  Claims claims(e.certificate["levels"][0]);

  const BruteForceOptions usual, finer{.ladder = {{384, 512}, {576, 720}}};
  int tets = 0, faces = 0, misled = 0;
  for (int i = 0; i < count; ++i) {
    const TetTensors& tensors = members[static_cast<std::size_t>(i)];
    const bool is_cone = i % 5 == 4;
    SCOPED_TRACE(exact_text(tensors));
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      if (is_cone && opposite != static_cast<std::size_t>(i) % 4) continue;
      std::array<SymmetricTensor<double>, 3> corners;
      std::array<int, 3> vertices{};
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != opposite) corners[n] = tensors[k], vertices[n++] = 4 * i + static_cast<int>(k);
      const FaceTopology claimed = claims.in_face(vertices);
      auto seen = brute_force_face_topology(corners_of(corners), level);
      if (seen && *seen != claimed) {  // two lattices alike can tear a strip at its neck
        ++misled;
        seen = brute_force_face_topology(corners_of(corners), level, finer);
      }
      if (!seen) continue;
      ++faces;
      EXPECT_EQ(claimed, *seen);
      if (is_cone) {
        EXPECT_EQ(claims.cones[i], static_cast<std::size_t>(seen->open_arcs + seen->closed_loops));
      }
    }
    if (is_cone) continue;
    const LocalTopology claimed = claims.in_tet(i);
    auto seen = brute_force_topology(corners_of(tensors), level, usual);
    if (seen && *seen != claimed) {  // a tube that slips through two lattices alike looks resolved
      ++misled;
      seen = brute_force_topology(corners_of(tensors), level, finer);
    }
    if (!seen) continue;
    ++tets;
    EXPECT_EQ(claimed, *seen);
  }
  std::cout << "mode " << mode << ": brute force decided " << tets << " tetrahedra and " << faces
            << " faces of " << count << ", " << misled << " of them only on its finest lattices\n";
  EXPECT_LE(50 * misled, count + 50);
  EXPECT_GT(10 * tets, 6 * count);
  EXPECT_GT(faces, 2 * count);
}

}  // namespace tensortopo::test
