// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Compiled for AVX2, where that is known, and called where the processor has it. Nothing in here
// may have linkage but the kernels: a function of a library that was compiled here could be
// the one that the linker keeps for all.
#include "extract/level/proofs/direction_in_lanes.hpp"

#include <cmath>
#include <cstring>

#include "extract/level/lanes/lanes.hpp"
#include "extract/level/proofs/unit_directions.hpp"

namespace tensortopo {

namespace {

/// `DirectionSearch` with its unit directions in lanes. What fills the last lanes is the first
/// direction again, with no weight, so it is never chosen.
template <std::size_t Vertices>
class SearchInLanes {
  using Search = DirectionSearch<Vertices>;
  static constexpr std::size_t count = Search::count;
  static constexpr std::size_t kFours = (count + Lanes::count - 1) / Lanes::count;
  using Row = double[kFours * Lanes::count];

 public:
  explicit SearchInLanes(const Search& search) {
    for (std::size_t i = 0; i < Vertices; ++i) {
      d_[i] = search.d[i];
      for (std::size_t k = 0; k < count; ++k) unit_[i][k] = search.unit[i][k];
      fill(unit_[i], unit_[i][0]);
    }
    for (std::size_t k = 0; k < count; ++k) weight_[k] = search.weight[k];
    fill(weight_, 0);
  }

  SearchInLanes(const LevelIncrease<double, Vertices>& increase, bool of_sum_zero) {
    for (std::size_t i = 0; i < Vertices; ++i) {
      for (std::size_t k = 0; k < count; ++k)
        unit_[i][k] = increase.along[i][k] + increase.along[i][count + k];
      fill(unit_[i], unit_[i][0]);
    }
    for (std::size_t four = 0; four < kFours; ++four) {
      std::array<Lanes, Vertices> unit;
      for (std::size_t i = 0; i < Vertices; ++i) unit[i] = at(unit_[i], four);
      make_units(unit, of_sum_zero);
      for (std::size_t i = 0; i < Vertices; ++i) set(unit_[i], four, unit[i]);
    }
    for (std::size_t i = 0; i < Vertices; ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += unit_[i][k];
      d_[i] = sum / count;
    }
    for (std::size_t k = 0; k < count; ++k) weight_[k] = 1.0 / count;
    fill(weight_, 0);
  }

  /// Whether all is finite: else the order of what is not a number would matter.
  bool is_finite() const {
    for (const double x : d_)
      if (!(x - x == 0)) return false;
    return true;
  }

  std::array<double, Vertices> run(int step, int steps) {
    for (;; ++step) {
      const auto [least, most] = extremes();
      double square = 0;
      for (const double x : d_) square += x * x;
      if (least.growth > Search::enough) break;
      if (!(square > Search::nothing * Search::nothing) || step == steps) return {};
      double way[Vertices], gap = 0;
      for (std::size_t i = 0; i < Vertices; ++i) {
        way[i] = unit_[i][least.place] - unit_[i][most.place];
        gap += way[i] * way[i];
      }
      if (!(gap > 0)) return {};
      const double whole = (most.growth - least.growth) / gap, rest = weight_[most.place];
      const double shift = whole < rest ? whole : rest;
      weight_[least.place] += shift;
      weight_[most.place] -= shift;
      for (std::size_t i = 0; i < Vertices; ++i) d_[i] += shift * way[i];
    }
    double largest = 0;
    for (const double x : d_) largest = largest < std::fabs(x) ? std::fabs(x) : largest;
    std::array<double, Vertices> direction;
    for (std::size_t i = 0; i < Vertices; ++i) direction[i] = d_[i] / largest;
    return direction;
  }

 private:
  struct Extreme {
    double growth;
    std::size_t place;
  };
  struct Extremes {
    Extreme least;
    Extreme most;  ///< of those that have weight
  };

  static Lanes at(const Row& row, std::size_t four) {
    Lanes lanes;
    std::memcpy(&lanes.v, row + four * Lanes::count, sizeof lanes.v);
    return lanes;
  }
  static void set(Row& row, std::size_t four, const Lanes& lanes) {
    std::memcpy(row + four * Lanes::count, &lanes.v, sizeof lanes.v);
  }
  static void fill(Row& row, double x) {
    for (std::size_t k = count; k < kFours * Lanes::count; ++k) row[k] = x;
  }

  Extremes extremes() const {
    const Lanes none(-__builtin_inf());
    Lanes d[Vertices];
    for (std::size_t i = 0; i < Vertices; ++i) d[i] = Lanes(d_[i]);
    Lanes low(0), high(none), least(0), most(0), place(Lanes::Vector{0, 1, 2, 3});
    for (std::size_t four = 0; four < kFours; ++four, place = place + Lanes(4)) {
      Lanes growth = d[0] * at(unit_[0], four);
      for (std::size_t i = 1; i < Vertices; ++i) growth = growth + d[i] * at(unit_[i], four);
      const Lanes::Mask lower = four == 0 ? ~Lanes::Mask{} : growth < low;
      low = select(lower, growth, low);
      least = select(lower, place, least);
      const Lanes weighed = select(at(weight_, four) > Lanes(0), growth, none);
      const Lanes::Mask higher = weighed > high;
      high = select(higher, weighed, high);
      most = select(higher, place, most);
    }
    // Of equal ones the first.
    std::size_t l = 0, m = 0;
    for (std::size_t lane = 1; lane < Lanes::count; ++lane) {
      if (low[lane] < low[l] || (low[lane] == low[l] && least[lane] < least[l])) l = lane;
      if (high[lane] > high[m] || (high[lane] == high[m] && most[lane] < most[m])) m = lane;
    }
    return {{low[l], static_cast<std::size_t>(static_cast<int>(least[l]))},
            {high[m], static_cast<std::size_t>(static_cast<int>(most[m]))}};
  }

  Row unit_[Vertices];  ///< by coordinate
  Row weight_;
  double d_[Vertices];
};

template <std::size_t Vertices>
std::array<double, Vertices> found(SearchInLanes<Vertices> search, int step, int steps) {
  return search.is_finite() ? search.run(step, steps) : std::array<double, Vertices>{};
}

}  // namespace

std::array<double, 3> direction_in_lanes(const LevelIncrease<double, 3>& increase, int steps,
                                         bool of_sum_zero) {
  return found(SearchInLanes<3>(increase, of_sum_zero), 0, steps);
}

std::array<double, 4> direction_in_lanes(const LevelIncrease<double, 4>& increase, int steps,
                                         bool of_sum_zero) {
  return found(SearchInLanes<4>(increase, of_sum_zero), 0, steps);
}

std::array<double, 3> direction_in_lanes(const DirectionSearch<3>& search, int step, int steps) {
  return found(SearchInLanes<3>(search), step, steps);
}

std::array<double, 4> direction_in_lanes(const DirectionSearch<4>& search, int step, int steps) {
  return found(SearchInLanes<4>(search), step, steps);
}

}  // namespace tensortopo
