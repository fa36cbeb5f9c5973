// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Where a linear field on a face is degenerate.
#pragma once

#include <span>
#include <vector>

#include "curves/conic_arc.hpp"
#include "level.hpp"

namespace certificate {

/// The two kinds of degenerate tensors, by the sign of the mode.
enum class Kind : signed char { planar = -1, linear = 1 };

/// A degenerate point inside a face, on an arc without another.
class FacePoint {
 public:
  FacePoint(Arc<mpz_class> arc, int side) : arc_(std::move(arc)), side_(side) {}

  const Arc<mpz_class>& arc() const { return arc_; }
  /// A coefficient of a weight on the arc; all are positive.
  mpz_class weight(std::size_t corner, std::size_t k) const {
    return side_ * arc_.weight[corner][k];
  }
  /// Takes a shorter arc: mostly by a factor of a million, at least half of it.
  void sharpen();

 private:
  Arc<mpz_class> arc_;
  int side_;
};

struct FacePoints {
  bool decided = true;
  std::vector<FacePoint> points;
  bool by_integers = false;  ///< doubles left something open
};

/// Is it proved that no combination of the tensors with weights that are not negative is degenerate
/// of a kind? In doubles with an error bound.
bool is_free(std::span<const Tensor<Ball>* const> corners, Kind kind);

/// The points of a closed face that are degenerate of a kind. Undecided if they are not finitely
/// many, or some are on its edges or twofold.
/// @pre no tensor is zero
FacePoints points_in_face(const std::array<Corner, 3>& corners, Kind kind);

}  // namespace certificate
