// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "analyze/persistence/persistence_command.hpp"
#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kNoise{1e-6, 1e-4, 1e-2};
constexpr std::size_t kMostPairs = 20;

/// Cells as the file numbers them.
Json cell_of(const PersistenceReport& report, TetMesh::Index tet) {
  return tet < 0 ? Json(nullptr) : Json(report.cell_ids[as_size(tet)]);
}

double mode_persistence_of(const PersistencePair& pair) {
  return pair.has_death ? std::abs(pair.birth.middle() - pair.death.middle()) : 0;
}

Json json_of(const PersistenceReport& report, const PersistencePair& pair) {
  const auto place = [](const Vector3<double>& p) { return Json{p.x, p.y, p.z}; };
  Json json{{"dimension", 0}, {"kind", name_of(pair.kind)}};
  json["birth"] = pair.birth.middle();
  json["birth_range"] = {pair.birth.low, pair.birth.high};
  json["death"] = pair.has_death ? Json(pair.death.middle()) : Json(nullptr);
  json["death_range"] = {pair.death.low, pair.death.high};
  json["persistence"] = pair.has_death ? Json(mode_persistence_of(pair)) : Json(nullptr);
  json["angle_persistence"] = angle_persistence(pair);
  json["survives"] = survived_noise(pair);
  json["birth_tet"] = cell_of(report, pair.birth_tet);
  json["birth_point"] = place(pair.birth_point);
  json["death_tet"] = pair.has_death ? cell_of(report, pair.death_tet) : Json(nullptr);
  json["death_point"] = pair.has_death ? place(pair.death_point) : Json(nullptr);
  json["curve"] = pair.curve ? Json(*pair.curve) : Json(nullptr);
  json["tie"] = pair.is_tie;
  json["certain"] = pair.is_certain;
  return json;
}

Json json_of(const ModePersistence& persistence, const CurvePersistence& curve) {
  const PersistencePair& pair = persistence.pairs[curve.pair];
  return {{"mode", curve.mode},
          {"component", curve.component},
          {"closed", curve.is_closed},
          {"length", curve.length},
          {"pair", curve.pair},
          {"persistence", pair.has_death ? Json(mode_persistence_of(pair)) : Json(nullptr)},
          {"survives", survived_noise(pair)},
          {"certain", pair.is_certain}};
}

}  // namespace

std::string to_json(const PersistenceReport& report) {
  const ModePersistence& found = report.persistence;
  Json json;
  json["input"] = analyzed_mesh_json(report);
  json["complete"] = report.is_complete();
  json["pairs"] = Json::array();
  for (const PersistencePair& pair : found.pairs) json["pairs"].push_back(json_of(report, pair));
  json["curves"] = Json::array();
  for (const CurvePersistence& curve : found.curves)
    json["curves"].push_back(json_of(found, curve));
  json["not_proved"] = {{"superlevel", found.not_proved[0].size()},
                        {"sublevel", found.not_proved[1].size()}};
  json["unresolved_curve_cells"] = {{"linear", found.unresolved_curve_cells[0]},
                                    {"planar", found.unresolved_curve_cells[1]}};
  if (!report.output.empty()) json["output"] = report.output.string();
  if (!report.picture.empty()) json["picture"] = report.picture.string();
  json["seconds"] = report.seconds;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const PersistenceReport& report) {
  const ModePersistence& found = report.persistence;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {} tetrahedra\n\n", report.input.string(), report.tetrahedra);
  fmt::format_to(out, "{:<30} {:>8} {:>8}", "", "pairs", "ties");
  for (const double r : kNoise) fmt::format_to(out, " {:>10}", fmt::format("> {:g}", r));
  text += "  survive relative noise\n";
  const auto row = [&](const std::string& name, const auto& pairs) {
    std::size_t ties = 0;
    std::array<std::size_t, kNoise.size()> survivors{};
    for (const PersistencePair* pair : pairs) {
      ties += pair->is_tie;
      for (std::size_t i = 0; i < kNoise.size(); ++i)
        survivors[i] += survived_noise(*pair) > kNoise[i];
    }
    fmt::format_to(out, "{:<30} {:>8} {:>8}", name, pairs.size(), ties);
    for (const std::size_t n : survivors) fmt::format_to(out, " {:>10}", n);
    text += '\n';
  };
  for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel, PairKind::extended}) {
    std::vector<const PersistencePair*> pairs;
    for (const PersistencePair& pair : found.pairs)
      if (pair.kind == kind) pairs.push_back(&pair);
    row(std::string(name_of(kind)), pairs);
  }
  for (const int mode : {1, -1})
    for (const bool closed : {true, false}) {
      std::vector<const PersistencePair*> pairs;
      for (const CurvePersistence& curve : found.curves)
        if (curve.mode == mode && curve.is_closed == closed)
          pairs.push_back(&found.pairs[curve.pair]);
      row(fmt::format("{} curves of mode {}", closed ? "closed" : "open", mode), pairs);
    }
  std::vector<const PersistencePair*> first;
  for (const PersistencePair& pair : found.pairs) first.push_back(&pair);
  std::stable_sort(first.begin(), first.end(), [](const auto* a, const auto* b) {
    return survived_noise(*a) > survived_noise(*b);
  });
  first.resize(std::min(first.size(), kMostPairs));
  fmt::format_to(out, "\n{:<11} {:>14} {:>14} {:>12}  born at\n", "kind", "birth", "death",
                 "survives");
  for (const PersistencePair* pair : first)
    fmt::format_to(out, "{:<11} {:>14.9f} {:>14} {:>12.4g}  ({:.6g}, {:.6g}, {:.6g}){}{}{}\n",
                   name_of(pair->kind), pair->birth.middle(),
                   pair->has_death ? fmt::format("{:.9f}", pair->death.middle()) : "?",
                   survived_noise(*pair), pair->birth_point.x, pair->birth_point.y,
                   pair->birth_point.z, pair->curve ? ", a curve" : "", pair->is_tie ? ", tie" : "",
                   pair->is_certain ? "" : ", not certain");
  if (found.pairs.size() > kMostPairs)
    fmt::format_to(out, "(--json lists the {} pairs)\n", found.pairs.size());
  const std::size_t open = found.not_proved[0].size() + found.not_proved[1].size();
  const std::size_t cells = found.unresolved_curve_cells[0] + found.unresolved_curve_cells[1];
  if (open > 0)
    fmt::format_to(out,
                   "{} critical points are not proved; pairs that they may concern are not "
                   "certain\n",
                   open);
  if (cells > 0) fmt::format_to(out, "degenerate curves are not known in {} tetrahedra\n", cells);
  for (const auto& file : {report.output, report.picture})
    if (!file.empty()) fmt::format_to(out, "\n{}\n", file.string());
  return text;
}

}  // namespace tensortopo
