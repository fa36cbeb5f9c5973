// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "analyze/curvature/level_extremality.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Ridges: the larger principal curvature is largest along its direction. Valleys: the smaller one
/// is smallest along its own. With the opposite normal each is the other.
enum class RidgeKind : std::size_t { ridge, valley };

/// Why a line of ridges or valleys ends.
enum class RidgeEnd : std::size_t {
  boundary,   ///< the surface does
  face,       ///< across a face of the mesh the derivatives of the field are others
  turn,       ///< the extremum becomes one of the other sign
  umbilic,    ///< at a triangle that is skipped: its directions do not agree
  flat,       ///< at one where the curvature is constant along its direction, up to rounding
  undefined,  ///< at one where the mode has no gradient
};
inline constexpr std::size_t kRidgeEnds = 6;

struct RidgeLines {
  /// One of each point, with what is interpolated there.
  std::vector<Vector3<double>> points;
  std::vector<double> curvature;        ///< the principal curvature that is extremal
  std::vector<double> other_curvature;  ///< the other one
  /// How fast its derivative along its direction falls (ridges) or rises (valleys): how sharp the
  /// extremum is, in 1 / length^3.
  std::vector<double> strength;

  struct Line {
    RidgeKind kind{};
    std::vector<SurfaceMesh::Index> points;  ///< two or more; a closed one ends where it begins
    std::array<RidgeEnd, 2> ends{};          ///< at the first and at the last point, if it is open
    double length = 0;
    double strength = 0;      ///< the mean along it
    double strongest = 0;     ///< the largest at a point
    double crest_length = 0;  ///< see `Sum`, as the next two
    std::size_t bridges = 0;
    double bridge_length = 0;
    bool is_closed() const { return points.front() == points.back(); }
  };
  std::vector<Line> lines;

  /// Of ridges and of valleys.
  struct Sum {
    std::size_t lines = 0, closed = 0;
    double length = 0;
    /// Of the parts where the curvature is larger in magnitude than the other (crest lines).
    double crest_length = 0;
    double strongest = 0;
    std::size_t flat_triangles = 0;  ///< skipped: the derivative is zero up to rounding
    std::array<std::size_t, kRidgeEnds> ends{};
    /// Where a line comes to an edge of the surface in a face of the mesh, and goes on from another
    /// point of that edge: both are joined along it.
    std::size_t bridges = 0;
    double bridge_length = 0;
    std::size_t left_out = 0;  ///< lines that `filtered` left out, and that nothing else counts
    double left_out_length = 0;

    void add(const Line& line);
  };
  std::array<Sum, 2> sums{};
  std::size_t umbilic_triangles = 0, undefined_triangles = 0;  ///< skipped
};

/// The ridges and valleys of an extracted surface, by the derivatives of the field.
///
/// In each triangle the principal directions at the corners are turned to agree, and the derivative
/// of the curvature along them (`extremality`) is interpolated linearly (K. Hildebrandt, K.
/// Polthier and M. Wardetzky, Smooth feature lines on surface meshes, 2005): it vanishes on a
/// segment or nowhere, and its slope tells maxima from minima. Where directions cannot be turned to
/// agree the triangle is skipped: an umbilic is near. In a tetrahedron segments share their ends;
/// across a face see `Sum::bridges` and `RidgeEnd::face`. Nothing of this is proved.
/// @param surface  with `tet`, indices into the mesh
/// The result does not depend on the number of threads.
RidgeLines surface_ridges(const SurfaceMesh& surface, const TetMesh& mesh);

/// The ridges and valleys by curvatures that are known at vertices, one each, as those that are
/// recovered: their derivatives are those of linear interpolation, averaged around each vertex by
/// area (Hildebrandt, Polthier and Wardetzky). Lines do not end at faces of the mesh.
RidgeLines ridges_of(const SurfaceMesh& surface,
                     const std::vector<std::optional<LevelCurvature<double>>>& vertices);

/// The same from what is known at the corners, three a triangle. Corners of triangles of one
/// tetrahedron must agree where they share a vertex.
RidgeLines ridges_of(const SurfaceMesh& surface,
                     const std::vector<std::optional<LevelExtremality<double>>>& corners);

/// Which lines to keep: on sampled fields most are short, faint, and mean nothing.
struct RidgeFilter {
  double least_strength = 0;  ///< of the mean along a line, in 1 / length^3
  double least_length = 0;
  bool keeps(const RidgeLines::Line& line) const {
    return line.strength >= least_strength && line.length >= least_length;
  }
};

/// The lines that the filter keeps, whole, and only their points; sums count what is left out.
RidgeLines filtered(const RidgeLines& ridges, const RidgeFilter& filter);

}  // namespace tensortopo
