// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/field/linear_field.hpp"
#include "tensortopo/theory/arithmetic.hpp"
#include "tensortopo/theory/outcome.hpp"

namespace tensortopo::theory {

/// A change of one of the numbers that a statement claims, to see whether its check would notice.
struct Mutation {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::size_t constant = none;  ///< which, in the order in which the check asks for them
  int change = 0;               ///< what is added to it
};

/// Numbers that determine a field up to rotation and scaling: <T_i, T_j> and tr(T_i T_j T_k), made
/// free of the scale.
std::vector<Rational> invariants(const TetrahedronField<Rational>& field);

/// What a check establishes on one trial, in numbers of one kind.
///
/// A check computes in `Scalar` and states facts: that numbers are equal, or of a sign. Each is
/// decided as far as the scalar can: rational numbers decide all of them, enclosures can certify a
/// strict sign and refute an equality, and otherwise leave the trial undecided. The first violation
/// is kept, with the witness that `about` names.
class FactsBase {
 public:
  /// Names the place that the next facts are about; called only where one is violated.
  void about(std::function<std::string()> place) { place_ = std::move(place); }

  /// What is tried: numbers that do not change if all tensors are rotated, or scaled alike, so that
  /// trials with the same numbers are one configuration. Requires at least one.
  void configuration(const std::vector<Rational>& numbers);
  /// A field up to rotation and scaling, by its products <T_i, T_j> and tr(T_i T_j T_k); and more
  /// numbers.
  void configuration_of(const TetrahedronField<Rational>& field,
                        const std::vector<Rational>& numbers = {});

  /// A fact of counting, or one that was decided in rational numbers.
  void holds(std::string_view what, bool is_so) {
    if (!is_so) violate(what);
  }
  /// The trial lacks a hypothesis. Only before any fact.
  void not_applicable(std::string why) { outcome_ = Outcome::not_applicable(std::move(why)); }
  void undecided(std::string why);

  /// A whole number that is part of the claim.
  int claimed_count(int number) { return number + change_of_next(); }
  /// How many numbers the claim has had so far.
  std::size_t constants() const { return constants_; }
  /// Whether nothing more can change the outcome.
  bool is_settled() const { return outcome_.kind == Outcome::Kind::violated; }

  Outcome outcome() const;

 protected:
  explicit FactsBase(Mutation mutation) : mutation_(mutation) {}
  int change_of_next() { return constants_++ == mutation_.constant ? mutation_.change : 0; }
  void violate(std::string_view what);
  void leave_open(std::string_view what, double reach);

 private:
  Mutation mutation_;
  std::size_t constants_ = 0;
  std::function<std::string()> place_;
  Outcome outcome_;
  std::string open_;   // the fact that is open by the widest margin
  double reach_ = -1;  // by which
};

template <class S>
class Facts : public FactsBase {
 public:
  using Scalar = S;

  explicit Facts(Mutation mutation = {}) : FactsBase(mutation) {}

  Scalar number(const Rational& q) const { return enclosing<Scalar>(q); }
  Vector3<Scalar> vector(const Vector3<Rational>& v) const {
    return {number(v.x), number(v.y), number(v.z)};
  }
  SymmetricTensor<Scalar> tensor(const SymmetricTensor<Rational>& t) const {
    return {number(t.xx), number(t.yy), number(t.zz), number(t.xy), number(t.yz), number(t.xz)};
  }
  /// A number that is part of the claim: a fraction.
  Scalar claimed(int numerator, int denominator = 1) {
    return Scalar(numerator + change_of_next() * denominator) / Scalar(denominator);
  }

  void zero(std::string_view what, const Scalar& x) {
    const Verdict v = certified_sign(x);
    if (v == Verdict::unknown) return leave_open(what, reach(x));
    if (v != Verdict::zero) violate(what);
  }
  void equal(std::string_view what, const Scalar& x, const Scalar& y) { zero(what, x - y); }
  void equal(std::string_view what, const Vector3<Scalar>& u, const Vector3<Scalar>& v) {
    equal(what, u.x, v.x), equal(what, u.y, v.y), equal(what, u.z, v.z);
  }
  void equal(std::string_view what, const SymmetricTensor<Scalar>& s,
             const SymmetricTensor<Scalar>& t) {
    equal(what, s.xx, t.xx), equal(what, s.yy, t.yy), equal(what, s.zz, t.zz);
    equal(what, s.xy, t.xy), equal(what, s.yz, t.yz), equal(what, s.xz, t.xz);
  }
  void positive(std::string_view what, const Scalar& x) {
    const Verdict v = certified_sign(x);
    if (v == Verdict::unknown) return leave_open(what, reach(x));
    if (v != Verdict::positive) violate(what);
  }
  void negative(std::string_view what, const Scalar& x) { positive(what, -x); }
  void not_negative(std::string_view what, const Scalar& x) {
    const Verdict v = certified_sign(x);
    if (v == Verdict::unknown) return leave_open(what, reach(x));
    if (v == Verdict::negative) violate(what);
  }
  void not_positive(std::string_view what, const Scalar& x) { not_negative(what, -x); }
  void not_zero(std::string_view what, const Scalar& x) {
    const Verdict v = certified_sign(x);
    if (v == Verdict::unknown) return leave_open(what, reach(x));
    if (v == Verdict::zero) violate(what);
  }
  /// Of a sign that is known from elsewhere.
  void sign(std::string_view what, const Scalar& x, Sign expected) {
    if (expected == Sign::zero) return zero(what, x);
    positive(what, expected == Sign::positive ? x : Scalar(-x));
  }
  /// Both positive, both negative or both zero.
  void same_sign(std::string_view what, const Scalar& x, const Scalar& y) {
    const Verdict v = certified_sign(x), w = certified_sign(y);
    if (v == Verdict::unknown) return leave_open(what, reach(x));
    if (w == Verdict::unknown) return leave_open(what, reach(y));
    if (v != w) violate(what);
  }
};

}  // namespace tensortopo::theory
