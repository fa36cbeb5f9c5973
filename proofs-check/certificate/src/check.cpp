// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "compare_arrays.hpp"
#include "compare_distance.hpp"

namespace certificate {
namespace {

Range range_of(const Json& value) { return {value[0].get<Number>(), value[1].get<Number>()}; }

/// The tetrahedra about which a level claims nothing. False if there is no such tetrahedron.
bool mark_left_out(const Json& claims, const Input& input, std::vector<bool>& left_out,
                   Ledger& ledger) {
  for (const Json& entry : claims["undecided"]) {
    const std::string reason = reason_of(entry[1]), name = "tetrahedron " + entry[0].dump();
    const std::size_t tet = input.tet_at(entry[0].get<Number>());
    if (tet == Input::kNone) return ledger.refute(name, reason, "no such tetrahedron"), false;
    left_out[tet] = true;
    ledger.leave_open(name, reason);
  }
  return true;
}

Level level_of(const Json& claims) {
  if (claims.contains("mode")) {
    const mpq_class mode = mode_of(claims["mode"]);
    return {mode.get_num(), mode.get_den()};
  }
  const Invariant invariant = invariant_of(claims["invariant"]);
  return {invariant, value_of(claims["value"], invariant)};
}

void check_level(const Json& claims, const Level& level, const Input& input, const Field& field,
                 const Triangles& surface, Ledger& ledger, const Progress& progress) {
  ledger.level = (claims.contains("mode")
                      ? "mode " + claims["mode"].get<std::string>()
                      : claims["invariant"].get<std::string>() + ' ' +
                            claims["value"].get<std::string>()) + ", ";
  std::vector<bool> left_out(input.tets.size());
  ledger.begin("left out");
  if (!mark_left_out(claims, input, left_out, ledger)) return;
  const std::size_t left_open = ledger.open();
  const Topology topology = derive_topology(input, field, level, left_out, progress);
  const Range vertices_of_level = range_of(claims["vertices"]);
  const LevelCase c{input, field, level, surface, claims, vertices_of_level,
                    range_of(claims["triangles"]), left_out, topology, progress};
  ledger.begin("vertices on the level");
  ledger.settle(claims["on_level"] == topology.on_level, "vertices on the level",
                claims["on_level"].dump(), std::to_string(topology.on_level));
  ledger.begin("edges");
  const CrossingVertices vertices = compare_edges(c, ledger);
  ledger.begin("faces");
  compare_faces(c, vertices, ledger);
  ledger.begin("tetrahedra");
  compare_tets(c, vertices, ledger);
  ledger.begin("cones");
  compare_cones(c, vertices, ledger);
  ledger.begin("surface");
  const auto placed = compare_surface(c, vertices, ledger);
  ledger.begin("distances");
  // Where something is refuted or open, the level may have more sheets, and vertices need not be
  // where they are claimed to be.
  const bool is_sound = placed && !ledger.has_refuted() && ledger.open() == left_open;
  if (!claims["distance"].is_null()) compare_distance(c, is_sound ? &*placed : nullptr, ledger);
  ledger.count(level.decided_by_balls(), level.decided_exactly());
}

/// Do the levels' ranges follow each other, to the end?
bool are_in_order(const Json& levels, const char* key, Number all) {
  Number next = 0;
  for (const Json& level : levels) {
    const Range range = range_of(level[key]);
    if (range.first != next || range.count > all - next) return false;
    next += range.count;
  }
  return next == all;
}

Report check(const std::string& input_file, const std::string& surface_file,
             const Json& certificate, const Progress& progress) {
  const Json &input_claims = certificate["input"], &surface_claims = certificate["surface"];
  const Input input =
      read_input(input_file, input_claims["tensor"], input_claims["components"]);
  const Triangles surface = read_triangles(surface_file);
  Report report;
  Ledger ledger(report);
  ledger.begin("files");
  const auto compare = [&](const char* what, const Json& claimed, const Json& derived) {
    ledger.settle(claimed == derived, what, claimed.dump(), derived.dump());
  };
  compare("points", input_claims["points"], input.points.size());
  compare("tetrahedra", input_claims["tetrahedra"], input.tets.size());
  compare("input's sha256", input_claims["sha256"], input.sha256());
  compare("vertices", surface_claims["vertices"], surface.points.size());
  compare("triangles", surface_claims["triangles"], surface.triangles.size());
  compare("surface's sha256", surface_claims["sha256"], surface.sha256());
  const Json& levels = certificate["levels"];
  const bool are_levels_of_surface = are_in_order(levels, "vertices", surface.points.size()) &&
                                     are_in_order(levels, "triangles", surface.triangles.size());
  ledger.settle(are_levels_of_surface, "levels", "all of the surface, one after the other",
                "they are not");
  ledger.begin("arrays");
  compare_hashes(surface_claims, surface, ledger);
  if (are_levels_of_surface) compare_arrays(levels, surface, ledger);
  if (report.refuted > 0) return report;  // of another field or surface nothing need be derived

  std::optional<Field> field;  // levels mostly are about the same tensors
  for (const Json& claims : levels) {
    const Level level = level_of(claims);
    if (!field || !(field->multiples() == level.multiples()))
      field.emplace(input, level.multiples());
    check_level(claims, level, input, *field, surface, ledger, progress);
  }
  return report;
}

}  // namespace

Report check_certificate(const std::string& input, const std::string& surface,
                         const std::string& certificate, const Progress& progress) {
  const Json document = read_document(certificate);
  try {
    return check(input, surface, document, progress);
  } catch (const Malformed& error) {
    throw Malformed(error.file().empty() ? certificate : error.file(), error.problem());
  }
}

}  // namespace certificate
