// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene/fine_surface.hpp"

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace tensortopo {
namespace {

using Index = FineSurface::Index;

// A triangle with the triangle of the surface that it is a part of.
struct Part {
  std::array<Index, 3> corners;
  Index parent;
};

std::array<double, 3> weights_in(const SurfaceMesh& surface, const SurfacePlace& place) {
  const auto& t = surface.triangles[as_size(place.triangle)];
  const Vector3<double>&p = surface.points[as_size(t[0])], &q = surface.points[as_size(t[1])],
        &r = surface.points[as_size(t[2])];
  const Vector3<double> area = cross(q - p, r - p), x = place.point;
  const double square = dot(area, area);
  if (!(square > 0)) return {1, 0, 0};
  const double u = dot(cross(r - q, x - q), area) / square;
  const double v = dot(cross(p - r, x - r), area) / square;
  return {u, v, 1 - u - v};
}

class Refinement {
 public:
  Refinement(const SurfaceMesh& surface, double longest, std::size_t most)
      : square_(longest * longest), most_(most) {
    for (const auto& point : surface.points) places_.push_back({-1, point});
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      parts_.push_back({surface.triangles[i], static_cast<Index>(i)});
      for (const Index v : surface.triangles[i])
        places_[as_size(v)].triangle = static_cast<Index>(i);
    }
    while (places_.size() < most_ && pass()) {
    }
  }

  std::vector<SurfacePlace> take_places() { return std::move(places_); }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  // Halves each edge that is too long, once; whether there was one.
  bool pass() {
    std::unordered_map<std::uint64_t, Index> middles;
    std::vector<Part> parts;
    parts.reserve(2 * parts_.size());
    for (const Part& part : parts_) split(part, middles, parts);
    parts_ = std::move(parts);
    return !middles.empty();
  }

  Index middle(Index u, Index v, Index parent, std::unordered_map<std::uint64_t, Index>& middles) {
    const Vector3<double> p = places_[as_size(u)].point, q = places_[as_size(v)].point;
    if (!(dot(p - q, p - q) > square_)) return -1;
    const auto low = static_cast<std::uint64_t>(u < v ? u : v),
               high = static_cast<std::uint64_t>(u < v ? v : u);
    const auto [entry, is_new] =
        middles.emplace(high << 32 | low, static_cast<Index>(places_.size()));
    if (is_new) places_.push_back({parent, 0.5 * (p + q)});
    return entry->second;
  }

  void split(const Part& part, std::unordered_map<std::uint64_t, Index>& middles,
             std::vector<Part>& out) {
    const auto& c = part.corners;
    std::array<Index, 3> m;  // on the edge across from each corner
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      m[k] = middle(c[(k + 1) % 3], c[(k + 2) % 3], part.parent, middles);
      if (m[k] >= 0) ++count;
    }
    const auto add = [&](Index a, Index b, Index d) { out.push_back({{a, b, d}, part.parent}); };
    if (count == 0) {
      out.push_back(part);
    } else if (count == 3) {
      add(c[0], m[2], m[1]), add(m[2], c[1], m[0]), add(m[1], m[0], c[2]), add(m[0], m[1], m[2]);
    } else {
      // Turned so that the edge across from c0 is the one halved, or the one of three that is not.
      std::size_t k = 0;
      while ((m[k] >= 0) != (count == 1)) ++k;
      const Index a = c[k], b = c[(k + 1) % 3], d = c[(k + 2) % 3];
      if (count == 1) {
        add(a, b, m[k]), add(a, m[k], d);
      } else {
        const Index ad = m[(k + 1) % 3], ab = m[(k + 2) % 3];
        add(a, ab, ad), add(ab, b, d), add(ab, d, ad);
      }
    }
  }

  std::vector<SurfacePlace> places_;
  std::vector<Part> parts_;
  double square_;
  std::size_t most_;
};

}  // namespace

FineSurface fine_surface(const SurfaceMesh& surface, double longest, std::size_t most) {
  Refinement refinement(surface, longest, most);
  FineSurface fine;
  fine.vertices = refinement.take_places();
  fine.weights.reserve(fine.vertices.size());
  for (const SurfacePlace& place : fine.vertices)
    fine.weights.push_back(place.triangle < 0 ? std::array<double, 3>{1, 0, 0}
                                              : weights_in(surface, place));
  fine.triangles.reserve(refinement.parts().size());
  for (const Part& part : refinement.parts()) fine.triangles.push_back(part.corners);
  return fine;
}

}  // namespace tensortopo
