// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "ascent.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo::persistence {
namespace {

constexpr int kMostSteps = 600;
constexpr std::size_t kMostTries = 8;  // of moves from one place

TetWeights between(const TetWeights& from, const TetWeights& to, double x) {
  TetWeights weights;
  for (std::size_t i = 0; i < 4; ++i) weights[i] = (1 - x) * from[i] + x * to[i];
  return weights;
}

/// Of sum about 1, by a power of two.
TetWeights of_size_one(TetWeights weights) {
  const double sum = weights[0] + weights[1] + weights[2] + weights[3];
  const double factor = std::ldexp(1.0, -std::ilogb(sum));
  for (double& w : weights) w *= factor;
  return weights;
}

TetWeights corner(std::size_t i) {
  TetWeights weights{};
  weights[i] = 1;
  return weights;
}

/// The gradient of the mode, without what leads out of the tetrahedron.
TetWeights steepest(const Deviators& corners, const Deviator<double>& t, const TetWeights& here,
                    const std::array<bool, 4>& used) {
  TetWeights rise{};
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (used[i]) sum += rise[i] = derivative(t, corners[i]), ++count;
  for (std::size_t i = 0; i < 4; ++i) {
    if (used[i]) rise[i] -= sum / count;
    if (here[i] == 0) rise[i] = std::max(rise[i], 0.0);
  }
  return rise;
}

/// Where a direction leaves the tetrahedron.
void add_target(std::vector<TetWeights>& targets, const TetWeights& here,
                const TetWeights& direction) {
  double most = HUGE_VAL;
  for (std::size_t i = 0; i < 4; ++i)
    if (direction[i] < 0) most = std::min(most, here[i] / -direction[i]);
  if (!std::isfinite(most) || !(most > 0)) return;
  TetWeights end;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_first = direction[i] < 0 && here[i] / -direction[i] <= most;
    end[i] = is_first ? 0 : std::max(0.0, here[i] + most * direction[i]);
  }
  targets.push_back(end);
}

}  // namespace

std::vector<TetMesh::Index> Ascent::star_of(const TetPlace& place) const {
  std::array<Index, 4> carrier{-1, -1, -1, -1};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (place.weights[i] > 0) carrier[n++] = mesh_.tets[as_size(place.tet)][i];
  return stars_.around(carrier);
}

TetPlace Ascent::seen_from(const TetPlace& place, Index tet) const {
  TetPlace seen{tet, {}};
  for (std::size_t i = 0; i < 4; ++i)
    if (place.weights[i] > 0)
      seen.weights[corner_of(mesh_, tet, mesh_.tets[as_size(place.tet)][i])] = place.weights[i];
  return seen;
}

bool Ascent::is_above(Index tet, const TetWeights& from, const TetWeights& to, double level) const {
  const auto tensors = tensors_of(mesh_, tet);
  return is_mode_above(deviator_box(tensors, from), deviator_box(tensors, to), level);
}

Ascent::Reached Ascent::maximum_in_sight(const TetPlace& place, const std::vector<Index>& star,
                                         double level) const {
  const double most = elementary::acos(std::clamp(level, -1.0, 1.0)) / 3;
  for (const Index tet : star) {
    const auto marks = landmarks_.in(tet);
    if (marks.empty()) continue;
    const auto corners = deviators_of(mesh_, tet);
    const auto tensors = tensors_of(mesh_, tet);
    const TetWeights here = of_size_one(seen_from(place, tet).weights);
    const auto box = deviator_box(tensors, here);
    for (const Landmark& mark : marks) {
      const TetWeights there = of_size_one(mark.weights);
      const auto is_clear = [&](double x) {
        return angle_of(combine(corners, between(here, there, x))) < most;
      };
      if (is_clear(1) && is_clear(0.5) && is_clear(0.25) && is_clear(0.75) &&
          is_mode_above(box, mark.deviator, level) &&
          is_mode_above(mark.deviator, mark.deviator, level))
        return {{}, mark.maximum};
    }
  }
  return {};
}

Ascent::Reached Ascent::vertex_in_sight(const TetPlace& place, const std::vector<Index>& star,
                                        double level) const {
  struct Seen {
    double angle;
    Index vertex, tet;
  };
  std::vector<Seen> seen;
  for (const Index tet : star) {
    const auto corners = deviators_of(mesh_, tet);
    for (std::size_t i = 0; i < 4; ++i)
      seen.push_back({angle_of(corners[i]), mesh_.tets[as_size(tet)][i], tet});
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
    return std::tie(a.angle, a.vertex, a.tet) < std::tie(b.angle, b.vertex, b.tet);
  });
  const double most = elementary::acos(std::clamp(level, -1.0, 1.0)) / 3;
  std::size_t tries = 0;
  for (std::size_t i = 0; i < seen.size() && tries < kMostTries; ++i) {
    if (i > 0 && seen[i].vertex == seen[i - 1].vertex) continue;
    if (!(seen[i].angle < most)) break;
    ++tries;
    const auto here = seen_from(place, seen[i].tet);
    if (is_above(here.tet, here.weights, corner(corner_of(mesh_, here.tet, seen[i].vertex)), level))
      return {seen[i].vertex, {}};
  }
  return {};
}

std::vector<Ascent::Move> Ascent::moves(const TetPlace& place, const std::vector<Index>& star,
                                        double level) const {
  constexpr int kHalvings = 24;
  constexpr double kClose = 1e-2;  // of weights whose sum is about 1
  const double most = elementary::acos(std::clamp(level, -1.0, 1.0)) / 3;
  std::vector<Move> found;
  for (const Index tet : star) {
    const auto corners = deviators_of(mesh_, tet);
    const TetWeights here = of_size_one(seen_from(place, tet).weights);
    const double now = angle_of(combine(corners, here));
    std::vector<TetWeights> targets;
    for (std::size_t i = 0; i < 4; ++i) targets.push_back(corner(i));
    for (const Landmark& mark : landmarks_.in(tet)) targets.push_back(of_size_one(mark.weights));
    // Along the gradient and along crests: in all of the tetrahedron, in what holds the place, and
    // in a face or an edge close by.
    const auto add_uphill = [&](const TetWeights& from, bool is_whole) {
      std::array<bool, 4> used;
      for (std::size_t i = 0; i < 4; ++i) used[i] = is_whole || from[i] > 0;
      add_target(targets, from, steepest(corners, combine(corners, from), from, used));
      const TetWeights newton = newton_direction(corners, from, used);
      TetWeights end;
      for (std::size_t i = 0; i < 4; ++i) end[i] = from[i] + newton[i];
      if (std::all_of(end.begin(), end.end(), [](double w) { return w >= 0; }))
        targets.push_back(end);
      add_target(targets, from, newton);
    };
    add_uphill(here, true);
    add_uphill(here, false);
    TetWeights near = here;
    for (std::size_t i = 0; i < 4; ++i)
      if (near[i] < kClose) near[i] = 0;
    if (near != here) add_uphill(near, false);
    for (const TetWeights& target : targets) {
      // As far as samples stay above the level.
      Move best{now, {}};
      double x = std::ldexp(1.0, -kHalvings);
      for (int i = 0; i <= kHalvings; ++i, x *= 2) {
        const TetWeights there = x == 1 ? target : between(here, target, x);
        const double angle = angle_of(combine(corners, there));
        if (angle >= most) break;
        if (angle < best.angle) best = {angle, {tet, there}};
      }
      if (best.to.tet >= 0) found.push_back(best);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Move& a, const Move& b) { return a.angle < b.angle; });
  return found;
}

/// Ends at the last place where it reaches nothing.
Ascent::Reached Ascent::climb(TetPlace& place, double level) const {
  for (int step = 0; step < kMostSteps; ++step) {
    const auto star = star_of(place);
    if (auto reached = maximum_in_sight(place, star, level)) return reached;
    if (auto reached = vertex_in_sight(place, star, level)) return reached;
    bool has_moved = false;
    const auto possible = moves(place, star, level);
    for (std::size_t i = 0; i < possible.size() && i < kMostTries && !has_moved; ++i) {
      const TetPlace here = seen_from(place, possible[i].to.tet);
      if (!is_above(here.tet, here.weights, possible[i].to.weights, level)) continue;
      place = possible[i].to;
      has_moved = true;
    }
    if (!has_moved) return {};
  }
  return {};
}

/// Where climbing ends beside a crest, or along one that is about as high everywhere: goes through
/// the maxima of edges and faces. By what `TouchedMaxima` says, the largest mode that a component
/// has in a tetrahedron is at one of these unless it is at a vertex or on a curve.
std::optional<std::size_t> Ascent::walk(const TetPlace& start, double level) {
  constexpr std::size_t kMostPlaces = 300;
  std::vector<TetPlace> places{start};
  std::set<SimplexMaxima::Simplex> seen;
  for (std::size_t i = 0; i < places.size() && i < kMostPlaces; ++i) {
    const auto star = star_of(places[i]);
    if (const auto reached = maximum_in_sight(places[i], star, level)) return reached.maximum;
    if (const auto reached = vertex_in_sight(places[i], star, level))
      if (const auto maximum = from_vertex(*reached.vertex)) return maximum;
    for (const Index tet : star) {
      const TetPlace here = seen_from(places[i], tet);
      for (const auto& simplex : simplices_of(mesh_, tet)) {
        if (seen.contains(simplex)) continue;
        for (const SimplexMaximum& maximum : along_.along(simplex)) {
          if (!(maximum.bound.high > level)) continue;
          TetPlace there{tet, {}};
          for (std::size_t k = 0; k < 4; ++k)
            if (maximum.weights[k] > 0)
              there.weights[corner_of(mesh_, tet, simplex[k])] = maximum.weights[k];
          if (!is_above(tet, here.weights, there.weights, level)) continue;
          seen.insert(simplex);
          places.push_back(there);
        }
      }
    }
  }
  return std::nullopt;
}

Ascent::Reached Ascent::step_from_vertex(Index vertex) {
  const auto star = stars_.of(vertex);
  if (star.empty()) return {};
  struct Way {
    double angle;
    Index tet;
    std::size_t to;
  };
  std::vector<Way> ways;
  for (const Index tet : star) {
    const auto corners = deviators_of(mesh_, tet);
    const auto from = corner_of(mesh_, tet, vertex);
    for (std::size_t i = 0; i < 4; ++i)
      if (i != from && derivative(corners[from], corners[i]) > 0)
        ways.push_back({angle_of(corners[i]), tet, i});
  }
  std::sort(ways.begin(), ways.end(), [&](const Way& a, const Way& b) {
    const Index v = mesh_.tets[as_size(a.tet)][a.to], w = mesh_.tets[as_size(b.tet)][b.to];
    return std::tie(a.angle, v, a.tet) < std::tie(b.angle, w, b.tet);
  });
  std::vector<std::pair<TetPlace, double>> places;
  Index last = -1;
  for (const Way& way : ways) {
    const Index w = mesh_.tets[as_size(way.tet)][way.to];
    if (w == last) continue;
    last = w;
    const auto tensors = tensors_of(mesh_, way.tet);
    Departure departure;
    departure.weights = corner(corner_of(mesh_, way.tet, vertex));
    departure.towards = corner(way.to);
    departure.deviator = deviator_box(tensors, departure.weights);
    const double level = mode_range(departure.deviator)[1];
    const auto weights = rise_from(tensors, departure, level);
    if (!weights) continue;
    if (*weights == departure.towards) return {w, {}};
    places.push_back({{way.tet, *weights}, level});
  }
  if (places.size() > kMostTries) places.resize(kMostTries);
  for (auto& [place, level] : places)
    if (auto reached = climb(place, level)) return reached;
  for (const auto& [place, level] : places)
    if (const auto maximum = walk(place, level)) return {{}, maximum};
  return {};
}

std::optional<std::size_t> Ascent::from_vertex(Index vertex) {
  std::vector<Index> path;
  std::optional<std::size_t> maximum;
  for (;;) {
    if (const auto found = known_.find(vertex); found != known_.end()) {
      maximum = found->second;
      break;
    }
    path.push_back(vertex);
    const Reached next = step_from_vertex(vertex);
    if (!next.vertex) {
      maximum = next.maximum;
      break;
    }
    vertex = *next.vertex;
  }
  for (const Index v : path) known_[v] = maximum;
  return maximum;
}

std::optional<std::size_t> Ascent::finish(const Reached& reached) {
  return reached.vertex ? from_vertex(*reached.vertex) : reached.maximum;
}

std::optional<std::size_t> Ascent::from_place(const TetPlace& place, double level) {
  TetPlace end = place;
  if (const auto reached = climb(end, level))
    if (const auto maximum = finish(reached)) return maximum;
  return walk(end, level);
}

std::optional<std::size_t> Ascent::leave(const TetDeparture& way, double level) {
  const auto weights = rise_from(tensors_of(mesh_, way.tet), way.departure, level);
  if (!weights) return std::nullopt;
  return from_place({way.tet, *weights}, level);
}

}  // namespace tensortopo::persistence
