// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "extract/report/certificate_report_output.hpp"
#include "extract/report/topology_json.hpp"
#include "tensortopo/analysis/extract_report.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;


Json counts(const std::map<std::string, std::size_t>& unresolved) {
  Json json = Json::object();
  for (const auto& [reason, count] : unresolved) json[reason] = count;
  return json;
}

Json stability_json(const StabilityReport& stability) {
  const StabilitySummary& s = stability.summary;
  return {{"radius", stability.radius},       {"stable_tets", s.stable_tets},
          {"unstable_tets", s.unstable_tets}, {"crossed_stable_tets", s.crossed_stable_tets},
          {"crossings", s.crossings},         {"stable_crossings", s.stable_crossings},
          {"crossing_reasons", counts(s.crossing_reasons)},
          {"reasons", counts(s.reasons)},     {"stable_components", s.components.size()},
          {"seconds", stability.seconds}};
}

/// @param size  what the size is called: "area" or "length"
Json filter_json(const FilterReport& filter, const char* size) {
  Json json = Json::object();
  if (const auto& limit = filter.persistence) {
    json["min_persistence"] = limit->least;
    json["left_out"] = limit->left_out;
    json["largest_left_out"] = limit->largest_left_out;
    json["not_known"] = limit->not_known;
  }
  if (const auto& limit = filter.size) {
    json[std::string("min_") + size] = limit->least;
    json["left_out_small"] = limit->left_out;
    json["largest_left_out_small"] = limit->largest_left_out;
  }
  return json;
}

Json improvement_json(const ImprovementCounts& counts) {
  return {{"flipped_edges", counts.flipped},
          {"moved_vertices", counts.moved_in_tets + counts.moved_along_faces},
          {"least_angle_before", counts.before.least},
          {"least_angle", counts.after.least},
          {"mean_least_angle_before", counts.before.mean},
          {"mean_least_angle", counts.after.mean}};
}

Json surface_json(const SurfaceReport& surface) {
  Json json{{"mode", surface.mode.approx()},
            {"mode_exact", surface.mode.text()},
            {"vertices", surface.vertices},
            {"triangles", surface.triangles}};
  add_topology(json, surface.invariants);
  json["max_abs_residual"] = surface.max_abs_residual;
  json["tets_crossed"] = surface.statistics.tets_crossed;
  json["distance_bound"] = surface.distance_bound ? Json(*surface.distance_bound) : Json();
  json["tets_farther"] = surface.tets_farther;
  if (surface.distance_bound) json["area_within"] = surface.area_within;
  if (surface.not_embedded) json["not_embedded"] = *surface.not_embedded;
  json["unresolved"] = counts(surface.unresolved);
  if (surface.stability) json["stability"] = stability_json(*surface.stability);
  if (surface.filter) json["filter"] = filter_json(*surface.filter, "area");
  if (surface.improvement) json["improvement"] = improvement_json(*surface.improvement);
  json["parts"] = parts_json(surface.invariants);
  return json;
}

Json curve_json(const CurveReport& curve) {
  const CurveStatistics& s = curve.statistics;
  Json json{{"mode", curve.mode.approx()},
            {"mode_exact", curve.mode.text()},
            {"vertices", curve.invariants.vertices},
            {"length", curve.invariants.length},
            {"components", curve.invariants.components},
            {"closed_components", curve.invariants.closed_components},
            {"max_residual", curve.max_residual},
            {"tets_crossed", s.tets_crossed},
            {"tets_screened_out", s.tets_screened_out},
            {"faces_counted", s.faces},
            {"faces_counted_with_more_digits", s.faces_exact},
            {"unresolved", counts(curve.unresolved)}};
  if (curve.stability) json["stability"] = stability_json(*curve.stability);
  if (curve.filter) json["filter"] = filter_json(*curve.filter, "length");
  return json;
}

Json unresolved_json(const UnresolvedReport& cell) {
  Json json{{"cell", cell.cell}, {"reason", cell.reason}, {"modes", Json::array()}};
  for (const ModeValue& mode : cell.modes) json["modes"].push_back(mode.text());
  return json;
}

Json statistics_json(const ExtractStatistics& s) {
  return {{"tets_screened_out", s.tets_screened_out},
          {"tets_crossed", s.tets_crossed},
          {"tets_monotone", s.tets_monotone},
          {"tets_refined", s.tets_refined},
          {"sheets_small", s.sheets_small},
          {"sheets_bisected", s.sheets_bisected},
          {"sheets_tubes", s.sheets_tubes},
          {"sheets_graph", s.sheets_graph},
          {"sheets_manifold", s.sheets_manifold},
          {"sheets_dominant", s.sheets_dominant},
          {"sheets_subdivision", s.sheets_subdivision},
          {"sheets_loops", s.sheets_loops},
          {"sheets_leaves", s.sheets_subdivision},  // deprecated
          {"sheets_rims", s.sheets_loops},          // deprecated
          {"tets_nearby", s.tets_nearby},
          {"vertices_on_level", s.vertices_on_level},
          {"tets_coned", s.tets_coned},
          {"tets_undefined", s.tets_undefined},
          {"sheets_cones", s.sheets_cones},
          {"cone_points", s.cone_points},
          {"zero_deviator_vertices", s.zero_deviator_vertices}};
}

Json seconds_json(const ExtractReport& report, const ExtractStatistics& s) {
  return {{"read", report.seconds_read},
          {"edges", s.seconds_edges},
          {"faces", s.seconds_faces},
          {"tets", s.seconds_tets},
          {"stitch", s.seconds_stitch},
          {"extract", report.seconds_extract},
          {"invariants", report.seconds_invariants},
          {"certify", report.certificate ? report.certificate->seconds : 0},
          {"write", report.seconds_write}};
}

}  // namespace

std::string to_json(const ExtractReport& report) {
  const ExtractStatistics statistics = total_statistics(report);
  Json json = begin_json("tensortopo extract", report);
  json["output"] = output_json(report);
  json["pieces"] = report.pieces;
  if (report.memory)
    json["memory"] = {{"limit_bytes", report.memory->limit},
                      {"estimated_bytes", report.memory->estimated},
                      {"peak_bytes", report.memory->peak}};
  json["surfaces"] = Json::array();
  for (const SurfaceReport& surface : report.surfaces) {
    json["surfaces"].push_back(surface_json(surface));
  }
  json["curves"] = Json::array();
  for (const CurveReport& curve : report.curves) json["curves"].push_back(curve_json(curve));
  json["unresolved"] = counts(count_unresolved(report));
  json["unresolved_cells"] = listed_cells_json(report.unresolved, unresolved_json);
  json["certificate"] = certificate_json(report.certificate);
  json["seconds"] = seconds_json(report, statistics);
  json["statistics"] = statistics_json(statistics);
  json["predicates"] = {{"double", report.predicates.fast},
                        {"multiprecision", report.predicates.multiprecision},
                        {"longer", report.predicates.multiprecision},  // deprecated
                        {"exact", report.predicates.exact}};
  json["deprecated"] = {{"statistics.sheets_leaves", "statistics.sheets_subdivision"},
                        {"statistics.sheets_rims", "statistics.sheets_loops"},
                        {"predicates.longer", "predicates.multiprecision"}};
  // A path may hold bytes that are no UTF-8; JSON must not.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tensortopo
