// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "lane_kernels.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "direction_search.hpp"
#include "lanes.hpp"
#include "level_slope.hpp"
#include "tensortopo/extract/segment_root.hpp"

#if defined(__x86_64__) && !defined(__clang__)  // whose gnu::flatten is shallow
#define TENSORTOPO_LANES_WITH_AVX2
#endif

namespace tensortopo {

namespace {

using Mask = Lanes::Mask;

/// As far as the formulas look at it.
Level<Lanes> in_lanes(const Level<double>& level) {
  Level<Lanes> result;
  result.mu = Lanes(level.mu);
  result.sqrt2 = Lanes(level.sqrt2);
  return result;
}

/// A lane of each simplex; the last one in those to spare.
template <std::size_t Vertices>
std::array<Deviator<Lanes>, Vertices> in_lanes(
    std::span<const std::array<Deviator<double>, Vertices>> simplices) {
  std::array<Deviator<Lanes>, Vertices> result;
  std::array<const std::array<Deviator<double>, Vertices>*, Lanes::count> of;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    of[lane] = &simplices[std::min(lane, simplices.size() - 1)];
  for (std::size_t i = 0; i < Vertices; ++i) {
    const auto gather = [&](double Deviator<double>::*part) {
      return Lanes(Lanes::Vector{(*of[0])[i].*part, (*of[1])[i].*part, (*of[2])[i].*part,
                                 (*of[3])[i].*part});
    };
    using Tensor = Deviator<double>;
    result[i] = {gather(&Tensor::a), gather(&Tensor::b), gather(&Tensor::xy), gather(&Tensor::yz),
                 gather(&Tensor::xz)};
  }
  return result;
}

/// As `is_crossed`.
template <std::size_t Vertices>
Mask crossed_lanes(const std::array<Deviator<Lanes>, Vertices>& tensors,
                   const Level<Lanes>& level) {
  Mask above{}, below{};
  for (const auto& t : tensors) {
    const Lanes p = norm_form(t);
    const Mask side = Lanes(1.4142135623730951) * determinant_form(t) > level.mu * p * sqrt(p);
    above |= side, below |= ~side;
  }
  return above & below;
}

/// As `rounding_unit` of a total of one.
Lanes rounding_unit_of(const Lanes& norm) {
  return Lanes(unit_roundoff<double>()) * (Lanes(1) + Lanes(40) / norm);
}

/// What the proofs below want of a simplex.
template <std::size_t Vertices>
struct Ground {
  Mask sound;         ///< where the bounds hold and the lower one is positive
  Lanes norm;         ///< the largest of a vertex
  LevelIncrease<Lanes, Vertices> increase;
};

/// As in `prove_simplex`: `largest_norm`, `mode_forms`, `norm_bounds`, and the cubics from these.
template <std::size_t Vertices>
Ground<Vertices> ground(const std::array<Deviator<Lanes>, Vertices>& tensors,
                        const Level<Lanes>& level) {
  const auto forms = mode_forms(tensors);
  NormBounds<Lanes, Vertices> bounds;
  std::array<Lanes, Vertices> norm;
  Lanes largest(0), least{};
  Mask sound = ~Mask{};
  for (std::size_t i = 0, pair = 0; i < Vertices; pair += Vertices - i, ++i) {
    const Lanes& p = forms.norm.coefficients[pair];
    sound &= p > Lanes(0);
    largest = select(p > largest, p, largest);
    norm[i] = sqrt(p);
    least = i == 0 ? norm[i] : select(norm[i] < least, norm[i], least);
  }
  const Lanes room = Lanes(32) * rounding_unit_of(least);
  sound &= room < Lanes(0.125);
  for (std::size_t i = 0; i < Vertices; ++i) bounds.upper[i] = norm[i] * (Lanes(1) + room);
  Lanes cosine(1);
  for (std::size_t i = 0, pair = 0; i < Vertices; ++i) {
    ++pair;
    for (std::size_t j = i + 1; j < Vertices; ++j, ++pair) {
      const Lanes c = forms.norm.coefficients[pair] / (Lanes(2) * norm[i] * norm[j]);
      cosine = select(c < cosine, c, cosine);
    }
  }
  constexpr double kPairs = 1 - 1.0 / static_cast<double>(Vertices);
  const Lanes square = Lanes(1) - Lanes(kPairs) * (Lanes(1) - cosine) - Lanes(4) * room;
  sound &= square > Lanes(0);
  bounds.lower = sqrt(square) * (Lanes(1) - room);
  sound &= bounds.lower > Lanes(0);
  return {sound, sqrt(largest), {forms, bounds, level}};
}

/// Where `detail::increases_along` would say yes.
template <std::size_t Vertices>
Mask increases_in(const Ground<Vertices>& on, const std::array<Lanes, Vertices>& d) {
  using Cubic = typename LevelIncrease<double, Vertices>::Cubic;
  const Lanes bound = Lanes(detail::kIncreaseBound) * rounding_unit_of(on.norm) * on.norm *
                      on.norm * on.norm * on.norm;
  Mask positive = ~Mask{};
  const auto coefficients = on.increase(d);
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    positive &= coefficients[k] > Lanes(Cubic::multinomials[k % Cubic::size]) * bound;
  return positive;
}

/// `DirectionSearch` in lanes.
template <std::size_t Vertices>
class LaneSearch {
 public:
  /// The start, as in `likely_direction`.
  explicit LaneSearch(const LevelIncrease<Lanes, Vertices>& increase) {
    std::array<Lanes, count> factor;
    for (std::size_t k = 0; k < count; ++k) {
      Lanes square(0);
      for (std::size_t i = 0; i < Vertices; ++i) {
        unit_[i][k] = increase.along[i][k] + increase.along[i][count + k];
        square = square + unit_[i][k] * unit_[i][k];
      }
      factor[k] = Lanes(1) / sqrt(square);
    }
    for (std::size_t i = 0; i < Vertices; ++i) {
      d_[i] = Lanes(0);
      for (std::size_t k = 0; k < count; ++k) {
        unit_[i][k] = unit_[i][k] * factor[k];
        d_[i] = d_[i] + unit_[i][k];
      }
      d_[i] = d_[i] / Lanes(static_cast<int>(count));
    }
    weight_.fill(Lanes(1.0 / count));
  }

  /// Searches in the lanes given, and returns those in which it has found a direction. One that
  /// takes longer than all others goes on alone.
  Mask run(Mask lanes, std::array<Lanes, Vertices>& direction) {
    // Other cases than those below: not a number, or infinite.
    for (const auto& x : d_) lanes &= (x - x).v == Lanes(0).v;
    Mask found{};
    int step = 0;
    unsigned left = 0;
    for (;; ++step) {
      Lanes low(0), high(-std::numeric_limits<double>::infinity());
      Mask least{}, most{};
      for (std::size_t k = 0; k < count; ++k) {
        Lanes growth = d_[0] * unit_[0][k];
        for (std::size_t i = 1; i < Vertices; ++i) growth = growth + d_[i] * unit_[i][k];
        const auto place = static_cast<long long>(k);
        const Mask here{place, place, place, place};
        const Mask lower = k == 0 ? ~Mask{} : growth < low;
        low = select(lower, growth, low);
        least = lower ? here : least;
        const Mask higher = (weight_[k] > Lanes(0)) & (growth > high);
        high = select(higher, growth, high);
        most = higher ? here : most;
      }
      const Mask enough = lanes & (low > Lanes(Search::enough));
      found |= enough;
      lanes &= ~enough;
      Lanes square(0);
      for (const auto& x : d_) square = square + x * x;
      lanes &= square > Lanes(Search::nothing * Search::nothing);
      left = bits(lanes);
      if (left == 0 || step == kLongSearch) break;
      if (step >= kTogether && (left & (left - 1)) == 0) break;
      move(lanes, low, high, least, most);
    }
    Lanes largest(0);
    for (const auto& x : d_) {
      const Lanes size = abs(x);
      largest = select(largest < size, size, largest);
    }
    for (std::size_t i = 0; i < Vertices; ++i) direction[i] = d_[i] / largest;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      if (!(left >> lane & 1) || step == kLongSearch) continue;
      const auto alone = finished(lane, step);
      for (std::size_t i = 0; i < Vertices; ++i) {
        direction[i].v[lane] = alone[i];
        if (alone[i] != 0) found[lane] = -1;
      }
    }
    return found;
  }

 private:
  using Search = DirectionSearch<Vertices>;
  static constexpr std::size_t count = Search::count;
  static constexpr int kTogether = 4;

  /// A step of the lanes given, from the least of the unit directions in place of the most.
  void move(Mask& lanes, const Lanes& low, const Lanes& high, const Mask& least,
            const Mask& most) {
    const auto at = [](const std::array<Lanes, count>& x, const Mask& k) {
      return Lanes(Lanes::Vector{x[static_cast<std::size_t>(k[0])].v[0],
                                 x[static_cast<std::size_t>(k[1])].v[1],
                                 x[static_cast<std::size_t>(k[2])].v[2],
                                 x[static_cast<std::size_t>(k[3])].v[3]});
    };
    std::array<Lanes, Vertices> way;
    Lanes gap(0);
    for (std::size_t i = 0; i < Vertices; ++i) {
      way[i] = at(unit_[i], least) - at(unit_[i], most);
      gap = gap + way[i] * way[i];
    }
    lanes &= gap > Lanes(0);
    const Lanes rest = at(weight_, most), whole = (high - low) / gap;
    const Lanes shift = select(whole < rest, whole, rest);
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      if (lanes[lane] == 0) continue;
      weight_[static_cast<std::size_t>(least[lane])].v[lane] += shift[lane];
      weight_[static_cast<std::size_t>(most[lane])].v[lane] -= shift[lane];
    }
    for (std::size_t i = 0; i < Vertices; ++i)
      d_[i] = select(lanes, d_[i] + shift * way[i], d_[i]);
  }

  std::array<double, Vertices> finished(std::size_t lane, int step) const {
    Search search;
    for (std::size_t i = 0; i < Vertices; ++i) {
      search.d[i] = d_[i][lane];
      for (std::size_t k = 0; k < count; ++k) search.unit[i][k] = unit_[i][k][lane];
    }
    for (std::size_t k = 0; k < count; ++k) search.weight[k] = weight_[k][lane];
    return search.run(step, kLongSearch);
  }

  std::array<std::array<Lanes, count>, Vertices> unit_;
  std::array<Lanes, count> weight_;
  std::array<Lanes, Vertices> d_;
};

/// The first try of `prove_simplex` on a simplex with vertices on both sides. Returns a bit for each
/// lane in which it succeeds; elsewhere nothing is said.
template <std::size_t Vertices>
unsigned prove_lanes(std::span<const std::array<Deviator<double>, Vertices>> simplices,
                     const Level<Lanes>& level,
                     std::array<std::array<double, Vertices>, Lanes::count>& directions) {
  const auto tensors = in_lanes(simplices);
  const auto on = ground(tensors, level);
  std::array<Lanes, Vertices> d;
  Mask proved =
      LaneSearch<Vertices>(on.increase).run(on.sound & crossed_lanes(tensors, level), d);
  // As `detail::meets_outside`.
  Mask all_up = ~Mask{}, all_down = ~Mask{}, some = Mask{};
  for (const auto& x : d) {
    all_up &= x > Lanes(0), all_down &= x < Lanes(0);
    some |= (x > Lanes(0)) | (x < Lanes(0));
  }
  proved &= ~all_up & ~all_down & some & increases_in(on, d);
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    for (std::size_t i = 0; i < Vertices; ++i) directions[lane][i] = d[i][lane];
  return bits(proved);
}

/// As `segment_root`, between ends that are strictly on their sides: the lanes in which they are not
/// are taken out of `lanes`.
Lanes roots_between(const Deviator<Lanes>& below, const Deviator<Lanes>& above,
                    const Level<Lanes>& level, Mask& lanes) {
  const Deviator<Lanes> step = above - below;
  const auto step3 = thrice(step);
  const Lanes f0 = level_function(below, level), f1 = level_function(above, level);
  const Lanes half(0.5), tiny(unit_roundoff<double>());
  lanes &= (f0 < Lanes(0)) & (f1 > Lanes(0));
  Lanes lo(0), hi(1), t = -f0 / (f1 - f0);
  t = select((t > lo) & (t < hi), t, half * (lo + hi));
  Mask active = lanes;
  for (int iteration = 0; iteration < 400 && bits(active) != 0; ++iteration) {
    const auto at = detail::slope_at(below + t * step, level);
    const Mask less = at.value < Lanes(0), more = at.value > Lanes(0);
    lo = select(active & less, t, lo);
    hi = select(active & more, t, hi);
    active &= (less | more) & ~(hi - lo <= Lanes(2) * tiny);
    const Lanes derivative = inner(at.slope, step3);
    Lanes next = t - at.value / derivative;
    const Mask keep = iteration % 12 == 11 ? Mask{} : (next > lo) & (next < hi);
    next = select(keep, next, half * (lo + hi));
    const Lanes way = select(next > t, next - t, t - next);
    t = select(active, next, t);
    active &= ~(way <= tiny * select(t < half, Lanes(1), t));
  }
  return t;
}

/// Up to four edges; see `single_crossings`.
void cross_lanes(std::span<const std::array<Deviator<double>, 2>> ends,
                 std::span<const char> rising, const Level<Lanes>& level,
                 std::span<double> weights) {
  const auto tensors = in_lanes(ends);
  const auto on = ground(tensors, level);
  const Lanes up = select(on.increase.along[1][0] > on.increase.along[0][0], Lanes(1), Lanes(-1));
  Mask lanes = on.sound & crossed_lanes(tensors, level) & increases_in(on, {-up, up});
  Mask upwards{};
  for (std::size_t lane = 0; lane < ends.size(); ++lane) upwards[lane] = rising[lane] != 0 ? -1 : 0;
  const auto choose = [&](std::size_t first, std::size_t second) {
    const auto &s = tensors[first], &t = tensors[second];
    return Deviator<Lanes>{select(upwards, s.a, t.a), select(upwards, s.b, t.b),
                           select(upwards, s.xy, t.xy), select(upwards, s.yz, t.yz),
                           select(upwards, s.xz, t.xz)};
  };
  const Lanes root = roots_between(choose(0, 1), choose(1, 0), level, lanes);
  const Lanes weight = select(upwards, root, Lanes(1) - root);
  for (std::size_t lane = 0; lane < ends.size(); ++lane)
    weights[lane] = lanes[lane] != 0 ? weight[lane] : -1;
}

// Each kernel once for any processor, once for AVX2.
template <std::size_t Vertices>
[[gnu::flatten]] unsigned prove_with_any(
    std::span<const std::array<Deviator<double>, Vertices>> simplices, const Level<Lanes>& level,
    std::array<std::array<double, Vertices>, Lanes::count>& directions) {
  return prove_lanes(simplices, level, directions);
}

[[gnu::flatten]] void cross_with_any(std::span<const std::array<Deviator<double>, 2>> ends,
                                     std::span<const char> rising, const Level<Lanes>& level,
                                     std::span<double> weights) {
  cross_lanes(ends, rising, level, weights);
}

#ifdef TENSORTOPO_LANES_WITH_AVX2
template <std::size_t Vertices>
[[gnu::flatten, gnu::target("avx2")]] unsigned prove_with_avx2(
    std::span<const std::array<Deviator<double>, Vertices>> simplices, const Level<Lanes>& level,
    std::array<std::array<double, Vertices>, Lanes::count>& directions) {
  return prove_lanes(simplices, level, directions);
}

[[gnu::flatten, gnu::target("avx2")]] void cross_with_avx2(
    std::span<const std::array<Deviator<double>, 2>> ends, std::span<const char> rising,
    const Level<Lanes>& level, std::span<double> weights) {
  cross_lanes(ends, rising, level, weights);
}
#else
template <std::size_t Vertices>
unsigned prove_with_avx2(std::span<const std::array<Deviator<double>, Vertices>> simplices,
                         const Level<Lanes>& level,
                         std::array<std::array<double, Vertices>, Lanes::count>& directions) {
  return prove_with_any(simplices, level, directions);
}

void cross_with_avx2(std::span<const std::array<Deviator<double>, 2>> ends,
                     std::span<const char> rising, const Level<Lanes>& level,
                     std::span<double> weights) {
  cross_with_any(ends, rising, level, weights);
}
#endif

}  // namespace

Instructions best_instructions() {
#ifdef TENSORTOPO_LANES_WITH_AVX2
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return Instructions::avx2;
#endif
  return Instructions::any;
}

template <std::size_t Vertices>
void prove_simplices(std::span<const std::array<Deviator<double>, Vertices>> tensors,
                     const Level<double>& level, std::span<SimplexProof<double, Vertices>> proofs,
                     Instructions instructions) {
  using Proof = SimplexProof<double, Vertices>;
  const auto level_in_lanes = in_lanes(level);
  std::array<std::array<double, Vertices>, Lanes::count> directions;
  for (std::size_t i = 0; i < tensors.size(); i += Lanes::count) {
    const auto four = tensors.subspan(i, std::min(Lanes::count, tensors.size() - i));
    const unsigned proved = instructions == Instructions::avx2
                                ? prove_with_avx2(four, level_in_lanes, directions)
                                : prove_with_any(four, level_in_lanes, directions);
    for (std::size_t lane = 0; lane < four.size(); ++lane)
      proofs[i + lane] = proved >> lane & 1
                             ? Proof{Proof::Kind::monotone, directions[lane], false}
                             : prove_simplex(four[lane], level);
  }
}

void single_crossings(std::span<const std::array<Deviator<double>, 2>> ends,
                      std::span<const char> rising, const Level<double>& level,
                      std::span<double> weights, Instructions instructions) {
  const auto level_in_lanes = in_lanes(level);
  const auto cross = instructions == Instructions::avx2 ? cross_with_avx2 : cross_with_any;
  for (std::size_t i = 0; i < ends.size(); i += Lanes::count) {
    const std::size_t count = std::min(Lanes::count, ends.size() - i);
    cross(ends.subspan(i, count), rising.subspan(i, count), level_in_lanes,
          weights.subspan(i, count));
  }
}

template void prove_simplices<3>(std::span<const std::array<Deviator<double>, 3>>,
                                 const Level<double>&, std::span<SimplexProof<double, 3>>,
                                 Instructions);
template void prove_simplices<4>(std::span<const std::array<Deviator<double>, 4>>,
                                 const Level<double>&, std::span<SimplexProof<double, 4>>,
                                 Instructions);

}  // namespace tensortopo
