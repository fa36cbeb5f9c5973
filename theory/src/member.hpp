// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dominant_form.hpp"

namespace tensortopo::theory {

/// A tensor of a field with medium eigenvector v: its parameter |s| and its dominant direction.
struct Member {
  Rational s;
  Vector3<Rational> dominant;
};

/// A tensor of the field with medium eigenvector basis[2] and a rational dominant direction, or
/// nothing if none was found soon.
std::optional<Member> random_member(const Tensor& n, const Basis& basis, Random& random);

/// A field made around one of its tensors: all those orthogonal to `characteristic`, which is
/// orthogonal to the tensor of parameter s, dominant eigenvector basis[0] and medium basis[2].
struct Made {
  Tensor characteristic;
  Basis basis;
  Tensor member;
};
Made made_around(const Rational& s, Random& random);

/// The same with basis[2] on the boundary of the complex domain of s.
Made made_on_boundary(const Rational& s, Random& random);

}  // namespace tensortopo::theory
