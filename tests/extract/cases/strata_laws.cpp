// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "strata_laws.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>

#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {

void perturb(TetTensors& tensors, double factor, Random& random) {
  if (factor == 0) return;
  for (auto& t : tensors) {
    double largest = 0;
    for (const double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      largest = std::max(largest, std::abs(*entry));
    for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      *entry += factor * largest * (2 * random.uniform() - 1);
  }
}

Outcome outcome(const Extraction& extraction) {
  if (!extraction.unresolved.empty())
    return {std::string(name_of(extraction.unresolved[0].reason)), {}, 0};
  const LocalTopology topology = topology_in_tet(extraction);
  return {"", topology.components, topology.crossings()};
}

std::ostream& operator<<(std::ostream& out, const Outcome& o) {
  if (!o.reason.empty()) return out << o.reason;
  out << o.components.size() << " components:";
  for (const auto& c : o.components) out << ' ' << c;
  return out << ", " << o.crossings << " crossings";
}

std::vector<std::string> modes_for(Stratum stratum) {
  std::vector<std::string> modes{"1/2", "-9/10"};
  const std::string special = special_mode(stratum);
  if (special != "0") modes.insert(modes.begin(), "0");
  if (stratum == Stratum::degenerate_edge)
    for (const char* near : {"1/1000", "-999/1000", "999999/1000000"}) modes.push_back(near);
  if (!special.empty()) modes.insert(modes.begin(), special);
  return modes;
}

AffineMap random_affine_map(Random& random) {
  AffineMap map;
  double determinant = 0;
  while (determinant == 0) {
    for (auto& row : map.rows) {
      const double scale = std::ldexp(1.0, random.integer(-3, 3));
      for (double* entry : {&row.x, &row.y, &row.z}) *entry = scale * random.integer(-5, 5);
    }
    determinant = dot(map.rows[0], cross(map.rows[1], map.rows[2]));
  }
  if (determinant < 0) map.rows[0] = -1.0 * map.rows[0];
  for (double* entry : {&map.offset.x, &map.offset.y, &map.offset.z})
    *entry = random.integer(-1000, 1000);
  return map;
}

std::ostream& operator<<(std::ostream& out, const AffineMap& map) {
  for (const auto& row : map.rows) out << row.x << ' ' << row.y << ' ' << row.z << "; ";
  return out << "offset " << map.offset.x << ' ' << map.offset.y << ' ' << map.offset.z;
}

void expect_sound_near_strata(int count, int compared, std::uint64_t seed) {
  SCOPED_TRACE(announce(seed));
  constexpr std::array<const char*, 5> modes{"0", "1e-6", "1/2", "-9/10", "99/100"};
  constexpr std::array<double, 6> factors{0, 0x1p-53, 1e-12, 1e-9, 1e-6, 1e-3};
  const auto& strata = all_strata();
  std::map<std::string, int> reasons;
  int asked_twice = 0, nearby = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int trial = 0; trial < count; ++trial) {
    Random random(seed + static_cast<std::uint64_t>(trial));
    TetTensors tensors = random.tet_tensors();
    std::string mode = modes[static_cast<std::size_t>(random.integer(0, 4))];
    std::string patch = "general";
    if (trial % 2 == 1) {
      const Stratum stratum =
          strata[static_cast<std::size_t>(random.integer(0, static_cast<int>(strata.size()) - 1))];
      tensors = stratum_tensors(stratum, random);
      perturb(tensors, factors[static_cast<std::size_t>(random.integer(0, 5))], random);
      if (!special_mode(stratum).empty() && random.integer(0, 1) == 0) mode = special_mode(stratum);
      patch = name_of(stratum);
    }
    SCOPED_TRACE("trial " + std::to_string(trial) + ", " + patch + " at " + mode + '\n' +
                 exact_text(tensors));
    const TetMesh mesh = reference_tet_mesh(tensors);
    const Extraction extraction = extract(mesh, mode);
    // Where the level runs within rounding of a vertex or an edge, points may fall together.
    const std::string found =
        flaws(extraction, mesh, {.residuals = false, .coincidences = trial % 2 == 0});
    ASSERT_EQ(found, "");
    const Outcome seen = outcome(extraction);
    nearby += extraction.statistics.tets_nearby > 0;
    if (!seen.reason.empty()) ++reasons[patch + ' ' + seen.reason];
    if (trial % 2 == 0) {
      EXPECT_EQ(seen.reason, "");
    }
    // Where nothing was found there is nothing to compare, at a price of seconds.
    if (trial / 2 % compared != 0 || !seen.reason.empty()) continue;
    const Outcome precise = outcome(extract<Real50>(mesh, mode));
    ++asked_twice;
    if (precise.reason.empty()) {
      ASSERT_EQ(seen, precise);
    }
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::cout << count << " tetrahedra, " << asked_twice << " also at fifty digits, "
            << 1000 * time.count() / count << " s per thousand; " << nearby
            << " drawn next to their level; given up:";
  for (const auto& [reason, number] : reasons) std::cout << "\n  " << reason << ' ' << number;
  std::cout << '\n';
}

}  // namespace tensortopo::test
