// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/persistence/mode_homology.hpp"

namespace tensortopo::persistence {

/// By how much Betti numbers grow somewhere in an enclosure.
struct BettiChange {
  ModeRange mode;
  std::array<long, 3> by{};
  /// By how much the Euler characteristic grows besides, with Betti numbers of which it is not
  /// known which ones.
  long euler = 0;
};

/// What the Betti numbers of {mode >= m} or {mode <= m} follow from.
struct BettiChanges {
  bool falls = true;                 ///< {mode >= m}: the changes are met by falling mode
  std::vector<BettiChange> changes;  ///< all that are known, in any order
  /// Between which modes the number of components, and that of voids, is in doubt.
  std::array<std::vector<ModeRange>, 2> doubts;
  std::vector<ModeRange> undecided;  ///< enclosures of points whose change is not known
  bool is_known = true;              ///< there are no changes elsewhere
  std::array<long, 3> mesh{};        ///< the Betti numbers of the mesh
};

/// The intervals between the enclosures, with the Betti numbers there, by growing mode.
///
/// Components follow from the changes met before, voids from those of the mesh and the changes met
/// later (by duality, see `mode_homology`); the Euler characteristic from either, if no point met
/// before, or later, is undecided; and loops from these three.
std::vector<BettiInterval> betti_intervals(const BettiChanges& changes);

}  // namespace tensortopo::persistence
