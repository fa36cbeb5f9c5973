// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tensortopo/mesh/torn_faces.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// A mesh in pieces that are read one at a time.
struct PieceSource {
  std::int32_t pieces = 0;  ///< how many there are
  /// One of the pieces, the same whenever it is read: valid, with points of its own. What it throws
  /// reaches the caller.
  std::function<TetMesh(std::int32_t piece)> read;
};

namespace detail {
struct PieceIndex;
}

/// A mesh that is never in memory as a whole. Points of different pieces in one place are one.
///
/// Ids count points and tetrahedra as if all pieces were read in order.
/// Memory    the points and tetrahedra on the boundaries of all pieces.
class StreamedMesh {
 public:
  /// Reads each piece twice.
  /// @throws std::invalid_argument if pieces have different tensors at one place, two points of one
  ///         piece lie where another piece has one, or pieces overlap: a face has three tetrahedra,
  ///         or two on one side, or a point of one piece is inside another; it names the place
  explicit StreamedMesh(PieceSource source);

  /// The pieces.
  const PieceSource& source() const { return source_; }
  /// The numbers of their points and tetrahedra.
  const detail::PieceIndex& index() const { return *index_; }
  /// How many points the whole mesh has.
  std::size_t points() const;
  /// How many tetrahedra the whole mesh has.
  std::size_t tets() const;
  /// Where pieces, or the cells of one, meet without sharing faces: as `torn_faces` of the whole.
  const TornFaces& torn_faces() const;
  /// Whether several pieces have points, and none of these is in two.
  bool is_in_parts() const;
  /// As `field_sha256` of the whole mesh. Reads each piece three times.
  std::string field_sha256() const;

 private:
  PieceSource source_;
  std::shared_ptr<const detail::PieceIndex> index_;
};

/// The mode surface of a mesh, piece after piece: the same bits as `extract_mode_surface` gives for
/// the whole.
///
/// Memory    A few pieces at a time, and the surface with the tetrahedra that it crosses.
/// Reads     each piece once for itself and its neighbours; again where more than four are asked
///           for in turn.
/// @param options  `density` and `part` must be empty
/// @throws std::invalid_argument if they are not, and as `require_fitting`
MergedSurface extract_streamed(const StreamedMesh& mesh, const ModeValue& mode,
                               const ExtractOptions& options = {});

/// The degenerate curves of a mesh, likewise: the same bits as `extract_degenerate_curves` gives.
MergedCurves extract_streamed(const StreamedMesh& mesh, Degeneracy kind,
                              const ExtractOptions& options = {});

}  // namespace tensortopo
