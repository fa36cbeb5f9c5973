// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/line_field.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

// Steps along a line, in cells, and how many edges one step may cross.
constexpr double kStep = 0.7;
constexpr int kMostEdges = 64;

// What lines need to know of a triangle.
struct Facet {
  Vector3<double> a{}, b{};                   // orthonormal, in its plane
  std::array<Vector3<double>, 3> slope{};     // gradients of the barycentric coordinates
  std::array<Index, 3> beyond{{-1, -1, -1}};  // the triangle across from each corner
};

class Walker {
 public:
  Walker(const SurfaceMesh& surface, const LineField& field) : surface_(surface), field_(field) {
    facets_.resize(surface.triangles.size());
    for (std::size_t i = 0; i < facets_.size(); ++i) facets_[i] = facet(surface.triangles[i]);
    join();
  }

  // The direction at a place, turned to make a sharp angle with `along`; 0 if there is none.
  Vector3<double> direction(const SurfacePlace& place, const Vector3<double>& along) const {
    const Facet& f = facets_[as_size(place.triangle)];
    const auto& corners = surface_.triangles[as_size(place.triangle)];
    const Vector3<double> from = place.point - surface_.points[as_size(corners[0])];
    const double w1 = dot(f.slope[1], from), w2 = dot(f.slope[2], from);
    const SymmetricTensor<double> t = (1 - w1 - w2) * field_[as_size(corners[0])] +
                                      w1 * field_[as_size(corners[1])] +
                                      w2 * field_[as_size(corners[2])];
    const Vector3<double> ta = t * f.a;
    const double p = (dot(f.a, ta) - dot(f.b, t * f.b)) / 2, q = dot(f.b, ta);
    const double spread = std::hypot(p, q);
    if (!(spread > 0)) return {};
    // The eigenvector of the larger eigenvalue, from the row in which nothing cancels.
    const Vector3<double> d =
        unit_or_zero(p >= 0 ? (spread + p) * f.a + q * f.b : q * f.a + (spread - p) * f.b);
    return dot(d, along) < 0 ? -d : d;
  }

  // Goes on by a distance along `d`, and turns it where the surface turns; false at the end.
  bool go(SurfacePlace& place, Vector3<double>& d, double distance) const {
    for (int edges = 0; edges < kMostEdges; ++edges) {
      const Facet& f = facets_[as_size(place.triangle)];
      const auto& corners = surface_.triangles[as_size(place.triangle)];
      double reach = distance;
      std::size_t out = 3;
      for (std::size_t k = 0; k < 3; ++k) {
        const double rate = dot(f.slope[k], d);
        if (!(rate < 0)) continue;
        const double weight =
            dot(f.slope[k], place.point - surface_.points[as_size(corners[(k + 1) % 3])]);
        const double to_edge = std::max(0.0, weight / -rate);
        if (to_edge < reach) reach = to_edge, out = k;
      }
      place.point += reach * d;
      if (out == 3) return true;
      distance -= reach;
      const Index next = f.beyond[out];
      if (next < 0) return false;
      // Unfold: the part along the edge stays, the part outwards goes inwards there.
      const Vector3<double> edge = unit_or_zero(surface_.points[as_size(corners[(out + 2) % 3])] -
                                                surface_.points[as_size(corners[(out + 1) % 3])]);
      const Vector3<double> outwards = -unit_or_zero(f.slope[out]);
      const double along = dot(d, edge), across = dot(d, outwards);
      const Facet& g = facets_[as_size(next)];
      std::size_t in = 0;
      while (in < 2 && g.beyond[in] != place.triangle) ++in;
      d = unit_or_zero(along * edge + across * unit_or_zero(g.slope[in]));
      place.triangle = next;
    }
    return false;
  }

 private:
  Facet facet(const std::array<Index, 3>& t) const {
    const auto &p = surface_.points[as_size(t[0])], &q = surface_.points[as_size(t[1])],
               &r = surface_.points[as_size(t[2])];
    Facet f;
    const Vector3<double> area = cross(q - p, r - p), normal = unit_or_zero(area);
    f.a = unit_or_zero(q - p);
    f.b = cross(normal, f.a);
    const double twice = length(area);
    if (!(twice > 0)) return f;
    f.slope = {(1 / twice) * cross(normal, r - q), (1 / twice) * cross(normal, p - r),
               (1 / twice) * cross(normal, q - p)};
    return f;
  }

  void join() {
    struct SideOfFace {
      Index low, high, triangle;
      int corner;
    };
    std::vector<SideOfFace> sides;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const Index u = surface_.triangles[i][as_size((k + 1) % 3)],
                    v = surface_.triangles[i][as_size((k + 2) % 3)];
        sides.push_back({std::min(u, v), std::max(u, v), static_cast<Index>(i), k});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const SideOfFace& s, const SideOfFace& t) {
      return std::array{s.low, s.high, s.triangle} < std::array{t.low, t.high, t.triangle};
    });
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      const SideOfFace &s = sides[i], &t = sides[i + 1];
      if (s.low != t.low || s.high != t.high) continue;
      facets_[as_size(s.triangle)].beyond[as_size(s.corner)] = t.triangle;
      facets_[as_size(t.triangle)].beyond[as_size(t.corner)] = s.triangle;
    }
  }

  const SurfaceMesh& surface_;
  const LineField& field_;
  std::vector<Facet> facets_;
};

double convolved(const Walker& walker, const SurfacePlace& start, const LicOptions& options) {
  double sum = solid_noise(start.point, options);
  int count = 1;
  if (start.triangle < 0) return sum;
  const Vector3<double> first = walker.direction(start, {});
  if (first == Vector3<double>{}) return sum;
  const int steps = static_cast<int>(options.half_length / kStep);
  for (const int way : {1, -1}) {
    SurfacePlace place = start;
    Vector3<double> d = way * 1.0 * first;
    for (int i = 0; i < steps; ++i) {
      if (!walker.go(place, d, kStep * options.cell)) break;
      sum += solid_noise(place.point, options);
      ++count;
      d = walker.direction(place, d);
      if (d == Vector3<double>{}) break;
    }
  }
  return sum / count;
}

// A random number in [0, 1] for each point of the lattice.
double grain(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed) {
  // The finalizer of SplitMix64, on a number for the point.
  std::uint64_t h = seed * 0x9e3779b97f4a7c15u +
                    static_cast<std::uint64_t>(x) * 0x8cb92ba72f3d8dd7u +
                    static_cast<std::uint64_t>(y) * 0xd6e8feb86659fd93u +
                    static_cast<std::uint64_t>(z) * 0xa0761d6478bd642fu;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  h ^= h >> 31;
  return static_cast<double>(h >> 11) / static_cast<double>((std::uint64_t{1} << 53) - 1);
}

}  // namespace

SymmetricTensor<double> dyad(const Vector3<double>& d) {
  return {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.y * d.z, d.x * d.z};
}

double solid_noise(const Vector3<double>& point, const LicOptions& options) {
  const double x = point.x / options.cell, y = point.y / options.cell, z = point.z / options.cell;
  const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
  const auto i = static_cast<std::int64_t>(fx), j = static_cast<std::int64_t>(fy),
             k = static_cast<std::int64_t>(fz);
  double value = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
    const double weight =
        (a ? x - fx : 1 - (x - fx)) * (b ? y - fy : 1 - (y - fy)) * (c ? z - fz : 1 - (z - fz));
    value += weight * grain(i + a, j + b, k + c, options.seed);
  }
  return std::clamp(value, 0.0, 1.0);
}

std::vector<double> line_integral_convolution(const SurfaceMesh& surface, const LineField& field,
                                              const std::vector<SurfacePlace>& places,
                                              const LicOptions& options) {
  const Walker walker(surface, field);
  std::vector<double> values(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { values[i] = convolved(walker, places[i], options); });
  return values;
}

std::vector<double> stretched(std::vector<double> values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = values.empty() ? 0 : sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double deviation =
      values.empty() ? 0 : std::sqrt(squares / static_cast<double>(values.size()));
  for (double& v : values)
    v = deviation > 0 ? std::clamp(0.5 + (v - mean) / (4 * deviation), 0.0, 1.0) : 0.5;
  return values;
}

}  // namespace tensortopo
