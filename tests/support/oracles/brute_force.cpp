// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tensortopo::test {

namespace {

// What must agree between two lattices, besides the crossings on edges, which are counted exactly.
bool same(const LocalTopology& s, const LocalTopology& t) { return s.components == t.components; }
bool same(const FaceTopology& s, const FaceTopology& t) {
  return s.open_arcs == t.open_arcs && s.closed_loops == t.closed_loops;
}

bool has_handle(const LocalTopology& t) {
  return std::any_of(t.components.begin(), t.components.end(),
                     [](const ComponentTopology& c) { return c.euler + c.loops < 2; });
}
bool has_handle(const FaceTopology&) { return false; }

// Tries one pair of resolutions; `view(mode, n)` is a lattice's view. Empty if the result is
// accepted, else the reason why not.
template <class View, class Topology, class Crossings>
const char* judge(const View& view, double mode, const std::pair<int, int>& rung,
                  const Crossings& exact_crossings, const BruteForceOptions& options,
                  Topology& result) {
  const auto fine = view(mode, rung.second);
  result = fine.topology;
  if (options.check_edges && fine.topology.edge_crossings != exact_crossings) {
    return "the lattice misses crossings on an edge";
  }
  if (!(fine.cell_angle < options.max_cell_angle)) return "the field turns too much in a cell";
  if (!same(view(mode, rung.first).topology, fine.topology)) return "two resolutions disagree";
  if (options.band > 0 && fine.cell_angle > 0) {
    // Around the degenerate curves, where the Lode angle is 0 or a third of pi, the surface is a
    // tube whose angular radius is the distance to that end: a tube that slips through the lattice
    // shows at a level where it is wider.
    const double lode = std::acos(mode) / 3, end = std::numbers::pi / 3;
    const double shift = options.band * fine.cell_angle * fine.cell_angle;
    const double widened = std::max(shift, fine.cell_angle / 2 - std::min(lode, end - lode));
    const double down = lode < end / 2 ? shift : widened, up = lode < end / 2 ? widened : shift;
    if (!(lode - down > 0 && lode + up < end)) return "the level is almost degenerate";
    for (const double beside : {lode - down / 3, lode + up / 3, lode - down, lode + up}) {
      if (!same(view(std::cos(3 * beside), rung.second).topology, fine.topology)) {
        return "a level nearby differs";
      }
    }
  }
  return "";
}

// Whether the field has the mode m, or no deviator, all over the simplex: at so many points
// inside that a polynomial of the degree of the level cannot vanish at all of them by accident.
bool lies_on_level(const LevelQuestion& question) {
  constexpr std::int64_t n = 10;
  const bool is_tet = question.size() == 4;
  for (std::int64_t i = 1; i < n; ++i) {
    for (std::int64_t j = 1; i + j < n; ++j) {
      for (std::int64_t k = is_tet ? 1 : 0; k <= (is_tet ? n - 1 - i - j : 0); ++k) {
        if (question.sign(std::array<std::int64_t, 4>{n - i - j - k, i, j, k}) != 0) return false;
      }
    }
  }
  return true;
}

template <class Topology, class View, class Corners>
std::optional<Topology> climb(const View& view, const Corners& corners, double mode, int factor,
                              const BruteForceOptions& options, BruteForceTrace* trace) {
  Topology result;
  auto exact_crossings = result.edge_crossings;
  const LevelQuestion question(corners, mode);
  if (options.check_edges) {
    std::size_t edge = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        exact_crossings[edge++] = exact_edge_crossings(question, i, j);
      }
    }
  }
  BruteForceTrace local;
  BruteForceTrace& told = trace != nullptr ? *trace : local;
  told = {};
  if (lies_on_level(question)) {
    told.refused = "the whole simplex lies on the level";
    return std::nullopt;
  }
  std::optional<Topology> unconfirmed;
  for (const auto& [coarse, fine] : options.ladder) {
    const std::pair<int, int> rung{factor * coarse, factor * fine};
    told.resolution = rung.second;
    ++told.rungs;
    told.refused = judge(view, mode, rung, exact_crossings, options, result);
    if (*told.refused != '\0') continue;
    if (!options.confirm_handles || !has_handle(result) ||
        (unconfirmed && same(*unconfirmed, result)))
      return result;
    told.refused = "a handle was seen once only";
    unconfirmed = result;
  }
  return std::nullopt;
}

}  // namespace

std::optional<LocalTopology> brute_force_topology(const TetCorners& corners, double mode,
                                                  const BruteForceOptions& options,
                                                  BruteForceTrace* trace) {
  const auto view = [&](double level, int n) { return lattice_view(corners, level, n); };
  return climb<LocalTopology>(view, corners, mode, 1, options, trace);
}

std::optional<FaceTopology> brute_force_face_topology(const TriangleCorners& corners, double mode,
                                                      const BruteForceOptions& options,
                                                      BruteForceTrace* trace) {
  const auto view = [&](double level, int n) { return lattice_face_view(corners, level, n); };
  return climb<FaceTopology>(view, corners, mode, 2, options, trace);
}

}  // namespace tensortopo::test
