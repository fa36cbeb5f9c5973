// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/loop_crossings.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "levels/medium_forms.hpp"
#include "tensortopo/theory/arithmetic.hpp"

namespace tensortopo::theory {
namespace {

// Crossings are enclosed by this many halvings, which mostly is enough; by more, up to the second
// number, if not.
constexpr int kFirstHalvings = 12, kMostHalvings = 60;

BoundedDeviator near_tensor(const Deviator<Integer>& tensor) {
  return bounded(tensor, binary_size(tensor));
}

Integer raised(const Integer& number, long places) {
  return number << static_cast<unsigned long>(std::max(places, 0L));
}

// A vector near the medium eigenvector; a proposal.
std::array<double, 3> likely_medium(const std::vector<BoundedDeviator>& tensors) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const BoundedDeviator& t : tensors) {
    const SymmetricTensor<double> d =
        to_tensor(Deviator<double>{t.a.value, t.b.value, t.xy.value, t.yz.value, t.xz.value});
    Eigen::Matrix3d m;
    m << d.xx, d.xy, d.xz, d.xy, d.yy, d.yz, d.xz, d.yz, d.zz;
    sum += m / m.norm();
  }
  const Eigen::Vector3d v =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(1);
  return {v.x(), v.y(), v.z()};
}

}  // namespace

LoopCrossings::LoopCrossings(const LevelComplex& complex, const LoopTetrahedron& t)
    : complex_(complex), level_(ModeLevel::of_parameter(t.s)), side_(t.side) {
  for (std::size_t i = 0; i < 3; ++i) normal_[i] = enclosing<Bounded<double>>(t.values[i]);
  const Rational square = t.s * t.s;
  factor_ = enclosing<Bounded<double>>(
      Rational(Rational(6) * (Rational(3) + square) / (Rational(9) - square)));
}

void LoopCrossings::halve(Bracket& bracket) const {
  const long low = binary_size(bracket[0]), high = binary_size(bracket[1]);
  const Deviator<Integer> middle = primitive(raised(Integer(1), high - low) * bracket[0] +
                                             raised(Integer(1), low - high) * bracket[1]);
  bracket[is_above(middle, level_) ? 1 : 0] = middle;
}

LoopCrossings::Bracket& LoopCrossings::crossing(const Edge& edge) {
  const auto [place, is_new] = crossings_.try_emplace(edge);
  Bracket& bracket = place->second;
  if (is_new) {
    for (const LevelComplex::Index v : edge)
      bracket[complex_.is_above(v) ? 1 : 0] = complex_.tensor(v);
    for (int i = 0; i < kFirstHalvings; ++i) halve(bracket);
  }
  return bracket;
}

Verdict LoopCrossings::sigma_at(Bracket& bracket, const std::array<double, 3>& g) const {
  for (int i = kFirstHalvings;; ++i) {
    const std::array<BoundedDeviator, 2> ends = {near_tensor(bracket[0]), near_tensor(bracket[1])};
    const Verdict sign = strict_sign(MediumForms<2>(ends, normal_, factor_).sigma_along(g));
    if (sign != Verdict::unknown || i == kMostHalvings) return sign;
    halve(bracket);
  }
}

std::optional<OddCrossings> LoopCrossings::of(const LevelComplex::Face& face) {
  std::vector<Bracket*> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [u, w] = std::minmax(face[i], face[(i + 1) % 3]);
    if (complex_.is_above(u) != complex_.is_above(w)) ends.push_back(&crossing({u, w}));
  }
  const std::array<double, 3> g =
      likely_medium({near_tensor((*ends[0])[0]), near_tensor((*ends[1])[0])});
  const MediumForms<3> forms(
      {near_tensor(complex_.tensor(face[0])), near_tensor(complex_.tensor(face[1])),
       near_tensor(complex_.tensor(face[2]))},
      normal_, factor_);
  if (strict_sign(forms.sigma_along(g)) != Verdict::unknown) return OddCrossings{};
  if (strict_sign(forms.squared_along(g)) != Verdict::positive) return std::nullopt;
  const Verdict product = strict_sign(forms.v[0][2]);
  if (product == Verdict::unknown) return std::nullopt;
  const Verdict from = sigma_at(*ends[0], g), to = sigma_at(*ends[1], g);
  if (from == Verdict::unknown || to == Verdict::unknown) return std::nullopt;
  const bool is_odd = from != to,
             is_loop = product == (side_ > 0 ? Verdict::positive : Verdict::negative);
  return OddCrossings{is_odd && is_loop, is_odd && !is_loop};
}

}  // namespace tensortopo::theory
