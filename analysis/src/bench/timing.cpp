// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace tensortopo {

double BenchSeries::median() const { return seconds.at(median_place(seconds)); }

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t median_place(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order[order.size() / 2];
}

std::vector<BenchSeries> time_in_turn(
    const std::vector<Contender>& contenders, int repeat,
    const std::function<void(std::size_t contender, double fraction)>& told, double longest) {
  std::vector<BenchSeries> series;
  double all = 0, last = 0;  // seconds of the rounds
  for (const Contender& contender : contenders) series.push_back({contender.name, {}, 0});
  for (int round = 0; round < repeat && (round == 0 || all + last <= longest); ++round) {
    last = 0;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      series[i].seconds.push_back(seconds_of([&] { series[i].triangles = contenders[i].run(); }));
      last += series[i].seconds.back();
      const auto done = static_cast<std::size_t>(round) * contenders.size() + i + 1;
      if (told)
        told(i, static_cast<double>(done) /
                    (static_cast<double>(repeat) * static_cast<double>(contenders.size())));
    }
    all += last;
  }
  return series;
}

double power_law_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sum_x = 0, sum_y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum_x += std::log(x[i]), sum_y += std::log(y[i]);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]) - sum_x / n, v = std::log(y[i]) - sum_y / n;
    xx += u * u;
    xy += u * v;
  }
  return xx > 0 ? xy / xx : std::nan("");
}

double serial_share(const std::vector<double>& threads, const std::vector<double>& seconds) {
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const double shrunk = 1 - 1 / threads[i];
    xx += shrunk * shrunk;
    xy += shrunk * (seconds[i] / seconds[0] - 1 / threads[i]);
  }
  return xx > 0 ? xy / xx : std::nan("");
}

}  // namespace tensortopo
