// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"

namespace tensortopo {

/// An enclosure of a mode.
struct ModeRange {
  /// Bounds, both included.
  double low = -1, high = 1;
  /// Halfway between them.
  double middle() const { return low + (high - low) / 2; }
  /// Whether a mode may be in both.
  bool overlaps(const ModeRange& other) const { return low <= other.high && other.low <= high; }
};

/// A local maximum of the mode, at which a component of {mode >= m} is born: a component of the
/// degenerate curves of mode 1, or a point.
struct ModeMaximum {
  ModeRange mode;                    ///< there
  std::optional<std::size_t> curve;  ///< component of the degenerate curves
  double length = 0;                 ///< of that
  bool is_closed = false;            ///< the curve has no end
  /// The simplex that holds it (of a curve a tetrahedron that it meets); -1 fills up.
  std::array<TetMesh::Index, 4> vertices{-1, -1, -1, -1};
  /// Of a point: which one, as an index into `MeshCriticalValues::points`.
  std::optional<std::size_t> critical_point;
  Vector3<double> point{};  ///< about where; of a curve, a vertex of it
  TetMesh::Index tet = -1;  ///< one that it is in
};

/// A critical point of the mode from which it rises in several separate directions, so that
/// components of {mode >= m} may meet there.
struct ModeMerge {
  std::size_t point = 0;    ///< as an index into `MeshCriticalValues::points`
  ModeRange mode;           ///< there
  TetMesh::Index tet = -1;  ///< one that it is in
  /// For each part of the link with a larger mode a maximum of the component into which it leads: one
  /// to which a path leads along which the mode is larger than at the point, or the only one that
  /// the component can have. Parts for which neither is proved are left out.
  std::vector<std::size_t> reached;
  /// One for each of `reached`, if the link is known: the part touches the link's boundary, and so
  /// the point reaches the boundary of the mesh by it.
  std::vector<char> touches_boundary;
  /// The link is known, and each part of it has its maximum.
  bool is_proved = false;
  /// The same of the parts that do not touch the boundary of the mesh.
  bool is_proved_inside = false;
  /// If it is not proved: all maxima in whose components the point may be, and perhaps others;
  /// nothing if these are not known. (None are known that are no maxima of the tree.)
  std::optional<std::vector<std::size_t>> possible;
  /// It is not known whether the mode rises from there: a component may be born instead.
  bool may_be_maximum = false;
};

/// How the components of {mode >= m} of a piecewise linear field come and meet as m falls.
struct MergeTree {
  std::vector<ModeMaximum> maxima;  ///< curves first
  std::vector<ModeMerge> merges;    ///< by falling mode
  /// Critical points from which the mode rises in one part of the link, with the path from there: on
  /// the boundary of the mesh, where the part does not touch it, a component of {mode >= m} comes to
  /// touch the boundary. Others change its loops and voids. By falling mode.
  std::vector<ModeMerge> others;
};

/// The merge tree of the mode.
///
/// By stratified Morse theory components of {mode >= m} are born at local maxima, which are the
/// degenerate curves and points whose link has no part with a larger mode, and meet at points whose
/// link has several. From each part of such a link a path leads up to a maximum. The paths consist
/// of segments inside tetrahedra on each of which the mode is proved to be larger than at the point
/// (`is_mode_above`), the first one by the sign of derivatives (`rise_from`). Where they run is
/// found in floating point. Where none is found, the maxima that the component can have are
/// enclosed, and if that is a single one it is taken. Components of isotropic points are left out of the domain.
///
/// A path to a curve ends at a vertex of the extracted polyline, and the mode is proved to be
/// larger around it up to 2^-36 of the tensor's size; that the curve's own point is that close to
/// its rounded vertex is taken from the extraction.
/// @param mesh  valid
/// @param values  all of -1 to 1
/// @param curves  those of mode 1
MergeTree merge_tree(const TetMesh& mesh, const MeshCriticalValues& values,
                     const CurveExtraction& curves);

/// A maximum to which a path leads from each of these critical points, along which the mode is
/// larger than at it; nothing where none is proved, or the point is a maximum itself.
/// @param tree  of the same mesh, critical points and curves
std::vector<std::optional<std::size_t>> maxima_above_points(const TetMesh& mesh,
                                                            const MeshCriticalValues& values,
                                                            const CurveExtraction& curves,
                                                            const MergeTree& tree,
                                                            std::span<const std::size_t> points);
/// The same from vertices of the mesh; of a maximum itself.
std::vector<std::optional<std::size_t>> maxima_above_vertices(
    const TetMesh& mesh, const MeshCriticalValues& values, const CurveExtraction& curves,
    const MergeTree& tree, std::span<const TetMesh::Index> vertices);

/// The field with the opposite tensors, whose mode is the opposite: its merge tree is that of
/// {mode <= m}.
TetMesh opposite(TetMesh mesh);
/// The critical points of the opposite field, in the same order.
MeshCriticalValues opposite(MeshCriticalValues values);

}  // namespace tensortopo
