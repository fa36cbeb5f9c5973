// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/curves/points/curve_in_tet.hpp"
#include "extract/curves/points/degenerate_forms.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

/// A form divided by its largest entry, rounded.
template <class Real>
SymmetricTensor<Real> unit_form(const SymmetricTensor<Extended>& form) {
  Extended largest = 0;
  for (const Extended& x : {form.xx, form.yy, form.zz, form.xy, form.yz, form.xz})
    largest = std::max(largest, x < 0 ? Extended(-x) : x);
  const auto scaled = [&](Extended x) {
    return largest > 0 ? static_cast<Real>(x / largest) : Real(0);
  };
  return {scaled(form.xx), scaled(form.yy), scaled(form.zz),
          scaled(form.xy), scaled(form.yz), scaled(form.xz)};
}

/// Places points on the conic of a tetrahedron.
class ConicSampler {
 public:
  /// @param forms   with a conic form of negative determinant
  /// @param inside  a point inside the conic; `first` and `second` complete a right-handed frame
  ConicSampler(const FieldForms<Extended, 4>& forms, const Vector3<double>& inside,
               const Vector3<double>& first, const Vector3<double>& second);

  /// Samples from one direction on the conic to another in the sense in which the angle around
  /// `inside` grows, ends left out.
  std::vector<CurveSample> between(const Vector3<Extended>& begin, const Vector3<Extended>& end,
                                   double largest_turn) const;

 private:
  using Direction = Vector3<Extended>;

  /// The direction of the conic in the half plane of c and m.
  Direction projected(const Direction& m) const;
  /// Unit, on the side of `inside`.
  Direction turned(const Direction& e) const;
  /// From `inside`, in [0, 2 pi).
  double angle(const Direction& e) const;
  void bisect(const Direction& begin, const Direction& end, double least_cosine, int depth,
              std::vector<CurveSample>& samples) const;
  CurveSample sample(const Direction& e) const;

  SymmetricTensor<Extended> form_;
  std::array<SymmetricTensor<Extended>, 4> weight_;
  Direction inside_, first_, second_, plane_;
};

}  // namespace tensortopo
