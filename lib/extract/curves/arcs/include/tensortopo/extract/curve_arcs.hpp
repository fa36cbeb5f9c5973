// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A box that encloses a point.
struct PlaceBox {
  /// Bounds of the coordinates, both included.
  Vector3<double> low{}, high{};

  /// Its middle, rounded.
  Vector3<double> middle() const { return low + 0.5 * (high - low); }
};

/// Why nothing, or not all, is proved of a line of degenerate curves.
enum class ArcObstacle {
  special_position,  ///< the curve is in special position in its tetrahedron
  not_told_apart,    ///< 150 digits do not tell zeros from each other, or from an end
};

/// The separation of wedges and trisectors along a line, as the field of its tetrahedron has it.
struct LineSeparation {
  /// Signs where the line begins and ends: 1 wedge, -1 trisector, 0 not proved.
  int begin = 0, end = 0;
  /// Transitions inside: each box holds a point of the curve at which the separation has a simple
  /// zero. In the order of the line; they are different points.
  std::vector<PlaceBox> zeros;
  /// Enclose the points of faces at which the line begins and ends; nothing if it is in special
  /// position.
  std::array<PlaceBox, 2> ends{};
  /// If nothing: these are all zeros, and the signs are certain.
  std::optional<ArcObstacle> obstacle;
};

/// A curve's arc in a tetrahedron, enclosed.
struct EnclosedArc {
  /// Points of the curve, in the order of the line, from its begin to its end.
  std::vector<PlaceBox> points;
  /// Between two points that follow each other: the arc is in the convex hull of points in these
  /// boxes, of which the first and the last enclose the two.
  std::vector<std::array<PlaceBox, 5>> hulls;
};

/// The arcs of degenerate curves that extracted lines stand for, as exact curves.
///
/// Inside a tetrahedron in general position the dominant eigenvectors of the degenerate tensors are
/// on a conic, of which a line stands for one arc. The arc is a rational curve of degree 2 in the
/// eigenvector and 4 in space, between two points of faces that are proved; its coefficients are
/// enclosed in intervals, of doubles first, then of 150 digits. What is said below holds for all
/// numbers in these.
class CurveArcs {
 public:
  /// @param mesh    valid (see `validate`); not kept
  /// @param curves  as `extract_degenerate_curves` gives them for this mesh and kind; kept by
  /// reference
  CurveArcs(const TetMesh& mesh, Degeneracy kind, const CurveMesh& curves);
  ~CurveArcs();

  CurveArcs(const CurveArcs&) = delete;             ///< no copies
  CurveArcs& operator=(const CurveArcs&) = delete;  ///< no copies

  /// The separation along a line. Its polynomial has degree 8 in the arc's parameter; zeros are
  /// isolated by Descartes' rule for Bernstein's coefficients.
  /// @throws std::invalid_argument if there is no such line
  LineSeparation separation(std::size_t line) const;

  /// A line's arc in 2^depth parts; nothing if its position is special or 150 digits do not
  /// suffice.
  ///
  /// All points but the first and the last are inside the tetrahedron, these inside of faces.
  /// @param depth  at most `kDeepest`
  /// @throws std::invalid_argument if there is no such line, or for other depths
  std::optional<EnclosedArc> enclosed(std::size_t line, int depth) const;

  /// The largest depth of `enclosed`: a million parts.
  static constexpr int kDeepest = 20;

  /// The lines.
  const CurveMesh& curves() const { return *curves_; }

 private:
  struct Source;

  const CurveMesh* curves_;
  std::unique_ptr<const Source> source_;
};

/// A vertex at which the separation jumps from one sign to the other.
struct SeparationJump {
  CurveMesh::Index vertex = 0;         ///< of the curves, on a face of the mesh
  std::array<std::size_t, 2> lines{};  ///< that meet there, ascending
  PlaceBox place;                      ///< encloses the point of the curve
};

/// The separation along all lines.
struct CurveSeparation {
  std::vector<LineSeparation> lines;  ///< one for each line
  /// The derivative of a piecewise linear field jumps at faces, and so may the sign. Vertices in
  /// which two lines meet, with certain and different signs; ascending.
  std::vector<SeparationJump> jumps;
};

/// The separation along all lines, and where it jumps between them.
/// The result does not depend on the number of threads.
/// @param options  its `progress` only
CurveSeparation curve_separation(const CurveArcs& arcs, const ExtractOptions& options = {});

}  // namespace tensortopo
