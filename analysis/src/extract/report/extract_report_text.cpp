// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "append_format.hpp"
#include "counted.hpp"
#include "extract/report/certificate_report_output.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/extract_report.hpp"

namespace tensortopo {
namespace {

/// A mode that differs by about 1e-9, as one can ask for it.
std::string mode_beside(const ModeValue& mode) {
  constexpr double difference = 1e-9;
  if (mode.sign() == 0) return "1e-9";
  const double value = mode.approx();
  return fmt::format("{:.12g}", value + (value + difference < 1 ? difference : -difference));
}

/// What of a surface, or of curves, is in all fields within the radii.
template <class Report>
std::string stability_line(const Report& output) {
  const StabilitySummary& s = output.stability->summary;
  const auto listed = [](const std::map<std::string, std::size_t>& counts) {
    std::string text;
    for (const auto& [reason, count] : counts)
      text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", count, reason);
    return text.empty() ? text : text + ")";
  };
  return fmt::format(
      "mode {}, uncertainty {}: {} of {} components stable, {} of {} crossed tetrahedra, {} of {} "
      "crossings; not: {} crossings{}, {} of all tetrahedra{}\n",
      short_text(output.mode), output.stability->radius, s.components.size(),
      output.invariants.components, s.crossed_stable_tets, output.statistics.tets_crossed,
      s.stable_crossings, s.crossings, s.crossings - s.stable_crossings,
      listed(s.crossing_reasons), s.unstable_tets, listed(s.reasons));
}

/// What a filter left out.
std::string filter_lines(const ModeValue& mode, const FilterReport& filter) {
  std::string text;
  const auto add = [&](const char* measure, const std::optional<FilterReport::Limit>& limit) {
    if (!limit) return;
    text += fmt::format("mode {}, {} below {:g}: {} left out", short_text(mode), measure,
                        limit->least, counted(limit->left_out, "component"));
    if (limit->left_out > 0)
      text += fmt::format(", the largest of {} {:.3g}", measure, limit->largest_left_out);
    if (limit->not_known > 0)
      text += fmt::format("; {} kept because theirs is not known", limit->not_known);
    text += '\n';
  };
  add(is_degenerate(mode) ? "length" : "area", filter.size);
  add("persistence", filter.persistence);
  return text;
}

}  // namespace

std::map<std::string, std::size_t> count_unresolved(const ExtractReport& report) {
  std::map<std::string, std::size_t> counts;
  for (const UnresolvedReport& cell : report.unresolved) ++counts[cell.reason];
  return counts;
}

ExtractStatistics total_statistics(const ExtractReport& report) {
  ExtractStatistics total;
  for (const SurfaceReport& surface : report.surfaces) {
    const ExtractStatistics& s = surface.statistics;
    total.tets_screened_out += s.tets_screened_out;
    total.tets_crossed += s.tets_crossed;
    total.tets_monotone += s.tets_monotone;
    total.tets_refined += s.tets_refined;
    total.sheets_small += s.sheets_small;
    total.sheets_bisected += s.sheets_bisected;
    total.sheets_tubes += s.sheets_tubes;
    total.sheets_graph += s.sheets_graph;
    total.sheets_manifold += s.sheets_manifold;
    total.sheets_dominant += s.sheets_dominant;
    total.sheets_subdivision += s.sheets_subdivision;
    total.sheets_loops += s.sheets_loops;
    total.tets_nearby += s.tets_nearby;
    total.vertices_on_level += s.vertices_on_level;
    total.tets_coned += s.tets_coned;
    total.sheets_cones += s.sheets_cones;
    total.cone_points += s.cone_points;
    // Of the field, not of a mode: the same in all.
    total.tets_undefined = std::max(total.tets_undefined, s.tets_undefined);
    total.zero_deviator_vertices = std::max(total.zero_deviator_vertices, s.zero_deviator_vertices);
    total.seconds_edges += s.seconds_edges;
    total.seconds_faces += s.seconds_faces;
    total.seconds_tets += s.seconds_tets;
    total.seconds_stitch += s.seconds_stitch;
  }
  for (const CurveReport& curve : report.curves) {
    total.seconds_faces += curve.statistics.seconds_faces;
    total.seconds_tets += curve.statistics.seconds_tets;
    total.seconds_stitch += curve.statistics.seconds_stitch;
  }
  return total;
}

std::string unresolved_line(const ExtractReport& report) {
  if (report.unresolved.empty()) return {};
  std::set<std::int64_t> cells;
  for (const UnresolvedReport& cell : report.unresolved) cells.insert(cell.cell);
  std::string reasons;
  for (const auto& [reason, count] : count_unresolved(report)) {
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", count, reason);
  }
  return fmt::format("{} of {} unresolved ({})", cells.size(), counted_tets(report.tetrahedra),
                     reasons);
}

std::string unresolved_advice(const ExtractReport& report) {
  const auto found = std::find_if(
      report.unresolved.begin(), report.unresolved.end(),
      [](const UnresolvedReport& cell) { return cell.reason.starts_with("level_constant_"); });
  if (found == report.unresolved.end()) return {};
  if (std::all_of(
          report.unresolved.begin(), report.unresolved.end(),
          [](const UnresolvedReport& cell) { return cell.reason == "level_constant_in_cell"; }))
    return "the whole tetrahedra have this mode, so that it has no surface in them";
  return fmt::format(
      "where the level is constant, ask for a mode next to it, for example --mode {}, which holds "
      "the surface beside those edges and faces",
      mode_beside(found->modes.front()));
}

bool is_flawless(const ExtractReport& report) {
  return report.unresolved.empty() &&
         std::none_of(report.surfaces.begin(), report.surfaces.end(),
                      [](const SurfaceReport& s) { return s.tets_farther > 0; }) &&
         doubtful_lines(report).empty();
}

std::vector<std::string> doubtful_lines(const ExtractReport& report) {
  // Of modes; elsewhere residuals are some orders below.
  constexpr double kOffTheLevel = 1e-6;
  std::vector<std::string> lines;
  for (const SurfaceReport& s : report.surfaces) {
    std::string what;
    if (s.max_abs_residual > kOffTheLevel)
      what = fmt::format("vertices are off the mode by up to {:.1e}", s.max_abs_residual);
    if (s.not_embedded.value_or(0) > 0)
      what += fmt::format(
          "{}in {} triangles intersect, or are at 90 degrees or more to the gradient",
          what.empty() ? "" : "; ", counted_tets(*s.not_embedded));
    if (!what.empty())
      lines.push_back(fmt::format("mode {}: {}: the topology is proved, but coordinates in double "
                                  "precision do not show the shape there",
                                  short_text(s.mode), what));
    else if (!s.embedded.value_or(true))
      lines.push_back(fmt::format(
          "mode {}: triangles meet beyond their common vertices and edges: {}{}the mesh overlaps "
          "itself, or vertices have the same coordinates after rounding",
          short_text(s.mode),
          s.statistics.cone_points > 0 ? "parts touch at isotropic vertices, where all modes meet, "
                                       : "",
          s.statistics.tets_nearby > 0 ? "parts touch at a critical point of this mode, " : ""));
  }
  if (!report.surfaces.empty() && report.tetrahedra > 0 &&
      report.surfaces.front().statistics.tets_undefined == report.tetrahedra)
    lines.emplace_back("all tetrahedra are isotropic, so that the mode is undefined everywhere");
  return lines;
}

std::string improvement_line(const ModeValue& mode, const ImprovementCounts& counts) {
  return fmt::format(
      "mode {}: triangles improved: least angle {:.3g} degrees before, {:.3g} now; its mean over "
      "the triangles {:.3g} before, {:.3g} now\n",
      short_text(mode), counts.before.least, counts.after.least, counts.before.mean,
      counts.after.mean);
}

std::string to_text(const ExtractReport& report) {
  std::string text;
  append_format(text, "{}: {}, {}, tensor '{}': {}\n", report.input.string(),
                counted(report.vertices, "vertex", "vertices"), counted_tets(report.tetrahedra),
                report.tensor_name, report.components.text());
  if (!report.surfaces.empty()) {
    append_format(text, "{:>10} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13} {:>9} {:>8} {:>8}\n", "mode",
                  "vertices", "triangles", "parts", "loops", "euler", "area", "residual",
                  "manifold", "tets");
  }
  for (const SurfaceReport& s : report.surfaces) {
    const SurfaceInvariants& known = s.invariants;
    append_format(text, "{:>10} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13.6g} {:>9} {:>8} {:>8}\n",
                  short_text(s.mode), s.vertices, s.triangles, known.components,
                  known.boundary_loops, known.euler_characteristic, known.area,
                  std::isnan(s.max_abs_residual) ? "-" : fmt::format("{:.1e}", s.max_abs_residual),
                  known.manifold ? "yes" : "no", s.statistics.tets_crossed);
  }
  for (const SurfaceReport& s : report.surfaces)
    if (s.stability) text += stability_line(s);
  for (const SurfaceReport& s : report.surfaces)
    if (s.filter) text += filter_lines(s.mode, *s.filter);
  for (const SurfaceReport& s : report.surfaces)
    if (s.improvement) text += improvement_line(s.mode, *s.improvement);
  for (const CurveReport& c : report.curves)
    if (c.filter) text += filter_lines(c.mode, *c.filter);
  for (const CurveReport& c : report.curves)
    if (c.stability) text += stability_line(c);
  if (!report.curves.empty()) {
    append_format(text, "{:>10} {:>9} {:>6} {:>6} {:>13} {:>9} {:>8}\n", "curves", "vertices",
                  "parts", "closed", "length", "residual", "tets");
  }
  for (const CurveReport& c : report.curves) {
    append_format(text, "{:>10} {:>9} {:>6} {:>6} {:>13.6g} {:>9.1e} {:>8}\n", short_text(c.mode),
                  c.invariants.vertices, c.invariants.components, c.invariants.closed_components,
                  c.invariants.length, c.max_residual, c.statistics.tets_crossed);
  }
  const ExtractStatistics total = total_statistics(report);
  if (total.zero_deviator_vertices > 0) {
    append_format(text, "isotropic, where the mode is undefined: {} ({} on surfaces), {} {}\n",
                  counted(total.zero_deviator_vertices, "vertex", "vertices"),
                  counted(total.cone_points, "cone point"), total.tets_undefined,
                  total.tets_undefined == 1 ? "whole tetrahedron" : "whole tetrahedra");
  }
  if (total.tets_nearby > 0) {
    append_format(text, "critical mode: {} meshed at a mode next to it, of the same topology\n",
                  counted_tets(total.tets_nearby));
  }
  if (total.sheets_loops > 0) {
    append_format(text, "filled between their boundary loops, without a vertex inside: {}\n",
                  counted(total.sheets_loops, "sheet"));
  }
  if (report.torn_faces.count > 0) append_format(text, "{}\n", report.torn_faces.text());
  if (report.written) {
    append_format(text, "{}: {} bytes written ({:.2f} s read, {:.2f} s extract, {:.2f} s write)\n",
                  report.output.string(), report.bytes, report.seconds_read, report.seconds_extract,
                  report.seconds_write);
  }
  return text + text_of(report.certificate);
}

}  // namespace tensortopo
