// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level in a refined edge, face or tetrahedron, by counting signs at its points.
#pragma once

#include <compare>
#include <map>
#include <optional>

#include "refinement.hpp"

namespace certificate {

/// A point of the level on an edge between two roots: the how-manieth from the first.
struct Crossing {
  unsigned edge = 0;  ///< a bit for each of the two roots
  unsigned ordinal = 0;

  auto operator<=>(const Crossing&) const = default;
};

/// An edge of the refinement, as a point of the level on it.
using CrossedEdge = std::array<Refinement::Id, 2>;

/// The crossings of all edges between roots.
class Crossings {
 public:
  explicit Crossings(const Refinement& refinement);

  unsigned count(unsigned edge) const;
  /// The crossing on an edge of the refinement; nothing if that lies on no edge between roots.
  std::optional<Crossing> at(const CrossedEdge& edge) const;

 private:
  const Refinement& refinement_;
  std::map<std::uint64_t, unsigned> ordinals_;
  std::map<unsigned, unsigned> counts_;
};

/// The level in a face.
struct FaceCurves {
  std::vector<std::array<Crossing, 2>> arcs;
  std::vector<std::vector<CrossedEdge>> loops;  ///< of each closed curve the edges that it crosses
};
FaceCurves trace_face(const Refinement& refinement);

/// A boundary loop of a sheet. For roots that are positively oriented it runs such that from
/// outside the larger modes are seen to its left.
struct Loop {
  struct Step {
    Crossing from;
    unsigned face;  ///< through which the arc from there goes: its roots' bits
  };
  std::vector<Step> steps;  ///< none if it is a closed curve in one face
  unsigned face = 0;        ///< in that case
  CrossedEdge sample{};     ///< a point of it
};
struct Sheet {
  long euler_characteristic = 0;
  std::vector<Loop> loops;
};
/// Nothing if rims do not close, which proofs exclude.
std::optional<std::vector<Sheet>> trace_tet(const Refinement& refinement);

}  // namespace certificate
