// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "members.hpp"

#include <algorithm>
#include <cmath>

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

/// All places of a lattice in the simplex on some corners, then those around the best.
std::vector<Candidate> likely_places(const std::array<Tensor, 4>& tensors,
                                     const std::array<double, 4>& radii, unsigned corners,
                                     double mu, std::size_t count) {
  using Weights = std::array<double, 4>;
  const auto candidate = [&](const Weights& x) {
    Tensor t{};
    for (std::size_t i = 0; i < 4; ++i) t = t + x[i] * tensors[i];
    Tensor normal = gradient(t, mu);
    const double size = norm(normal);
    Candidate result{size > 0 ? 0.0 : 1e9, normal};
    if (size > 0) result.normal = (1 / size) * normal;
    for (std::size_t i = 0; i < 4; ++i)
      if (corners >> i & 1)
        result.needed = std::max(result.needed,
                                 std::abs(inner(result.normal, tensors[i])) / (radii[i] + 1e-300));
    return result;
  };
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

std::vector<TetMesh> members_that_may_differ(const TetMesh& mesh, std::size_t tet,
                                             std::span<const double> radii, double mu,
                                             std::size_t places) {
  std::array<Tensor, 4> tensors;
  std::array<double, 4> own_radii;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto v = as_size(mesh.tets[tet][i]);
    tensors[i] = without_trace(mesh.tensors[v]);
    own_radii[i] = radii[v];
  }
  std::vector<TetMesh> members;
  for (unsigned corners = 1; corners < 16; ++corners)
    for (const Candidate& place : likely_places(tensors, own_radii, corners, mu, places))
      for (unsigned signs = 0; signs < 16; ++signs) {
        if ((signs & ~corners) != 0) continue;
        TetMesh member = mesh;
        for (std::size_t i = 0; i < 4; ++i) {
          if (!(corners >> i & 1)) continue;
          const auto v = as_size(mesh.tets[tet][i]);
          const double by = (signs >> i & 1 ? kWithin : -kWithin) * own_radii[i];
          member.tensors[v] = member.tensors[v] + by * place.normal;
        }
        members.push_back(std::move(member));
      }
  return members;
}

}  // namespace tensortopo::test
