// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "member.hpp"

namespace tensortopo::theory {
namespace {

Tensor random_tensor(Random& random) {
  const Rational xx = random.fraction(), yy = random.fraction();
  return {xx, yy, -(xx + yy), random.fraction(), random.fraction(), random.fraction()};
}

Tensor without(const Tensor& part, const Tensor& t) {
  return t - Rational(inner(part, t) / inner(part, part)) * part;
}

}  // namespace

std::optional<Member> random_member(const Tensor& n, const Basis& basis, Random& random) {
  // The field's tensors with medium eigenvector v and one eigenvector along d are solutions of one
  // linear equation for s; negative s exchanges the roles of d and of the vector across it.
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Vector3<Rational> d =
        Rational(random.integer(-9, 9)) * basis[0] + Rational(random.integer(-9, 9)) * basis[1];
    const Rational at_zero = inner(n, tensor_with(Rational(0), basis[2], d));
    const Rational at_one = inner(n, tensor_with(Rational(1), basis[2], d));
    if (at_zero == at_one) continue;
    const Rational s = at_zero / (at_zero - at_one);
    if (s < -1 || s > 1) continue;
    if (s < 0) return Member{-s, cross(basis[2], d)};
    return Member{s, d};
  }
  return std::nullopt;
}

Made made_around(const Rational& s, Random& random) {
  Made made;
  made.basis = random_basis(random);
  made.member = tensor_with(s, made.basis[2], made.basis[0]);
  do {
    made.characteristic = without(made.member, random_tensor(random));
  } while (made.characteristic == Tensor{});
  return made;
}

Made made_on_boundary(const Rational& s, Random& random) {
  Made made = made_around(s, random);
  // The member is diagonal in the basis, so this stays orthogonal to it.
  made.characteristic = without(product_of(made.basis[0], made.basis[1]), made.characteristic);
  return made;
}

}  // namespace tensortopo::theory
