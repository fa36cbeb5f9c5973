// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace tensortopo {

/// A contender's times, one for each repetition, for all modes together.
struct BenchSeries {
  std::string name;
  std::vector<double> seconds;
  std::size_t triangles = 0;
  double median() const;
};

/// Something to be timed: returns the number of triangles that it made.
struct Contender {
  std::string name;
  std::function<std::size_t()> run;
};

double seconds_of(const std::function<void()>& work);

/// Where the median stands among the values (the upper one of two). Requires one value or more.
std::size_t median_place(const std::vector<double>& values);

/// Runs all of them in turn, `repeat` times over, so that whatever else the machine does meets all
/// of them alike; after each run `told` gets the contender's place and how much of all is done.
///
/// @param longest  seconds; a further round begins only if as long as the one before it would not
///                 exceed them. The first round is always run.
std::vector<BenchSeries> time_in_turn(
    const std::vector<Contender>& contenders, int repeat,
    const std::function<void(std::size_t contender, double fraction)>& told = {},
    double longest = std::numeric_limits<double>::infinity());

/// The exponent p of the power law y = c x^p that fits best: the slope of the line through
/// (log x, log y) with the least squares. NaN for fewer than two different x; all values positive.
double power_law_exponent(const std::vector<double>& x, const std::vector<double>& y);

/// The share s of the time with one thread that more threads do not shorten: by Amdahl's law
/// T(n) = T(1) (s + (1 - s) / n), with the least squares of T(n) / T(1).
///
/// @param threads  the first is 1; all positive
/// NaN if none is more than 1. Noise can make it negative.
double serial_share(const std::vector<double>& threads, const std::vector<double>& seconds);

}  // namespace tensortopo
