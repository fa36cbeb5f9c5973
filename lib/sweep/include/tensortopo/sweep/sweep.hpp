// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The mode surface of one mode, extracted.
struct SweepLevel {
  ModeValue mode;                 ///< exact
  std::size_t components = 0;     ///< connected by edges
  long euler_characteristic = 0;  ///< of all components
  long boundary_loops = 0;        ///< of all components
  double area = 0;                ///< in units of the mesh, squared
  /// Tetrahedra without a proof; the rest does not tell the topology then.
  std::size_t unresolved = 0;
};

/// A critical value, or several that doubles do not separate.
struct SweepEvent {
  /// All of them are within.
  double low = 0, high = 0;
  std::vector<MeshCriticalPoint> points;  ///< at least one
  /// By how much the level's Euler characteristic grows, if known of each point.
  std::optional<long> euler_change() const;
  /// The least and the most by which components and boundary loops grow; nothing if a point is
  /// undecided.
  std::optional<std::array<GrowthBounds, 2>> growth() const;
};

/// The modes between two events, and with what topology: the same for all of them.
struct SweepInterval {
  /// The modes in between.
  double low = 0, high = 0;
  /// From the levels extracted and the events between; nothing if these don't tell.
  std::optional<long> euler_characteristic;
  /// A level extracted from this interval, as an index into `levels`.
  std::optional<std::size_t> level;
};

/// Topology against the mode.
struct Sweep {
  std::vector<SweepLevel> levels;          ///< by mode
  std::vector<std::size_t> samples;        ///< those asked for, as indices into `levels`
  std::vector<SweepEvent> events;          ///< disjoint, ascending
  std::vector<SweepInterval> intervals;    ///< one more: before, between and after them
  std::array<std::size_t, 4> looked_at{};  ///< see `MeshCriticalValues`
  /// Levels whose Euler characteristic is not what the others and the events between say, as
  /// indices into `levels`. There should be none.
  std::vector<std::size_t> contradictions;
};

/// So many intervals are looked at in any case.
inline constexpr std::size_t kWidestIntervals = 5;

/// Which modes, and how many levels are extracted.
struct SweepOptions {
  /// The ends, from < to.
  ModeValue from, to;
  std::size_t samples = 2;  ///< evenly spaced, the ends included (but not -1 and 1); at least 2
  /// A level is extracted in each interval if there are no more of them than this, else in the
  /// `kWidestIntervals` widest; then components and loops are known there and at the samples only,
  /// and the Euler characteristic everywhere. 0: at the samples only.
  std::size_t most_levels = 250;
};

/// The diagram of topology against the mode: every event from one mode to another, and the levels
/// between. Throws std::invalid_argument if the options make no sense.
/// @param mesh  valid
/// @param progress  called now and then, from one thread at a time, with the stage and how much of
///                  it is done; what it throws ends the sweep
/// The result does not depend on the number of threads.
Sweep sweep_modes(const TetMesh& mesh, const SweepOptions& options,
                  const std::function<void(std::string_view, double)>& progress = {});

/// A short decimal between two doubles, as a mode. Nothing if they are neighbours, or both within
/// 1e-280 of zero and on one side of it.
/// @pre -1 <= low < high <= 1
std::optional<ModeValue> mode_between(double low, double high);

}  // namespace tensortopo
