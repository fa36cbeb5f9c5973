// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "distances/closed_loops.hpp"
#include "distances/coarse_tets.hpp"
#include "distances/layers.hpp"
#include "distances/level_in_cell.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo::detail {

using Index = SurfaceMesh::Index;

/// A triangle that is not proved has its reaches multiplied by 2^(kStep/4), to no more than
/// 2^(kGrowth/4) times what it asked for.
inline constexpr int kStep = 2;
inline constexpr int kGrowth = 10;
inline constexpr int kAttempts = 4;
inline constexpr int kShortest = -4000;
/// A reach starts at so much of what the mode at a few places asks for.
inline constexpr double kMargin = 1.5;
/// A flat triangle asks for next to nothing, less than can be proved in double: in any case the
/// reaches may grow to so much of the tetrahedron's size.
inline constexpr double kFlat = 0x1p-20;
/// Of the way to the end of its edge, face or tetrahedron a vertex may go.
inline constexpr double kRoom = 0.98;

/// A tetrahedron, and the corners in it that were asked for: its triangles follow each other, and
/// share them.
template <class Cell>
class CellWithCorners {
 public:
  template <class Cells>
  CellWithCorners(const Cells& cells, Index tet) : tet_(tet), cell_(cells.at(tet)) {}

  Index tet() const { return tet_; }
  const Cell& cell() const { return cell_; }
  const MovingCorner& corner(const SurfaceMesh& surface, Index vertex) {
    const auto found = std::find(vertices_.begin(), vertices_.end(), vertex);
    const auto place = static_cast<std::size_t>(found - vertices_.begin());
    if (found == vertices_.end()) {
      vertices_.push_back(vertex);
      corners_.push_back(cell_.corner(surface, vertex));
    }
    return corners_[place];
  }

 private:
  Index tet_;
  Cell cell_;
  std::vector<Index> vertices_;
  std::vector<MovingCorner> corners_;
};

/// Whether a triangle was proved with these reaches.
struct Trial {
  std::array<std::int16_t, 3> reach;
  bool is_proved;
  std::int32_t previous;  ///< of the same triangle, or -1
};

/// Finds the reaches.
///
/// @tparam Cells  gives a tetrahedron and the level in it, like `LevelInCell`, and says of a vertex
///                of the mesh whether the level's function is undefined there
template <class Cells>
class ReachSearch {
 public:
  ReachSearch(const SurfaceMesh& surface, std::span<const std::size_t> triangles,
              const LevelTopology& topology, const Cells& cells)
      : surface_(surface), triangles_(triangles), topology_(topology), cells_(cells) {}

  /// Finds reaches that prove as many triangles as possible; returns those that are left.
  std::vector<std::size_t> run() {
    measure();
    last_trial_.assign(surface_.triangles.size(), -1);
    std::vector<char> given_up(surface_.triangles.size(), 0);
    // A triangle that is given up has made its neighbours' reaches longer: once more without it.
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      start(given_up);
      if (!grow(given_up)) break;
    }
    std::vector<std::size_t> left;
    for (const auto i : triangles_)
      if (given_up[i]) left.push_back(i);
    return left;
  }

  std::vector<int> reach() && { return std::move(reach_); }

 private:
  using Cell = CellWithCorners<decltype(std::declval<const Cells&>().at(Index{}))>;

  /// Is the level's function undefined there, as between isotropic vertices of the mesh?
  bool is_apex(Index vertex) const {
    const auto& carrier = surface_.carrier_vertices[as_size(vertex)];
    return std::all_of(carrier.begin(), carrier.end(),
                       [&](Index v) { return v < 0 || cells_.is_undefined_at(v); });
  }

  /// Calls f with the corners of a triangle that may move, one to three: all but apexes, from which
  /// the mode is constant along rays.
  template <class F>
  auto with_movable(std::size_t triangle, const F& f) const {
    auto v = surface_.triangles[triangle];
    const auto end = std::remove_if(v.begin(), v.end(), [&](Index w) { return is_apex(w); });
    if (end - v.begin() == 3) return f(v);
    if (end - v.begin() == 2) return f(std::array{v[0], v[1]});
    return f(std::array{v[0]});
  }

  /// Calls f for some triangles, in parallel, with their tetrahedra.
  template <class F>
  void for_each(std::span<const std::size_t> triangles, const F& f) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 512),
                      [&](const auto& range) {
                        const FloatingPointEnvironment environment;
                        std::optional<Cell> cell;
                        for (std::size_t k = range.begin(); k != range.end(); ++k) {
                          const Index tet = surface_.tet[triangles[k]];
                          if (!cell || cell->tet() != tet) cell.emplace(cells_, tet);
                          f(triangles[k], *cell);
                        }
                      });
  }

  std::array<std::int16_t, 3> reaches(std::size_t triangle) const {
    std::array<std::int16_t, 3> result;
    for (std::size_t c = 0; c < 3; ++c)
      result[c] = static_cast<std::int16_t>(reach_[as_size(surface_.triangles[triangle][c])]);
    return result;
  }

  /// What is known of a triangle with the reaches as they are.
  const Trial* trial_of(std::size_t triangle) const {
    const auto reach = reaches(triangle);
    for (auto t = last_trial_[triangle]; t >= 0; t = trials_[as_size(t)].previous)
      if (trials_[as_size(t)].reach == reach) return &trials_[as_size(t)];
    return nullptr;
  }

  bool is_proved(std::size_t triangle, Cell& in) const {
    return with_movable(triangle, [&](const auto& v) {
      const auto& cell = in.cell();
      std::array<std::array<double, 4>, std::tuple_size_v<std::decay_t<decltype(v)>>> ahead, behind;
      for (std::size_t c = 0; c < v.size(); ++c) {
        const MovingCorner& corner = in.corner(surface_, v[c]);
        const double by = reach_length(reach_[as_size(v[c])]);
        ahead[c] = corner.moved(by);
        behind[c] = corner.moved(-by);
      }
      return cell.is_on_side(ahead, Verdict::positive) &&
             cell.is_on_side(behind, Verdict::negative);
    });
  }

  /// What each triangle asks for.
  void measure() {
    asked_.resize(surface_.triangles.size());
    limit_.resize(surface_.triangles.size());
    std::vector<std::array<double, 3>> rooms(surface_.triangles.size());
    for_each(triangles_, [&](std::size_t i, Cell& in) {
      const auto& cell = in.cell();
      double farthest = 0x1p-44 * cell.size();
      const auto look = [&](const std::array<double, 4>& weights) {
        const double d = cell.distance(weights);
        if (d < cell.size()) farthest = std::max(farthest, d);
      };
      with_movable(i, [&](const auto& v) {
        const auto count = static_cast<double>(v.size());
        std::array<MovingCorner, 3> corners;
        std::array<double, 4> centre{};
        for (std::size_t c = 0; c < v.size(); ++c) {
          corners[c] = in.corner(surface_, v[c]);
          rooms[i][c] = kRoom * corners[c].room();
          for (std::size_t j = 0; j < 4; ++j) centre[j] += corners[c].weights[j] / count;
        }
        for (std::size_t c = 0; c < v.size(); ++c) {
          std::array<double, 4> middle;
          for (std::size_t j = 0; j < 4; ++j)
            middle[j] = 0.5 * (corners[c].weights[j] + corners[(c + 1) % v.size()].weights[j]);
          look(middle);
        }
        look(centre);
      });
      asked_[i] = reach_of(kMargin * farthest);
      limit_[i] = std::max(asked_[i] + kGrowth, reach_of(kFlat * cell.size()));
    });
    const auto vertices = surface_.points.size();
    std::vector<double> room(vertices, std::numeric_limits<double>::max());
    for (const auto i : triangles_)
      with_movable(i, [&](const auto& v) {
        for (std::size_t c = 0; c < v.size(); ++c)
          room[as_size(v[c])] = std::min(room[as_size(v[c])], rooms[i][c]);
      });
    // Nor may it come to the next crossing of its edge.
    for (const auto& edge : topology_.edges)
      for (std::size_t k = 1; k < edge.crossings.size(); ++k) {
        const auto v = as_size(edge.crossings[k - 1].vertex), w = as_size(edge.crossings[k].vertex);
        const auto gap = surface_.points[w] - surface_.points[v];
        const double half = 0.49 * length(gap);
        room[v] = std::min(room[v], half);
        room[w] = std::min(room[w], half);
      }
    for (const auto& [vertex, copy] : topology_.copies)
      room[as_size(copy)] = room[as_size(vertex)] =
          std::min(room[as_size(vertex)], room[as_size(copy)]);
    most_.resize(vertices);
    // A vertex in a corner of its carrier can hardly move, or not at all.
    for (std::size_t v = 0; v < vertices; ++v)
      most_[v] = room[v] > 0x1p-999 ? reach_of(room[v]) - 1 : kShortest;
  }

  void start(const std::vector<char>& given_up) {
    reach_.assign(surface_.points.size(), kShortest);
    for (const auto i : triangles_)
      if (!given_up[i])
        with_movable(i, [&](const auto& corners) {
          for (const Index v : corners)
            reach_[as_size(v)] =
                std::max(reach_[as_size(v)], std::min(asked_[i], most_[as_size(v)]));
        });
  }

  /// Tries all triangles, and those again whose reaches grew. Gives up those that a few times what
  /// they asked for does not help; tells whether there are such.
  bool grow(std::vector<char>& given_up) {
    std::vector<std::size_t> trying;
    for (const auto i : triangles_)
      if (!given_up[i]) trying.push_back(i);
    std::vector<char> proved(surface_.triangles.size(), 0), grown(surface_.points.size(), 0);
    std::vector<std::size_t> unknown;
    bool any_given_up = false;
    while (!trying.empty()) {
      unknown.clear();
      for (const auto i : trying)
        if (const auto* known = trial_of(i))
          proved[i] = known->is_proved;
        else
          unknown.push_back(i);
      for_each(unknown, [&](std::size_t i, Cell& in) { proved[i] = is_proved(i, in); });
      for (const auto i : unknown) {
        trials_.push_back({reaches(i), proved[i] != 0, last_trial_[i]});
        last_trial_[i] = static_cast<std::int32_t>(trials_.size() - 1);
      }
      std::fill(grown.begin(), grown.end(), 0);
      bool any_grown = false;
      for (const auto i : trying) {
        if (proved[i]) continue;
        bool can_grow = false;
        with_movable(i, [&](const auto& corners) {
          for (const Index v : corners) {
            const int limit = std::min(limit_[i], most_[as_size(v)]);
            can_grow |= grown[as_size(v)] != 0;
            if (grown[as_size(v)] || reach_[as_size(v)] >= limit) continue;
            reach_[as_size(v)] = std::min(reach_[as_size(v)] + kStep, limit);
            grown[as_size(v)] = 1;
            any_grown = can_grow = true;
          }
        });
        if (!can_grow) given_up[i] = 1, any_given_up = true;
      }
      if (!any_grown) break;
      trying.clear();
      for (const auto i : triangles_)
        if (!given_up[i] && std::any_of(surface_.triangles[i].begin(), surface_.triangles[i].end(),
                                        [&](Index v) { return grown[as_size(v)] != 0; }))
          trying.push_back(i);
    }
    return any_given_up;
  }

  const SurfaceMesh& surface_;
  std::span<const std::size_t> triangles_;
  const LevelTopology& topology_;
  const Cells& cells_;
  std::vector<int> asked_, limit_;        ///< by triangle
  std::vector<int> reach_, most_;         ///< by vertex
  std::vector<Trial> trials_;             ///< attempts differ around few triangles
  std::vector<std::int32_t> last_trial_;  ///< by triangle, or -1
};

/// For each tetrahedron of the mesh the longest reach of its triangles, with what rounding of
/// places adds; 0 where there are none.
/// @param triangles  those of a tetrahedron together
template <class Cells>
std::vector<double> longest_reaches(const TetMesh& mesh, const SurfaceMesh& surface,
                                    std::span<const std::size_t> triangles,
                                    std::span<const int> reach, const Cells& cells) {
  std::vector<double> result(mesh.tets.size(), 0);
  Index tet = -1;
  double size = 0;
  for (const auto i : triangles) {
    if (tet != surface.tet[i]) size = cells.at(tet = surface.tet[i]).size();
    double& longest = result[as_size(tet)];
    for (const Index v : surface.triangles[i]) {
      // A position is rounded off the edge or face that holds the vertex.
      const double rounding = 0x1p-48 * (one_norm(surface.points[as_size(v)]) + size);
      longest = std::max(longest, kAboveRounding * (reach_length(reach[as_size(v)]) + rounding));
    }
  }
  return result;
}

/// See `prove_distance`.
template <class Cells>
DistanceClaim distance_claim(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles, const LevelTopology& topology,
                             const Cells& cells, double wanted) {
  DistanceClaim claim;
  ReachSearch<Cells> search(surface, triangles, topology, cells);
  std::set<Index> coarse;
  for (const auto i : search.run()) coarse.insert(surface.tet[i]);
  claim.reach = std::move(search).reach();
  for (const Index t : uncovered_closed_loops(surface, triangles, topology, claim.reach))
    coarse.insert(t);
  auto by_reach = longest_reaches(mesh, surface, triangles, claim.reach, cells);
  for (const Index t : coarse) by_reach[as_size(t)] = 0;
  // What is proved, but not quite the distance that is wanted, may be so by parts.
  std::vector<Index> looked_at(coarse.begin(), coarse.end());
  if (wanted > 0)
    for (std::size_t t = 0; t < by_reach.size(); ++t)
      if (by_reach[t] > wanted && by_reach[t] < 2 * wanted)
        looked_at.push_back(static_cast<Index>(t));
  std::sort(looked_at.begin(), looked_at.end());
  const auto by_parts = coarse_bounds(mesh, surface, triangles, looked_at, cells, wanted);
  for (std::size_t i = 0; i < looked_at.size(); ++i) {
    double& reached = by_reach[as_size(looked_at[i])];
    if (reached > 0 && by_parts[i] >= reached) continue;
    reached = 0;
    claim.coarse.push_back(looked_at[i]);
    claim.coarse_bounds.push_back(by_parts[i]);
    claim.coarse_bound = std::max(claim.coarse_bound, by_parts[i]);
  }
  for (const double bound : by_reach) claim.bound = std::max(claim.bound, bound);
  return claim;
}

/// See `moved_places`.
template <class Cells>
MovedPlaces places_moved(const TetMesh& mesh, const SurfaceMesh& surface,
                         std::span<const int> reach, const Cells& cells) {
  return [&mesh, &surface, reach, cells](Index tet, Index vertex) {
    const auto corner = cells.at(tet).corner(surface, vertex);
    const double by = reach_length(reach[as_size(vertex)]);
    const auto at = [&](const std::array<double, 4>& weights) {
      Vector3<double> place{};
      for (std::size_t i = 0; i < 4; ++i)
        place += weights[i] * mesh.points[as_size(mesh.tets[as_size(tet)][i])];
      return place;
    };
    return std::array{at(corner.moved(-by)), at(corner.moved(by))};
  };
}

}  // namespace tensortopo::detail
