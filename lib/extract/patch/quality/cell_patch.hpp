// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/level/tet_geometry.hpp"
#include "extract/patch/patch.hpp"
#include "extract/patch/patch_defects.hpp"
#include "extract/patch/patch_extents.hpp"

namespace tensortopo {

/// The triangles of one tetrahedron, from which samples of its faces' curves can be taken out: a
/// vertex goes to a neighbour on its curve, and the triangle between them vanishes.
class CellPatch {
 public:
  using Id = std::int32_t;

  /// @param level in double, whatever the scalar of the extraction is; it has to outlive this
  template <class Scalar>
  CellPatch(const TetWithCurves<Scalar>& tet, const Level<double>& level,
            const FaceArcVertices& boundaries, const Patch<Scalar>& patch);

  /// The sine of the least angle, at most 60 degrees, of the triangles around a vertex.
  double least_sine_around(Id vertex) const;

  /// The same with the vertex moved to a neighbour on its curve.
  /// @param least_cosine of a triangle's normal and the gradient of the mode at its corners
  /// @return 0 if it is below `least_sine`, or if sheets would change their topology, touch a face,
  ///         or turn over
  double least_sine_after(Id vertex, Id neighbour, double least_sine, double least_cosine);

  /// Whether the triangles that the vertex's become when it moves to a neighbour face larger modes,
  /// and intersect none (see `PatchDefects`).
  bool is_embedded_after(Id vertex, Id neighbour);

  /// How far the level is from the triangles around a vertex, at most, at the middles of their
  /// edges and of themselves, to first order and in longest edges of the tetrahedron.
  double offset_around(Id vertex) const;

  /// The same with the vertex moved to a neighbour.
  double offset_after(Id vertex, Id neighbour) const;

  /// Twice the vector area of a closed polygon.
  Vector3<double> area_of(std::span<const Id> polygon) const;

  void move(Id vertex, Id neighbour);

  /// How many moves were made.
  std::uint32_t turn() const { return turn_; }

  /// Whether all that the questions about a vertex and its neighbours look at is as it was after so
  /// many moves: the triangles around these, and those that refused a move.
  bool is_unchanged_since(std::uint32_t turn, Id vertex, const std::array<Id, 2>& neighbours) const;

  std::vector<std::array<Id, 3>> triangles() const;

 private:
  using Place = std::uint32_t;
  using Triangle = std::array<Place, 3>;
  struct Corner {
    Vector3<double> position;  ///< in a unit of the tetrahedron's size
    Vector3<double> up;        ///< unit gradient of the mode; zero while nobody asked
    std::uint8_t faces = 0;    ///< of the tetrahedron, that hold the vertex
  };

  /// Why a vertex may not move to a neighbour: a triangle that would be intersected, or the
  /// vertex's own triangles. It holds until one of these changes.
  struct Refusal {
    static constexpr std::uint32_t kNone = 0xffffffff;
    Place neighbour = 0;
    std::uint32_t intersected = kNone;
    std::uint32_t turn = 0;  ///< of `changed_`
  };

  Place place_of(Id id) const;
  /// Of a vertex and a neighbour; null if there is none.
  Refusal* refusal_of(Place v, Place u);
  bool is_unchanged_around(Place v, std::uint32_t turn) const;
  bool is_still_refused(Place v, Place u);
  void refuse(Place v, Place u, std::uint32_t intersected);
  bool keeps_sheets(Place v, Place u) const;
  const Vector3<double>& up(Corner& corner) const;
  Vector3<double> normal(const Triangle& t) const;
  double offset_at(const Vector3<double>& x) const;
  double offset_of(const Triangle& t) const;

  std::array<Deviator<double>, 4> tensors_;
  const Level<double>* level_;
  TetGeometry geometry_;
  double length_;
  std::vector<Id> ids_;  ///< ascending
  std::vector<Corner> corners_;
  std::vector<Vector3<double>> places_;  ///< of the corners, as they are written
  UpwardTest upward_;
  std::optional<PatchExtents> extents_;  ///< once they are asked for
  std::vector<Triangle> triangles_;      ///< with three times the same corner: taken out
  using Star = boost::container::small_vector<std::uint32_t, 6>;
  std::vector<Star> around_;            ///< the triangles of each corner, ascending
  std::uint32_t turn_ = 0;              ///< moves made
  std::vector<std::uint32_t> changed_;  ///< the last move that changed each triangle
  std::vector<std::uint32_t> lost_;     ///< the last move that took a triangle from each corner
  std::vector<boost::container::small_vector<Refusal, 2>> refusals_;  ///< of each corner
};

}  // namespace tensortopo
