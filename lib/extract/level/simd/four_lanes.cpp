// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2, where that is known, and called where the processor has it. Nothing in here
// may have linkage but the two kernels: a function of a library that was compiled here could be
// the one that the linker keeps for all.
#include "extract/level/simd/four_lanes.hpp"

#include "extract/level/level_slope.hpp"
#include "extract/level/proofs/direction_search.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/simd/lanes.hpp"

namespace tensortopo {

namespace {

using Mask = Lanes::Mask;

/// As far as the formulas look at it.
struct LaneLevel {
  Lanes mu, sqrt2;

  explicit LaneLevel(const LevelNumbers& level) : mu(level.mu), sqrt2(level.sqrt2) {}
};

/// A lane of each simplex; the last one in those to spare.
template <std::size_t Vertices>
std::array<Deviator<Lanes>, Vertices> in_lanes(
    std::span<const std::array<Deviator<double>, Vertices>> simplices) {
  std::array<Deviator<Lanes>, Vertices> result;
  const std::array<Deviator<double>, Vertices>* of[Lanes::count];
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    of[lane] = &simplices[lane < simplices.size() ? lane : simplices.size() - 1];
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
Mask crossed_lanes(const std::array<Deviator<Lanes>, Vertices>& tensors, const LaneLevel& level) {
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
  Mask sound;  ///< where the bounds hold and the lower one is positive
  Lanes norm;  ///< the largest of a vertex
  LevelIncrease<Lanes, Vertices> increase;
};

/// As in `prove_simplex`: `largest_norm`, `mode_forms`, `norm_bounds`, and the cubics of these.
template <std::size_t Vertices>
Ground<Vertices> ground(const std::array<Deviator<Lanes>, Vertices>& tensors,
                        const LaneLevel& level) {
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
  return {sound, sqrt(largest), LevelIncrease<Lanes, Vertices>(forms, bounds, level)};
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
  LaneSearch(const LevelIncrease<Lanes, Vertices>& increase, bool of_sum_zero) {
    d_.fill(Lanes(0));
    for (std::size_t k = 0; k < count; ++k) {
      std::array<Lanes, Vertices> unit;
      for (std::size_t i = 0; i < Vertices; ++i)
        unit[i] = increase.along[i][k] + increase.along[i][count + k];
      if (of_sum_zero) {
        Lanes mean(0);
        for (const auto& x : unit) mean = mean + x / Lanes(static_cast<int>(Vertices));
        for (auto& x : unit) x = x - mean;
      }
      Lanes square(0);
      for (const auto& x : unit) square = square + x * x;
      const Lanes factor = Lanes(1) / sqrt(square);
      for (std::size_t i = 0; i < Vertices; ++i) {
        unit_[i][k] = unit[i] * factor;
        d_[i] = d_[i] + unit_[i][k];
      }
    }
    for (auto& x : d_) x = x / Lanes(static_cast<int>(count));
    weight_.fill(Lanes(1.0 / count));
  }

  /// Searches in the lanes given; the direction is 0 where there is none. Lanes with what is not a
  /// number, or infinite, are taken out. One that takes longer than all others goes on alone.
  void run(Mask& known, std::array<Lanes, Vertices>& direction) {
    for (const auto& x : d_) known &= (x - x).v == Lanes(0).v;
    Mask lanes = known, found{};
    int step = 0;
    unsigned left = 0;
    for (;; ++step) {
      Lanes low(0), high(-__builtin_inf());
      Lanes least(0), most(0), place(0);
      for (std::size_t k = 0; k < count; ++k, place = place + Lanes(1)) {
        Lanes growth = d_[0] * unit_[0][k];
        for (std::size_t i = 1; i < Vertices; ++i) growth = growth + d_[i] * unit_[i][k];
        const Mask lower = k == 0 ? ~Mask{} : growth < low;
        low = select(lower, growth, low);
        least = select(lower, place, least);
        const Mask higher = (weight_[k] > Lanes(0)) & (growth > high);
        high = select(higher, growth, high);
        most = select(higher, place, most);
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
    for (std::size_t i = 0; i < Vertices; ++i)
      direction[i] = select(found, d_[i] / largest, Lanes(0));
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      if (!(left >> lane & 1) || step == kLongSearch) continue;
      const auto alone = finished(lane, step);
      for (std::size_t i = 0; i < Vertices; ++i) direction[i].v[lane] = alone[i];
    }
  }

 private:
  using Search = DirectionSearch<Vertices>;
  static constexpr std::size_t count = Search::count;
  static constexpr int kTogether = 4;
  static std::size_t as_index(double place) {
    return static_cast<std::size_t>(static_cast<int>(place));
  }

  /// A step of the lanes given, from the least of the unit directions in place of the most.
  void move(Mask& lanes, const Lanes& low, const Lanes& high, const Lanes& least,
            const Lanes& most) {
    const auto at = [](const std::array<Lanes, count>& x, const Lanes& k) {
      return Lanes(Lanes::Vector{x[as_index(k[0])].v[0], x[as_index(k[1])].v[1],
                                 x[as_index(k[2])].v[2], x[as_index(k[3])].v[3]});
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
      weight_[as_index(least[lane])].v[lane] += shift[lane];
      weight_[as_index(most[lane])].v[lane] -= shift[lane];
    }
    for (std::size_t i = 0; i < Vertices; ++i) d_[i] = select(lanes, d_[i] + shift * way[i], d_[i]);
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

/// As `detail::meets_outside`.
template <std::size_t Vertices>
Mask outside_lanes(const std::array<Lanes, Vertices>& d) {
  Mask all_up = ~Mask{}, all_down = ~Mask{}, some = Mask{};
  for (const auto& x : d) {
    all_up &= x > Lanes(0), all_down &= x < Lanes(0);
    some |= (x > Lanes(0)) | (x < Lanes(0));
  }
  return ~all_up & ~all_down & some;
}

/// `prove_simplex` of simplices with vertices on both sides.
template <std::size_t Vertices>
LaneProofs prove_lanes(std::span<const std::array<Deviator<double>, Vertices>> simplices,
                       const LaneLevel& level,
                       std::array<std::array<double, Vertices>, kLaneCount>& directions) {
  const auto tensors = in_lanes(simplices);
  const auto on = ground(tensors, level);
  // Known so far, to the end; with a direction to be proved.
  Mask known = on.sound & crossed_lanes(tensors, level), found{};
  std::array<Lanes, Vertices> d{}, other;
  for (const bool of_sum_zero : {false, true}) {
    Mask searching = known & ~found;
    if (bits(searching) == 0) break;
    const Mask before = searching;
    LaneSearch<Vertices>(on.increase, of_sum_zero).run(searching, other);
    known &= ~before | searching;
    for (std::size_t i = 0; i < Vertices; ++i) d[i] = select(searching, other[i], d[i]);
    found |= searching & outside_lanes(other);
  }
  const Mask proved = known & found & increases_in(on, d);
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    for (std::size_t i = 0; i < Vertices; ++i) directions[lane][i] = d[i][lane];
  // Without a direction: no proof, and no rounding that hides one.
  return {bits(proved), bits(known & ~found)};
}

struct LaneSlope {
  Lanes value{};
  SymmetricTensor<Lanes> slope{};
};

/// As `segment_root`, between ends that are strictly on their sides: the lanes in which they are
/// not are taken out of `lanes`.
Lanes roots_between(const Deviator<Lanes>& below, const Deviator<Lanes>& above,
                    const LaneLevel& level, Mask& lanes) {
  const Deviator<Lanes> step = above - below;
  const auto step3 = thrice(step);
  const auto value_at = [&](const Deviator<Lanes>& t) {  // as `level_function`
    const Lanes p = norm_form(t);
    return level.sqrt2 * determinant_form(t) - level.mu * p * sqrt(p);
  };
  const Lanes f0 = value_at(below), f1 = value_at(above);
  const Lanes half(0.5), tiny(unit_roundoff<double>());
  lanes &= (f0 < Lanes(0)) & (f1 > Lanes(0));
  Lanes lo(0), hi(1), t = -f0 / (f1 - f0);
  t = select((t > lo) & (t < hi), t, half * (lo + hi));
  Mask active = lanes;
  for (int iteration = 0; iteration < 400 && bits(active) != 0; ++iteration) {
    const auto at = detail::slope_at<LaneSlope>(below + t * step, level);
    const Mask less = at.value<Lanes(0), more = at.value> Lanes(0);
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
                 std::span<const char> rising, const LaneLevel& level, std::span<double> weights) {
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

}  // namespace

static_assert(kLaneCount == Lanes::count);

LaneProofs prove_four(std::span<const std::array<Deviator<double>, 3>> triangles,
                      const LevelNumbers& level,
                      std::array<std::array<double, 3>, kLaneCount>& directions) {
  return prove_lanes(triangles, LaneLevel(level), directions);
}

LaneProofs prove_four(std::span<const std::array<Deviator<double>, 4>> tets,
                      const LevelNumbers& level,
                      std::array<std::array<double, 4>, kLaneCount>& directions) {
  return prove_lanes(tets, LaneLevel(level), directions);
}

void cross_four(std::span<const std::array<Deviator<double>, 2>> ends, std::span<const char> rising,
                const LevelNumbers& level, std::span<double> weights) {
  cross_lanes(ends, rising, LaneLevel(level), weights);
}

}  // namespace tensortopo
