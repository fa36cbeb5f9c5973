// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "extract_case.hpp"
#include "support/fields/strata_fields.hpp"

namespace tensortopo::test {

/// What an extraction from one tetrahedron says: the reason if it gives up, else the topology.
struct Outcome {
  std::string reason;
  std::vector<ComponentTopology> components;
  int crossings = 0;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};
Outcome outcome(const Extraction& extraction);
std::ostream& operator<<(std::ostream& out, const Outcome& o);

/// Every entry off by up to so much of the largest; a factor of 0 leaves them as they are.
void perturb(TetTensors& tensors, double factor, Random& random);

/// The levels at which the strata are extracted: the special one first, if there is one.
std::vector<std::string> modes_for(Stratum stratum);

/// x -> A x + b with A of positive determinant.
struct AffineMap {
  std::array<Vector3<double>, 3> rows;
  Vector3<double> offset;

  Vector3<double> operator()(const Vector3<double>& p) const {
    return Vector3<double>{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + offset;
  }
};
/// With entries of few bits: what it makes of points with few bits is exact.
AffineMap random_affine_map(Random& random);
std::ostream& operator<<(std::ostream& out, const AffineMap& map);

/// Extracts from `count` tetrahedra, half of them of general tensors, half of tensors in a
/// degenerate configuration, exact or off by between a rounding and a thousandth, and expects
/// surfaces without flaws; from every `compared`-th also at fifty digits, where the topology must
/// be the same.
void expect_sound_near_strata(int count, int compared, std::uint64_t seed);

}  // namespace tensortopo::test
