// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "bench/bench_command.hpp"

namespace tensortopo {

std::string to_json(const BenchReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["input"] = report.input.string();
  json["tetrahedra"] = report.tetrahedra;
  json["modes"] = Json::array();
  for (const ModeValue& mode : report.modes) json["modes"].push_back(mode.approx());
  json["threads"] = report.threads;
  const double ours = report.series.front().median();
  for (const BenchSeries& series : report.series) {
    json["times"][series.name] = series.median();
    json["all_times"][series.name] = series.seconds;
    json["triangles"][series.name] = series.triangles;
  }
  for (std::size_t i = 1; i < report.series.size(); ++i) {
    json["ratios"]["extract_over_" + report.series[i].name] = ours / report.series[i].median();
  }
  json["stages"] = report.stages;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const BenchReport& report) {
  std::string text, modes;
  const auto out = std::back_inserter(text);
  for (const ModeValue& mode : report.modes) modes += fmt::format(" +-{}", mode.text());
  fmt::format_to(out, "{}: {} tetrahedra, modes{}, {} threads, medians of {}\n",
                 report.input.string(), report.tetrahedra, modes, report.threads,
                 report.series.front().seconds.size());
  fmt::format_to(out, "{:<28} {:>10} {:>10} {:>14}\n", "", "seconds", "triangles", "extract over");
  const double ours = report.series.front().median();
  for (const BenchSeries& series : report.series) {
    fmt::format_to(out, "{:<28} {:>10.4f} {:>10} {:>14.3f}\n", series.name, series.median(),
                   series.triangles, ours / series.median());
  }
  for (const auto& [stage, seconds] : report.stages) {
    fmt::format_to(out, "  {:<26} {:>10.4f}\n", stage, seconds);
  }
  fmt::format_to(out, "peak memory {:.0f} MB\n",
                 static_cast<double>(report.peak_memory_bytes) / 1e6);
  return text;
}

}  // namespace tensortopo
