// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "extract_case.hpp"
#include "support/oracles/brute_force.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {

void expect_agreement_with_brute_force(const std::string& mode, int count, std::uint64_t seed) {
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  const double level = ModeValue::parse(mode).approx();
  Random random(seed);
  // Where the lattices that usually do disagree with the extraction, finer ones are asked: a tube
  // that slips through two lattices alike looks resolved.
  const BruteForceOptions usual, finer{.ladder = {{384, 512}, {576, 720}}};
  int decided = 0, misled = 0;
  for (int trial = 0; trial < count; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const auto corners = corners_of(tensors);
    const Extraction extraction = extract(reference_tet_mesh(tensors), mode);
    EXPECT_EQ(unresolved_text(extraction), "") << exact_text(tensors);
    const LocalTopology seen = topology_in_tet(extraction);
    auto expected = brute_force_topology(corners, level, usual);
    if (expected && *expected != seen) {
      ++misled;
      expected = brute_force_topology(corners, level, finer);
    }
    if (!expected) continue;
    ++decided;
    EXPECT_EQ(seen, *expected) << "trial " << trial << '\n' << exact_text(tensors);
  }
  std::cout << "mode " << mode << ": brute force decided " << decided << " of " << count << ", "
            << misled << " of them only on its finest lattices\n";
  EXPECT_LE(50 * misled, count + 50);
  // Next to modes -1 and 1 tubes are often thinner than the finest lattice.
  const bool is_near_degenerate = std::abs(level) > 0.998;
  EXPECT_GT(10 * decided, (is_near_degenerate ? 5 : 8) * count);
}

void expect_agreement_with_fifty_digits(const std::string& mode, int count, std::uint64_t seed) {
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  Random random(seed);
  for (int trial = 0; trial < count; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction plain = extract(mesh, mode), precise = extract<Real50>(mesh, mode);
    EXPECT_EQ(unresolved_text(plain), "") << exact_text(tensors);
    EXPECT_EQ(unresolved_text(precise), "") << exact_text(tensors);
    EXPECT_EQ(topology_in_tet(plain), topology_in_tet(precise)) << exact_text(tensors);
  }
}

void expect_flawless_surfaces(const std::string& mode, int count, int cubes, bool smooth,
                              std::uint64_t seed) {
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  TetMesh mesh = cube_mesh(cubes);
  for (int trial = 0; trial < count; ++trial) {
    const std::uint64_t field = seed + static_cast<std::uint64_t>(trial);
    if (smooth)
      fill_with_smooth_tensors(mesh, field);
    else
      fill_with_normal_tensors(mesh, field);
    const Extraction extraction = extract(mesh, mode);
    EXPECT_EQ(unresolved_text(extraction), "") << "field " << field;
    EXPECT_EQ(flaws(extraction, mesh), "") << "field " << field;
    if (!smooth) {
      EXPECT_FALSE(extraction.surface.triangles.empty()) << "field " << field;
    }
  }
}

}  // namespace tensortopo::test
