// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo {

/// A mode at which independent loops (1-cycles, with coefficients modulo 2) of {mode >= m} appear
/// or vanish as m falls, or of {mode <= m} as m grows.
struct LoopEvent {
  PairKind kind = PairKind::superlevel;  ///< of which sets; not `extended`
  bool is_birth = true;                  ///< they appear
  ModeRange mode;                        ///< encloses it
  std::size_t count = 1;                 ///< how many
  std::size_t paired = 0;                ///< how many of them are in `ModeHomology::pairs`
  Vector3<double> place{};               ///< about where; of a curve, a vertex of it
  TetMesh::Index tet = -1;               ///< one that it is in
  std::optional<std::size_t> point;      ///< as an index into `MeshCriticalValues::points`
  /// Component of the degenerate curves: of mode 1 for a birth of superlevel or a death of sublevel
  /// sets, else of mode -1.
  std::optional<std::size_t> curve;
  /// The enclosure overlaps that of an event by which as well components meet, or voids appear:
  /// with other values in them those may be here, and the loops there.
  bool is_tie = false;
};

/// The Betti numbers of {mode >= m} or {mode <= m} for all m between two modes.
struct BettiInterval {
  double low = -1;  ///< m is larger
  double high = 1;  ///< m is smaller
  /// The numbers of components, loops and voids; nothing where that is not known.
  std::array<std::optional<long>, 3> betti;
};

/// The homology of {mode >= m} and {mode <= m} above dimension 0, with coefficients modulo 2.
struct ModeHomology {
  /// Of kind superlevel or sublevel. In dimension 1 those loops of which it is proved which birth
  /// and death belong together; in dimension 2 all voids. Voids of {mode >= m} are born as m falls
  /// and gone, filled, at a minimum of the mode inside of the mesh.
  std::vector<PersistencePair> pairs;
  std::vector<LoopEvent>
      loops;  ///< in dimension 1: superlevel first, in the order in which they are
  /// Of {mode >= m}, and of {mode <= m}; by growing mode.
  std::array<std::vector<BettiInterval>, 2> betti;
  std::array<long, 3> mesh_betti{};  ///< of the mesh
  /// Points whose effect on voids is not proved, for {mode >= m} and {mode <= m}.
  std::array<std::size_t, 2> not_proved{};
  std::size_t isotropic_vertices = 0;  ///< vertices without a mode: they count as part of no set
  /// All degenerate curves are known, and where they meet the boundary. If not, no loops are paired
  /// and no Betti number is known.
  bool has_known_curves = true;
  /// All changes add up to the Betti numbers of the mesh, for superlevel and sublevel sets. Where
  /// all points are proved and they do not, a change is missing, and no Betti number is known.
  std::array<bool, 2> adds_up{};
};

/// Voids and loops of the sets {mode >= m} and {mode <= m}.
///
/// By Alexander duality the voids of {mode >= m} are the components of {mode < m} together with
/// what is outside of the mesh, but for one for each part of the mesh. So they are paired as
/// components are, in the merge tree of the opposite mode to which the boundary surfaces are added.
/// At a critical point {mode >= m} changes as by a cone over the part of the link with a larger
/// mode. Each component of that part but one joins components or makes a loop, each of its loops
/// makes a void or fills a loop; what is not the one is the other.
/// Loops of different components of {mode >= m} are independent, and so are, by duality, loops
/// around different components of the rest. So a birth and a death of loops are a pair if no other
/// loop is there in their component. Others are left open.
/// @pre the mesh does not overlap itself
ModeHomology mode_homology(const TetMesh& mesh, const PersistenceInput& input);

}  // namespace tensortopo
