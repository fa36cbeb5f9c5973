// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/topology/regions/superlevel_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "extract/level/proofs/is_above.hpp"
#include "extract/level/proofs/tiers.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/subdivision/degenerate_offset.hpp"
#include "extract/topology/regions/arc_loops.hpp"
#include "extract/topology/regions/closed_curves.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::detail {

namespace {

/// Paths have 2^kDepth segments at most.
constexpr int kDepth = 9;

/// Steps of Newton's method towards the degenerate curve.
constexpr int kNewtonSteps = 4;

/// A walk along the curve: the longest and the shortest step, in weights of the tetrahedron, how
/// many there are at most, and how far outside the tetrahedron the curve may run. (Rounding puts a
/// curve in a plane of symmetry to either side of a face.)
constexpr double kLongestWalkStep = 1.0 / 16, kShortestWalkStep = 1e-6;
constexpr std::size_t kMostSteps = 600;
constexpr double kOutside = 1e-6;
constexpr int kDepthOfStep = 2;

/// Steps of Newton's method on a walk, each halved so often at most: where curves nearly cross it
/// has no direction to speak of.
constexpr int kCarefulSteps = 12, kHalvings = 6;

/// How often two walks are made denser where they come closest.
constexpr int kRounds = 12;

using Weights = std::array<double, 4>;

double sum(const Weights& w) { return std::accumulate(w.begin(), w.end(), 0.0); }

double dot(const Weights& u, const Weights& v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

Weights scaled_sum(const Weights& u, double factor, const Weights& v) {
  Weights w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = u[i] + factor * v[i];
  return w;
}

Weights normalized(Weights w) {
  const double total = sum(w);
  for (double& x : w) x /= total;
  return w;
}

/// Where the two other eigenvalues are the same, if their plane is given: two linear equations.
struct CurveEquations {
  Weights f, g;  ///< without their means, so that steps along them keep the sum of the weights
  double f0 = 0, g0 = 0;

  double square() const { return f0 * f0 + g0 * g0; }

  /// The shortest step to the solution, to be subtracted.
  std::optional<Weights> step() const {
    const double ff = dot(f, f), fg = dot(f, g), gg = dot(g, g);
    const double det = ff * gg - fg * fg;
    const double a = (gg * f0 - fg * g0) / det, b = (ff * g0 - fg * f0) / det;
    if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
    return scaled_sum(scaled_sum({}, a, f), b, g);
  }

  /// Along the curve, of length one: across f, g and the sum of the weights.
  std::optional<Weights> tangent() const {
    Weights t;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
      t[i] = (f[j] * (g[k] - g[l]) + f[k] * (g[l] - g[j]) + f[l] * (g[j] - g[k])) *
             (i % 2 == 0 ? 1 : -1);
    }
    const double length = std::sqrt(dot(t, t));
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    for (double& x : t) x /= length;
    return t;
  }
};

template <class Scalar>
class Paths {
 public:
  Paths(const LevelSimplex<Scalar, 4>& tet, const Level<Scalar>& level)
      : tet_(tet), level_(level), about_(rounded(tet.tensors)) {}

  struct Place {
    Weights weights;  ///< exact
    Deviator<Scalar> tensor;
  };

  Place at(const Weights& weights) const { return {weights, tensor_at(tet_.tensors, weights)}; }

  bool is_in_superlevel_set(const Place& p) const {
    return is_above(tet_, p.tensor, p.weights, level_) == (level_.sign > 0);
  }

  /// Whether there is a path, by way of the curve.
  bool join(const Place& from, const Place& to) const {
    const Place a = center(from.weights), b = center(to.weights);
    return is_in_superlevel_set(a) && is_in_superlevel_set(b) && reach(from, a, kDepth, false) &&
           reach(a, b, kDepth, true) && reach(b, to, kDepth, false);
  }

  /// Places along the curve next to one in the superlevel set, both ways to where it leaves the
  /// tetrahedron. From each to the next there is a path in the superlevel set, and to the place
  /// given.
  std::vector<Place> walk(const Place& from) const {
    Place start = from;
    if (const auto near = on_curve(from.weights)) {
      const Place p = at(*near);
      if (is_in_superlevel_set(p) && reach(from, p, kDepth, false)) start = p;
    }
    const auto along = equations(start.weights).tangent();
    std::vector<Place> line{start};
    if (!along) return line;
    walk_on(line, *along);
    std::reverse(line.begin(), line.end());
    walk_on(line, scaled_sum({}, -1, *along));
    return line;
  }

  /// Whether two walks are joined where they come closest, which are made denser there.
  bool meet(std::vector<Place> first, std::vector<Place> second) const {
    for (int round = 0; round < kRounds; ++round) {
      const auto [i, j] = closest(first, second);
      if (reach(first[i], second[j], kDepthOfStep, true)) return true;
      const std::size_t before = first.size() + second.size();
      make_denser(first, i);
      make_denser(second, j);
      if (first.size() + second.size() == before) return false;
    }
    return false;
  }

 private:
  /// Whether what is between two places in the superlevel set is beyond as well, or a path bent
  /// towards the curve.
  bool reach(const Place& from, const Place& to, int depth, bool bent) const {
    if (edge_is_simple<Scalar, 4>(tet_, {from.weights, to.weights}, {from.tensor, to.tensor},
                                  level_))
      return true;
    if (depth == 0) return false;
    const auto middle = between(from, to);
    const Place m = bent ? center(middle) : at(middle);
    return is_in_superlevel_set(m) && reach(from, m, depth - 1, bent) &&
           reach(m, to, depth - 1, bent);
  }

  static Weights between(const Place& from, const Place& to) {
    return scaled_sum(normalized(from.weights), 1, normalized(to.weights));
  }

  CurveEquations equations(const Weights& w) const {
    const auto e = simple_eigenvector(tensor_at(about_, w), level_.sign);
    const Vector3<double> axis =
        std::abs(e.x) < 0.6 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0};
    const auto u = unit(cross(e, axis)), v = cross(e, u);
    CurveEquations c;
    double f_mean = 0, g_mean = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto m = thrice(about_[i]);
      const auto mu = m * u, mv = m * v;
      c.f[i] = tensortopo::dot(u, mu) - tensortopo::dot(v, mv);
      c.g[i] = 2 * tensortopo::dot(u, mv);
      c.f0 += w[i] * c.f[i], c.g0 += w[i] * c.g[i];
      f_mean += c.f[i] / 4, g_mean += c.g[i] / 4;
    }
    for (std::size_t i = 0; i < 4; ++i) c.f[i] -= f_mean, c.g[i] -= g_mean;
    return c;
  }

  /// The point of the degenerate curve next to a place, about, or of the tetrahedron next to that.
  Place center(Weights w) const {
    for (int step = 0; step < kNewtonSteps; ++step) {
      w = normalized(w);
      const auto back = equations(w).step();
      if (!back) break;
      Weights next;
      for (std::size_t i = 0; i < 4; ++i) next[i] = std::max(0.0, w[i] - (*back)[i]);
      if (!(sum(next) > 0)) break;
      w = next;
    }
    return at(w);
  }

  /// The same with steps that come closer, and nothing if it is outside.
  std::optional<Weights> on_curve(const Weights& near) const {
    Weights w = normalized(near);
    auto here = equations(w);
    for (int step = 0; step < kCarefulSteps && here.square() > 0; ++step) {
      const auto back = here.step();
      if (!back) break;
      double part = 1;
      Weights next = scaled_sum(w, -part, *back);
      auto there = equations(next);
      for (int k = 0; k < kHalvings && !(there.square() < here.square()); ++k) {
        part /= 2;
        next = scaled_sum(w, -part, *back);
        there = equations(next);
      }
      if (!(there.square() < here.square())) break;
      w = next, here = there;
    }
    for (double& x : w) {
      if (!(x > -kOutside)) return std::nullopt;
      x = std::max(0.0, x);
    }
    return w;
  }

  /// From the last place of a line on, in a direction.
  void walk_on(std::vector<Place>& line, Weights along) const {
    double step = kLongestWalkStep;
    const std::size_t most = line.size() + kMostSteps;
    while (step > kShortestWalkStep && line.size() < most) {
      const Weights w = normalized(line.back().weights);
      const Weights guess = scaled_sum(w, step, along);
      const auto found = on_curve(guess);
      step /= 2;
      if (!found) continue;
      const Weights off = scaled_sum(*found, -1, guess);
      if (dot(off, off) > step * step) continue;
      const Place next = at(*found);
      if (!is_in_superlevel_set(next) || !reach(line.back(), next, kDepthOfStep, true)) continue;
      line.push_back(next);
      if (const auto tangent = equations(*found).tangent())
        along = scaled_sum({}, dot(*tangent, along) < 0 ? -1 : 1, *tangent);
      step = std::min(4 * step, kLongestWalkStep);
    }
  }

  static std::pair<std::size_t, std::size_t> closest(const std::vector<Place>& first,
                                                     const std::vector<Place>& second) {
    double least = HUGE_VAL;
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (std::size_t i = 0; i < first.size(); ++i)
      for (std::size_t j = 0; j < second.size(); ++j) {
        const auto off =
            scaled_sum(normalized(first[i].weights), -1, normalized(second[j].weights));
        if (const double square = dot(off, off); square < least) least = square, best = {i, j};
      }
    return best;
  }

  /// Places between one of a line and its neighbours.
  void make_denser(std::vector<Place>& line, std::size_t i) const {
    const auto add = [&](std::size_t k) {  // between k and k + 1
      const Place m = center(between(line[k], line[k + 1]));
      if (is_in_superlevel_set(m) && reach(line[k], m, kDepthOfStep, true))
        line.insert(line.begin() + static_cast<std::ptrdiff_t>(k) + 1, m);
    };
    if (i + 1 < line.size()) add(i);
    if (i > 0) add(i - 1);
  }

  const LevelSimplex<Scalar, 4>& tet_;
  const Level<Scalar>& level_;
  std::array<Deviator<double>, 4> about_;
};

/// A place in the superlevel set on a face, next to a loop.
template <class Scalar>
std::optional<Weights> place_next_to(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                     const BoundaryArc& piece) {
  const auto f = static_cast<std::size_t>(piece.face);
  const auto& v = tet.face_vertices[f];
  const auto place = superlevel_place(part_of_simplex<3>(tet.simplex, v),
                                      tet.arcs[f][static_cast<std::size_t>(piece.arc)], level);
  if (!place) return std::nullopt;
  Weights weights{};
  for (std::size_t i = 0; i < 3; ++i) weights[v[i]] = (*place)[i];
  return weights;
}

}  // namespace

template <class Scalar>
std::vector<int> loops_joined_in_superlevel_set(const TetWithCurves<Scalar>& tet,
                                                const Level<Scalar>& level,
                                                const BoundaryLoops& loops, int parts,
                                                Search search) {
  std::vector<int> part(loops.size());
  std::iota(part.begin(), part.end(), 0);
  auto left = static_cast<int>(loops.size());
  const auto unite = [&](std::size_t i, std::size_t j) {
    if (part[i] == part[j]) return;
    const int kept = std::min(part[i], part[j]), gone = std::max(part[i], part[j]);
    std::replace(part.begin(), part.end(), gone, kept);
    --left;
  };
  if (search == Search::everything)
    for (const auto& joined : arcs_between_loops(tet, level, loops))
      unite(as_size(joined.loops[0]), as_size(joined.loops[1]));
  const Paths<Scalar> paths(tet.simplex, level);
  std::vector<std::optional<Weights>> places(loops.size());
  if (left > parts)
    for (std::size_t i = 0; i < loops.size(); ++i)
      places[i] = place_next_to(tet, level, loops[i][0]);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = i + 1; j < loops.size() && left > parts; ++j) {
      if (!places[i] || !places[j] || part[i] == part[j]) continue;
      if (paths.join(paths.at(*places[i]), paths.at(*places[j]))) unite(i, j);
    }
  if (left == parts || search == Search::chords) return part;
  std::vector<std::vector<typename Paths<Scalar>::Place>> walks(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (places[i]) walks[i] = paths.walk(paths.at(*places[i]));
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = i + 1; j < loops.size() && left > parts; ++j)
      if (places[i] && places[j] && part[i] != part[j] && paths.meet(walks[i], walks[j]))
        unite(i, j);
  return part;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                      \
  template std::vector<int> loops_joined_in_superlevel_set( \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, const BoundaryLoops&, int, Search);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
