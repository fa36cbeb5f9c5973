// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "extract/curves/points/curve_in_tet.hpp"
#include "extract/curves/points/degenerate_forms.hpp"

namespace tensortopo {

/// A form divided by its largest entry, rounded.
template <class Real>
SymmetricTensor<Real> unit_form(const SymmetricTensor<long double>& form) {
  long double largest = 0;
  for (const long double x : {form.xx, form.yy, form.zz, form.xy, form.yz, form.xz})
    largest = std::max(largest, std::abs(x));
  const auto scaled = [&](long double x) {
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
  ConicSampler(const FieldForms<long double, 4>& forms, const Vector3<double>& inside,
               const Vector3<double>& first, const Vector3<double>& second);

  /// Samples from one direction on the conic to another in the sense in which the angle around
  /// `inside` grows, ends left out.
  std::vector<CurveSample> between(const Vector3<long double>& begin,
                                   const Vector3<long double>& end, double largest_turn) const;

 private:
  using Direction = Vector3<long double>;

  /// The direction of the conic in the half plane of c and m.
  Direction projected(const Direction& m) const;
  /// Unit, on the side of `inside`.
  Direction turned(const Direction& e) const;
  /// From `inside`, in [0, 2 pi).
  long double angle(const Direction& e) const;
  void bisect(const Direction& begin, const Direction& end, long double least_cosine, int depth,
              std::vector<CurveSample>& samples) const;
  CurveSample sample(const Direction& e) const;

  SymmetricTensor<long double> form_;
  std::array<SymmetricTensor<long double>, 4> weight_;
  Direction inside_, first_, second_, plane_;
};

}  // namespace tensortopo
