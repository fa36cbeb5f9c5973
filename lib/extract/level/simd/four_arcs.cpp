// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Compiled as four_lanes.cpp is.
#include "extract/level/simd/four_arcs.hpp"

#include "extract/level/simd/lane_roots.hpp"

namespace tensortopo {

namespace {

using LaneWeights = std::array<Lanes, 3>;

/// A point of an arc, as far as its neighbours' turning is concerned.
struct LanePoint {
  Deviator<Lanes> tensor;
  Vector3<Lanes> medium;
};

Vector3<Lanes> select_vector(Mask mask, const Vector3<Lanes>& u, const Vector3<Lanes>& v) {
  return {select(mask, u.x, v.x), select(mask, u.y, v.y), select(mask, u.z, v.z)};
}

/// As `medium_eigenvector`.
Vector3<Lanes> medium_lanes(const Deviator<Lanes>& t, double medium) {
  auto m = thrice(t);
  const Lanes lambda = sqrt(Lanes(3) * norm_form(t)) * Lanes(medium);
  m.xx = m.xx - lambda, m.yy = m.yy - lambda, m.zz = m.zz - lambda;
  const Vector3<Lanes> r0{m.xx, m.xy, m.xz}, r1{m.xy, m.yy, m.yz}, r2{m.xz, m.yz, m.zz};
  Vector3<Lanes> best = cross(r1, r2);
  Lanes length = dot(best, best);
  for (const auto& c : {cross(r2, r0), cross(r0, r1)}) {
    const Lanes l = dot(c, c);
    const Mask longer = l > length;
    best = select_vector(longer, c, best);
    length = select(longer, l, length);
  }
  return select_vector(length > Lanes(0), Lanes(1) / sqrt(length) * best,
                       {Lanes(0), Lanes(0), Lanes(1)});
}

/// As `Sampler::is_close`.
Mask close_lanes(const LanePoint& a, const LanePoint& b, const LeastCosines& least) {
  const Lanes product = norm_form(a.tensor, b.tensor), wide(least.tensor);
  return (abs(dot(a.medium, b.medium)) > Lanes(least.medium)) & (product > Lanes(0)) &
         (product * product > wide * wide * norm_form(a.tensor) * norm_form(b.tensor));
}

/// Arcs in lanes, and points on them.
struct LaneArcs {
  std::array<Deviator<Lanes>, 3> tensors;
  LaneWeights direction, begin, end;

  explicit LaneArcs(std::span<const GraphArc> arcs) {
    std::array<const GraphArc*, Lanes::count> of;
    std::array<const std::array<Deviator<double>, 3>*, Lanes::count> tensors_of;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      of[lane] = &arcs[lane < arcs.size() ? lane : arcs.size() - 1];
      tensors_of[lane] = &of[lane]->tensors;
    }
    tensors = in_lanes<3>(tensors_of);
    const auto gather = [&](std::array<double, 3> GraphArc::*part, std::size_t i) {
      return Lanes(Lanes::Vector{(of[0]->*part)[i], (of[1]->*part)[i], (of[2]->*part)[i],
                                 (of[3]->*part)[i]});
    };
    for (std::size_t i = 0; i < 3; ++i) {
      direction[i] = gather(&GraphArc::direction, i);
      begin[i] = gather(&GraphArc::begin, i);
      end[i] = gather(&GraphArc::end, i);
    }
  }

  LaneWeights between(double fraction) const {
    LaneWeights base;
    for (std::size_t i = 0; i < 3; ++i) base[i] = begin[i] + Lanes(fraction) * (end[i] - begin[i]);
    return base;
  }

  Deviator<Lanes> tensor_of(const LaneWeights& w) const {
    return w[0] * tensors[0] + w[1] * tensors[1] + w[2] * tensors[2];
  }

  LanePoint at(const LaneWeights& base, double medium) const {
    const auto tensor = tensor_of(base);
    return {tensor, medium_lanes(tensor, medium)};
  }

  /// As the middle of a piece: where the line through the middle of its ends meets the level. Lanes
  /// in which that is not sure are taken out of `lanes`.
  LaneWeights middle(const LaneLevel& level, Mask& lanes) const {
    LaneWeights base = between(0.5);
    Lanes down(0), up(0);
    Mask has_down{}, has_up{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes k = -base[i] / direction[i];
      const Mask enters = direction[i] > Lanes(0), leaves = direction[i] < Lanes(0);
      down = select(enters & (~has_down | (k > down)), k, down);
      up = select(leaves & (~has_up | (k < up)), k, up);
      has_down |= enters, has_up |= leaves;
    }
    const auto end_at = [&](const Lanes& k) {
      LaneWeights w;
      Lanes total(0);
      for (std::size_t i = 0; i < 3; ++i) {
        w[i] = base[i] + k * direction[i];
        total = total + w[i];
      }
      for (auto& x : w) x = x / total;
      return w;
    };
    const auto lower = end_at(down), upper = end_at(up);
    const Lanes root = roots_between(tensor_of(lower), tensor_of(upper), level, lanes);
    for (std::size_t i = 0; i < 3; ++i) {
      base[i] = lower[i] + root * (upper[i] - lower[i]);
      base[i] = select(base[i] < Lanes(0), Lanes(0), base[i]);
    }
    return base;
  }
};

}  // namespace

unsigned straight_four(std::span<const GraphArc> arcs, const LevelNumbers& level,
                       const LeastCosines& least) {
  const LaneArcs on(arcs);
  const auto a = on.at(on.between(0), level.medium), b = on.at(on.between(1), level.medium);
  Mask lanes = close_lanes(a, b, least);
  if (bits(lanes) == 0) return 0;
  const auto m = on.at(on.middle(LaneLevel(level), lanes), level.medium);
  return bits(lanes & close_lanes(a, m, least) & close_lanes(m, b, least));
}

}  // namespace tensortopo
