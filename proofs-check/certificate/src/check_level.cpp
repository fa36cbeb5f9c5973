// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "check_level.hpp"

#include "claims/compare_level.hpp"
#include "claims/curve_names.hpp"
#include "claims/left_out.hpp"
#include "distances/compare_distance.hpp"
#include "isotopy/compare_isotopy.hpp"
#include "surface/compare_embedding.hpp"
#include "surface/compare_places.hpp"
#include "vertices/compare_vectors.hpp"
#include "vertices/residual.hpp"

namespace certificate {

std::string level_name_of(const Json& claims) {
  return claims.contains("mode")
             ? "mode " + claims["mode"].get<std::string>()
             : claims["invariant"].get<std::string>() + ' ' + claims["value"].get<std::string>();
}

Level level_of(const Json& claims) {
  if (claims.contains("mode")) {
    const mpq_class mode = mode_of(claims["mode"]);
    return {mode.get_num(), mode.get_den()};
  }
  const Invariant invariant = invariant_of(claims["invariant"]);
  return {invariant, value_of(claims["value"], invariant)};
}

void derive_level(CheckedLevel& checked, const Input& input, WorkLimit& limit,
                  const Progress& progress) {
  const Json& claims = checked.claims;
  Ledger& ledger = checked.ledger;
  ledger.begin_level(level_name_of(claims));
  ledger.of_level().vertices = claims["vertices"][1].get<std::size_t>();
  ledger.begin("left out");
  checked.left_out.resize(input.tets.size());
  if (!mark_left_out(claims, input, reason_of, checked.left_out, ledger)) return;
  constexpr const char* kTooMuch = "more work than files of this size are given";
  if (limit.is_reached()) return ledger.leave_open("topology", kTooMuch);
  checked.topology = derive_topology(input, *checked.field, checked.level, checked.left_out,
                                     in_parallel(progress), limit.within(checked.level, progress));
  if (limit.is_reached()) ledger.leave_open("topology", kTooMuch);
}

void compare_level(CheckedLevel& checked, const RadiiByArray& radii, const Input& input,
                   const Triangles& surface, const Progress& progress, PartBorder* border) {
  if (!checked.topology) return;
  const Json& claims = checked.claims;
  const Topology& topology = *checked.topology;
  Ledger& ledger = checked.ledger;
  LevelCase c{input,
              *checked.field,
              checked.level,
              surface,
              claims,
              range_of(claims["vertices"]),
              range_of(claims["triangles"]),
              checked.left_out,
              topology,
              progress,
              {}};
  c.curves = name_curves(c);
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
  if (placed) {
    ledger.begin("places");
    compare_places(c, *placed, ledger);
    ledger.begin("orientation");
    compare_orientation(c, *placed, ledger);
    ledger.of_level().residual = residual_bound(c, *placed);
    ledger.begin("arrays");
    compare_vectors(c, *placed, ledger);
    if (border != nullptr) add_surface(c, vertices, *placed, *border);
  }
  ledger.begin("embedded");
  if (const auto embedded = claims.find("embedded"); embedded != claims.end())
    compare_embedding(c, embedded->get<bool>(), ledger);
  ledger.begin("distances");
  // Where something is refuted or open, the level may have more sheets, and vertices need not be
  // where they are claimed to be.
  const bool is_sound =
      placed && !ledger.has_refuted() && ledger.open() == ledger.of_level().left_out_count();
  if (const Json& distance = claims["distance"]; !distance.is_null()) {
    ledger.of_level().bound = distance["bound"].get<std::string>();
    ledger.of_level().coarse = distance["coarse"].size();
    ledger.of_level().coarse_bound = distance["coarse_bound"].get<std::string>();
    if (placed) ledger.of_level().bounded = count_bounded(c, *placed);
    ledger.of_level().near = compare_distance(c, is_sound ? &*placed : nullptr, ledger);
  }
  ledger.begin("isotopic");
  if (claims.contains("isotopic"))
    compare_isotopy(c, is_sound ? &*placed : nullptr, ledger.of_level().near, ledger);
  ledger.begin("stability");
  if (claims.contains("stability"))
    compare_stability(c, radii, is_sound ? &*placed : nullptr, ledger);
  ledger.count(checked.level.decided_by_balls(), checked.level.decided_exactly());
}

}  // namespace certificate
