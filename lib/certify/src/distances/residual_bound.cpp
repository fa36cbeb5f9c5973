// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/certify/residual_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "run/for_each.hpp"
#include "tensortopo/scalar/power_of_two.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// A number known up to an error. Each operation rounds to nearest: 2^-53 of its result, or 2^-1074
/// where it underflows; twice that, and a factor for the roundings of the error itself, are added.
struct Near {
  double value = 0, error = 0;

  Near() = default;
  explicit Near(double v, double e = 0) : value(v), error(e) {}

  static Near rounded(double v, double e) {
    return Near(v, (e + std::abs(v) * 0x1p-52 + 0x1p-1000) * (1 + 0x1p-40));
  }
  friend Near operator+(const Near& a, const Near& b) {
    return rounded(a.value + b.value, a.error + b.error);
  }
  friend Near operator-(const Near& a, const Near& b) {
    return rounded(a.value - b.value, a.error + b.error);
  }
  friend Near operator-(const Near& a) { return Near(-a.value, a.error); }
  friend Near operator*(const Near& a, const Near& b) {
    return rounded(a.value * b.value,
                   std::abs(a.value) * b.error + a.error * (std::abs(b.value) + b.error));
  }
};

/// Bounds of a number.
struct Range {
  double low, high;
};
/// Wider than what a few roundings may change.
Range widened(double low, double high) {
  return {low - 0x1p-45 * std::abs(low) - 0x1p-1000, high + 0x1p-45 * std::abs(high) + 0x1p-1000};
}
Range range_of(const Near& x) { return widened(x.value - x.error, x.value + x.error); }
/// @pre 0 <= low; the divisor's low is > 0
Range quotient(const Range& a, const Range& b) { return widened(a.low / b.high, a.high / b.low); }
Range root(const Range& a) { return widened(std::sqrt(std::max(a.low, 0.0)), std::sqrt(a.high)); }

/// The tensors of a tetrahedron at places near it, times six times its volume.
class Interpolation {
 public:
  Interpolation(const TetMesh& mesh, Index tet) {
    const auto& vertices = mesh.tets[as_size(tet)];
    double size = 0, largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      points_[i] = mesh.points[as_size(vertices[i])];
      largest = std::max(largest, max_norm(mesh.tensors[as_size(vertices[i])]));
      size = std::max(size, max_norm(points_[i] - points_[0]));
    }
    const double scale = inverse_power(largest);
    length_ = inverse_power(size);
    unit_ = 1 / scale;
    const auto near = [&](double x) { return Near(scale * x, 0x1p-1000); };
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& t = mesh.tensors[as_size(vertices[i])];
      tensors_[i] = {near(t.xx), near(t.yy), near(t.zz), near(t.xy), near(t.yz), near(t.xz)};
    }
    for (std::size_t i = 0; i < 3; ++i) edges_[i] = from_first(points_[i + 1]);
    for (std::size_t i = 0; i < 3; ++i)
      normals_[i] = cross(edges_[(i + 1) % 3], edges_[(i + 2) % 3]);
    volume_ = dot(edges_[0], normals_[0]);
  }

  const Near& volume() const { return volume_; }
  /// What the tensors are divided by.
  double unit() const { return unit_; }
  SymmetricTensor<Near> at(const Vector3<double>& x) const {
    const auto d = from_first(x);
    Near rest = volume_;
    SymmetricTensor<Near> sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Near weight = dot(normals_[i], d);
      rest = rest - weight;
      sum = sum + weight * tensors_[i + 1];
    }
    return sum + rest * tensors_[0];
  }

 private:
  Vector3<Near> from_first(const Vector3<double>& p) const {
    const auto near = [&](double x, double y) {
      const Near d = Near(x) - Near(y);
      return Near(length_ * d.value, length_ * d.error + 0x1p-1000);
    };
    return {near(p.x, points_[0].x), near(p.y, points_[0].y), near(p.z, points_[0].z)};
  }

  std::array<Vector3<double>, 4> points_;
  std::array<SymmetricTensor<Near>, 4> tensors_;
  std::array<Vector3<Near>, 3> edges_, normals_;
  Near volume_;
  double length_ = 1, unit_ = 1;
};

/// The largest of a bound at each vertex of each tetrahedron with triangles.
/// @param bound  of an interpolation and a place
template <class Bound>
double largest_bound(const TetMesh& mesh, const SurfaceMesh& surface, const Bound& bound) {
  std::vector<std::uint32_t> order(surface.triangles.size());  // by tetrahedron
  std::iota(order.begin(), order.end(), 0u);
  if (!std::is_sorted(surface.tet.begin(), surface.tet.end()))
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return surface.tet[a] < surface.tet[b];
    });
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i == 0 || surface.tet[order[i]] != surface.tet[order[i - 1]]) starts.push_back(i);
  starts.push_back(order.size());
  std::vector<double> bounds(starts.size(), 0);
  detail::for_each(starts.size() - 1, [&](std::size_t n) {
    thread_local std::vector<Index> vertices;
    vertices.clear();
    for (std::size_t i = starts[n]; i < starts[n + 1]; ++i) {
      const auto& triangle = surface.triangles[order[i]];
      vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const Interpolation inside(mesh, surface.tet[order[starts[n]]]);
    for (const auto v : vertices) bounds[n] = std::max(bounds[n], bound(inside, as_size(v)));
  });
  return *std::max_element(bounds.begin(), bounds.end());
}

double farther(const Range& range, double from) {
  const double distance = std::max(std::abs(range.low - from), std::abs(range.high - from));
  return (1 + 0x1p-40) * distance + 0x1p-52 * std::abs(from);  // which is rounded itself
}

}  // namespace

double residual_bound(const TetMesh& mesh, const ModeValue& mode, const SurfaceMesh& surface) {
  const double mu = mode.approx(), all = 1 + std::abs(mu);
  const auto is_isotropic = [&](Index v) {
    const auto d = deviator(mesh.tensors[as_size(v)]);
    return d == Deviator<double>{};
  };
  const auto has_no_mode = [&](std::size_t v) {
    const auto& carrier = surface.carrier_vertices[v];
    return carrier[0] >= 0 && std::all_of(carrier.begin(), carrier.end(),
                                          [&](Index i) { return i < 0 || is_isotropic(i); });
  };
  return largest_bound(mesh, surface, [&](const Interpolation& inside, std::size_t v) {
    const Range volume = range_of(inside.volume());
    const auto t = deviator(inside.at(surface.points[v]));
    const Range p = range_of(norm_form(t)), q = range_of(determinant_form(t));
    if (!(p.low > 0) || !(volume.low > 0 || volume.high < 0)) return has_no_mode(v) ? 0.0 : all;
    const Range size = widened(p.low * std::sqrt(p.low), p.high * std::sqrt(p.high));
    if (!(size.low > 0)) return all;
    const double root2 = std::sqrt(2.0);
    Range value = widened(root2 * (q.low < 0 ? q.low / size.low : q.low / size.high),
                          root2 * (q.high > 0 ? q.high / size.low : q.high / size.high));
    if (volume.high < 0) value = {-value.high, -value.low};  // an odd form, of a negative multiple
    const double bound = farther(value, mu);
    return bound < all ? bound : all;
  });
}

double residual_bound(const TetMesh& mesh, const InvariantLevel& level,
                      const SurfaceMesh& surface) {
  const Invariant invariant = level.invariant();
  const double value = level.approx(), none = std::numeric_limits<double>::infinity();
  return largest_bound(mesh, surface, [&](const Interpolation& inside, std::size_t v) {
    Range volume = range_of(inside.volume());
    if (volume.high < 0) volume = {-volume.high, -volume.low};
    const auto t = inside.at(surface.points[v]);
    Range all = range_of(inner(t, t)), d = range_of(norm_form(deviator(t)));
    d = widened(d.low / 3, d.high / 3);  // |D|^2
    if (!(volume.low > 0) || !(all.low > 0)) return none;
    const Range found = invariant == Invariant::anisotropy
                            ? quotient(root(d), root(all))
                            : quotient(root(invariant == Invariant::magnitude ? all : d), volume);
    const double unit = invariant == Invariant::anisotropy ? 1 : inside.unit();
    const double bound = farther({found.low * unit, found.high * unit}, value);
    return bound < none ? bound : none;
  });
}

}  // namespace tensortopo
