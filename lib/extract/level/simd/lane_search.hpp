// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "extract/level/lanes/lanes.hpp"
#include "extract/level/proofs/direction_search.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/proofs/unit_directions.hpp"

namespace tensortopo {

// Without linkage, see `Lanes`.
namespace {

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
      make_units(unit, of_sum_zero);
      for (std::size_t i = 0; i < Vertices; ++i) {
        unit_[i][k] = unit[i];
        d_[i] = d_[i] + unit_[i][k];
      }
    }
    for (auto& x : d_) x = x / Lanes(static_cast<int>(count));
    weight_.fill(Lanes(1.0 / count));
  }

  /// Searches in the lanes given; the direction is 0 where there is none. Lanes with what is not a
  /// number, or infinite, are taken out. One that takes longer than all others goes on alone.
  void run(Lanes::Mask& known, std::array<Lanes, Vertices>& direction) {
    for (const auto& x : d_) known &= (x - x).v == Lanes(0).v;
    Lanes::Mask lanes = known, found{};
    int step = 0;
    unsigned left = 0;
    for (;; ++step) {
      Lanes low(0), high(-__builtin_inf());
      Lanes least(0), most(0), place(0);
      for (std::size_t k = 0; k < count; ++k, place = place + Lanes(1)) {
        Lanes growth = d_[0] * unit_[0][k];
        for (std::size_t i = 1; i < Vertices; ++i) growth = growth + d_[i] * unit_[i][k];
        const Lanes::Mask lower = k == 0 ? ~Lanes::Mask{} : growth < low;
        low = select(lower, growth, low);
        least = select(lower, place, least);
        const Lanes::Mask higher = (weight_[k] > Lanes(0)) & (growth > high);
        high = select(higher, growth, high);
        most = select(higher, place, most);
      }
      const Lanes::Mask enough = lanes & (low > Lanes(Search::enough));
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
  void move(Lanes::Mask& lanes, const Lanes& low, const Lanes& high, const Lanes& least,
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

}  // namespace
}  // namespace tensortopo
