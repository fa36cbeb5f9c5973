// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2, where that is known, and called where the processor has it. Nothing in here
// may have linkage but the kernels: a function of a library that was compiled here could be
// the one that the linker keeps for all.
#include "extract/level/simd/four_lanes.hpp"

#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/simd/lane_roots.hpp"
#include "extract/level/simd/lane_search.hpp"

namespace tensortopo {

namespace {

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

/// What all proofs want of a simplex.
template <std::size_t Vertices>
struct BoundedForms {
  ModeForms<Lanes, Vertices> forms;
  NormBounds<Lanes, Vertices> bounds;
  Mask sound;  ///< where the bounds hold and the lower one is positive
  Lanes norm;  ///< the largest of a vertex
};

/// As in `prove_simplex`: `largest_norm`, `mode_forms`, `norm_bounds`.
template <std::size_t Vertices>
BoundedForms<Vertices> bounded_forms(const std::array<Deviator<Lanes>, Vertices>& tensors) {
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
  return {forms, bounds, sound, sqrt(largest)};
}

/// Where `detail::has_strict_sign` would say yes: `sign` is 1 or -1.
template <class Polynomial>
Mask strictly_signed(const Polynomial& p, const Lanes& sign, const Lanes& bound) {
  Mask all = ~Mask{};
  for (std::size_t i = 0; i < p.size; ++i)
    all &= sign * p.coefficients[i] > Lanes(static_cast<double>(p.multinomials[i])) * bound;
  return all;
}

/// Of up to four simplices: where `is_proved_empty` would say yes, and where this tells.
template <std::size_t Vertices>
LaneEmptiness empty_lanes(std::span<const std::array<Deviator<double>, Vertices>> simplices,
                          const LevelNumbers& numbers) {
  const auto on = bounded_forms(in_lanes(simplices));
  const LaneLevel level(numbers);
  const Lanes u = rounding_unit_of(on.norm), cube = on.norm * on.norm * on.norm;
  const Mask opposite = strictly_signed(on.forms.determinant, Lanes(-numbers.sign),
                                        Lanes(detail::kDeterminantBound) * u * cube);
  const RootBounds<Lanes, Vertices> root(on.forms, on.bounds);
  const Mask above =
      on.forms.determinant.coefficients[0] >
      Lanes(3) * level.sqrt2 * level.mu * on.forms.norm.coefficients[0] * on.bounds.upper[0];
  // As `side_form`, which takes the tangent on one side and the chord on the other.
  auto bound = root.tangent;
  const Mask by_tangent = numbers.mu > 0 ? above : ~above;
  for (std::size_t i = 0; i < bound.size; ++i)
    bound.coefficients[i] =
        select(by_tangent, root.tangent.coefficients[i], root.chord.coefficients[i]);
  const Lanes factor = Lanes(3) * level.sqrt2 * level.mu;
  const auto form = root.l * on.forms.determinant - factor * (on.forms.norm * bound);
  const Mask strict = strictly_signed(form, select(above, Lanes(1), Lanes(-1)),
                                      Lanes(detail::kSideBound) * u * cube * on.norm);
  return {bits(on.sound & (opposite | strict)), bits(on.sound)};
}

/// What proofs of a direction want of a simplex.
template <std::size_t Vertices>
struct Ground {
  Mask sound;
  Lanes norm;
  LevelIncrease<Lanes, Vertices> increase;
};

/// The same with the cubics of these.
template <std::size_t Vertices>
Ground<Vertices> ground(const std::array<Deviator<Lanes>, Vertices>& tensors,
                        const LaneLevel& level) {
  const auto on = bounded_forms(tensors);
  return {on.sound, on.norm, LevelIncrease<Lanes, Vertices>(on.forms, on.bounds, level)};
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

LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 2>> edges,
                         const LevelNumbers& level) {
  return empty_lanes(edges, level);
}

LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 3>> triangles,
                         const LevelNumbers& level) {
  return empty_lanes(triangles, level);
}

LaneEmptiness empty_four(std::span<const std::array<Deviator<double>, 4>> tets,
                         const LevelNumbers& level) {
  return empty_lanes(tets, level);
}

void cross_four(std::span<const std::array<Deviator<double>, 2>> ends, std::span<const char> rising,
                const LevelNumbers& level, std::span<double> weights) {
  cross_lanes(ends, rising, LaneLevel(level), weights);
}

}  // namespace tensortopo
