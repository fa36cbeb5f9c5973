// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/reference_points.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "extract/level/exact_side.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo {

namespace {

using Integer = boost::multiprecision::mpz_int;

constexpr int kPlaceBits = 120, kStepBits = 108, kDirectionBits = 30, kDigits = 36;

// The simplex of a vertex: corners, and tensors scaled by one power of two.
struct Cell {
  std::vector<Vector3<double>> points;
  std::vector<SymmetricTensor<double>> tensors;
  double diameter = 0;
};

Cell cell_of(const TetMesh& mesh, const std::array<TetMesh::Index, 4>& vertices) {
  Cell cell;
  for (const auto v : vertices) {
    if (v < 0) break;
    cell.points.push_back(mesh.points[as_size(v)]);
    cell.tensors.push_back(mesh.tensors[as_size(v)]);
  }
  for (const auto& p : cell.points)
    for (const auto& q : cell.points) cell.diameter = std::max(cell.diameter, dot(p - q, p - q));
  cell.diameter = std::sqrt(cell.diameter);
  return cell;
}

// Barycentric coordinates of the point of the simplex nearest to p: Cramer's rule on the normal
// equations.
std::optional<std::vector<Real50>> barycentric(const Cell& cell, const Vector3<double>& p) {
  const std::size_t n = cell.points.size() - 1;
  std::array<std::array<Real50, 4>, 3> m{};  // the last column is the right-hand side
  const Vector3<Real50> origin = vector_cast<Real50>(cell.points[0]),
                        to = vector_cast<Real50>(p) - origin;
  for (std::size_t i = 0; i < n; ++i) {
    const auto u = vector_cast<Real50>(cell.points[i + 1]) - origin;
    for (std::size_t j = 0; j < n; ++j)
      m[i][j] = dot(u, vector_cast<Real50>(cell.points[j + 1]) - origin);
    m[i][3] = dot(u, to);
  }
  // Elimination: the matrix is positive definite, no pivoting.
  for (std::size_t k = 0; k < n; ++k) {
    if (!(m[k][k] > 0)) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Real50 factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] = m[i][j] - factor * m[k][j];
    }
  }
  std::vector<Real50> w(n + 1);
  w[0] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    w[i + 1] = m[i][3] / m[i][i];
    w[0] = w[0] - w[i + 1];
  }
  return w;
}

template <class Scalar, class Weight>
Deviator<Scalar> tensor_at(const Cell& cell, const std::vector<Weight>& w) {
  Deviator<Scalar> t{};
  for (std::size_t i = 0; i < w.size(); ++i)
    t = t + Scalar(w[i]) * deviator(tensor_cast<Scalar>(cell.tensors[i]));
  return t;
}

// A point of the simplex and a direction in it, as integers over 2^kPlaceBits.
struct Place {
  std::vector<Integer> w, d;
};

Integer rounded(const Real50& x, int bits) {
  return Integer(floor(ldexp(x, bits) + Real50(1) / Real50(2)));
}

// Newton's method along the gradient.
std::optional<Place> place_on_level(const Cell& cell, std::vector<Real50> w,
                                    const Level<Real50>& level) {
  const std::size_t n = w.size();
  std::vector<Real50> d(n);
  Real50 along(0);
  for (int iteration = 0; iteration < 12; ++iteration) {
    const auto at = level_slope(tensor_at<Real50>(cell, w), level);
    Real50 mean(0), square(0);
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = inner(at.slope, thrice(deviator(tensor_cast<Real50>(cell.tensors[i]))));
      mean = mean + d[i] / Real50(static_cast<int>(n));
    }
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = d[i] - mean;
      square = square + d[i] * d[i];
    }
    if (!(square > 0)) return std::nullopt;
    along = -at.value / square;
    for (std::size_t i = 0; i < n; ++i) w[i] = w[i] + along * d[i];
    if (abs(along) * sqrt(square) < Real50("1e-42")) break;
  }
  Real50 largest(0);
  for (const Real50& x : d) largest = std::max(largest, Real50(abs(x)));
  if (!(largest > 0)) return std::nullopt;
  Place place{std::vector<Integer>(n), std::vector<Integer>(n)};
  place.w[0] = Integer(1) << kPlaceBits;
  for (std::size_t i = 1; i < n; ++i) {
    if (!(abs(w[i]) < 2)) return std::nullopt;
    place.w[i] = rounded(w[i], kPlaceBits);
    place.w[0] -= place.w[i];
    // A step of 2^-kStepBits times a direction of kDirectionBits.
    place.d[i] = rounded(d[i] / largest, kDirectionBits);
    place.d[0] -= place.d[i];
  }
  return place;
}

// The sign of mode - mu at the place w, a multiple of barycentric coordinates.
Sign side_at(const Cell& cell, const std::vector<Integer>& w, const Rational& mu) {
  return exact_side_of_level(tensor_at<Rational>(cell, w), mu);
}

bool is_proved(const Cell& cell, const Place& place, const Rational& mu) {
  // Over 2^(kStepBits + kDirectionBits).
  constexpr int shift = kStepBits + kDirectionBits - kPlaceBits;
  std::vector<Integer> before, after;
  for (std::size_t i = 0; i < place.w.size(); ++i) {
    before.push_back((place.w[i] << shift) - place.d[i]);
    after.push_back((place.w[i] << shift) + place.d[i]);
    if (before[i] < 0 || after[i] < 0) return false;
  }
  const Sign s = side_at(cell, before, mu), t = side_at(cell, after, mu);
  return s != Sign::zero && t == -s;
}

std::array<std::string, 3> decimals(const Vector3<Real50>& p) {
  return {p.x.str(kDigits), p.y.str(kDigits), p.z.str(kDigits)};
}

}  // namespace

ReferencePoints reference_points(const TetMesh& mesh, const SurfaceMesh& surface,
                                 const ModeValue& mode) {
  const auto level = make_level<Real50>(mode);
  const auto mu = to_scalar<Rational>(mode);
  ReferencePoints result;
  const std::size_t n = surface.points.size();
  result.coordinates.resize(n);
  std::vector<char> proved(n, 0);
  std::vector<double> bounds(n, 0);
  const auto refine = [&](std::size_t v) {
    const auto& p = surface.points[v];
    result.coordinates[v] = decimals(vector_cast<Real50>(p));
    if (surface.carrier[v] == Carrier::vertex) return;
    const Cell cell = cell_of(mesh, surface.carrier_vertices[v]);
    const auto w = barycentric(cell, p);
    if (!w) return;
    const auto place = place_on_level(cell, *w, level);
    if (!place || !is_proved(cell, *place, mu)) return;
    Vector3<Real50> q{};
    double size = 0;
    for (std::size_t i = 0; i < cell.points.size(); ++i) {
      const auto& corner = cell.points[i];
      q = q + ldexp(Real50(place->w[i]), -kPlaceBits) * vector_cast<Real50>(corner);
      size = std::max({size, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    result.coordinates[v] = decimals(q);
    // |sum d_i p_i| <= the sum of the positive d_i, at most 3 and a rounding, times the diameter.
    bounds[v] = std::ldexp(cell.diameter, 2 - kStepBits) + std::ldexp(size, -110);
    proved[v] = 1;
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 64), [&](const auto& range) {
    for (std::size_t v = range.begin(); v != range.end(); ++v) refine(v);
  });
  for (std::size_t v = 0; v < n; ++v) {
    result.bound = std::max(result.bound, bounds[v]);
    if (!proved[v]) result.unproved.push_back(static_cast<SurfaceMesh::Index>(v));
  }
  return result;
}

}  // namespace tensortopo
