// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/level_distance.hpp"
#include "conformance/score.hpp"

namespace tensortopo {

/// What a method's surfaces of all modes together got wrong.
struct MethodErrors {
  std::string method, setting;
  std::size_t triangles = 0;
  LevelDistance distance;
  /// Against the certified truth: components (also those with another topology), crossings of mesh
  /// edges, holes and seams.
  std::size_t components = 0, true_components = 0, missed = 0, extra = 0, wrong_topology = 0;
  long euler_characteristic = 0, true_euler_characteristic = 0;
  std::size_t true_crossings = 0, missed_crossings = 0, extra_crossings = 0;
  std::size_t holes = 0, seam_edges = 0;
};

/// Measures surfaces of the same modes, made by whatever method.
class Judge {
 public:
  /// The resolution of the reference, which is certified.
  static constexpr double kResolution = 16;

  /// @param mesh  kept by reference
  Judge(const TetMesh& mesh, std::span<const ModeValue> modes);

  /// @param surfaces  one for each mode
  /// @param mesh      that their `tet` count in: the judge's, or a subdivision of it
  LevelDistance distance(std::span<const SurfaceMesh> surfaces, const TetMesh& mesh) const;
  LevelDistance distance(std::span<const SurfaceMesh> surfaces) const {
    return distance(surfaces, mesh_);
  }

  MethodErrors errors(std::string method, std::string setting,
                      std::span<const SurfaceMesh> surfaces, const TetMesh& mesh) const;

  /// Tetrahedra about which there is no truth, in all modes.
  std::size_t undecided() const;
  MethodErrors reference() const;

 private:
  const TetMesh& mesh_;
  std::vector<ModeValue> modes_;
  std::vector<Standard> standards_;
};

}  // namespace tensortopo
