// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "report/report_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

#include "check/check_command.hpp"
#include "check/checkable.hpp"
#include "counted.hpp"
#include "extract/stability.hpp"
#include "report/page.hpp"
#include "report/page_arrays.hpp"
#include "require_folder.hpp"
#include "shell_word.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/hash/sha256.hpp"
#include "tensortopo/io/field_formats.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/temporary_folder.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/io/write_text.hpp"
#include "tensortopo/modes/mode_extractor.hpp"

namespace tensortopo {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 1000;  ///< of the cells left out

void require_sense(const ReportCommand& command) {
  if (lower_extension(command.output) != ".html")
    throw UsageError(command.output.string() + ": the name must end in .html");
  if (command.modes.empty()) throw UsageError("no mode given (--mode)");
  for (const ModeValue& mode : command.modes)
    if (is_degenerate(mode))
      throw UsageError("--mode " + mode.text() +
                       ": surfaces have modes between -1 and 1; degenerate curves are in the "
                       "report without asking (but with --no-curves)");
  require_folder(command.output);
}

/// Why there is no certificate; empty if there is one.
std::string no_certificate(const ReportCommand& command, const ReadResult& read) {
  if (!command.certify) return "None was asked for.";
  if (command.read.making_others() != nullptr)
    return "A certificate is about the numbers of a file as they are, not about means or parts of "
           "cells.";
  const std::string why = why_not_checkable(command.input, subject_of(read));
  return why.empty() ? "" : "The checker of certificates does not read the field's file as it is: " + why + '.';
}

/// Of triangles or lines, whether they are the same in all fields within the radii.
const CellArray* stability_array(const std::vector<CellArray>& arrays) {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [](const CellArray& a) { return a.name == "stable"; });
  return found == arrays.end() ? nullptr : &*found;
}

/// What of a surface, or of curves, is in all fields within the radii; adds to the summary.
Json stability_facts(const std::string& name, std::size_t components, const ModePart& part,
                     ReportSummary& summary) {
  const StabilitySummary& s = *part.stability;
  summary.stable_components = summary.stable_components.value_or(0) + s.components.size();
  summary.components = summary.components.value_or(0) + components;
  Json reasons = Json::object();
  for (const auto& [reason, count] : s.reasons) reasons[reason] = count;
  return {{"of", name},
          {"stable_components", s.components.size()},
          {"components", components},
          {"crossed_stable_tets", s.crossed_stable_tets},
          {"crossings", s.crossings},
          {"stable_crossings", s.stable_crossings},
          {"unstable_tets", s.unstable_tets},
          {"reasons", std::move(reasons)}};
}

Json surface_facts(const ModeSurfaces& made, PageArrays& arrays) {
  const CellArray* const stable = stability_array(made.more);
  std::map<std::string, std::size_t> left_out;
  for (const LeftOut& cell : made.unresolved) ++left_out[cell.mode.text()];
  Json list = Json::array();
  std::size_t vertex = 0, triangle = 0;
  for (const ModePart& part : made.parts) {
    const SurfaceInvariants& i = part.invariants;
    Json parts = Json::array();
    for (const auto& p : i.parts)
      parts.push_back({{"euler_characteristic", p.euler_characteristic},
                       {"boundary_loops", p.boundary_loops},
                       {"genus", p.genus},
                       {"triangles", p.triangles},
                       {"area", p.area}});
    list.push_back({{"mode", short_text(part.mode)},
                    {"value", part.mode.approx()},
                    {"euler_characteristic", i.euler_characteristic},
                    {"boundary_loops", i.boundary_loops},
                    {"triangles", part.cells},
                    {"area", i.area},
                    {"distance_bound",
                     part.distance_bound ? Json(*part.distance_bound) : Json(nullptr)},
                    {"unresolved", left_out[part.mode.text()]},
                    {"parts", std::move(parts)},
                    {"arrays", arrays.add(made.surface, vertex, part.vertices, triangle, part.cells,
                                          stable ? std::span(stable->values)
                                                 : std::span<const std::int32_t>())}});
    vertex += part.vertices, triangle += part.cells;
  }
  return list;
}

Json curve_facts(const DegenerateCurves& made, Json& lines, PageArrays& arrays) {
  const CellArray* const stable = stability_array(made.more);
  Json list = Json::array();
  for (const ModePart& part : made.parts) {
    const char* const kind = part.mode.sign() > 0 ? "linear" : "planar";
    const CurveInvariants& i = part.curve_invariants;
    list.push_back({{"kind", kind},
                    {"components", i.components},
                    {"closed", i.closed_components},
                    {"length", i.length},
                    {"vertices", i.vertices},
                    {"unresolved", std::count_if(made.unresolved.begin(), made.unresolved.end(),
                                                 [&](const LeftOut& cell) {
                                                   return cell.mode == part.mode;
                                                 })}});
    if (stable != nullptr) {
      lines[kind] = arrays.add(made.curves, part.mode.approx(), stable->line_values, true);
      lines[std::string(kind) + "_unstable"] =
          arrays.add(made.curves, part.mode.approx(), stable->line_values, false);
    } else {
      lines[kind] = arrays.add(made.curves, part.mode.approx(), {}, true);
    }
  }
  return list;
}

Json left_out_facts(const std::vector<LeftOut>& cells, const TetMesh& mesh) {
  Json list = Json::array();
  for (const LeftOut& cell : cells) {
    if (list.size() == kMostListed) break;
    Vector3<double> centre{};
    for (const auto v : mesh.tets[as_size(cell.tet)])
      centre += 0.25 * mesh.points[as_size(v)];
    list.push_back({{"cell", mesh.cell_ids[as_size(cell.tet)]},
                    {"reason", cell.reason},
                    {"mode", short_text(cell.mode)},
                    {"centre", {centre.x, centre.y, centre.z}}});
  }
  return list;
}

Json sweep_facts(const Sweep& sweep, const SweepOptions& options) {
  Json json{{"from", options.from.approx()}, {"to", options.to.approx()}};
  json["intervals"] = Json::array();
  for (const SweepInterval& i : sweep.intervals)
    json["intervals"].push_back(
        {{"low", i.low},
         {"high", i.high},
         {"euler", i.euler_characteristic ? Json(*i.euler_characteristic) : Json(nullptr)}});
  json["events"] = Json::array();
  for (const SweepEvent& event : sweep.events) {
    std::string changes;
    for (const MeshCriticalPoint& point : event.points)
      changes += (changes.empty() ? "" : ", ") + std::string(name_of(point.effect.change));
    json["events"].push_back({{"mode", event.low}, {"changes", changes}});
  }
  return json;
}

/// The verdict of the checker, as HTML; fills the summary.
/// @param reason  why there is none
std::string certificate_part(const ReportCommand& command, const std::string& reason,
                             const ReadResult& read, const ModeSurfaces& made, ReportSummary& summary,
                             const Progress& progress) {
  summary.verdict = "none";
  if (!reason.empty())
    return "<p><span class=\"verdict none\">none</span> " + html_text(reason) + "</p>";
  TemporaryFolder folder;
  const auto surface = folder.file("surface.vtp"), certificate = folder.file("certificate.json");
  // There now, for the checker, whatever becomes of the page.
  FileGroup files(FileGroup::Bond::apart);
  write_surface(made.surface, {}, read.mesh, surface, {.mode_surfaces = true}, {}, made.more);
  write_text(certificate, made.certificate);
  files.commit();
  CheckDemands demands;
  for (const ModePart& part : made.parts) demands.modes.push_back(part.mode.text());
  const CheckOutcome outcome = run_check(command.input.string(), surface.string(),
                                         certificate.string(), demands, progress);
  summary.certified = outcome.certified;
  summary.claims = outcome.certified + outcome.refuted + outcome.undecided;
  summary.verdict = outcome.all_certified ? "certified"
                    : outcome.refuted > 0 ? "refuted"
                                          : "undecided";
  Sha256 sum;
  sum.add(made.certificate);
  const auto row = [](const char* what, const std::string& value) {
    return fmt::format("<dt>{}</dt><dd class=\"hash\">{}</dd>\n", what, value);
  };
  std::string flags;
  for (const ModePart& part : made.parts) flags += " --mode " + part.mode.text();
  if (!command.uncertainty.empty()) flags += " --uncertainty " + shell_word(command.uncertainty);
  const std::string file = html_text(shell_word(command.input.filename().string()));
  return fmt::format(
             "<p><span class=\"verdict {0}\" id=\"verdict\">{0}</span> {1} of {2} claims derived "
             "again, from the bits of the tensors, by a checker that shares no code with the "
             "extractor.</p>\n<dl>\n",
             summary.verdict, summary.certified, summary.claims) +
         row("SHA-256 of the field's numbers", field_sha256(read.mesh)) +
         row("of the surface's numbers", surface_sha256(made.surface, read.mesh)) +
         row("of the certificate", sum.hex()) +
         fmt::format("</dl>\n<p>To repeat it:<br><code>tensortopo extract {0} -o surface.vtp{1} "
                     "--certify certificate.json</code><br><code>tensortopo check {0} surface.vtp "
                     "certificate.json</code></p>",
                     file, html_text(flags));
}

std::string field_part(const ReportCommand& command, const ReadResult& read) {
  std::string notes;
  for (const std::string& note : read.report.all_notes()) notes += "<br>" + html_text(note);
  return fmt::format(
      "<dl><dt>file</dt><dd>{}{}</dd>\n<dt>SHA-256 of it</dt><dd class=\"hash\">{}</dd>\n"
      "<dt>tensors</dt><dd>{}</dd>\n<dt>mesh</dt><dd>{} vertices, {} tetrahedra</dd></dl>",
      html_text(command.input.filename().string()), notes, read.sha256,
      html_text(read.report.tensor_name), read.mesh.points.size(), read.mesh.tets.size());
}

/// Given modes and, if asked for, opposite ones; ascending, each once.
std::vector<ModeValue> modes_of(const ReportCommand& command) {
  auto modes = modes_to_extract(command.modes, command.generalized);
  std::stable_sort(modes.begin(), modes.end(), [](const ModeValue& a, const ModeValue& b) {
    return a.approx() < b.approx();
  });
  return modes;
}

}  // namespace

ReportSummary run_report(const ReportCommand& command, const Progress& progress) {
  require_sense(command);
  const auto tell = [&](const char* stage) {
    if (progress) progress(stage, 0);
  };
  tell("reading");
  const ReadResult read = read_mesh(command.input, command.read);
  const std::string uncertified = no_certificate(command, read);
  const TetMesh& mesh = read.mesh;
  auto uncertainty = requested_uncertainty(command.uncertainty);
  if (uncertainty) read_radii(command.input, command.read, read, *uncertainty);
  const ModeExtractor extractor(mesh);
  SurfaceRequest surfaces;
  surfaces.uncertainty = uncertainty;
  surfaces.modes = modes_of(command);
  surfaces.resolution = command.resolution;
  surfaces.certify = uncertified.empty();
  surfaces.names = {read.report.tensor_name, std::string(name_of(read.report.components.order)), false};
  surfaces.progress = progress;
  const ModeSurfaces made = extractor.surfaces(surfaces);

  ReportSummary summary;
  summary.output = command.output;
  PageArrays arrays(mesh);
  Json facts, lines = Json::object(), stability = Json::array();
  facts["surfaces"] = surface_facts(made, arrays);
  if (uncertainty)
    for (const ModePart& part : made.parts)
      stability.push_back(stability_facts(short_text(part.mode), part.invariants.parts.size(), part,
                                          summary));
  std::vector<LeftOut> left_out = made.unresolved;
  facts["curves"] = Json::array();
  if (command.curves) {
    CurveRequest request;
    request.planar = true;
    request.uncertainty = uncertainty;
    request.resolution = command.resolution;
    request.progress = progress;
    const DegenerateCurves curves = extractor.curves(request);
    facts["curves"] = curve_facts(curves, lines, arrays);
    if (uncertainty)
      for (const ModePart& part : curves.parts)
        stability.push_back(
            stability_facts(part.mode.sign() > 0 ? "linear degenerate curves"
                                                 : "planar degenerate curves",
                            part.curve_invariants.components, part, summary));
    left_out.insert(left_out.end(), curves.unresolved.begin(), curves.unresolved.end());
  }
  if (!left_out.empty()) lines["unresolved"] = arrays.add(left_out);
  lines["outline"] = arrays.add_outline();
  facts["lines"] = std::move(lines);
  facts["uncertainty"] = uncertainty ? Json{{"radius", command.uncertainty},
                                            {"levels", std::move(stability)}}
                                     : Json(nullptr);
  facts["unresolved"] = left_out_facts(left_out, mesh);
  facts["unresolved_count"] = left_out.size();

  std::string sweep_text;
  if (command.sweep) {
    const Sweep sweep = sweep_modes(mesh, *command.sweep, progress);
    facts["sweep"] = sweep_facts(sweep, *command.sweep);
    sweep_text = fmt::format("<p>{} modes at which the topology changes, from {} to {}.</p>",
                             sweep.events.size(), html_text(short_text(command.sweep->from)),
                             html_text(short_text(command.sweep->to)));
  } else {
    facts["sweep"] = nullptr;
  }

  const std::string certificate = certificate_part(command, uncertified, read, made, summary, progress);
  tell("writing");
  const std::string page = page_of(
      {{"TITLE", "Mode surfaces of " + html_text(command.input.filename().string())},
       {"FIELD", field_part(command, read)},
       {"SWEEP", sweep_text},
       {"CERTIFICATE", certificate},
       {"FACTS", json_for_script(facts.dump(-1, ' ', false, Json::error_handler_t::replace))},
       {"GEOMETRY", arrays.text()}});
  write_text(command.output, page);
  summary.bytes = page.size();
  summary.surfaces = made.parts.size();
  summary.triangles = made.surface.triangles.size();
  std::set<TetMesh::Index> cells;  // each may be missing in several outputs
  for (const LeftOut& cell : left_out) cells.insert(cell.tet);
  summary.unresolved = cells.size();
  return summary;
}

std::string to_json(const ReportSummary& s) {
  Json json{{"output", s.output.string()}, {"bytes", s.bytes},
            {"surfaces", s.surfaces},      {"triangles", s.triangles},
            {"unresolved", s.unresolved},  {"certificate", s.verdict},
            {"certified", s.certified},    {"claims", s.claims}};
  if (s.components) {
    json["components"] = *s.components;
    json["stable_components"] = *s.stable_components;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const ReportSummary& s) {
  const std::string verdict =
      s.verdict == "none" ? "no certificate"
                          : fmt::format("{}: {} of {} claims", s.verdict, s.certified, s.claims);
  const std::string stable =
      s.components
          ? fmt::format("; {} of {} components stable", *s.stable_components, *s.components)
          : "";
  return fmt::format("{}: {} bytes, {} of {}, {} left out; {}{}\n", s.output.string(), s.bytes,
                     counted(s.surfaces, "surface"), counted(s.triangles, "triangle"),
                     counted(s.unresolved, "cell"), verdict, stable);
}

}  // namespace tensortopo
