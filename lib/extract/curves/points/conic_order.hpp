// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "extract/curves/points/certified_zero.hpp"
#include "extract/curves/points/degenerate_forms.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {

/// A frame of numbers taken as exact, near the eigenvectors of the conic's form: `inside` is the
/// point that the conic is seen from.
struct ConicFrame {
  Vector3<double> first{}, second{}, inside{};
};

inline ConicFrame frame_of(const SymmetricTensor<double>& form) {
  const auto eigen = eigen_decomposition(form);
  return {eigen.vectors[0], eigen.vectors[1], eigen.vectors[2]};
}

/// A point of the conic as seen from inside.
struct SeenPoint {
  std::size_t index = 0;  ///< in the list given
  bool upper = false;     ///< in the first half turn from the reference direction
  double angle = 0;       ///< from the reference direction, rounded
};

/// Points of a conic in their order around it.
template <class E>
struct ConicOrder {
  std::vector<SeenPoint> seen;     ///< empty if a sign is not certain
  std::vector<Vector3<E>> turned;  ///< the directions given, on the side of `inside`
  Vector3<E> tangent_plane;        ///< the conic's form at `inside`
};

/// Where the reference direction is: as far as possible from the points and their opposites.
inline double reference_angle(const std::vector<double>& angles) {
  constexpr int kCandidates = 48;
  double best = 0, farthest = -1;
  for (int k = 0; k < kCandidates; ++k) {
    const double candidate = pi<double>() * k / kCandidates;
    double nearest = 2;
    for (const double a : angles)
      nearest = std::min(nearest, std::abs(elementary::sin(a - candidate)));
    if (nearest > farthest) farthest = nearest, best = candidate;
  }
  return best;
}

/// The order of directions on the conic around it, in the sense in which the angle grows.
template <class E>
ConicOrder<E> order_around(const SymmetricTensor<E>& form, Verdict conic_sign,
                           const ConicFrame& frame, const std::vector<Vector3<E>>& directions) {
  // With det N < 0 the cone e.N e < 0 around c is solid, and every e of the conic can be turned
  // to the side of c; N' = -N otherwise.
  ConicOrder<E> result;
  const bool negated = conic_sign == Verdict::positive;
  const auto c = widened<E>(frame.inside);
  result.tangent_plane = form * c;
  const auto& tangent_plane = result.tangent_plane;
  const Verdict at_c = sign_in(dot(c, tangent_plane));
  if (at_c != (negated ? Verdict::positive : Verdict::negative)) return result;

  std::vector<double> angles;
  auto& turned = result.turned;
  for (const auto& e : directions) {
    const Verdict side = sign_in(dot(e, tangent_plane));
    if (!is_strict(side)) return result;
    turned.push_back(side == at_c ? e : -e);
    const auto middle = [](const E& x) { return EnclosureOf<E>::middle(x); };
    const Vector3<double> m{middle(turned.back().x), middle(turned.back().y),
                            middle(turned.back().z)};
    angles.push_back(elementary::atan2(dot(m, frame.second), dot(m, frame.first)));
  }
  const double start = reference_angle(angles);
  const Vector3<double> reference =
      elementary::cos(start) * frame.first + elementary::sin(start) * frame.second;
  const auto half_plane = cross(c, widened<E>(reference));

  std::vector<SeenPoint> seen(directions.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Verdict half = sign_in(dot(half_plane, turned[i]));
    if (!is_strict(half)) return result;
    double angle = std::fmod(angles[i] - start, 2 * pi<double>());
    if (angle < 0) angle += 2 * pi<double>();
    seen[i] = {i, half == Verdict::positive, angle};
  }
  std::sort(seen.begin(), seen.end(), [](const SeenPoint& p, const SeenPoint& q) {
    return p.upper != q.upper ? p.upper : p.angle < q.angle;
  });
  // Angles are rounded: what they say of neighbours is proved, or put right by insertion.
  for (std::size_t i = 1; i < seen.size(); ++i)
    for (std::size_t k = i; k > 0 && seen[k].upper == seen[k - 1].upper; --k) {
      const auto plane = cross(c, turned[seen[k - 1].index]);
      const Verdict order = sign_in(dot(plane, turned[seen[k].index]));
      if (!is_strict(order)) return result;
      if (order == Verdict::positive) break;
      std::swap(seen[k - 1], seen[k]);
    }
  result.seen = std::move(seen);
  return result;
}

}  // namespace tensortopo
