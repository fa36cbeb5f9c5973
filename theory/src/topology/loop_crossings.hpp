// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>

#include "levels/level_complex.hpp"
#include "topology/loop_tetrahedron.hpp"

namespace tensortopo::theory {

/// Whether the arc of the surface of mode mu in a face crosses the loop, and the other loop, of the
/// complex domain's boundary an odd number of times.
struct OddCrossings {
  bool loop = false, other = false;
};

/// Counts them for the faces of a complex in a tetrahedron. With certified signs only.
///
/// Let g.v be of one sign along the arc, g some vector and v the medium eigenvector, which the
/// coefficients of (g.v)^2 prove. The boundary is where sigma vanishes, and crossed where sigma
/// does change its sign. So the number of crossings is odd exactly if (g.v) sigma differs in sign
/// at the ends of the arc. Which loop they are of is told by x z, of one sign on each loop: it has
/// a sign on the face, or else sigma has one there.
class LoopCrossings {
 public:
  /// Both must outlive it.
  LoopCrossings(const LevelComplex& complex, const LoopTetrahedron& t);

  /// Of a face that the level meets in one arc; nothing if the face is too large to tell.
  std::optional<OddCrossings> of(const LevelComplex::Face& face);

 private:
  using Edge = std::array<LevelComplex::Index, 2>;
  // A part of an edge: the end below the level, and the end above.
  using Bracket = std::array<Deviator<Integer>, 2>;

  Bracket& crossing(const Edge& edge);
  void halve(Bracket& bracket) const;
  Verdict sigma_at(Bracket& bracket, const std::array<double, 3>& g) const;

  const LevelComplex& complex_;
  ModeLevel level_;
  int side_;
  std::array<Bounded<double>, 3> normal_;
  Bounded<double> factor_;
  std::map<Edge, Bracket> crossings_;
};

}  // namespace tensortopo::theory
