// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "analyze/persistence/persistence_chart.hpp"
#include "analyze/persistence/persistence_command.hpp"
#include "append_format.hpp"
#include "counted.hpp"
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
  return pair.has_death || pair.is_lasting ? std::abs(pair.birth.middle() - pair.death.middle())
                                           : 0;
}

Json json_of(const PersistenceReport& report, const PersistencePair& pair) {
  const auto place = [](const Vector3<double>& p) { return Json{p.x, p.y, p.z}; };
  Json json{{"dimension", pair.dimension}, {"kind", name_of(pair.kind)}};
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
  json["lasting"] = pair.is_lasting;
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

Json json_of(const PersistenceReport& report, const LoopEvent& event) {
  Json json{{"kind", name_of(event.kind)}, {"event", event.is_birth ? "birth" : "death"}};
  json["mode"] = event.mode.middle();
  json["mode_range"] = {event.mode.low, event.mode.high};
  json["count"] = event.count;
  json["paired"] = event.paired;
  json["tet"] = cell_of(report, event.tet);
  json["point"] = {event.place.x, event.place.y, event.place.z};
  json["curve"] = event.curve ? Json(*event.curve) : Json(nullptr);
  json["tie"] = event.is_tie;
  return json;
}

Json json_of(const std::vector<BettiInterval>& intervals) {
  Json json = Json::array();
  for (const BettiInterval& interval : intervals) {
    Json betti = Json::array();
    for (const auto& number : interval.betti)
      betti.push_back(number ? Json(*number) : Json(nullptr));
    json.push_back({{"from", interval.low}, {"to", interval.high}, {"betti", betti}});
  }
  return json;
}

std::size_t loops_born(const ModeHomology& homology, PairKind kind) {
  std::size_t count = 0;
  for (const LoopEvent& event : homology.loops)
    if (event.kind == kind && event.is_birth) count += event.count;
  return count;
}

/// Loops and voids, in words.
std::string homology_text(const ModeHomology& homology) {
  std::string text;
  for (std::size_t side = 0; side < 2; ++side) {
    const PairKind kind = side == 0 ? PairKind::superlevel : PairKind::sublevel;
    std::array<long, 3> most{};
    std::array<double, 3> known{};
    for (const BettiInterval& interval : homology.betti[side])
      for (std::size_t k = 0; k < 3; ++k) {
        if (!interval.betti[k]) continue;
        most[k] = std::max(most[k], *interval.betti[k]);
        known[k] += (interval.high - interval.low) / 2;
      }
    append_format(text, "{{mode {} m}}:", side == 0 ? ">=" : "<=");
    for (std::size_t k = 0; k < 3; ++k) {
      if (known[k] == 0)
        append_format(text, " number of {} not known,", kFeatureNames[k]);
      else
        append_format(
            text, " {} {} at most{},", most[k], kFeatureNames[k],
            known[k] < 0.999 ? fmt::format(" (known for {:.3g} of all m)", known[k]) : "");
    }
    append_format(text, " {} loops appear\n", loops_born(homology, kind));
  }
  text +=
      "Of loops only those are paired of which no others are in one component (--json lists all)\n";
  return text;
}

}  // namespace

std::string to_json(const PersistenceReport& report) {
  const ModePersistence& found = report.persistence;
  Json json;
  json["input"] = analyzed_mesh_json(report);
  json["complete"] = report.is_complete();
  json["pairs"] = Json::array();
  for (const PersistencePair& pair : report.pairs()) json["pairs"].push_back(json_of(report, pair));
  json["curves"] = Json::array();
  for (const CurvePersistence& curve : found.curves)
    json["curves"].push_back(json_of(found, curve));
  const ModeHomology& homology = report.homology;
  json["loops"] = Json::array();
  for (const LoopEvent& event : homology.loops) json["loops"].push_back(json_of(report, event));
  json["betti"] = {{"mesh", homology.mesh_betti},
                   {"superlevel", json_of(homology.betti[0])},
                   {"sublevel", json_of(homology.betti[1])},
                   {"adds_up", homology.adds_up}};
  json["not_proved"] = {{"superlevel", found.not_proved[0].size()},
                        {"sublevel", found.not_proved[1].size()},
                        {"superlevel_voids", homology.not_proved[0]},
                        {"sublevel_voids", homology.not_proved[1]}};
  json["isotropic_vertices"] = homology.isotropic_vertices;
  json["known_curves"] = homology.has_known_curves;
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
  append_format(text, "{}: {}\n\n", report.input.string(), counted_tets(report.tetrahedra));
  append_format(text, "{:<30} {:>8} {:>8}", "", "pairs", "ties");
  for (const double r : kNoise) append_format(text, " {:>10}", fmt::format("> {:g}", r));
  text += "  certainly survive relative noise\n";
  const auto row = [&](const std::string& name, const auto& pairs) {
    std::size_t ties = 0;
    std::array<std::size_t, kNoise.size()> survivors{};
    for (const PersistencePair* pair : pairs) {
      ties += pair->is_tie;
      for (std::size_t i = 0; i < kNoise.size(); ++i)
        survivors[i] += pair->is_certain && survived_noise(*pair) > kNoise[i];
    }
    append_format(text, "{:<30} {:>8} {:>8}", name, pairs.size(), ties);
    for (const std::size_t n : survivors) append_format(text, " {:>10}", n);
    text += '\n';
  };
  for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel, PairKind::extended}) {
    std::vector<const PersistencePair*> pairs;
    for (const PersistencePair& pair : found.pairs)
      if (pair.kind == kind) pairs.push_back(&pair);
    row(fmt::format("{} components", name_of(kind)), pairs);
  }
  for (const int dimension : {1, 2})
    for (const PairKind kind : {PairKind::superlevel, PairKind::sublevel}) {
      std::vector<const PersistencePair*> pairs;
      for (const PersistencePair& pair : report.homology.pairs)
        if (pair.kind == kind && pair.dimension == dimension) pairs.push_back(&pair);
      row(fmt::format("{} {}", name_of(kind), kFeatureNames[static_cast<std::size_t>(dimension)]), pairs);
    }
  for (const int mode : {1, -1})
    for (const bool closed : {true, false}) {
      std::vector<const PersistencePair*> pairs;
      for (const CurvePersistence& curve : found.curves)
        if (curve.mode == mode && curve.is_closed == closed)
          pairs.push_back(&found.pairs[curve.pair]);
      row(fmt::format("{} curves of mode {}", closed ? "closed" : "open", mode), pairs);
    }
  text += '\n' + homology_text(report.homology);
  const std::vector<PersistencePair> all = report.pairs();
  std::vector<const PersistencePair*> first;
  for (const PersistencePair& pair : all) first.push_back(&pair);
  std::stable_sort(first.begin(), first.end(), [](const auto* a, const auto* b) {
    return survived_noise(*a) > survived_noise(*b);
  });
  first.resize(std::min(first.size(), kMostPairs));
  append_format(text, "\n{:<11} {:<10} {:>14} {:>14} {:>12}  born at\n", "kind", "", "birth",
                "death", "survives");
  for (const PersistencePair* pair : first)
    append_format(
        text, "{:<11} {:<10} {:>14.9f} {:>14} {:>12.4g}  ({:.6g}, {:.6g}, {:.6g}){}{}{}\n",
        name_of(pair->kind),
        std::array{"component", "loop", "void"}[static_cast<std::size_t>(pair->dimension)],
        pair->birth.middle(),
        pair->has_death    ? fmt::format("{:.9f}", pair->death.middle())
        : pair->is_lasting ? "none"
                           : "?",
        survived_noise(*pair), pair->birth_point.x, pair->birth_point.y, pair->birth_point.z,
        !pair->curve           ? ""
        : pair->dimension == 2 ? ", around a curve"
                               : ", a curve",
        pair->is_tie ? ", tie" : "", pair->is_certain ? "" : ", not certain");
  if (all.size() > kMostPairs) append_format(text, "(--json lists the {} pairs)\n", all.size());
  const std::size_t open = found.not_proved[0].size() + found.not_proved[1].size();
  const std::size_t cells = found.unresolved_curve_cells[0] + found.unresolved_curve_cells[1];
  if (open > 0)
    append_format(text,
                  "{} critical points are not proved; pairs that they may concern are not "
                  "certain\n",
                  open);
  if (cells > 0) append_format(text, "degenerate curves are not known in {} tetrahedra\n", cells);
  if (report.homology.isotropic_vertices > 0)
    append_format(text, "{} vertices are isotropic: loops and voids are not certain\n",
                  report.homology.isotropic_vertices);
  if (report.is_proved() && !report.adds_up())
    text += "Betti numbers do not add up to those of the mesh: a change of topology is missing\n";
  for (const auto& file : {report.output, report.picture})
    if (!file.empty()) append_format(text, "\n{}\n", file.string());
  return text;
}

}  // namespace tensortopo
