// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/sweep/sweep_command.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <stdexcept>

#include "analyze/sweep/sweep_chart.hpp"
#include "check/checkable.hpp"
#include "extract/certificate.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {

bool SweepReport::is_complete() const {
  const auto is_known = [](const SweepEvent& e) { return e.euler_change().has_value(); };
  const auto is_resolved = [](const SweepLevel& level) { return level.unresolved == 0; };
  const auto has_topology = [](const SweepInterval& i) {
    return i.euler_characteristic || !(i.low < i.high);
  };
  return sweep.contradictions.empty() &&
         std::all_of(sweep.intervals.begin(), sweep.intervals.end(), has_topology) &&
         std::all_of(sweep.events.begin(), sweep.events.end(), is_known) &&
         std::all_of(sweep.levels.begin(), sweep.levels.end(), is_resolved);
}

bool SweepReport::is_contradicted() const {
  return !sweep.contradictions.empty() || (check && !check->contradictions.empty());
}

void parse_sweep(std::string_view text, SweepOptions& options) {
  constexpr std::size_t kMost = 100000;
  const auto fail = [&](const std::string& why) {
    throw UsageError("--sweep " + std::string(text) + ": " + why);
  };
  const std::size_t one = text.find(':'), two = text.find(':', one + 1);
  if (one == std::string_view::npos || two == std::string_view::npos) fail("must be A:B:N");
  const std::string_view count = text.substr(two + 1);
  const auto read = std::from_chars(count.data(), count.data() + count.size(), options.samples);
  if (read.ec != std::errc() || read.ptr != count.data() + count.size() || options.samples < 2 ||
      options.samples > kMost)
    fail("N must be a number of modes, 2 to 100000");
  try {
    options.from = parse_mode(text.substr(0, one));
    options.to = parse_mode(text.substr(one + 1, two - one - 1));
  } catch (const std::invalid_argument& problem) {
    fail(problem.what());
  }
  if (!(options.from.approx() < options.to.approx())) fail("A must be less than B");
}

SweepReport run_sweep(const SweepCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (!command.picture.empty() && lower_extension(command.picture) != ".png")
    throw UsageError(command.picture.string() + ": the name must end in .png");
  if (!command.picture.empty()) require_folder(command.picture);
  if (progress) progress("reading", 0);
  if (command.check_modes > 0) require_certifiable(command.read, "surface.vtp", "certificate.cbor");
  SweepReport report;
  const ReadResult read = read_analyzed(command.input, command.read, report);
  if (command.check_modes > 0) require_checkable(command.input, subject_of(read));
  report.options = command.sweep;
  // Checking takes most of the time.
  const double sweep_ends = command.check_modes > 0 ? 0.2 : 0.95;
  const auto part = [&](double from, double to) -> Progress {
    if (!progress) return {};
    return [&progress, from, to](std::string_view stage, double fraction) {
      progress(stage, from + (stage == "levels" ? 0.5 * (to - from) : 0) +
                          fraction * (to - from) * (stage == "checking" ? 1 : 0.5));
    };
  };
  report.sweep = sweep_modes(read.mesh, command.sweep, part(0, sweep_ends));
  if (command.check_modes > 0)
    report.check = check_sweep(report.sweep, command.input, command.read, command.check_modes,
                               part(sweep_ends, 0.95));
  if (!command.picture.empty()) {
    if (progress) progress("drawing", 0.95);
    try {
      write_text(command.picture, sweep_chart(report.sweep, command.sweep));
    } catch (const IoError&) {
      throw;
    } catch (const std::runtime_error& problem) {
      throw IoError(IoError::Kind::unwritable, command.picture, problem.what());
    }
    report.picture = command.picture;
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
