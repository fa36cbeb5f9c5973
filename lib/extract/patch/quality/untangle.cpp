// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/untangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "extract/level/position.hpp"
#include "tensortopo/scalar/power_of_two.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/patch/patch_extents.hpp"
#include "extract/patch/vertex_on_level.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

namespace {

/// How often all triangles that have defects are gone through.
constexpr int kMostRounds = 8;

/// Triangles tried for each triangle of the patch: where more are needed, mending hardly ever
/// succeeds. Boxes and triangles compared count as well, so many as one triangle.
constexpr std::size_t kTriedPerTriangle = 384, kComparedAsOne = 8;

/// Newton steps go on, four at a time, until they change no weight by more than rounding does.
constexpr int kMostAttempts = 8;
constexpr double kConverged = 0x1p-48;

/// A change that leaves as many defects makes the least cosine so much larger.
constexpr double kLessAgainst = 1.0 / 64;

template <class Scalar>
class Untangling {
 public:
  using Place = std::uint32_t;
  using Vector = Vector3<double>;

  Untangling(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
             std::span<const std::vector<BoundaryVertex>> boundaries, PlacedPatch placed,
             Patch<Scalar>& patch)
      : tet_(tet),
        level_(level),
        test_(tet),
        geometry_(tet.points, tet.simplex.exponents),
        placed_(std::move(placed)),
        extents_(placed_.points, placed_.triangles),
        patch_(patch),
        around_(placed_.ids.size()),
        faces_(placed_.ids.size(), 0),
        bad_(placed_.triangles.size(), 0),
        cosine_(placed_.triangles.size()),
        most_tried_(kTriedPerTriangle * placed_.triangles.size()) {
    for (std::uint32_t t = 0; t < placed_.triangles.size(); ++t) enter(t);
    for (const auto& loop : boundaries)
      for (const auto& vertex : loop) {
        const auto at = std::lower_bound(placed_.ids.begin(), placed_.ids.end(), vertex.id);
        if (at != placed_.ids.end() && *at == vertex.id)
          faces_[static_cast<std::size_t>(at - placed_.ids.begin())] = vertex.faces;
      }
  }

  bool run(const PatchDefects& defects) {
    for (const auto t : defects.against) bad_[t] = 1;
    for (const auto& pair : defects.intersecting)
      for (const auto t : pair) bad_[t] = 1;
    bool any = false;
    for (int round = 0; round < kMostRounds; ++round) {
      bool has_changed = false;
      for (std::uint32_t t = 0; t < placed_.triangles.size(); ++t)
        if (bad_[t] != 0 && !is_gone(t) && !is_spent()) has_changed |= mend(t);
      any |= has_changed;
      if (!has_changed) break;
    }
    if (any) write();
    return any;
  }

 private:
  bool is_spent() const { return tried_ >= most_tried_; }
  bool is_gone(std::uint32_t t) const { return placed_.triangles[t][0] == placed_.triangles[t][1]; }
  bool is_inner(Place v) const { return placed_.ids[v] < 0; }
  void enter(std::uint32_t t) {
    for (const Place v : placed_.triangles[t]) around_[v].push_back(t);
    cosine_[t] = facing(placed_.triangles[t]).cosine;
  }
  void take_out(std::uint32_t t) {
    for (const Place v : placed_.triangles[t]) std::erase(around_[v], t);
    placed_.triangles[t] = {};
    bad_[t] = 0;
  }
  static bool has(const PatchTriangle& t, Place v) { return t[0] == v || t[1] == v || t[2] == v; }
  bool is_edge(Place a, Place b) const {
    return std::any_of(around_[a].begin(), around_[a].end(),
                       [&](std::uint32_t t) { return has(placed_.triangles[t], b); });
  }
  /// The other triangle at an edge of one, if there is just one.
  std::optional<std::uint32_t> across(std::uint32_t t, Place a, Place b) const {
    std::optional<std::uint32_t> found;
    for (const std::uint32_t other : around_[a]) {
      if (other == t || !has(placed_.triangles[other], b)) continue;
      if (found) return std::nullopt;
      found = other;
    }
    return found;
  }

  /// Whether triangles in place of some others leave fewer defects, or as many that are less
  /// against the gradient, and none with the rest.
  bool is_better(std::span<const std::uint32_t> old, std::span<const PatchTriangle> fresh) {
    if (is_spent()) return false;
    std::ptrdiff_t before = 0, after = 0;
    tried_ += fresh.size();
    double worst_before = 1, worst_after = 1;
    for (const std::uint32_t t : old)
      before += bad_[t], worst_before = std::min(worst_before, cosine_[t]);
    for (const PatchTriangle& t : fresh) {
      const auto [is_upward, cosine] = facing(t);
      worst_after = std::min(worst_after, cosine);
      if (!is_upward && ++after > before) return false;
    }
    if (after == before && worst_after < worst_before + kLessAgainst) return false;
    std::size_t compared = placed_.triangles.size();
    const auto found =
        extents_.find_intersection(placed_.points, placed_.triangles, old, fresh, compared);
    tried_ += compared / kComparedAsOne;
    return !found;
  }
  UpwardTest::Facing facing(const PatchTriangle& t) const {
    const auto& p = placed_.points;
    return test_.facing(p[t[0]], p[t[1]], p[t[2]]);
  }

  void replace(std::vector<std::uint32_t> old, std::span<const PatchTriangle> fresh) {
    for (const std::uint32_t t : old) take_out(t);
    for (const PatchTriangle& triangle : fresh) {
      std::uint32_t t = static_cast<std::uint32_t>(placed_.triangles.size());
      if (old.empty()) {
        placed_.triangles.emplace_back(), bad_.push_back(0), cosine_.push_back(1);
      } else {
        t = old.back(), old.pop_back();
      }
      placed_.triangles[t] = triangle;
      bad_[t] = !facing(triangle).is_upward;
      extents_.set(t, placed_.points, triangle);
      enter(t);
    }
  }

  bool mend(std::uint32_t t) {
    const PatchTriangle corners = placed_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (flip(t, corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3])) return true;
    for (const Place v : corners)
      if (is_inner(v) && (move(v) || contract(v))) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (split(t, corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3])) return true;
    return move_around(corners);
  }

  /// Other places for the inner vertices around a triangle, which may make room for it.
  bool move_around(const PatchTriangle& corners) {
    std::vector<Place> around;
    for (const Place v : corners)
      for (const std::uint32_t t : around_[v])
        for (const Place w : placed_.triangles[t])
          if (is_inner(w) && std::find(around.begin(), around.end(), w) == around.end())
            around.push_back(w);
    bool any = false;
    for (const Place w : around) any |= move(w);
    return any;
  }

  /// The other diagonal in place of an edge from a to b.
  bool flip(std::uint32_t t, Place a, Place b, Place c) {
    const auto u = across(t, a, b);
    if (!u) return false;
    const Place d = third(*u, a, b);
    if (c == d || (faces_[c] & faces_[d]) != 0 || is_edge(c, d)) return false;
    const std::array<std::uint32_t, 2> old{t, *u};
    const std::array<PatchTriangle, 2> fresh{{{a, d, c}, {d, b, c}}};
    if (!is_better(old, fresh)) return false;
    return replace({t, *u}, fresh), true;
  }

  Place third(std::uint32_t t, Place a, Place b) const {
    for (const Place v : placed_.triangles[t])
      if (v != a && v != b) return v;
    return a;
  }

  std::vector<PatchTriangle> star(Place v) const {
    std::vector<PatchTriangle> result;
    for (const std::uint32_t t : around_[v]) result.push_back(placed_.triangles[t]);
    return result;
  }

  /// Places for a vertex among those of its triangles: their mean, half-way to it, and others.
  std::vector<Vector> places_amid(std::span<const PatchTriangle> triangles, Place v) const {
    const Vector x = placed_.points[v];
    std::vector<Place> link;
    for (const auto& t : triangles)
      for (const Place w : t)
        if (w != v && std::find(link.begin(), link.end(), w) == link.end()) link.push_back(w);
    Vector mean{};
    for (const Place w : link) mean += (1.0 / static_cast<double>(link.size())) * placed_.points[w];
    std::vector<Vector> result{mean, 0.5 * (x + mean)};
    for (const Place w : link)
      for (const double share : {0.5, 0.2}) {
        result.push_back(x + share * (placed_.points[w] - x));
        result.push_back(mean + share * (placed_.points[w] - mean));
      }
    return result;
  }

  /// The vertex of the level near a place.
  std::optional<InnerVertex<Scalar>> at(const Vector& x) const {
    const auto& exponents = tet_.simplex.exponents;
    const int least = *std::min_element(exponents.begin(), exponents.end());
    std::array<double, 4> weights;
    double total = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      weights[i] = times_power(geometry_.weight(i, x), least - exponents[i]);
      if (!(weights[i] > 0)) return std::nullopt;
      total += weights[i];
    }
    std::array<Scalar, 4> shares;
    for (std::size_t i = 0; i < 4; ++i) shares[i] = Scalar(weights[i] / total);
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
      const auto vertex = vertex_on_level(tet_, level_, shares);
      if (!vertex) return std::nullopt;
      double change = 0;
      for (std::size_t i = 0; i < 4; ++i)
        change = std::max(change, std::abs(static_cast<double>(vertex->weights[i] - shares[i])));
      if (change <= kConverged) return vertex;
      shares = vertex->weights;
    }
    return std::nullopt;
  }

  /// Looks for a place of a vertex at which its triangles are better than the old ones.
  bool put(Place v, std::span<const std::uint32_t> old, std::span<const PatchTriangle> fresh) {
    const Vector before = placed_.points[v];
    for (const Vector& x : places_amid(fresh, v)) {
      if (is_spent()) break;
      const auto vertex = at(x);
      if (!vertex) continue;
      const Vector place = position_at(vertex->weights, tet_.simplex.exponents, tet_.points);
      if (std::find(placed_.points.begin(), placed_.points.end(), place) != placed_.points.end())
        continue;
      placed_.points[v] = place;
      if (!is_better(old, fresh)) continue;
      patch_.inner[static_cast<std::size_t>(-1 - placed_.ids[v])] = *vertex;
      return true;
    }
    placed_.points[v] = before;
    return false;
  }

  bool move(Place v) {
    const auto old = around_[v];
    const auto fresh = star(v);
    if (!put(v, old, fresh)) return false;
    return replace(old, fresh), true;
  }

  /// An inner vertex goes to a neighbour. That keeps the sheet if only two vertices are neighbours
  /// of both.
  bool contract(Place v) {
    const auto old = around_[v];
    std::vector<Place> link;
    for (const std::uint32_t t : old)
      for (const Place w : placed_.triangles[t])
        if (w != v && std::find(link.begin(), link.end(), w) == link.end()) link.push_back(w);
    if (link.size() < 4) return false;
    for (const Place u : link) {
      std::size_t common = 0;
      bool meets_face = false;
      for (const Place w : link) {
        if (w == u) continue;
        const bool is_neighbour = is_edge(u, w);
        common += is_neighbour;
        meets_face |= !is_neighbour && (faces_[u] & faces_[w]) != 0;
      }
      if (common != 2 || meets_face) continue;
      std::vector<PatchTriangle> fresh;
      for (PatchTriangle t : star(v)) {
        if (has(t, u)) continue;
        *std::find(t.begin(), t.end(), v) = u;
        fresh.push_back(t);
      }
      if (!is_better(old, fresh)) continue;
      return replace(old, fresh), true;
    }
    return false;
  }

  /// A vertex amid the edge from a to b.
  bool split(std::uint32_t t, Place a, Place b, Place c) {
    const auto u = across(t, a, b);
    if (!u) return false;
    const Place d = third(*u, a, b), m = static_cast<Place>(placed_.ids.size());
    patch_.inner.emplace_back();
    placed_.ids.push_back(-static_cast<std::int32_t>(patch_.inner.size()));
    placed_.points.push_back(0.5 * (placed_.points[a] + placed_.points[b]));
    around_.emplace_back(), faces_.push_back(0);
    const std::array<std::uint32_t, 2> old{t, *u};
    const std::array<PatchTriangle, 4> fresh{{{a, m, c}, {m, b, c}, {b, m, d}, {m, a, d}}};
    if (put(m, old, fresh)) return replace({t, *u}, fresh), true;
    patch_.inner.pop_back(), placed_.ids.pop_back(), placed_.points.pop_back();
    around_.pop_back(), faces_.pop_back();
    return false;
  }

  void write() {
    patch_.triangles.clear();
    for (std::uint32_t t = 0; t < placed_.triangles.size(); ++t) {
      if (is_gone(t)) continue;
      const auto& [a, b, c] = placed_.triangles[t];
      patch_.triangles.push_back({placed_.ids[a], placed_.ids[b], placed_.ids[c]});
    }
    drop_unused_inner(patch_);
  }

  const TetWithCurves<Scalar>& tet_;
  const Level<Scalar>& level_;
  UpwardTest test_;
  TetGeometry geometry_;
  PlacedPatch placed_;  ///< a triangle with one corner three times is gone
  PatchExtents extents_;
  Patch<Scalar>& patch_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< the triangles of each vertex
  std::vector<std::uint8_t> faces_;                 ///< of the tetrahedron, that hold each vertex
  std::vector<char> bad_;                           ///< triangles with defects
  std::vector<double> cosine_;                      ///< of triangles, with the gradient
  std::size_t tried_ = 0, most_tried_;
};

}  // namespace

template <class Scalar>
bool untangle(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
              std::span<const std::vector<BoundaryVertex>> boundaries, PlacedPatch placed,
              const PatchDefects& defects, Patch<Scalar>& patch) {
  return Untangling<Scalar>(tet, level, boundaries, std::move(placed), patch).run(defects);
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                              \
  template bool untangle(const TetWithCurves<Scalar>&, const Level<Scalar>&,        \
                         std::span<const std::vector<BoundaryVertex>>, PlacedPatch, \
                         const PatchDefects&, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
