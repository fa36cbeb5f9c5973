// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace tensortopo {

/// How densely curves and sheets are sampled.
struct Sampling {
  /// Samples per unit (radian) of turning of the medium eigenvector; positive and finite.
  double resolution = 4;
  /// The largest turning between neighbouring samples, in radians.
  double largest_turn() const { return 1 / resolution; }
};

/// How sheets that turn too far for a disc without inner samples are meshed.
enum class MeshingMethod {
  /// Discs and tubes by bisection: their boundary loops are filled with triangles, whose edges are
  /// bisected at points of the level. Other sheets, and those of which triangles would intersect so,
  /// on the manifold.
  bisection,
  manifold,  ///< on the medium eigenvector manifold, as in the paper
};

/// How a mode surface is extracted. No option changes its topology.
struct ExtractOptions {
  Sampling sampling;                                ///< how densely
  MeshingMethod meshing = MeshingMethod::bisection;  ///< how large sheets are meshed
  /// For each tetrahedron of the mesh by how much denser its samples are than `sampling` says; a
  /// face has the denser ones of its two. Positive and finite; empty for 1 everywhere.
  std::vector<float> density;
  /// Keep the samples of face curves that meshing on the manifold needed, but that make needles of
  /// the triangles beside them and that the level can do without. They are dropped otherwise.
  bool keep_samples = false;
  /// Give triangles that intersect another of their tetrahedron, or are at 90 degrees or more to the
  /// gradient of the mode at their centroid, other diagonals, vertices and samples until there are
  /// none, decided exactly for the coordinates that are written. Tetrahedra where some are left are
  /// listed in `Extraction::not_embedded`; nothing is looked at, or listed, without this.
  bool embedded = true;
  bool keep_topology = false;  ///< fill `Extraction::topology`
  /// Of each tetrahedron, a part that it belongs to: what tetrahedra of different parts tell each
  /// other is kept in `Extraction::messages`. Empty: nothing is kept.
  std::vector<char> part;
  /// Called now and then, from one thread at a time, with the stage and how much of it is done.
  std::function<void(std::string_view stage, double fraction)> progress;
};

/// Throws std::invalid_argument, with the reason, unless the options fit a mesh of so many
/// tetrahedra: `resolution` and `density` are positive and finite, and `density` and `part` empty
/// or of one entry for each tetrahedron. All that extract ask this first.
void require_fitting(const ExtractOptions& options, std::size_t tets);

}  // namespace tensortopo
