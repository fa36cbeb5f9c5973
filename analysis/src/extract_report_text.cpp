// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>
#include <set>

#include "tensortopo/analysis/extract_report.hpp"

namespace tensortopo {

std::map<UnresolvedReason, std::size_t> count_unresolved(const ExtractReport& report) {
  std::map<UnresolvedReason, std::size_t> counts;
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
    total.sheets_tubes += s.sheets_tubes;
    total.sheets_manifold += s.sheets_manifold;
    total.sheets_leaves += s.sheets_leaves;
    total.vertices_on_level += s.vertices_on_level;
    total.seconds_edges += s.seconds_edges;
    total.seconds_faces += s.seconds_faces;
    total.seconds_tets += s.seconds_tets;
    total.seconds_stitch += s.seconds_stitch;
  }
  return total;
}

std::string unresolved_line(const ExtractReport& report) {
  if (report.unresolved.empty()) return {};
  std::set<std::int64_t> cells;
  for (const UnresolvedReport& cell : report.unresolved) cells.insert(cell.cell);
  std::string reasons;
  for (const auto& [reason, count] : count_unresolved(report)) {
    reasons += fmt::format("{}{} {}", reasons.empty() ? "" : ", ", count, name_of(reason));
  }
  return fmt::format("{} of {} tetrahedra unresolved ({})", cells.size(), report.tetrahedra,
                     reasons);
}

std::string to_text(const ExtractReport& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {} vertices, {} tetrahedra, tensor '{}'\n", report.input.string(),
                 report.vertices, report.tetrahedra, report.tensor_name);
  fmt::format_to(out, "{:>10} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13} {:>9} {:>8} {:>8}\n", "mode",
                 "vertices", "triangles", "parts", "loops", "euler", "area", "residual", "manifold",
                 "tets");
  for (const SurfaceReport& s : report.surfaces) {
    const SurfaceInvariants& known = s.invariants;
    fmt::format_to(out, "{:>10} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13.6g} {:>9.1e} {:>8} {:>8}\n",
                   s.mode.text(), s.vertices, s.triangles, known.components, known.boundary_loops,
                   known.euler_characteristic, known.area, s.max_abs_residual,
                   known.manifold ? "yes" : "no", s.statistics.tets_crossed);
  }
  if (report.written) {
    fmt::format_to(out, "{}: {} bytes written ({:.2f} s read, {:.2f} s extract, {:.2f} s write)\n",
                   report.output.string(), report.bytes, report.seconds_read,
                   report.seconds_extract, report.seconds_write);
  }
  return text;
}

}  // namespace tensortopo
