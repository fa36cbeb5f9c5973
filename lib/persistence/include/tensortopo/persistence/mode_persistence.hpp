// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "tensortopo/persistence/persistence_pairs.hpp"

namespace tensortopo {

/// Which sets a component is one of.
enum class PairKind {
  superlevel,  ///< {mode >= m}: born at a maximum, gone at the mode at which it meets an older one
  sublevel,    ///< {mode <= m}: born at a minimum
  extended,    ///< a whole part of the mesh: born at its largest mode, gone at its least one
};

std::string_view name_of(PairKind kind);

/// A pair of critical values of the mode: of a component, or of a class of cycles of a larger
/// dimension.
struct PersistencePair {
  int dimension = 0;                     ///< 0: a component; 1: a loop; 2: a void
  PairKind kind = PairKind::superlevel;  ///< of which sets
  /// The modes at which it is born and gone.
  ModeRange birth, death;
  /// About where that is.
  Vector3<double> birth_point{}, death_point{};
  /// Tetrahedra that these are in.
  TetMesh::Index birth_tet = -1, death_tet = -1;
  bool is_tie = false;     ///< see `MergePair`
  bool is_certain = true;  ///< see `MergePair`
  bool has_death = true;   ///< if not, it may meet older ones, at a mode not known
  bool is_lasting = false; ///< a class of the mesh itself, which has no death (dimensions 1 and 2)
  /// The component of the curves at which it is born: of mode 1 (sublevel: -1). Of dimension 2 at
  /// which it dies: of mode -1 (sublevel: 1).
  std::optional<std::size_t> curve;
};

/// A component of the degenerate curves.
struct CurvePersistence {
  int mode = 1;               ///< or -1
  std::size_t component = 0;  ///< as extraction numbers them, for each mode from 0
  bool is_closed = false;     ///< it has no end
  double length = 0;          ///< in units of the mesh
  std::size_t pair = 0;       ///< as an index into `ModePersistence::pairs`
};

/// The persistence of a field's mode in dimension 0.
struct ModePersistence {
  std::vector<PersistencePair> pairs;    ///< of all kinds
  std::vector<CurvePersistence> curves;  ///< of mode 1, then of mode -1
  /// Critical points whose link, or the paths from which, are not proved, for {mode >= m} and for
  /// {mode <= m}; as indices into the critical values.
  std::array<std::vector<std::size_t>, 2> not_proved;
  /// Tetrahedra in which the curves of mode 1 and -1 are not known: what is said holds but for
  /// extrema in them.
  std::array<std::size_t, 2> unresolved_curve_cells{};
};

/// The signed Lode angle arcsin(mode) / 3, in [-pi/6, pi/6].
double signed_lode_angle(double mode);

/// Persistence in the signed Lode angle: at least this much, given the enclosures.
double angle_persistence(const PersistencePair& pair);

/// The relative noise r that the pair survives: fields with |D - D'| <= r |D| have signed Lode
/// angles that differ by arcsin r at most, so what has a persistence of more than 2 arcsin r has a
/// counterpart in each of them (theory, `lasting-features`). Without isotropic points.
double survived_noise(const PersistencePair& pair);

/// What persistence is computed from.
struct PersistenceInput {
  MeshCriticalValues values;              ///< all from -1 to 1, both included
  std::array<CurveExtraction, 2> curves;  ///< of mode 1 and of mode -1
  std::array<MergeTree, 2> trees;         ///< of the mode, and of its opposite
};

/// What persistence is computed from, stage by stage.
/// @param mesh  valid
/// @param progress  called now and then with the stage and how much of it is done
PersistenceInput persistence_input(
    const TetMesh& mesh, const std::function<void(std::string_view, double)>& progress = {});

/// The persistence of the mode in dimension 0, and of degenerate curves.
/// The result does not depend on the number of threads.
ModePersistence mode_persistence(const TetMesh& mesh, const PersistenceInput& input);

}  // namespace tensortopo
