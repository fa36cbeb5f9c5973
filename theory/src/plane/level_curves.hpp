// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "plane/cell_forms.hpp"
#include "plane/critical_points.hpp"
#include "tensortopo/theory/random.hpp"

namespace tensortopo::theory {

/// The curves of mode mu and -mu in a triangle, traced exactly.
///
/// The triangle is cut into cells until each is empty or simple; then the curves are known from the
/// sides of cells that they cross. Curves through a critical point, or tangent to a side of the
/// triangle, are never resolved.
class LevelCurves {
 public:
  struct Closed {
    Sign mode;                 ///< of the mode along it
    std::vector<bool> inside;  ///< whether it surrounds this vertex of a cell
  };

  /// Nothing if `most_cells` do not suffice. Requires mode_squared in (0, 1).
  static std::optional<LevelCurves> trace(const Plane& plane, const Rational& mode_squared,
                                          std::size_t most_cells);

  const std::vector<Closed>& closed() const { return closed_; }
  std::size_t open_count() const { return open_; }
  /// The closed curves of modes of one sign.
  int closed_count(Sign mode) const;

  /// For each real point of a family: the cell in which it lies; nothing outside the triangle.
  std::vector<std::optional<std::size_t>> cells_of(const PointFamily& family) const;
  bool is_empty(std::size_t cell) const { return cells_[cell].kind == CellKind::empty; }
  /// Whether a closed curve surrounds an empty cell.
  bool surrounds(std::size_t curve, std::size_t cell) const {
    return closed_[curve].inside[cells_[cell].corner[0]];
  }
  bool surrounds_a_corner(std::size_t curve) const {
    const std::vector<bool>& inside = closed_[curve].inside;
    return inside[0] || inside[1] || inside[2];
  }

 private:
  using Edge = std::array<std::size_t, 2>;  // ascending

  struct Cell {
    std::array<std::size_t, 3> corner;  // the newest last; the side across it is cut next
    CellKind kind = CellKind::unclear;
    std::size_t child = 0;  // of two in a row; 0 for none
  };
  struct Corner {
    Vector3<Integer> weights;  // not negative, of any sum
    IntegerTensor tensor;
    Sign side;  // of |mode| - mu
  };

  LevelCurves(const Plane& plane, const Level& level) : plane_(plane), level_(level) {}
  bool add_corner(const Vector3<Integer>& weights);
  std::size_t cut(const Edge& edge);
  bool refine(std::size_t most_cells);
  void connect();
  Edge crossed_part(std::size_t a, std::size_t b) const;
  void surround(const std::vector<Edge>& crossed);

  Plane plane_;
  Level level_;
  Random random_{1};
  std::vector<Cell> cells_;
  std::vector<Corner> corners_;
  std::map<Edge, std::size_t> cuts_;
  std::vector<Closed> closed_;
  std::size_t open_ = 0;
};

}  // namespace tensortopo::theory
