// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "append_format.hpp"
#include "counted.hpp"
#include "generate/truth.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"

namespace tensortopo {

namespace {

using Json = nlohmann::ordered_json;

bool agree(LevelTruth file, const LevelTruth& now) {
  // Which member of a sheet a component is in is not seen in the field.
  for (auto& component : file.components) component.member = -1;
  std::sort(file.components.begin(), file.components.end());
  const auto same_cells = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& s, const auto& t) {
      return s.tet == t.tet && s.reason == t.reason;
    });
  };
  return file.components == now.components && same_cells(file.undecided, now.undecided) &&
         (!file.detailed ||
          (file.edges == now.edges && file.faces == now.faces && file.tets == now.tets));
}

void require_agreement(const std::filesystem::path& file, const TetMesh& mesh,
                       const ModeValue& mode, const CertifiedLevel& level) {
  const FieldTruth truth = read_truth(file);
  if (truth.field_sha256 != field_sha256(mesh))
    throw IoError(IoError::Kind::invalid, file, "is about another field than the mesh");
  const auto found = std::find_if(truth.levels.begin(), truth.levels.end(),
                                  [&](const LevelTruth& l) { return l.mode == mode; });
  if (found == truth.levels.end())
    throw IoError(IoError::Kind::invalid, file, "says nothing of mode " + mode.text());
  if (!agree(*found, level_truth(level, true)))
    throw IoError(IoError::Kind::invalid, file,
                  "contradicts what is certified of the mesh at mode " + mode.text());
}

Json json_of(const ScoredComponent& c) {
  return {{"euler_characteristic", c.euler_characteristic},
          {"boundary_loops", c.boundary_loops},
          {"triangles", c.triangles},
          {"place", {c.place.x, c.place.y, c.place.z}}};
}

Json json_of(const std::vector<ScoredComponent>& list) {
  Json json = Json::array();
  for (const auto& c : list) json.push_back(json_of(c));
  return json;
}

std::string text_of(const ScoredComponent& c) {
  return fmt::format("Euler characteristic {}, {}, {}, at ({:.4g}, {:.4g}, {:.4g})",
                     c.euler_characteristic, counted(c.boundary_loops, "loop"),
                     counted(c.triangles, "triangle"), c.place.x, c.place.y, c.place.z);
}

}  // namespace

ConformanceReport run_conformance(const ConformanceCommand& command, const Progress& progress) {
  if (is_degenerate(command.mode))
    throw UsageError("--mode " + command.mode.text() + ": surfaces are scored, not curves");
  const auto tell = [&](const char* stage) {
    if (progress) progress(stage, 0);
  };
  ConformanceReport report;
  report.surface = command.surface;
  report.input = command.input;
  report.mode = command.mode;
  tell("reading");
  const ReadTriangles triangles = read_triangles(command.surface, command.mode);
  const GivenSurface given =
      merge_points(triangles.surface, command.merge, lower_extension(command.surface) != ".stl");
  const ReadResult read = read_mesh(command.input, command.read);
  report.notes = read.report.all_notes();
  tell("certifying");
  const Standard standard = certified_standard(read.mesh, command.mode, command.resolution);
  if (!command.truth.empty())
    require_agreement(command.truth, read.mesh, command.mode, standard.level);
  tell("comparing");
  report.score = score_surface(read.mesh, standard, given);
  report.score.other_modes = triangles.other_modes;
  return report;
}

std::string to_json(const ConformanceReport& report) {
  const SurfaceScore& s = report.score;
  Json json;
  json["surface"] = report.surface.string();
  json["input"] = report.input.string();
  json["mode"] = report.mode.approx();
  json["mode_exact"] = report.mode.text();
  json["conforms"] = s.conforms();
  json["components"] = {{"matched", s.matched.size()},
                        {"wrong_topology", s.wrong_topology()},
                        {"missed", json_of(s.missed)},
                        {"without_extent", s.without_extent},
                        {"extra", json_of(s.extra)}};
  json["matches"] = Json::array();
  for (const auto& m : s.matched)
    json["matches"].push_back({{"truth", json_of(m.truth)},
                               {"given", json_of(m.given)},
                               {"shared_crossings", m.shared_crossings},
                               {"same_topology", m.same_topology()}});
  json["holes"] = {{"count", s.holes}, {"edges", s.hole_edges}};
  json["seam_edges"] = s.seam_edges;
  json["non_manifold"] = {{"edges", s.non_manifold_edges}, {"vertices", s.non_manifold_vertices}};
  json["consistently_oriented"] = s.consistently_oriented;
  Json edges = Json::array();
  for (const auto& e : s.edges)
    edges.push_back({{"vertices", e.vertices}, {"truth", e.truth}, {"given", e.given}});
  json["crossings"] = {{"truth", s.crossings},
                       {"missed", s.missed_crossings},
                       {"extra", s.extra_crossings},
                       {"unclear_edges", s.unclear_edges},
                       {"edges", edges}};
  // JSON has no infinity: without triangles there is no distance.
  json["distance"] = {{"sampled_to_truth", s.to_truth},
                      {"sampled_from_truth", s.from_truth},
                      {"certified_bound_of_truth", s.certified},
                      {"coarse_cells", s.coarse_cells},
                      {"coarse_bound", s.coarse_bound}};
  json["triangles"] = s.triangles;
  json["other_modes"] = s.other_modes;
  json["merged_points"] = s.merged_points;
  json["collapsed_triangles"] = s.collapsed_triangles;
  json["undecided_tetrahedra"] = s.undecided;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const ConformanceReport& report) {
  const SurfaceScore& s = report.score;
  std::string text;
  const auto row = [&](const char* what, const std::string& value) {
    append_format(text, "{:<34} {}\n", what, value);
  };
  append_format(text, "{} against mode {} of {}: {}\n", report.surface.string(),
                short_text(report.mode), report.input.string(),
                s.conforms() ? "conforms" : "does not conform");
  if (s.other_modes > 0 && s.triangles + s.collapsed_triangles == 0)
    append_format(text, "{} has no triangles of this mode\n", report.surface.string());
  row("components matched", std::to_string(s.matched.size()));
  row("  of these of another topology", std::to_string(s.wrong_topology()));
  row("components missed", std::to_string(s.missed.size()));
  if (s.without_extent > 0) row("  without extent, left out", std::to_string(s.without_extent));
  row("components extra", std::to_string(s.extra.size()));
  row("holes (edges)", fmt::format("{} ({})", s.holes, s.hole_edges));
  row("seam edges", std::to_string(s.seam_edges));
  row("non-manifold edges, vertices",
      fmt::format("{}, {}", s.non_manifold_edges, s.non_manifold_vertices));
  row("crossings of mesh edges",
      fmt::format("{}, {} missed, {} extra ({} edges too close to tell)", s.crossings,
                  s.missed_crossings, s.extra_crossings, s.unclear_edges));
  row("distance, sampled, to truth", fmt::format("{:.3g}", s.to_truth));
  row("distance, sampled, from truth", fmt::format("{:.3g}", s.from_truth));
  row("  certified bound of truth",
      fmt::format("{:.3g}", s.certified) +
          (s.coarse_cells == 0
               ? ""
               : fmt::format(" (in {} tetrahedra only {:.3g})", s.coarse_cells, s.coarse_bound)));
  if (s.merged_points + s.collapsed_triangles > 0)
    row("points merged, triangles dropped",
        fmt::format("{}, {}", s.merged_points, s.collapsed_triangles));
  if (s.other_modes > 0) row("triangles of other modes, left out", std::to_string(s.other_modes));
  if (!s.consistently_oriented) row("orientation", "not consistent");
  if (s.undecided > 0) row("tetrahedra without truth", std::to_string(s.undecided));
  for (const auto& m : s.matched)
    if (!m.same_topology())
      append_format(text, "wrong   {}\n  truth {}\n", text_of(m.given), text_of(m.truth));
  for (const auto& c : s.missed) append_format(text, "missed  {}\n", text_of(c));
  for (const auto& c : s.extra) append_format(text, "extra   {}\n", text_of(c));
  constexpr std::size_t most = 20;
  for (std::size_t i = 0; i < std::min(most, s.edges.size()); ++i)
    append_format(text, "edge {} {}: {} crossings, not {}\n", s.edges[i].vertices[0],
                  s.edges[i].vertices[1], s.edges[i].truth, s.edges[i].given);
  if (s.edges.size() > most) append_format(text, "and {} edges more\n", s.edges.size() - most);
  return text;
}

}  // namespace tensortopo
