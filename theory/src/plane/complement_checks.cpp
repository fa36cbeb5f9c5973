// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points of the mode and the tensors orthogonal to a plane.
#include "plane/checks.hpp"
#include "plane/pencil.hpp"
#include "tensors.hpp"

namespace tensortopo::theory {
namespace {

template <class Scalar>
SymmetricTensor<Scalar> across(const SymmetricTensor<Scalar>& s, const SymmetricTensor<Scalar>& t) {
  return s - Scalar(inner(s, t) / inner(t, t)) * t;
}

// What T^2 has apart from multiples of the identity and of T.
template <class Scalar>
SymmetricTensor<Scalar> companion_of(const SymmetricTensor<Scalar>& t, const Scalar& third) {
  const SymmetricTensor<Scalar> squared = square(t);
  const Scalar size = inner(t, t);
  return squared - isotropic<Scalar>(third * size) - Scalar(inner(squared, t) / size) * t;
}

const auto regular_normal = [](const Tensor& normal, const Tensor& drawn, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  const Scalar third = facts.claimed(1, 3), one = facts.claimed(1);
  const auto n = facts.tensor(normal);
  const auto t = companion_of(n, third);
  facts.zero("trace of T", trace(t));
  facts.zero("<T, N>", inner(t, n));
  facts.positive("|T|^2", inner(t, t));
  facts.equal("mode(T)^2 + mode(N)^2", mode_squared(t) + mode_squared(n), one);
  // A plane with T in it, orthogonal to N and to another tensor.
  const auto other = across(facts.tensor(drawn), t);
  facts.zero("cubic at N", pencil_cubic(n, n, other));
  // The gradient of the determinant is T^2 - |T|^2 I / 3: here along T and across the plane.
  const auto back = companion_of(t, third);
  facts.equal("companion of the companion, along N", back,
              Scalar(inner(back, n) / inner(n, n)) * n);
};

// The other way round: a T that is critical in a plane has the companion N of T, the part of the
// gradient across it, in the plane's complement; so it is among the companions, or neutral.
const auto regular_critical = [](const Tensor& drawn, auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  const Scalar third = facts.claimed(1, 3);
  const auto t = facts.tensor(drawn);
  const auto n = companion_of(t, third);
  facts.positive("|N|^2 of a T that is not degenerate", inner(n, n));
  facts.equal("mode(N)^2 + mode(T)^2", mode_squared(n) + mode_squared(t), facts.claimed(1));
  if (determinant(drawn) != 0) {
    const auto back = companion_of(n, third);
    facts.positive("|companion of N|^2", inner(back, back));
    facts.equal("companion of N, along T", back, Scalar(inner(back, t) / inner(t, t)) * t);
  } else {
    // Eigenvalues r, 0, -r: N is degenerate, and its dominant eigenvector is the kernel of T.
    facts.equal("companion of N", companion_of(n, third), isotropic(Scalar(0)));
    const auto product = Scalar(inner(n, n)) * n + isotropic<Scalar>(Scalar(3) * determinant(n));
    facts.equal("T on the dominant direction of N", t * (product * facts.vector({1, 2, 3})),
                Vector3<Scalar>{Scalar(0), Scalar(0), Scalar(0)});
  }
};

const auto degenerate_normal = [](const Basis& basis, const Tensor& neutral, const Tensor& drawn,
                                  auto& facts) {
  using Scalar = ScalarOf<std::decay_t<decltype(facts)>>;
  const auto n = facts.tensor(tensor_of({2, -1, -1}, basis));
  const auto t = facts.tensor(neutral);
  const Scalar third = Scalar(1) / Scalar(3);
  facts.equal("companion of a degenerate tensor", companion_of(n, third), isotropic(Scalar(0)));
  facts.zero("<T, N> of a neutral T with its kernel", inner(t, n));
  facts.zero("cubic at a degenerate N", pencil_cubic(n, n, across(facts.tensor(drawn), t)));
  const auto gradient = companion_of(t, third);
  facts.equal("gradient of the determinant at T, along N", gradient,
              Scalar(inner(gradient, n) / inner(n, n)) * n);
  facts.zero("determinant of T", determinant(t));
  // The gradient is not zero: the point is critical because of N.
  facts.not_zero("<gradient, N>", inner(gradient, n));
};

const auto complement_pencil = [](const Trial& trial, auto& facts) {
  Random random = trial.random;
  const Tensor normal = tensor_at_random_point(trial, random);
  const Tensor drawn = tensor_of({3, 1, -4}, random_basis(random));
  const Basis basis = random_basis(random);
  const Rational p(random.nonzero(9)), q = random.fraction();
  if (degeneracy_form(normal) == 0) return facts.not_applicable("a degenerate tensor was drawn");
  facts.about([&] { return "N = " + text(normal) + ", another normal from " + text(drawn); });
  regular_normal(normal, drawn, facts);
  for (const Tensor& t : {normal, tensor_of({2, 0, -2}, basis)}) {
    facts.about([&] { return "T = " + text(t); });
    regular_critical(t, facts);
  }
  const Tensor neutral = tensor_of({Rational(0), p, Rational(-p)}, basis) +
                         Rational(2) * q * product_of(basis[1], basis[2]);
  facts.about([&] { return "neutral " + text(neutral) + ", another normal from " + text(drawn); });
  degenerate_normal(basis, neutral, drawn, facts);
};

}  // namespace

Check check_complement_pencil() { return complement_pencil; }

}  // namespace tensortopo::theory
