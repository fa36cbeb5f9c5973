// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/level/tet_geometry.hpp"
#include "extract/patch/patch.hpp"
#include "extract/patch/patch_intersections.hpp"

namespace tensortopo {

/// The triangles of one cell with the places of their vertices, as they are written.
struct PlacedPatch {
  std::vector<std::int32_t> ids;  ///< of the vertices, as in `Patch`, ascending
  std::vector<Vector3<double>> points;
  std::vector<PatchTriangle> triangles;  ///< in the order of `Patch`
};

/// @param boundary the places of the vertices of boundary loops, by their ids
/// @param patch    receives it; reused, so that small patches need no memory of their own
template <class Scalar>
void place_patch(const TetWithCurves<Scalar>& tet, const Patch<Scalar>& meshed,
                 std::span<const Vector3<double>> boundary, PlacedPatch& patch);

/// Whether triangles face larger modes.
class UpwardTest {
 public:
  template <class Scalar>
  explicit UpwardTest(const TetWithCurves<Scalar>& tet)
      : UpwardTest(tet.points, tet.simplex.exponents, rounded(tet.simplex.tensors)) {}
  /// @param exponents of the scaled tensors, see `ScaledField`
  UpwardTest(const std::array<Vector3<double>, 4>& points, const std::array<int, 4>& exponents,
             const std::array<Deviator<double>, 4>& tensors);

  /// How a triangle, counter-clockwise, faces larger modes.
  struct Facing {
    /// Its normal and the gradient of the mode at its centroid are less than 90 degrees apart, and
    /// rounding cannot have changed that.
    bool is_upward = true;
    double cosine = 1;  ///< about that of the two; 1 of a triangle without area
  };
  Facing facing(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c) const;

 private:
  double unit_;
  TetGeometry geometry_;
  std::array<Deviator<double>, 4> tensors_;
};

/// What keeps triangles of a cell from being a surface that lies like the level.
struct PatchDefects {
  std::vector<std::uint32_t> against;  ///< triangles at 90 degrees to the gradient or more
  std::vector<std::array<std::uint32_t, 2>> intersecting;  ///< see `intersecting_pairs`
  std::size_t tested = 0;                                  ///< likewise
  bool are_all = true;                                     ///< likewise

  /// SIZE_MAX if not all were counted.
  std::size_t count() const { return are_all ? against.size() + intersecting.size() : SIZE_MAX; }

  bool any() const { return !against.empty() || !intersecting.empty(); }
};

/// @param most_tested  as for `intersecting_pairs`
PatchDefects defects_of(const PlacedPatch& patch, const UpwardTest& test,
                        std::size_t most_tested = SIZE_MAX);

/// Whether two vertices of the boundary loops have the same coordinates, as next to a tensor that
/// is nearly isotropic: then no triangles with these loops are embedded.
bool has_doubled_boundary(const PlacedPatch& patch);

}  // namespace tensortopo
