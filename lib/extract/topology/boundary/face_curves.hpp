// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/container/small_vector.hpp>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "extract/run/budget.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "extract/subdivision/refinement.hpp"
#include "extract/topology/boundary/edge_crossings.hpp"

namespace tensortopo {

/// An end of an arc: a crossing of one of the triangle's edges.
struct ArcEnd {
  int edge = -1;     ///< 0: vertices 0 1; 1: vertices 0 2; 2: vertices 1 2
  int crossing = 0;  ///< which of that edge's crossings, in their order
};

/// The corners of a face, as homogeneous weights in it.
inline constexpr std::array<std::array<double, 3>, 3> kFaceCorners{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// A triangle within a face.
template <class Scalar>
struct FacePart {
  std::array<std::array<double, 3>, 3> corners;  ///< homogeneous weights in the face
  std::array<Deviator<Scalar>, 3> tensors;       ///< at those corners
};

/// A stretch of a mode curve inside one monotone triangle: the curve is a graph across
/// `direction`, so the point above each place of the segment from `begin` to `end` is unique.
template <class Scalar>
struct ArcPiece {
  /// The monotone triangle if it is not the whole face. Nearly always it is, and what is known of
  /// the face need not be kept once more.
  std::shared_ptr<const FacePart<Scalar>> part;
  std::array<Scalar, 3> direction;   ///< barycentric in the monotone triangle
  std::array<Scalar, 3> begin, end;  ///< barycentric in the monotone triangle

  const std::array<std::array<double, 3>, 3>& corners() const {
    return part ? part->corners : kFaceCorners;
  }
  /// @param face the tensors at the face's corners
  const std::array<Deviator<Scalar>, 3>& tensors(
      const std::array<Deviator<Scalar>, 3>& face) const {
    return part ? part->tensors : face;
  }
};

/// A point of a mode curve.
template <class Scalar>
struct CurvePoint {
  Scalar place{};                   ///< index of the piece plus the fraction along it
  std::array<Scalar, 3> weights{};  ///< in the face
  Deviator<Scalar> tensor{};
  Vector3<Scalar> medium{};  ///< unit medium eigenvector, sign arbitrary
};

/// One mode curve in a triangle: an arc between two crossings of its edges, or a closed loop.
/// The larger mode lies to its left, seen from where the triangle's vertices run
/// counter-clockwise.
template <class Scalar>
struct FaceArc {
  bool closed = false;
  ArcEnd begin, end;                        ///< unless closed
  boost::container::small_vector<ArcPiece<Scalar>, 1> pieces;  ///< in order; mostly one
  std::vector<CurvePoint<Scalar>> samples;  ///< inner samples, in order; closed: all samples
  const Level<Scalar>* level = nullptr;     ///< that it was traced at, if not the extraction's
};

/// All mode curves of the level in a triangle, loops that touch no edge included.
///
/// Completeness is proved: the triangle is cut into triangles in each of which the level is empty
/// or monotone and crosses each side at most once. Each curve is then traced through its triangles
/// as a graph, sampled by the turning of the medium eigenvector. An arc with both ends on one
/// edge has an inner sample, a loop at least three.
///
/// @param triangle   vertices in the order of their global ids
/// @param crossings  of its edges 01, 02, 12, each in the order of its vertices
/// @return nothing if the proof does not close (the level is critical in the triangle, or runs
///         along it) or the edges' crossings contradict it
template <class Scalar>
std::optional<std::vector<FaceArc<Scalar>>> face_curves(
    const LevelSimplex<Scalar, 3>& triangle,
    const std::array<std::span<const EdgeCrossing<Scalar>>, 3>& crossings,
    const Level<Scalar>& level, const Sampling& sampling, Budget budget = Budget::regular);

/// The point of an arc at a place (index of the piece plus the fraction along it).
/// @param face the tensors at the corners of the arc's face
template <class Scalar>
CurvePoint<Scalar> point_on_arc(const FaceArc<Scalar>& arc,
                                const std::array<Deviator<Scalar>, 3>& face, const Scalar& place,
                                const Level<Scalar>& level);

/// The place on one of the arcs nearest to a point of the level given by its weights and by the
/// field there.
/// @param face the tensors at the corners of the arcs' face
/// @return index of the arc, and the place; -1 if there is none
template <class Scalar>
std::pair<int, Scalar> locate_on_arcs(std::span<const FaceArc<Scalar>> arcs,
                                      const std::array<Deviator<Scalar>, 3>& face,
                                      const std::array<Scalar, 3>& weights,
                                      const Deviator<Scalar>& tensor);

/// The cosine of the angle between two lines, in [0, 1].
template <class Scalar>
Scalar line_cosine(const Vector3<Scalar>& u, const Vector3<Scalar>& v) {
  const Scalar c = dot(u, v);
  return c < Scalar(0) ? -c : c;
}

}  // namespace tensortopo
