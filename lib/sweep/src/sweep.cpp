// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/sweep/sweep.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/prepared_field.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/scalar/rational.hpp"

namespace tensortopo {
namespace {

/// For a level's topology alone.
constexpr double kCoarse = 0.5;

Rational exact(const ModeValue& mode) { return to_scalar<Rational>(mode); }

ModeValue mode_of(const Rational& value) { return ModeValue::parse(value.str()); }

SweepLevel level_at(const PreparedField<double>& field, const ModeValue& mode,
                    const Sampling& sampling) {
  ExtractOptions options;
  options.sampling = sampling;
  const Extraction extraction = extract_mode_surface(field, mode, options);
  const SurfaceInvariants invariants = surface_invariants(extraction.surface);
  SweepLevel level;
  level.mode = mode;
  level.components = invariants.components;
  level.euler_characteristic = invariants.euler_characteristic;
  level.boundary_loops = invariants.boundary_loops;
  level.area = invariants.area;
  level.unresolved = extraction.unresolved.size();
  return level;
}

/// Critical points whose brackets leave no double between them, together.
std::vector<SweepEvent> group(std::vector<MeshCriticalPoint> points) {
  std::vector<SweepEvent> events;
  for (MeshCriticalPoint& point : points) {
    if (events.empty() || mode_between(events.back().high, point.low))
      events.push_back({point.low, point.high, {}});
    SweepEvent& event = events.back();
    event.high = std::max(event.high, point.high);
    event.points.push_back(std::move(point));
  }
  return events;
}

std::vector<SweepInterval> intervals_between(const std::vector<SweepEvent>& events, double low,
                                             double high) {
  std::vector<SweepInterval> intervals;
  for (const SweepEvent& event : events) {
    intervals.push_back({low, std::max(low, event.low), {}, {}});
    low = event.high;
  }
  intervals.push_back({low, std::max(low, high), {}, {}});
  return intervals;
}

/// The interval that certainly holds a mode. (A double that rounds a mode may be at an end of an
/// event and the mode in it.)
std::optional<std::size_t> interval_of(const Sweep& sweep, const ModeValue& mode) {
  const Rational value = exact(mode);
  const auto event =
      std::partition_point(sweep.events.begin(), sweep.events.end(),
                           [&](const SweepEvent& e) { return Rational(e.high) < value; });
  if (event != sweep.events.end() && Rational(event->low) <= value) return std::nullopt;
  return static_cast<std::size_t>(event - sweep.events.begin());
}

/// All of them, the widest first, or if these are too many the widest few.
std::vector<std::size_t> intervals_to_look_at(const Sweep& sweep, std::size_t most) {
  std::vector<std::size_t> order(sweep.intervals.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto width = [&](std::size_t i) {
    return sweep.intervals[i].high - sweep.intervals[i].low;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return width(i) > width(j); });
  if (order.size() > most) order.resize(std::min(most, kWidestIntervals));
  return order;
}

/// Carries Euler characteristics from levels to the intervals around, and notes where two differ.
void spread_euler_characteristics(Sweep& sweep) {
  for (std::size_t i = 0; i < sweep.levels.size(); ++i) {
    const SweepLevel& level = sweep.levels[i];
    const auto here = interval_of(sweep, level.mode);
    if (!here || level.unresolved > 0) continue;
    SweepInterval& interval = sweep.intervals[*here];
    if (interval.euler_characteristic) {
      if (*interval.euler_characteristic != level.euler_characteristic)
        sweep.contradictions.push_back(i);
      continue;
    }
    interval.euler_characteristic = level.euler_characteristic;
    for (std::size_t k = *here; k > 0; --k) {
      const auto change = sweep.events[k - 1].euler_change();
      auto& before = sweep.intervals[k - 1].euler_characteristic;
      if (!change || before) break;
      before = *sweep.intervals[k].euler_characteristic - *change;
    }
    for (std::size_t k = *here; k < sweep.events.size(); ++k) {
      const auto change = sweep.events[k].euler_change();
      auto& after = sweep.intervals[k + 1].euler_characteristic;
      if (!change || after) break;
      after = *sweep.intervals[k].euler_characteristic + *change;
    }
  }
}

}  // namespace

std::optional<long> SweepEvent::euler_change() const {
  long sum = 0;
  for (const MeshCriticalPoint& point : points) {
    if (point.effect.change == LocalChange::undecided) return std::nullopt;
    sum += point.effect.euler_change;
  }
  return sum;
}

std::optional<std::array<GrowthBounds, 2>> SweepEvent::growth() const {
  std::array<GrowthBounds, 2> sum;
  for (const MeshCriticalPoint& point : points) {
    if (point.effect.change == LocalChange::undecided) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& one = i == 0 ? point.effect.components : point.effect.boundary_loops;
      sum[i].least += one.least;
      sum[i].most += one.most;
    }
  }
  return sum;
}

std::optional<ModeValue> mode_between(double low, double high) {
  if (!(std::nextafter(low, 2.0) < high)) return std::nullopt;
  const double middle = low + (high - low) / 2;
  for (int digits = 0; digits <= 17; ++digits) {
    std::array<char, 32> characters;
    char* const end = std::to_chars(characters.begin(), characters.end(), middle,
                                    std::chars_format::scientific, digits)
                          .ptr;
    const std::string text(characters.begin(), end);
    const double value = std::strtod(text.c_str(), nullptr);
    // What rounds to a double between two others is itself between them. ModeValue holds no
    // numbers next to zero.
    if (value > low && value < high && (value == 0 || std::abs(value) > 1e-280))
      return ModeValue::parse(value == 0 ? "0" : text);
  }
  // All numbers between are next to zero, or zero.
  return low < 0 && high > 0 ? std::optional(ModeValue()) : std::nullopt;
}

Sweep sweep_modes(const TetMesh& mesh, const SweepOptions& options,
                  const std::function<void(std::string_view, double)>& progress) {
  const Rational from = exact(options.from), to = exact(options.to);
  if (!(from < to)) throw std::invalid_argument("the modes must ascend");
  if (options.samples < 2) throw std::invalid_argument("there must be two samples at least");
  const auto tell = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  tell("critical values", 0);
  const double low = options.from.approx(), high = options.to.approx();
  // At mode 1 there are degenerate curves, and no surface.
  MeshCriticalValues found =
      mesh_critical_values(mesh, low, high == 1 ? std::nextafter(1.0, 0.0) : high);
  Sweep sweep;
  sweep.looked_at = found.looked_at;
  sweep.events = group(std::move(found.points));
  sweep.intervals = intervals_between(sweep.events, low, high);

  // The samples, and where there is none a level in each interval.
  std::vector<std::pair<Rational, bool>> modes;  // and whether it is a sample
  std::vector<char> has_sample(sweep.intervals.size(), 0);
  for (std::size_t i = 0; i < options.samples; ++i) {
    const Rational mode = from + (to - from) * Rational(i) / Rational(options.samples - 1);
    if (abs(mode) == 1) continue;  // degenerate curves are no surface
    modes.emplace_back(mode, true);
    if (const auto interval = interval_of(sweep, mode_of(mode))) has_sample[*interval] = 1;
  }
  for (const std::size_t i : intervals_to_look_at(sweep, options.most_levels)) {
    const SweepInterval& interval = sweep.intervals[i];
    if (has_sample[i] != 0 || !(interval.low < interval.high)) continue;
    if (const auto mode = mode_between(interval.low, interval.high))
      modes.emplace_back(exact(*mode), false);
  }
  std::sort(modes.begin(), modes.end());
  const PreparedField<double> field(mesh);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    tell("levels", static_cast<double>(i) / static_cast<double>(modes.size()));
    const auto& [value, is_sample] = modes[i];
    const ModeValue mode = mode_of(value);
    sweep.levels.push_back(level_at(field, mode, is_sample ? Sampling{} : Sampling{kCoarse}));
    if (is_sample) sweep.samples.push_back(i);
    if (const auto interval = interval_of(sweep, mode))
      if (auto& level = sweep.intervals[*interval].level;
          !level || sweep.levels[*level].unresolved > sweep.levels[i].unresolved)
        level = i;
  }
  spread_euler_characteristics(sweep);
  return sweep;
}

}  // namespace tensortopo
