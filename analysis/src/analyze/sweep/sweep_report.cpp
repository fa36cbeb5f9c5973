// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "analyze/sweep/sweep_command.hpp"
#include "append_format.hpp"
#include "counted.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kPlaces{"vertex", "edge", "face", "tetrahedron"};
constexpr std::size_t kMostPoints = 40;

std::size_t dimension_of(const MeshCriticalPoint& point) {
  return static_cast<std::size_t>(point.dimension);
}

std::vector<TetMesh::Index> vertices_of(const MeshCriticalPoint& point) {
  return {point.vertices.begin(), point.vertices.begin() + point.dimension + 1};
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const SweepLevel& level) {
  return {{"mode", level.mode.approx()},
          {"mode_exact", level.mode.text()},
          {"components", level.components},
          {"euler_characteristic", level.euler_characteristic},
          {"boundary_loops", level.boundary_loops},
          {"area", level.area},
          {"unresolved", level.unresolved}};
}

Json json_of(const MeshCriticalPoint& point) {
  Json json{{"low", point.low}, {"high", point.high}};
  json["change"] = name_of(point.effect.change);
  const bool is_known = point.effect.change != LocalChange::undecided;
  json["euler_change"] = is_known ? Json(point.effect.euler_change) : Json(nullptr);
  json["on_boundary"] = point.effect.on_boundary;
  json["place"] = kPlaces[dimension_of(point)];
  json["vertices"] = vertices_of(point);
  json["point"] = {point.point.x, point.point.y, point.point.z};
  return json;
}

Json json_of(const SweepCheck& check) {
  Json json{{"critical_values", check.events},
            {"critical_values_compared", check.compared},
            {"certified", check.certified},
            {"contradictions", check.contradictions},
            {"undecided", check.undecided}};
  json["levels"] = Json::array();
  for (const CheckedLevel& checked : check.levels) {
    Json row = json_of(checked.level);
    row.erase("area");  // of a coarse surface
    row["interval"] = checked.interval;
    json["levels"].push_back(std::move(row));
  }
  return json;
}

std::string text_of(const SweepCheck& check) {
  std::string text = fmt::format(
      "\nchecked with {} surfaces, extracted and certified ({} claims confirmed), {} of {} "
      "critical values\n{}: {} contradictions, {} undecided\n",
      check.levels.size(), check.certified, check.compared, check.events,
      check.contradictions.empty() ? "passed" : "failed", check.contradictions.size(),
      check.undecided.size());
  for (const auto& words : check.contradictions) text += "contradiction: " + words + '\n';
  for (const auto& words : check.undecided) text += "undecided: " + words + '\n';
  return text;
}

std::string text_of(const std::optional<long>& value) {
  return value ? fmt::format("{}", *value) : "?";
}

std::map<std::string, std::size_t> count_changes(const Sweep& sweep) {
  std::map<std::string, std::size_t> counts;
  for (const SweepEvent& event : sweep.events)
    for (const MeshCriticalPoint& point : event.points)
      ++counts[std::string(name_of(point.effect.change))];
  return counts;
}

}  // namespace

std::string to_json(const SweepReport& report) {
  const Sweep& sweep = report.sweep;
  Json json;
  json["input"] = analyzed_mesh_json(report);
  json["from"] = report.options.from.text();
  json["to"] = report.options.to.text();
  json["complete"] = report.is_complete();
  json["samples"] = Json::array();
  for (const std::size_t i : sweep.samples) json["samples"].push_back(json_of(sweep.levels[i]));
  json["intervals"] = Json::array();
  for (const SweepInterval& interval : sweep.intervals) {
    Json row{{"low", interval.low}, {"high", interval.high}};
    row["euler_characteristic"] = or_null(interval.euler_characteristic);
    row["level"] = interval.level ? json_of(sweep.levels[*interval.level]) : Json(nullptr);
    json["intervals"].push_back(std::move(row));
  }
  json["events"] = Json::array();
  for (const SweepEvent& event : sweep.events) {
    Json row{{"low", event.low}, {"high", event.high}};
    row["euler_change"] = or_null(event.euler_change());
    row["points"] = Json::array();
    for (const MeshCriticalPoint& point : event.points) row["points"].push_back(json_of(point));
    json["events"].push_back(std::move(row));
  }
  for (std::size_t i = 0; i < 4; ++i) json["looked_at"][kPlaces[i]] = sweep.looked_at[i];
  json["changes"] = count_changes(sweep);
  json["contradictions"] = Json::array();
  for (const std::size_t i : sweep.contradictions)
    json["contradictions"].push_back(json_of(sweep.levels[i]));
  if (report.check) json["check"] = json_of(*report.check);
  if (!report.picture.empty()) json["picture"] = report.picture.string();
  json["seconds"] = report.seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const SweepReport& report) {
  const Sweep& sweep = report.sweep;
  std::string text;
  append_format(text, "{}: {}, modes from {} to {}\n\n", report.input.string(),
                counted_tets(report.tetrahedra), short_text(report.options.from),
                short_text(report.options.to));
  append_format(text, "{:>12} {:>10} {:>8} {:>8} {:>14}\n", "mode", "components", "Euler", "loops",
                "area");
  for (const std::size_t i : sweep.samples) {
    const SweepLevel& level = sweep.levels[i];
    append_format(text, "{:>12.6g} {:>10} {:>8} {:>8} {:>14.6g}", level.mode.approx(),
                  level.components, level.euler_characteristic, level.boundary_loops, level.area);
    text +=
        level.unresolved > 0 ? fmt::format("  {} tetrahedra unresolved\n", level.unresolved) : "\n";
  }
  if (is_degenerate(report.options.from) || is_degenerate(report.options.to))
    text += "(modes 1 and -1 have no row: there the level is a set of curves)\n";
  std::size_t points = 0, looked_at = 0, undecided = 0;
  for (const SweepEvent& event : sweep.events) {
    points += event.points.size();
    for (const MeshCriticalPoint& point : event.points)
      undecided += point.effect.change == LocalChange::undecided;
  }
  for (const std::size_t n : sweep.looked_at) looked_at += n;
  append_format(text,
                "\n{} critical values ({} points, of {} at which the level of a cell changes);\n"
                "between them the topology is constant{}\n",
                sweep.events.size(), points, looked_at,
                undecided > 0 ? fmt::format("; what {} of them change is undecided",
                                            counted(undecided, "point"))
                              : "");
  for (const auto& [change, count] : count_changes(sweep))
    append_format(text, "  {:<10} {:>7}\n", change, count);

  std::vector<const SweepInterval*> widest;
  for (const SweepInterval& interval : sweep.intervals) widest.push_back(&interval);
  std::stable_sort(widest.begin(), widest.end(), [](const auto* a, const auto* b) {
    return a->high - a->low > b->high - b->low;
  });
  widest.resize(std::min(widest.size(), kWidestIntervals));
  append_format(text, "\nwidest ranges of one topology\n{:>12} {:>12} {:>10} {:>8} {:>8}\n", "from",
                "to", "components", "Euler", "loops");
  for (const SweepInterval* interval : widest) {
    const SweepLevel* level = interval->level ? &sweep.levels[*interval->level] : nullptr;
    append_format(text, "{:>12.8g} {:>12.8g} {:>10} {:>8} {:>8}\n", interval->low, interval->high,
                  level ? fmt::format("{}", level->components) : "?",
                  text_of(interval->euler_characteristic),
                  level ? fmt::format("{}", level->boundary_loops) : "?");
  }
  if (points > kMostPoints) {
    append_format(text, "\n(--json lists the {} critical values)\n", sweep.events.size());
  } else if (points > 0) {
    append_format(text, "\n{:>20} {:<10} {:>6}  where\n", "critical value", "change", "Euler");
    for (const SweepEvent& event : sweep.events)
      for (const MeshCriticalPoint& point : event.points)
        append_format(text, "{:>20.15g} {:<10} {:>6}  {} {}{}\n", (point.low + point.high) / 2,
                      name_of(point.effect.change),
                      point.effect.change == LocalChange::undecided
                          ? "?"
                          : fmt::format("{:+}", point.effect.euler_change),
                      kPlaces[dimension_of(point)], fmt::join(vertices_of(point), " "),
                      point.effect.on_boundary ? ", on the boundary" : "");
  }
  for (const std::size_t i : sweep.contradictions)
    append_format(text, "contradiction: the Euler characteristic at {} is {}\n",
                  short_text(sweep.levels[i].mode), sweep.levels[i].euler_characteristic);
  if (report.check) text += text_of(*report.check);
  if (!report.picture.empty()) append_format(text, "\n{}\n", report.picture.string());
  return text;
}

}  // namespace tensortopo
