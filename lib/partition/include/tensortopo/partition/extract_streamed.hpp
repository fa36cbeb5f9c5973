// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// A mesh in pieces that are read one at a time.
struct PieceSource {
  std::int32_t pieces = 0;  ///< how many there are
  /// One of the pieces, the same whenever it is read: valid, with points of its own. What it throws
  /// reaches the caller.
  std::function<TetMesh(std::int32_t piece)> read;
};

/// The surface of a mesh that was never in memory as a whole.
struct StreamedSurface {
  MergedSurface merged;    ///< ids count points and tetrahedra as if all pieces were read in order
  std::size_t points = 0;  ///< of the whole mesh
  std::size_t tets = 0;    ///< of the whole mesh
  std::string field_sha256;  ///< as of the whole mesh; with `keep_topology`, else empty
};

/// The mode surface of a mesh, piece after piece: the same bits as `extract_mode_surface` gives for
/// the whole. Points of different pieces in one place become one.
///
/// Memory    A few pieces at a time, the points on the boundaries of all pieces, and the surface
///           with the tetrahedra that it crosses.
/// Reads     each piece once for the numbers of its points and once for itself and its neighbours
///           (again where more than four are asked for in turn), and three times for the hash.
/// @param options  `density` must be empty
/// @throws std::invalid_argument if pieces have different tensors at one place, or two points of
///         one piece lie where another piece has one; it names the place
StreamedSurface extract_streamed(const PieceSource& source, const ModeValue& mode,
                                 const ExtractOptions& options = {});

}  // namespace tensortopo
