// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "members.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo::test {

namespace {

using Tensor = SymmetricTensor<double>;

Tensor without_trace(const Tensor& t) {
  const double mean = trace(t) / 3;
  return {t.xx - mean, t.yy - mean, t.zz - mean, t.xy, t.yz, t.xz};
}

double norm(const Tensor& t) { return std::sqrt(inner(t, t)); }

/// Inside the ball for certain.
constexpr double kWithin = 1 - 0x1p-40;

Tensor random_direction(Random& random) {
  // Entries off the diagonal count twice.
  const auto t = random.tensor();
  const double h = std::sqrt(0.5);
  const Tensor d = without_trace({t.xx, t.yy, t.zz, h * t.xy, h * t.yz, h * t.xz});
  return (1 / norm(d)) * d;
}

/// Gradient of the mode, up to a positive factor, of a tensor of mode mu.
Tensor gradient(const Tensor& t, double mu) {
  return without_trace(square(t)) - (mu / std::sqrt(6.0) * norm(t)) * t;
}

struct Candidate {
  double needed;  ///< largest change of a vertex, as a share of its radius
  Tensor normal;
};

using Weights = std::array<double, 4>;

/// Of a place in a simplex on some corners.
using Judge = std::function<Candidate(const Weights&, unsigned corners)>;

struct Corners {
  std::array<Tensor, 4> tensors;
  std::array<double, 4> radii;

  Tensor at(const Weights& x) const {
    Tensor t{};
    for (std::size_t i = 0; i < 4; ++i) t = t + x[i] * tensors[i];
    return t;
  }
  /// Largest change along a unit tensor, as a share of the radius, until all are orthogonal to it.
  double needed(const Tensor& normal, unsigned corners) const {
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (corners >> i & 1)
        largest = std::max(largest, std::abs(inner(normal, tensors[i])) / (radii[i] + 1e-300));
    return largest;
  }
};

Candidate judge_level(const Corners& box, const Weights& x, unsigned corners, double mu) {
  Tensor normal = gradient(box.at(x), mu);
  const double size = norm(normal);
  if (!(size > 0)) return {1e9, normal};
  normal = (1 / size) * normal;
  return {box.needed(normal, corners), normal};
}

Candidate judge_curves(const Corners& box, const Weights& x, unsigned corners, Degeneracy kind) {
  const auto eigen = eigen_decomposition((kind == Degeneracy::planar ? -1.0 : 1.0) * box.at(x));
  const Vector3<double>&p = eigen.vectors[1], &q = eigen.vectors[2];
  const auto product = [](const Vector3<double>& a, const Vector3<double>& b) {
    return Tensor{a.x * b.x,
                  a.y * b.y,
                  a.z * b.z,
                  (a.x * b.y + a.y * b.x) / 2,
                  (a.y * b.z + a.z * b.y) / 2,
                  (a.x * b.z + a.z * b.x) / 2};
  };
  const double root = std::sqrt(0.5);
  const Tensor first = root * (product(p, p) - product(q, q)), second = (2 * root) * product(p, q);
  double radius = 1e-300;
  for (std::size_t i = 0; i < 4; ++i) radius += x[i] * box.radii[i];
  const double away = root * (eigen.values[1] - eigen.values[2]) / radius;
  if (std::popcount(corners) < 3) return {away, first};
  Candidate best{1e9, first};
  constexpr int kAngles = 24;
  for (int k = 0; k < kAngles; ++k) {
    const double angle = k * std::numbers::pi / kAngles;
    const Tensor normal = std::cos(angle) * first + std::sin(angle) * second;
    const double needed = std::max(away, box.needed(normal, corners));
    if (needed < best.needed) best = {needed, normal};
  }
  return best;
}

/// All places of a lattice in the simplex on some corners, then those around the best.
std::vector<Candidate> likely_places(const Judge& judge, unsigned corners, std::size_t count) {
  const auto candidate = [&](const Weights& x) { return judge(x, corners); };
  std::vector<std::pair<Candidate, Weights>> all;
  constexpr int kSteps = 10;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j)
      for (int k = 0; i + j + k <= kSteps; ++k) {
        const std::array<int, 4> w{i, j, k, kSteps - i - j - k};
        bool inside = true;
        for (std::size_t c = 0; c < 4; ++c) inside &= (corners >> c & 1) || w[c] == 0;
        if (!inside) continue;
        Weights x;
        for (std::size_t c = 0; c < 4; ++c) x[c] = static_cast<double>(w[c]) / kSteps;
        all.emplace_back(candidate(x), x);
      }
  const auto less = [](const auto& a, const auto& b) { return a.first.needed < b.first.needed; };
  std::sort(all.begin(), all.end(), less);
  if (all.size() > count) all.resize(count);
  Random random(1);
  std::vector<Candidate> result;
  for (auto& [best, x] : all) {
    for (double size = 1.0 / kSteps; size > 1e-4; size *= 0.93) {
      Weights y = x;
      double sum = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        if (corners >> c & 1) y[c] = std::max(0.0, y[c] + size * (2 * random.uniform() - 1));
        sum += y[c];
      }
      if (!(sum > 0)) continue;
      for (double& w : y) w /= sum;
      if (const Candidate other = candidate(y); other.needed < best.needed) best = other, x = y;
    }
    result.push_back(best);
  }
  return result;
}

}  // namespace

TetMesh random_member(const TetMesh& mesh, std::span<const double> radii, Random& random) {
  TetMesh member = mesh;
  for (std::size_t v = 0; v < mesh.tensors.size(); ++v) {
    const double share = random.integer(0, 1) == 0 ? 1.0 : random.uniform();
    member.tensors[v] = mesh.tensors[v] + (share * kWithin * radii[v]) * random_direction(random);
  }
  return member;
}

namespace {

Corners corners_of(const TetMesh& mesh, std::size_t tet, std::span<const double> radii) {
  Corners box;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto v = as_size(mesh.tets[tet][i]);
    box.tensors[i] = without_trace(mesh.tensors[v]);
    box.radii[i] = radii[v];
  }
  return box;
}

std::vector<TetMesh> moved_along_normals(const TetMesh& mesh, std::size_t tet, const Corners& box,
                                         const Judge& judge, std::size_t places) {
  std::vector<TetMesh> members;
  for (unsigned corners = 1; corners < 16; ++corners)
    for (const Candidate& place : likely_places(judge, corners, places))
      for (unsigned signs = 0; signs < 16; ++signs) {
        if ((signs & ~corners) != 0) continue;
        TetMesh member = mesh;
        for (std::size_t i = 0; i < 4; ++i) {
          if (!(corners >> i & 1)) continue;
          const auto v = as_size(mesh.tets[tet][i]);
          const double by = (signs >> i & 1 ? kWithin : -kWithin) * box.radii[i];
          member.tensors[v] = member.tensors[v] + by * place.normal;
        }
        members.push_back(std::move(member));
      }
  return members;
}

}  // namespace

std::vector<TetMesh> members_that_may_differ(const TetMesh& mesh, std::size_t tet,
                                             std::span<const double> radii, double mu,
                                             std::size_t places) {
  const Corners box = corners_of(mesh, tet, radii);
  return moved_along_normals(
      mesh, tet, box,
      [&](const Weights& x, unsigned corners) { return judge_level(box, x, corners, mu); }, places);
}

std::vector<TetMesh> members_that_may_differ(const TetMesh& mesh, std::size_t tet,
                                             std::span<const double> radii, Degeneracy kind,
                                             std::size_t places) {
  const Corners box = corners_of(mesh, tet, radii);
  return moved_along_normals(
      mesh, tet, box,
      [&](const Weights& x, unsigned corners) { return judge_curves(box, x, corners, kind); },
      places);
}

}  // namespace tensortopo::test
