// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "extract/topology/boundary/face_curves.hpp"
#include "extract/topology/regions/face_parts.hpp"

namespace tensortopo {

/// The vertices of a tetrahedron named, as a simplex of their own.
template <std::size_t Count, class Scalar>
LevelSimplex<Scalar, Count> part_of_simplex(const LevelSimplex<Scalar, 4>& tet,
                                            const std::array<std::uint8_t, Count>& vertices) {
  LevelSimplex<Scalar, Count> part;
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t v = vertices[i];
    part.tensors[i] = tet.tensors[v];
    part.above[i] = tet.above[v];
    part.exact[i] = tet.exact[v];
    part.exponents[i] = tet.exponents[v];
  }
  return part;
}

/// A place in the superlevel set, next to a curve of it: any corner there of the first triangle
/// that the curve runs through.
template <class Scalar>
std::optional<std::array<double, 3>> superlevel_place(const LevelSimplex<Scalar, 3>& face,
                                                      const FaceArc<Scalar>& arc,
                                                      const Level<Scalar>& level);

/// Separates the closed curves of a face by the parts of the face in the superlevel set that they
/// bound.
template <class Scalar>
class ClosedCurves {
 public:
  /// @param arcs all curves of the level in the face
  ClosedCurves(const LevelSimplex<Scalar, 3>& face, const Level<Scalar>& level,
               std::span<const FaceArc<Scalar>> arcs);
  ClosedCurves(const ClosedCurves&) = delete;
  ClosedCurves& operator=(const ClosedCurves&) = delete;

  /// The closed curve that alone bounds the part with a place that is in the superlevel set; -1 if
  /// there is none, or if it was taken before.
  int take(const std::array<double, 3>& place);

 private:
  LevelSimplex<Scalar, 3> face_;
  FaceParts<Scalar> parts_;
  bool built_ = false;
  std::map<std::uint32_t, int> curve_;
};

}  // namespace tensortopo
