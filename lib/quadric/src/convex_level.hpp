// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "tensortopo/quadric/copositive.hpp"
#include "tensortopo/quadric/quadric_form.hpp"

namespace tensortopo {

/// A level of an invariant as the boundary of a convex body of tensors.
///
/// {|T| <= v} and {|D| <= v} are convex. {|D| <= v |T|} is a double cone: two convex bodies,
/// the isotropic tensors of positive and of negative trace with what is close to them. They meet
/// in T = 0 only. The level of an anisotropy is therefore extracted as two, one for each nappe.
/// The level is value + 0: tensors on it belong to the body.
struct ConvexLevel : QuadraticLevel {
  int nappe = 0;  ///< 1 or -1: the sign of the trace in the body; 0: it is one piece

  /// Requires nappe 1 or -1 for an anisotropy and 0 else, or throws std::invalid_argument.
  ConvexLevel(const InvariantLevel& level, int nappe);
};

/// The place of a tensor.
enum class Side {
  inside,    ///< in the body or on the level
  outside,   ///< q > 0
  opposite,  ///< not in the body, but in the other nappe
  zero,      ///< the zero tensor, where an anisotropy is undefined
};

/// A place in a tetrahedron: homogeneous coordinates, not negative, not all 0, below 2^16.
using GridPoint = std::array<int, 4>;

/// What a convex level is to one tetrahedron of a linear field: exact answers, in doubles with an
/// error bound where these suffice, else in rationals.
///
/// Laws      (1) answers depend on the tensors and the level, not on which tier gave them;
///           (2) tensors and value times a power of two change nothing; (3) a place in a face has
///           the answer that it has in the tetrahedron on the face's other side.
class CellForm {
 public:
  /// Requires finite tensors, which must outlive this.
  CellForm(const ConvexLevel& level, const std::array<const SymmetricTensor<double>*, 4>& tensors);
  ~CellForm();

  Side side(const GridPoint& p) const;
  /// Whether q = 0 there and the tensor is not zero.
  bool is_on_level(const GridPoint& p) const;

  /// Whether some tensor of the tetrahedron is zero.
  bool holds_zero() const;

  /// Whether and where the body meets the simplex with these two to four corners, all of them
  /// `outside`, given that no proper face is met by either nappe: `outside` if it does not,
  /// `inside` if this nappe does, `opposite` if the other one, `zero` if in T = 0 at least.
  Side meeting(std::span<const GridPoint> corners) const;

  /// q is certainly positive on all of the tetrahedron: its matrix has positive entries only.
  bool is_clearly_outside() const;

  /// How many answers took rationals.
  std::size_t exact_answers() const { return exact_answers_; }

 private:
  struct Exact;
  template <std::size_t Corners>
  Side meeting_of(std::span<const GridPoint> corners) const;
  const Exact& exact() const;
  template <std::size_t Corners>
  bool has_zero_inside(unsigned mask) const;

  const ConvexLevel& level_;
  std::array<const SymmetricTensor<double>*, 4> tensors_;
  QuadricForm form_;
  std::array<double, 4> size_, trace_, trace_size_;  ///< of tensors scaled as the form's
  mutable std::unique_ptr<Exact> exact_;
  mutable std::size_t exact_answers_ = 0;
};

}  // namespace tensortopo
