// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "append_format.hpp"
#include "counted.hpp"
#include "extract/report/certificate_report_output.hpp"
#include "extract/report/topology_json.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/invariant_command.hpp"

namespace tensortopo {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReason = "zero_tensor";

Json counts(std::size_t unresolved) {
  Json json = Json::object();
  if (unresolved > 0) json[kReason] = unresolved;
  return json;
}

Json surface_json(const InvariantSurfaceReport& surface) {
  Json json{{"invariant", name_of(surface.level.invariant())},
            {"value", surface.level.approx()},
            {"value_exact", surface.level.text()},
            {"vertices", surface.vertices},
            {"triangles", surface.triangles}};
  add_topology(json, surface.topology);
  json["max_abs_residual"] = surface.max_abs_residual;
  json["tets_crossed"] = surface.statistics.tets_crossed;
  json["tets_refined"] = surface.statistics.tets_refined;
  json["vertices_on_level"] = surface.statistics.vertices_on_level;
  json["answers_exact"] = surface.statistics.signs_exact;
  json["unresolved"] = counts(surface.unresolved);
  json["parts"] = parts_json(surface.topology);
  return json;
}

}  // namespace

std::string unresolved_line(const InvariantReport& report) {
  if (report.unresolved.empty()) return {};
  return fmt::format("{0} of {1} unresolved ({0} {2})", report.unresolved.size(),
                     counted_tets(report.tetrahedra), kReason);
}

std::string to_json(const InvariantReport& report) {
  Json json = begin_json("tensortopo extract --invariant", report);
  json["output"] = output_json(report);
  json["surfaces"] = Json::array();
  double tets = 0, stitch = 0;
  for (const auto& surface : report.surfaces) {
    json["surfaces"].push_back(surface_json(surface));
    tets += surface.statistics.seconds_tets;
    stitch += surface.statistics.seconds_stitch;
  }
  json["unresolved"] = counts(report.unresolved.size());
  json["unresolved_cells"] = listed_cells_json(report.unresolved, [](const auto cell) {
    return Json{{"cell", cell}, {"reason", kReason}};
  });
  json["certificate"] = certificate_json(report.certificate);
  json["seconds"] = {{"read", report.seconds_read},
                     {"tets", tets},
                     {"stitch", stitch},
                     {"extract", report.seconds_extract},
                     {"certify", report.certificate ? report.certificate->seconds : 0},
                     {"write", report.seconds_write}};
  // A path may hold bytes that are no UTF-8; JSON must not.
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const InvariantReport& report) {
  std::string text;
  append_format(text, "{}: {}, {}, tensor '{}': {}\n", report.input.string(),
                counted(report.vertices, "vertex", "vertices"), counted_tets(report.tetrahedra),
                report.tensor_name, report.components.text());
  if (!report.surfaces.empty())
    append_format(text, "{:>20} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13} {:>9} {:>8} {:>8}\n",
                  name_of(report.surfaces[0].level.invariant()), "vertices", "triangles", "parts",
                  "loops", "euler", "area", "residual", "manifold", "tets");
  for (const auto& s : report.surfaces)
    append_format(text, "{:>20} {:>9} {:>9} {:>6} {:>6} {:>6} {:>13.6g} {:>9.1e} {:>8} {:>8}\n",
                  short_text(s.level), s.vertices, s.triangles, s.topology.components,
                  s.topology.boundary_loops, s.topology.euler_characteristic, s.topology.area,
                  s.max_abs_residual, s.topology.manifold ? "yes" : "no",
                  s.statistics.tets_crossed);
  if (report.torn_faces.count > 0) append_format(text, "{}\n", report.torn_faces.text());
  if (report.written)
    append_format(text, "{}: {} bytes written ({:.2f} s read, {:.2f} s extract, {:.2f} s write)\n",
                  report.output.string(), report.bytes, report.seconds_read, report.seconds_extract,
                  report.seconds_write);
  return text + text_of(report.certificate);
}

}  // namespace tensortopo
