// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "append_format.hpp"
#include "bench/bench_command.hpp"
#include "short_text.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: the distance to an empty surface.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Spread& spread) {
  return {{"root_mean_square", number(spread.root_mean_square())},
          {"largest", number(spread.largest)},
          {"samples", spread.samples}};
}

Json to_json(const MethodErrors& errors) {
  Json json;
  json["setting"] = errors.setting;
  json["triangles"] = errors.triangles;
  json["distance"] = {{"root_mean_square", number(errors.distance.root_mean_square())},
                      {"largest", number(errors.distance.largest())},
                      {"to_level", to_json(errors.distance.to_level)},
                      {"from_level", to_json(errors.distance.from_level)},
                      {"not_projected", errors.distance.not_projected}};
  if (errors.method == "reference") return json;
  json["topology"] = {{"components", errors.components},
                      {"true_components", errors.true_components},
                      {"missed_components", errors.missed},
                      {"extra_components", errors.extra},
                      {"components_of_other_topology", errors.wrong_topology},
                      {"euler_characteristic", errors.euler_characteristic},
                      {"true_euler_characteristic", errors.true_euler_characteristic},
                      {"edge_crossings", errors.true_crossings},
                      {"missed_crossings", errors.missed_crossings},
                      {"extra_crossings", errors.extra_crossings},
                      {"holes", errors.holes},
                      {"seam_edges", errors.seam_edges}};
  return json;
}

/// "0.5, +-9/10": each with its opposite, whichever sign was given.
std::string modes_text(const std::vector<ModeValue>& modes) {
  std::vector<std::string> words;
  for (const ModeValue& mode : modes) {
    const ModeValue positive = mode.sign() < 0 ? mode.opposite() : mode;
    const std::string word = (mode.sign() == 0 ? " " : " +-") + short_text(positive);
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return fmt::format("{}", fmt::join(words, ""));
}

}  // namespace

std::string to_json(const BenchReport& report) {
  Json json;
  json["input"] = report.input.string();
  json["tetrahedra"] = report.tetrahedra;
  json["modes"] = Json::array();
  for (const ModeValue& mode : report.modes) json["modes"].push_back(mode.approx());
  json["threads"] = report.threads;
  for (const BenchSeries& series : report.series) {
    json["times"][series.name] = series.median();
    json["all_times"][series.name] = series.seconds;
    json["triangles"][series.name] = series.triangles;
  }
  json["notes"] = Json::object();
  for (const BenchRatio& ratio : report.ratios) {
    json["ratios"][ratio.name] = ratio.value ? Json(*ratio.value) : Json(nullptr);
    if (!ratio.note.empty()) json["notes"][ratio.name] = ratio.note;
  }
  json["stages"] = report.stages;
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  json["errors"] = Json::object();
  for (const MethodErrors& errors : report.errors) json["errors"][errors.method] = to_json(errors);
  if (report.errors.empty())
    json["notes"]["errors"] = "not measured: see --only and --all";
  else
    json["undecided_tetrahedra"] = report.undecided;
  for (const ErrorCurve& curve : report.curves) {
    Json points = Json::array();
    for (const ErrorPoint& point : curve.points)
      points.push_back({{"setting", point.setting},
                        {"seconds", point.seconds},
                        {"root_mean_square", number(point.root_mean_square)},
                        {"largest", number(point.largest)},
                        {"triangles", point.triangles}});
    json["curves"][curve.method] = std::move(points);
    if (!curve.note.empty()) json["notes"]["curves_" + curve.method] = curve.note;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const BenchReport& report) {
  std::string text;
  append_format(text, "{}: {} tetrahedra, modes{}, {} threads, medians of {}\n",
                report.input.string(), report.tetrahedra, modes_text(report.modes), report.threads,
                report.series.front().seconds.size());
  append_format(text, "{:<28} {:>10} {:>10} {:>14}\n", "", "seconds", "triangles", "extract over");
  const double ours = report.series.front().median();
  for (const BenchSeries& series : report.series) {
    append_format(text, "{:<28} {:>10.4f} {:>10} {:>14.3f}\n", series.name, series.median(),
                  series.triangles, ours / series.median());
  }
  for (const auto& [stage, seconds] : report.stages) {
    append_format(text, "  {:<26} {:>10.4f}\n", stage, seconds);
  }
  for (const BenchRatio& ratio : report.ratios) {
    const std::string value = ratio.value ? fmt::format("{:.3f}", *ratio.value) : "none";
    append_format(text, "{:<42} {:>10}{}{}\n", ratio.name, value, ratio.note.empty() ? "" : "  ",
                  ratio.note);
  }
  if (!report.errors.empty())
    append_format(text, "{:<16} {:>12} {:>12}  {:>22} {:>24}\n", "errors", "rms", "largest",
                  "components", "crossings missed, extra");
  for (const MethodErrors& e : report.errors) {
    append_format(text, "{:<16} {:>12.4g} {:>12.4g}", e.method, e.distance.root_mean_square(),
                  e.distance.largest());
    if (e.method != "reference")
      append_format(
          text, "  {:>22} {:>24}",
          fmt::format("{} ({} wrong) of {}", e.components - e.extra, e.wrong_topology,
                      e.true_components),
          fmt::format("{}, {} of {}", e.missed_crossings, e.extra_crossings, e.true_crossings));
    append_format(text, "  {}\n", e.setting);
  }
  for (const ErrorCurve& curve : report.curves)
    for (const ErrorPoint& point : curve.points)
      append_format(text, "{:<16} {:<16} {:>10.4f} s {:>12.4g} rms {:>10} triangles\n",
                    curve.method, point.setting, point.seconds, point.root_mean_square,
                    point.triangles);
  append_format(text, "peak memory {:.0f} MB\n",
                static_cast<double>(report.peak_memory_bytes) / 1e6);
  return text;
}

}  // namespace tensortopo
