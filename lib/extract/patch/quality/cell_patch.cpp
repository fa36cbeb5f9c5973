// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/cell_patch.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/position.hpp"
#include "extract/patch/quality/least_sine.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

using Vector = Vector3<double>;

/// A vertex with more triangles does not move: fans that go from vertex to vertex would grow, and
/// each of their pairs of triangles is tested.
constexpr std::size_t kMostMoved = 16;

std::array<Vector, 4> times(double factor, std::array<Vector, 4> points) {
  for (auto& p : points) p = factor * p;
  return points;
}

template <class Triangle, class Corner>
bool has(const Triangle& t, Corner v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

}  // namespace

template <class Scalar>
CellPatch::CellPatch(const TetWithCurves<Scalar>& tet, const Level<double>& level,
                     const FaceArcVertices& boundaries, const Patch<Scalar>& patch)
    : tensors_(rounded(tet.simplex.tensors)),
      level_(&level),
      geometry_(times(unit_of(tet.points), tet.points), tet.simplex.exponents),
      length_(geometry_.longest_edge()),
      upward_(tet) {
  for (const auto& t : patch.triangles) ids_.insert(ids_.end(), t.begin(), t.end());
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  corners_.resize(ids_.size());
  const double unit = unit_of(tet.points);
  const auto points = times(unit, tet.points);
  places_.resize(ids_.size());
  for (std::size_t i = 0; i < ids_.size() && ids_[i] < 0; ++i)
    places_[i] = position_at(patch.inner[static_cast<std::size_t>(-1 - ids_[i])].weights,
                             tet.simplex.exponents, tet.points);
  for (std::size_t i = 0; i < ids_.size() && ids_[i] < 0; ++i)
    corners_[i].position = position_at(patch.inner[static_cast<std::size_t>(-1 - ids_[i])].weights,
                                       tet.simplex.exponents, points);
  for (const auto& face : boundaries)
    for (const auto& arc : face)
      for (const auto& vertex : arc.vertices) {
        const auto place = std::lower_bound(ids_.begin(), ids_.end(), vertex.id);
        if (place == ids_.end() || *place != vertex.id) continue;
        auto& corner = corners_[static_cast<std::size_t>(place - ids_.begin())];
        corner.position = unit * vertex.position;
        corner.faces = vertex.faces;
        places_[static_cast<std::size_t>(place - ids_.begin())] = vertex.position;
      }
  triangles_.reserve(patch.triangles.size());
  around_.resize(ids_.size() + 1);
  for (const auto& t : patch.triangles) {
    for (const Id id : t)
      around_[place_of(id)].push_back(static_cast<std::uint32_t>(triangles_.size()));
    triangles_.push_back({place_of(t[0]), place_of(t[1]), place_of(t[2])});
  }
  changed_.resize(triangles_.size(), 0);
  refusals_.resize(around_.size());
  lost_.resize(around_.size(), 0);
}

/// Of a vertex that no triangle here has: a place without triangles.
CellPatch::Place CellPatch::place_of(Id id) const {
  const auto place = std::lower_bound(ids_.begin(), ids_.end(), id);
  return static_cast<Place>((place != ids_.end() && *place == id ? place : ids_.end()) -
                            ids_.begin());
}

const Vector& CellPatch::up(Corner& corner) const {
  if (corner.up == Vector{}) {
    const auto at = level_slope(geometry_.tensor(corner.position, tensors_), *level_);
    const auto g = geometry_.gradient(at.slope, tensors_);
    corner.up = unit(g);
  }
  return corner.up;
}

double CellPatch::offset_at(const Vector& x) const {
  const auto at = level_slope(geometry_.tensor(x, tensors_), *level_);
  const auto g = geometry_.gradient(at.slope, tensors_);
  return std::abs(at.value) / (length(g) * length_);
}

Vector CellPatch::normal(const Triangle& t) const {
  const auto& p = corners_[t[0]].position;
  return cross(corners_[t[1]].position - p, corners_[t[2]].position - p);
}

double CellPatch::offset_of(const Triangle& t) const {
  const auto &p = corners_[t[0]].position, &q = corners_[t[1]].position,
             &r = corners_[t[2]].position;
  return std::max({offset_at(0.5 * (p + q)), offset_at(0.5 * (q + r)), offset_at(0.5 * (r + p)),
                   offset_at((1.0 / 3) * (p + q + r))});
}

double CellPatch::least_sine_around(Id vertex) const {
  double sine = 1;
  for (const auto i : around_[place_of(vertex)]) {
    const auto& t = triangles_[i];
    const auto n = normal(t);
    sine = std::min(sine, least_sine(corners_[t[0]].position, corners_[t[1]].position,
                                     corners_[t[2]].position, length(n)));
  }
  return sine;
}

double CellPatch::offset_around(Id vertex) const {
  double offset = 0;
  for (const auto i : around_[place_of(vertex)])
    offset = std::max(offset, offset_of(triangles_[i]));
  return offset;
}

double CellPatch::offset_after(Id vertex, Id neighbour) const {
  const Place v = place_of(vertex), u = place_of(neighbour);
  double offset = 0;
  for (const auto i : around_[v])
    if (Triangle t = triangles_[i]; !has(t, u)) {
      *std::find(t.begin(), t.end(), v) = u;
      offset = std::max(offset, offset_of(t));
    }
  return offset;
}

/// Contracting the edge between v and u leaves every sheet what it is if no vertex but the third
/// of their triangle is a neighbour of both, and that triangle is not all there is. No edge that is
/// new may lie in a face, but for the one that goes on along the curve.
bool CellPatch::keeps_sheets(Place v, Place u) const {
  thread_local std::vector<Place> near_v, near_u;
  near_v.clear(), near_u.clear();
  const auto add = [](std::vector<Place>& list, const Triangle& t, Place self) {
    for (const Place x : t)
      if (x != self) list.push_back(x);
  };
  std::size_t between = 0;
  const auto& star = around_[v];
  for (const auto i : star) {
    add(near_v, triangles_[i], v);
    between += has(triangles_[i], u);
  }
  if (between != 1) return false;
  for (const auto i : around_[u]) add(near_u, triangles_[i], u);
  std::sort(near_v.begin(), near_v.end());
  std::sort(near_u.begin(), near_u.end());
  const auto is_boundary_of = [](const std::vector<Place>& list, Place x) {
    return std::upper_bound(list.begin(), list.end(), x) -
               std::lower_bound(list.begin(), list.end(), x) ==
           1;
  };
  for (std::size_t i = 0; i < near_v.size(); ++i) {
    const Place x = near_v[i];
    if (x == u || (i > 0 && near_v[i - 1] == x)) continue;
    if (std::binary_search(near_u.begin(), near_u.end(), x)) {
      const bool is_third = std::any_of(star.begin(), star.end(), [&](std::uint32_t t) {
        return has(triangles_[t], u) && has(triangles_[t], x);
      });
      if (!is_third || (is_boundary_of(near_v, x) && is_boundary_of(near_u, x))) return false;
    } else if (!is_boundary_of(near_v, x) && (corners_[u].faces & corners_[x].faces) != 0) {
      return false;
    }
  }
  return true;
}

double CellPatch::least_sine_after(Id vertex, Id neighbour, double least, double least_cosine) {
  const Place v = place_of(vertex), u = place_of(neighbour);
  if (around_[v].size() > kMostMoved) return 0;
  double sine = 1;
  const auto changed = [&](const auto& look) {
    for (const auto i : around_[v]) {
      Triangle t = triangles_[i];
      if (has(t, u)) continue;
      *std::find(t.begin(), t.end(), v) = u;
      const auto n = normal(t);
      if (!look(t, n, length(n))) return false;
    }
    return true;
  };
  // The cheapest question first: most ways are no better.
  const bool is_better = changed([&](const Triangle& t, const Vector&, double length) {
    sine = std::min(sine, least_sine(corners_[t[0]].position, corners_[t[1]].position,
                                     corners_[t[2]].position, length));
    return sine > least;
  });
  if (!is_better || (!around_[v].empty() && !keeps_sheets(v, u))) return 0;
  const bool faces_up = changed([&](const Triangle& t, const Vector& n, double length) {
    return std::all_of(t.begin(), t.end(), [&](Place corner) {
      return dot(n, up(corners_[corner])) > least_cosine * length;
    });
  });
  return faces_up ? sine : 0;
}

CellPatch::Refusal* CellPatch::refusal_of(Place v, Place u) {
  auto& refusals = refusals_[v];
  const auto found = std::find_if(refusals.begin(), refusals.end(),
                                  [&](const Refusal& r) { return r.neighbour == u; });
  return found == refusals.end() ? nullptr : &*found;
}

bool CellPatch::is_still_refused(Place v, Place u) {
  const Refusal* refusal = refusal_of(v, u);
  if (refusal == nullptr) return false;
  return is_unchanged_around(v, refusal->turn) && (refusal->intersected == Refusal::kNone ||
                                                   changed_[refusal->intersected] <= refusal->turn);
}

void CellPatch::refuse(Place v, Place u, std::uint32_t intersected) {
  Refusal* old = refusal_of(v, u);
  Refusal& refusal = old != nullptr ? *old : refusals_[v].emplace_back();
  refusal = {u, intersected, turn_};
}

bool CellPatch::is_embedded_after(Id vertex, Id neighbour) {
  const Place v = place_of(vertex), u = place_of(neighbour);
  if (is_still_refused(v, u)) return false;
  thread_local std::vector<PatchTriangle> changed;
  changed.clear();
  const auto& star = around_[v];
  for (const auto i : star) {
    Triangle t = triangles_[i];
    if (has(t, u)) continue;
    *std::find(t.begin(), t.end(), v) = u;
    if (!upward_.facing(places_[t[0]], places_[t[1]], places_[t[2]]).is_upward) {
      refuse(v, u, Refusal::kNone);
      return false;
    }
    changed.push_back(t);
  }
  if (!extents_) extents_.emplace(places_, triangles_);
  std::size_t tested = 0;
  const auto found =
      extents_->find_intersection(places_, triangles_, {star.data(), star.size()}, changed, tested);
  if (!found) return true;
  refuse(v, u, *found < triangles_.size() ? static_cast<std::uint32_t>(*found) : Refusal::kNone);
  return false;
}

bool CellPatch::is_unchanged_around(Place v, std::uint32_t turn) const {
  return lost_[v] <= turn && std::all_of(around_[v].begin(), around_[v].end(),
                                         [&](std::uint32_t t) { return changed_[t] <= turn; });
}

bool CellPatch::is_unchanged_since(std::uint32_t turn, Id vertex,
                                   const std::array<Id, 2>& neighbours) const {
  const Place v = place_of(vertex);
  const auto& refusals = refusals_[v];
  return is_unchanged_around(v, turn) &&
         std::all_of(neighbours.begin(), neighbours.end(),
                     [&](Id u) { return is_unchanged_around(place_of(u), turn); }) &&
         std::all_of(refusals.begin(), refusals.end(), [&](const Refusal& r) {
           return r.intersected == Refusal::kNone || changed_[r.intersected] <= turn;
         });
}

Vector CellPatch::area_of(std::span<const Id> polygon) const {
  Vector area{}, last{};
  const auto& origin = corners_[place_of(polygon[0])].position;
  for (const Id id : polygon) {
    const auto next = corners_[place_of(id)].position - origin;
    area = area + cross(last, next);
    last = next;
  }
  return area;
}

void CellPatch::move(Id vertex, Id neighbour) {
  const Place v = place_of(vertex), u = place_of(neighbour);
  ++turn_;
  for (const auto i : around_[v]) {
    auto& t = triangles_[i];
    changed_[i] = turn_;
    if (!has(t, u)) {
      *std::find(t.begin(), t.end(), v) = u;
      if (extents_) extents_->set(i, places_, t);
      around_[u].push_back(i);
      continue;
    }
    for (const Place corner : t)
      if (corner != v) {
        auto& star = around_[corner];
        star.erase(std::remove(star.begin(), star.end(), i), star.end());
        lost_[corner] = turn_;
      }
    t = {};
  }
  around_[v].clear();
  std::sort(around_[u].begin(), around_[u].end());
}

std::vector<std::array<CellPatch::Id, 3>> CellPatch::triangles() const {
  std::vector<std::array<Id, 3>> result;
  result.reserve(triangles_.size());
  for (const auto& t : triangles_)
    if (t[0] != t[1]) result.push_back({ids_[t[0]], ids_[t[1]], ids_[t[2]]});
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                              \
  template CellPatch::CellPatch(const TetWithCurves<Scalar>&, const Level<double>&, \
                                const FaceArcVertices&, const Patch<Scalar>&);
TENSORTOPO_FOR_EACH_PRECISION(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
