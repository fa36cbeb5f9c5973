// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "beyond_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "arc_loops.hpp"
#include "closed_curves.hpp"
#include "degenerate_offset.hpp"
#include "extractor_scalars.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "tiers.hpp"

namespace tensortopo::detail {

namespace {

/// Paths have 2^kDepth segments at most.
constexpr int kDepth = 9;

/// Steps of Newton's method towards the degenerate curve.
constexpr int kNewtonSteps = 4;

using Weights = std::array<double, 4>;

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

  bool is_beyond(const Place& p) const {
    return is_above(tet_, p.tensor, p.weights, level_) == (level_.sign > 0);
  }

  /// Whether there is a path, by way of the curve.
  bool join(const Place& from, const Place& to) const {
    const Place a = center(from.weights), b = center(to.weights);
    return is_beyond(a) && is_beyond(b) && reach(from, a, kDepth, false) &&
           reach(a, b, kDepth, true) && reach(b, to, kDepth, false);
  }

 private:
  /// Whether what is between two places beyond the level is beyond as well, or a path bent towards
  /// the curve.
  bool reach(const Place& from, const Place& to, int depth, bool bent) const {
    if (edge_is_simple<Scalar, 4>(tet_, {from.weights, to.weights}, {from.tensor, to.tensor},
                                  level_))
      return true;
    if (depth == 0) return false;
    Weights middle;
    const double s = sum(from.weights), t = sum(to.weights);
    for (std::size_t i = 0; i < 4; ++i) middle[i] = from.weights[i] / s + to.weights[i] / t;
    const Place m = bent ? center(middle) : at(middle);
    return is_beyond(m) && reach(from, m, depth - 1, bent) && reach(m, to, depth - 1, bent);
  }

  static double sum(const Weights& w) { return std::accumulate(w.begin(), w.end(), 0.0); }

  /// The point of the degenerate curve next to a place, about, or of the tetrahedron next to that:
  /// where the two other eigenvalues are the same, two linear equations if their plane is given.
  Place center(Weights w) const {
    for (int step = 0; step < kNewtonSteps; ++step) {
      const double total = sum(w);
      for (double& x : w) x /= total;
      const auto e = simple_eigenvector(tensor_at(about_, w), level_.sign);
      const Vector3<double> axis =
          std::abs(e.x) < 0.6 ? Vector3<double>{1, 0, 0} : Vector3<double>{0, 1, 0};
      const auto u = unit(cross(e, axis)), v = cross(e, u);
      Weights f, g;
      double f0 = 0, g0 = 0, f_mean = 0, g_mean = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto m = thrice(about_[i]);
        const auto mu = m * u, mv = m * v;
        f[i] = dot(u, mu) - dot(v, mv);
        g[i] = 2 * dot(u, mv);
        f0 += w[i] * f[i], g0 += w[i] * g[i];
        f_mean += f[i] / 4, g_mean += g[i] / 4;
      }
      double ff = 0, fg = 0, gg = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        f[i] -= f_mean, g[i] -= g_mean;
        ff += f[i] * f[i], fg += f[i] * g[i], gg += g[i] * g[i];
      }
      const double det = ff * gg - fg * fg;
      const double a = (gg * f0 - fg * g0) / det, b = (ff * g0 - fg * f0) / det;
      if (!std::isfinite(a) || !std::isfinite(b)) break;
      Weights next;
      for (std::size_t i = 0; i < 4; ++i) next[i] = std::max(0.0, w[i] - a * f[i] - b * g[i]);
      if (!(sum(next) > 0)) break;
      w = next;
    }
    return at(w);
  }

  const LevelSimplex<Scalar, 4>& tet_;
  const Level<Scalar>& level_;
  std::array<Deviator<double>, 4> about_;
};

/// A place beyond the level on a face, next to a loop.
template <class Scalar>
std::optional<Weights> place_next_to(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                     const RimPiece& piece) {
  const auto f = static_cast<std::size_t>(piece.face);
  const auto& v = tet.face_vertices[f];
  const auto place = place_beyond(part_of_simplex<3>(tet.simplex, v),
                                  tet.arcs[f][static_cast<std::size_t>(piece.arc)], level);
  if (!place) return std::nullopt;
  Weights weights{};
  for (std::size_t i = 0; i < 3; ++i) weights[v[i]] = (*place)[i];
  return weights;
}

}  // namespace

template <class Scalar>
std::vector<int> loops_joined_beyond(const TetWithCurves<Scalar>& tet, const Level<Scalar>& level,
                                     const std::vector<std::vector<RimPiece>>& loops, int parts) {
  std::vector<int> part(loops.size());
  std::iota(part.begin(), part.end(), 0);
  auto left = static_cast<int>(loops.size());
  const auto unite = [&](std::size_t i, std::size_t j) {
    if (part[i] == part[j]) return;
    const int kept = std::min(part[i], part[j]), gone = std::max(part[i], part[j]);
    std::replace(part.begin(), part.end(), gone, kept);
    --left;
  };
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
  return part;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                    \
  template std::vector<int> loops_joined_beyond(          \
      const TetWithCurves<Scalar>&, const Level<Scalar>&, \
      const std::vector<std::vector<RimPiece>>&, int);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo::detail
