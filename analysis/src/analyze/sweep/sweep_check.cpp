// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/sweep/sweep_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check/check_command.hpp"
#include "counted.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/temporary_folder.hpp"

namespace tensortopo {
namespace {

/// "Next to" a critical value is about this part of the interval away from it.
constexpr double kNear = 1e-3;
/// Surfaces of one certificate.
constexpr std::size_t kBatch = 4;
/// For a level's topology alone.
constexpr double kCoarse = 0.5;

std::string words(const SweepLevel& level) {
  return fmt::format("{}, Euler characteristic {}, {} at {}", counted(level.components, "component"),
                     level.euler_characteristic, counted(level.boundary_loops, "boundary loop"),
                     level.mode.text());
}

bool alike(const SweepLevel& a, const SweepLevel& b) {
  return a.components == b.components && a.euler_characteristic == b.euler_characteristic &&
         a.boundary_loops == b.boundary_loops;
}

bool is_within(long growth, const GrowthBounds& bounds) {
  return bounds.least <= growth && growth <= bounds.most;
}

/// Components, Euler characteristic and boundary loops grow as the event between allows.
void compare_across(const SweepEvent& event, const SweepLevel& before, const SweepLevel& after,
                    SweepCheck& check) {
  const auto change = event.euler_change();
  const auto growth = event.growth();
  if (!change || !growth) {
    check.undecided.push_back(fmt::format(
        "what happens between {} and {}: the sweep does not decide it", event.low, event.high));
    return;
  }
  ++check.compared;
  const long components =
      static_cast<long>(after.components) - static_cast<long>(before.components);
  const bool agrees = after.euler_characteristic - before.euler_characteristic == *change &&
                      is_within(components, (*growth)[0]) &&
                      is_within(after.boundary_loops - before.boundary_loops, (*growth)[1]);
  if (!agrees)
    check.contradictions.push_back(fmt::format(
        "{} and {}: the Euler characteristic should grow by {}, components by {} to {}, loops by "
        "{} to {}",
        words(before), words(after), *change, (*growth)[0].least, (*growth)[0].most,
        (*growth)[1].least, (*growth)[1].most));
}

/// Extracts and certifies some modes. Adds their levels to `check`, and what the checker says.
void certify_levels(const ExtractCommand& command, const std::vector<std::size_t>& intervals,
                    SweepCheck& check) {
  FileGroup read_below(FileGroup::Bond::apart);
  const ExtractReport report = run_extract(command);
  read_below.commit();
  for (std::size_t i = 0; i < report.surfaces.size(); ++i) {
    const SurfaceReport& surface = report.surfaces[i];
    SweepLevel level;
    level.mode = surface.mode;
    level.components = surface.invariants.components;
    level.euler_characteristic = surface.invariants.euler_characteristic;
    level.boundary_loops = surface.invariants.boundary_loops;
    level.area = surface.invariants.area;
    for (const auto& [reason, count] : surface.unresolved) level.unresolved += count;
    check.levels.push_back({intervals[i], std::move(level)});
  }
  const CheckOutcome outcome = run_check(command.input.string(), command.output.string(),
                                         command.certificate.string());
  check.certified += outcome.certified;
  const auto modes = [&] {
    return fmt::format("modes {} to {}", command.modes.front().text(), command.modes.back().text());
  };
  if (outcome.refuted > 0)
    check.contradictions.push_back(
        fmt::format("{}: the checker refutes {} claims", modes(), outcome.refuted));
  if (outcome.undecided > 0)
    check.undecided.push_back(
        fmt::format("{}: the checker leaves {} claims undecided", modes(), outcome.undecided));
}

}  // namespace

ModesToCheck modes_to_check(const Sweep& sweep, std::size_t most) {
  ModesToCheck result;
  const std::size_t all = sweep.events.size();
  const std::size_t events = std::min(all, std::max<std::size_t>(most / 4, 1));
  const auto add = [&](std::size_t i, double low, double high) {
    const SweepInterval& interval = sweep.intervals[i];
    auto mode = low < high ? mode_between(low, high) : std::nullopt;
    // Some doubles wide: its middle is next to its ends.
    if (!mode && interval.low < interval.high) mode = mode_between(interval.low, interval.high);
    if (mode) {
      result.modes.push_back({i, *mode});
    } else {
      result.none.push_back(
          fmt::format("no mode between {} and {}", interval.low, interval.high));
    }
  };
  std::size_t next = 0;  // the first interval without its middle
  for (std::size_t k = 0; k < events; ++k) {
    const std::size_t event = (2 * k + 1) * all / (2 * events);
    const auto &before = sweep.intervals[event], &after = sweep.intervals[event + 1];
    const double near_before = 2 * kNear * (before.high - before.low),
                 near_after = 2 * kNear * (after.high - after.low);
    if (next <= event) add(event, before.low, before.high);
    add(event, std::max(before.low, before.high - near_before), before.high);
    add(event + 1, after.low, std::min(after.high, after.low + near_after));
    add(event + 1, after.low, after.high);
    next = event + 2;
  }
  if (all == 0 && !sweep.intervals.empty()) add(0, sweep.intervals[0].low, sweep.intervals[0].high);
  // Short decimals about the middle may be beyond those next to an end.
  std::sort(result.modes.begin(), result.modes.end(), [](const auto& a, const auto& b) {
    return a.mode.approx() < b.mode.approx();
  });
  const auto end = std::unique(result.modes.begin(), result.modes.end(),
                               [](const auto& a, const auto& b) { return a.mode == b.mode; });
  result.modes.erase(end, result.modes.end());
  result.events = events;
  return result;
}

void compare_levels(const Sweep& sweep, SweepCheck& check) {
  const CheckedLevel* before = nullptr;
  for (const CheckedLevel& checked : check.levels) {
    const SweepLevel& level = checked.level;
    if (level.unresolved > 0) {
      check.undecided.push_back(
          fmt::format("{}: {} tetrahedra unresolved", level.mode.text(), level.unresolved));
      continue;
    }
    const auto& known = sweep.intervals[checked.interval].euler_characteristic;
    if (!known) {
      check.undecided.push_back(
          fmt::format("{}: the sweep does not know the Euler characteristic", level.mode.text()));
    } else if (*known != level.euler_characteristic) {
      check.contradictions.push_back(
          fmt::format("{}: the sweep says Euler characteristic {}", words(level), *known));
    }
    if (before && before->interval == checked.interval && !alike(before->level, level))
      check.contradictions.push_back(
          fmt::format("{} and {}, with no critical value between", words(before->level),
                      words(level)));
    if (before && before->interval + 1 == checked.interval)
      compare_across(sweep.events[before->interval], before->level, level, check);
    before = &checked;
  }
}

SweepCheck check_sweep(const Sweep& sweep, const std::filesystem::path& input,
                       const ReadOptions& read, std::size_t modes, const Progress& progress) {
  const ModesToCheck chosen = modes_to_check(sweep, modes);
  TemporaryFolder folder;
  SweepCheck check;
  check.events = sweep.events.size();
  check.undecided = chosen.none;
  ExtractCommand command;
  command.input = input;
  command.read = read;
  command.sampling.resolution = kCoarse;
  command.output = folder.file("surface.vtp");
  command.certificate = folder.file("certificate.cbor");
  for (std::size_t i = 0; i < chosen.modes.size(); i += kBatch) {
    if (progress) {
      progress("checking", static_cast<double>(i) / static_cast<double>(chosen.modes.size()));
    }
    command.modes.clear();
    std::vector<std::size_t> intervals;
    for (std::size_t j = i; j < std::min(i + kBatch, chosen.modes.size()); ++j) {
      command.modes.push_back(chosen.modes[j].mode);
      intervals.push_back(chosen.modes[j].interval);
    }
    certify_levels(command, intervals, check);
  }
  compare_levels(sweep, check);
  return check;
}

}  // namespace tensortopo
