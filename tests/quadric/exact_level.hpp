// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/fields/random_fields.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/quadric/extract_invariant_surface.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo::test {

inline InvariantOptions in_pieces(int pieces) {
  InvariantOptions options;
  options.pieces = pieces;
  return options;
}

/// Another way to the topology of a level in one tetrahedron: the critical points of the quadratic
/// form on every face, in rationals. Shares nothing with the library but the tensors' definition.
class ExactLevel {
 public:
  /// `nappe` as in ConvexLevel.
  ExactLevel(const TetTensors& tensors, const InvariantLevel& level, int nappe);

  /// Whether {invariant <= value} (this nappe of it) meets the closed simplex of the corners in
  /// `mask`: if it does, then at a corner or in a critical point in the interior of some face.
  bool meets(unsigned mask) const;
  /// Crossings of the edge between two corners at value + 0.
  int crossings(int i, int j) const;
  /// Euler characteristic of the level: the body is convex and its boundary in the tetrahedron a
  /// sphere; the faces take a set of characteristic #faces - #edges + #vertices from it.
  int euler_characteristic() const;

 private:
  bool has_inner_place(unsigned mask) const;
  Rational form_[4][4];
  Rational trace_[4];
  int nappe_;
};

/// The level of an exact value.
InvariantLevel level_at(Invariant invariant, const Rational& value);

/// The nappes of an invariant's level.
std::vector<int> nappes(Invariant invariant);

/// Euler characteristic and loops of each part, sorted.
std::vector<std::vector<long>> topology(const InvariantExtraction& extraction);

}  // namespace tensortopo::test
