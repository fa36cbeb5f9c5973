// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/compare_distance.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "claims/containment.hpp"
#include "claims/half_edges.hpp"
#include "distances/closed_curves.hpp"
#include "distances/near_level.hpp"
#include "run/parallel.hpp"

namespace certificate {
namespace {

std::string text_of(double x) { return std::isfinite(x) ? Json(x).dump() : "infinite"; }

/// What is not proved to be so.
struct Unproved : Wrong {
  using Wrong::Wrong;
};

/// Its members throw Wrong or Unproved.
class Distances {
 public:
  Distances(const LevelCase& c, const PlacedSurface& placed);

  void require_bounds() const;
  void prove() const;

 private:
  bool is_asked(std::size_t triangle) const {
    const std::size_t tet = placed_.tets[triangle];
    return !c_.left_out[tet] && !is_coarse_[tet];
  }
  bool is_apex(std::size_t v) const { return certificate::is_apex(c_, placed_.carriers[v]); }
  bool is_amid_carrier(std::size_t v) const;
  /// Is the mode, or other invariant, defined at its corners?
  bool has_modes(std::size_t tet) const {
    const auto& v = c_.input.tets[tet];
    return std::none_of(v.begin(), v.end(), [&](Vertex i) { return c_.field.is_zero(i); });
  }
  bool is_clear(const MovedVertices& moved, std::size_t triangle) const;
  std::array<std::size_t, 3> vertices_of(std::size_t triangle) const {
    auto result = std::array<std::size_t, 3>{};
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = c_.surface.triangles[c_.triangles.first + triangle][i] - c_.vertices.first;
    return result;
  }
  std::string where(std::size_t tet) const {
    return " in tetrahedron " + std::to_string(c_.input.cells[tet]);
  }
  std::string vertex(std::size_t v) const {
    return "vertex " + std::to_string(c_.vertices.first + v);
  }
  std::optional<std::string> longer_edge(std::size_t tet) const;
  void prove_coarse() const;
  void prove_passed_crossings(const MovedVertices& moved) const;

  const LevelCase& c_;
  const PlacedSurface& placed_;
  std::vector<std::int64_t> reach_;
  double bound_, coarse_bound_;
  std::vector<bool> is_coarse_, is_used_;
};

Distances::Distances(const LevelCase& c, const PlacedSurface& placed)
    : c_(c),
      placed_(placed),
      reach_(c.claims["distance"]["reach"]),
      bound_(length_of(c.claims["distance"]["bound"])),
      coarse_bound_(length_of(c.claims["distance"]["coarse_bound"])),
      is_coarse_(c.input.tets.size()),
      is_used_(placed.carriers.size()) {
  for (const Json& cell : c.claims["distance"]["coarse"]) {
    const std::size_t tet = c.input.tet_at(cell.get<Number>());
    if (tet == Input::kNone) throw Wrong("no tetrahedron " + cell.dump());
    if (c.left_out[tet])
      throw Wrong("tetrahedron " + cell.dump() + " is undecided: no distance can be claimed there");
    is_coarse_[tet] = true;
  }
  for (std::size_t t = 0; t < placed.tets.size(); ++t)
    if (is_asked(t))
      for (const std::size_t v : vertices_of(t)) is_used_[v] = true;
}

/// An edge of a tetrahedron that is longer than the coarse bound, if there is one: else two points
/// in it are as near. Positions may be rounded out of their tetrahedron, on each axis by as much as
/// its corners say.
std::optional<std::string> Distances::longer_edge(std::size_t tet) const {
  const auto& v = c_.input.tets[tet];
  mpq_class rounding = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double largest = 0;
    for (const Vertex i : v) largest = std::max(largest, std::abs(c_.input.points[i][k]));
    rounding += rounding_of(largest);
  }
  const mpq_class most = mpq_class(coarse_bound_) - rounding;
  std::optional<std::string> result;
  for_subsets(4, 2, [&](const auto& ends) {
    mpq_class sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class d = mpq_class(c_.input.points[v[ends[0]]][k]) -
                          mpq_class(c_.input.points[v[ends[1]]][k]);
      sum += d * d;
    }
    if (!result && (most < 0 || sum > most * most))
      result = "the edge of vertices " + std::to_string(v[ends[0]]) + " and " +
               std::to_string(v[ends[1]]) + " is longer, about " + text_of(std::sqrt(sum.get_d())) +
               ", than coarse_bound " + text_of(coarse_bound_) +
               " less what rounding of positions adds" + where(tet);
  });
  return result;
}

/// What is wrong by the numbers themselves.
void Distances::require_bounds() const {
  if (reach_.size() != placed_.carriers.size())
    throw Wrong(std::to_string(placed_.carriers.size()) + " vertices, " +
                std::to_string(reach_.size()) + " reaches");
  for (std::size_t v = 0; v < reach_.size(); ++v)
    if (is_used_[v] && !is_apex(v) && reach_length(reach_[v]) > bound_)
      throw Wrong("the reach of " + vertex(v) + " is " + text_of(reach_length(reach_[v])) +
                  ", above the bound " + text_of(bound_));
}

/// In coarse tetrahedra with a longer edge than the coarse bound.
void Distances::prove_coarse() const {
  struct LongCell {
    std::size_t tet;
    std::string longer_edge;
    std::vector<std::array<Point3, 3>> triangles;
  };
  std::vector<LongCell> cells;
  std::map<std::size_t, std::size_t> cell_of;  // by tetrahedra
  for (std::size_t tet = 0; tet < is_coarse_.size(); ++tet) {
    if (!is_coarse_[tet]) continue;
    const auto why = longer_edge(tet);
    if (!why) continue;
    if (!has_modes(tet)) throw Unproved(*why + ", and there are no parts of a cone");
    cell_of[tet] = cells.size();
    cells.push_back({tet, *why, {}});
  }
  for (std::size_t t = 0; t < placed_.tets.size(); ++t) {
    const auto found = cell_of.find(placed_.tets[t]);
    if (found == cell_of.end()) continue;
    auto& corners = cells[found->second].triangles.emplace_back();
    const auto v = vertices_of(t);
    for (std::size_t k = 0; k < 3; ++k) corners[k] = c_.surface.points[c_.vertices.first + v[k]];
  }
  // The same on each machine: looked at after so many tetrahedra.
  constexpr std::size_t kTogether = 64, kMostWork = 400000000, kMostPerCell = 1000000;
  std::size_t work = 0;
  for (std::size_t first = 0; first < cells.size(); first += kTogether) {
    if (work >= kMostWork + kMostPerCell * first)
      throw Unproved("bounds of coarse tetrahedra below their edges take too much work");
    const std::size_t count = std::min(kTogether, cells.size() - first);
    std::vector<std::size_t> of_cell(count);
    std::vector<char> is_near(count);
    parallel_for(count, [&](std::size_t i) {
      const LongCell& cell = cells[first + i];
      is_near[i] = is_near_level(c_, cell.tet, cell.triangles, coarse_bound_, of_cell[i]);
    });
    for (const std::size_t w : of_cell) work += w;
    const auto missing = std::find(is_near.begin(), is_near.end(), 0);
    if (missing == is_near.end()) continue;
    const LongCell& cell = cells[first + static_cast<std::size_t>(missing - is_near.begin())];
    if (const auto far = point_far_from_level(c_, cell.tet, cell.triangles, coarse_bound_))
      throw Wrong("the level is farther than coarse_bound " + text_of(coarse_bound_) +
                  " from the triangles' point " + Json(*far).dump() + where(cell.tet));
    throw Unproved(cell.longer_edge + ", and less is not shown by parts of the tetrahedron");
  }
}

/// Is a vertex that does not move within the bound of the middle of what carries it?
bool Distances::is_amid_carrier(std::size_t v) const {
  const Carrier& carrier = placed_.carriers[v];
  const mpq_class limit = mpq_class(bound_) * static_cast<unsigned long>(carrier.count);
  mpq_class square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    mpq_class sum = 0;
    for (std::size_t i = 0; i < carrier.count; ++i)
      sum += mpq_class(c_.input.points[carrier.corners[i]][k]) -
             mpq_class(c_.surface.points[c_.vertices.first + v][k]);
    square += sum * sum;
  }
  return square <= limit * limit;
}

/// Do its corners, moved, span what the level does not meet? Those where there is no mode stay: on
/// each ray from these the mode is constant, so that the others decide.
bool Distances::is_clear(const MovedVertices& moved, std::size_t triangle) const {
  auto v = vertices_of(triangle);
  const auto end = std::remove_if(v.begin(), v.end(), [&](std::size_t i) { return is_apex(i); });
  for (const auto way : {MovedVertices::kBehind, MovedVertices::kAhead}) {
    const auto clear = [&]<std::size_t Count>(const std::array<std::size_t, Count>& at) {
      std::array<Corner, Count> corners;
      for (std::size_t i = 0; i < Count; ++i) corners[i] = moved.corner(at[i], way);
      if (c_.level.is_one_sided(corners)) return true;
      if constexpr (Count == 1) return false;
      else return Refinement(c_.level, corners).is_one_sided();
    };
    const bool is_clear = end == v.end()         ? clear(v)
                          : end == v.begin() + 2 ? clear(std::array{v[0], v[1]})
                          : end == v.begin() + 1 ? clear(std::array{v[0]})
                                                 : false;
    if (!is_clear) return false;
  }
  return true;
}

/// A crossing's vertex moves past no other crossing of its edge: as there are points of
/// different sides at its ends, it passes its own.
void Distances::prove_passed_crossings(const MovedVertices& moved) const {
  for (const Json& edge : c_.claims["edges"]) {
    for (std::size_t n = 2; n < edge.size() && edge.size() > 3; ++n) {
      for (std::size_t i = 2; i < edge[n].size(); ++i) {
        const std::size_t v = edge[n][i].get<Number>() - c_.vertices.first;
        if (v >= is_used_.size() || !is_used_[v]) continue;
        for (const auto way : {MovedVertices::kBehind, MovedVertices::kAhead}) {
          const auto& w = moved.weights(v, way);
          const mpq_class at = mpq_class(w[1]) / (mpq_class(w[0]) + mpq_class(w[1]));
          if ((n > 2 && at < interval_of(edge[n - 1]).end(1)) ||
              (n + 1 < edge.size() && at > interval_of(edge[n + 1]).end(0)))
            throw Unproved(vertex(v) + " moves past a crossing");
        }
      }
    }
  }
}

void Distances::prove() const {
  prove_coarse();
  const MovedVertices moved(c_, placed_, reach_);
  std::vector<char> is_near(placed_.carriers.size(), 1), clear(placed_.tets.size(), 1);
  parallel_for(is_near.size(), [&](std::size_t v) {
    is_near[v] = !is_used_[v] || (is_apex(v) ? is_amid_carrier(v)
                                             : moved.stays(v) && moved.is_within(v, bound_));
  });
  if (const auto far = std::find(is_near.begin(), is_near.end(), 0); far != is_near.end())
    throw Unproved(vertex(static_cast<std::size_t>(far - is_near.begin())) +
                   " moves out of its place or bound");
  // What does not close takes longest: not many of these are tried.
  constexpr std::size_t kTogether = 1024;
  for (std::size_t first = 0; first < clear.size(); first += kTogether) {
    if (c_.progress)
      c_.progress("distances", static_cast<double>(first) / static_cast<double>(clear.size()));
    parallel_for(std::min(kTogether, clear.size() - first), [&](std::size_t i) {
      if (is_asked(first + i)) clear[first + i] = is_clear(moved, first + i);
    });
    const auto missing = std::find(clear.begin(), clear.end(), 0);
    if (missing != clear.end())
      throw Unproved(std::to_string(std::count(missing, clear.end(), 0)) +
                     " triangles or more not shown to stay clear, the first" +
                     where(placed_.tets[static_cast<std::size_t>(missing - clear.begin())]));
  }
  prove_passed_crossings(moved);
  for (const auto& [tet, loops] : placed_.closed_sheets)
    if (!is_coarse_[tet] && !is_covered(c_, moved, tet, loops))
      throw Unproved("a sheet not shown to be covered" + where(tet));
}

}  // namespace

std::size_t count_bounded(const LevelCase& c, const PlacedSurface& placed) {
  std::set<std::size_t> coarse;
  for (const Json& cell : c.claims["distance"]["coarse"])
    coarse.insert(c.input.tet_at(cell.get<Number>()));
  return static_cast<std::size_t>(
      std::count_if(placed.tets.begin(), placed.tets.end(), [&](std::size_t tet) {
        return !c.left_out[tet] && !coarse.contains(tet);
      }));
}

bool compare_distance(const LevelCase& c, const PlacedSurface* placed, Ledger& ledger) {
  if (placed == nullptr) {
    ledger.leave_open("distance", "it rests on claims that are not certified");
    return false;
  }
  try {
    const Distances distances(c, *placed);
    distances.require_bounds();
    distances.prove();
    ledger.certify();
    return true;
  } catch (const Unproved& why) {
    ledger.leave_open("distance", why.what());
  } catch (const Wrong& wrong) {
    ledger.refute("distance", "within " + c.claims["distance"]["bound"].dump(), wrong.what());
  }
  return false;
}

}  // namespace certificate
