// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <span>

#include "tensortopo/io/read_surface_file.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {
namespace {

using Index = std::int32_t;
using Vector = Vector3<double>;
using Triangles = std::vector<std::array<Index, 3>>;

/// Polygons of more corners are cut as fans: the search for ears takes the cube of their number.
constexpr std::size_t largest_cut_at_ears = 64;

class Polygon {
 public:
  Polygon(const std::vector<Vector>& points, std::span<const Index> corners)
      : points_(points), corners_(corners.begin(), corners.end()) {
    for (std::size_t i = 0; i < corners_.size(); ++i)
      normal_ = normal_ + cross(at(i) - at(0), at((i + 1) % corners_.size()) - at(0));
  }

  void cut(Triangles& triangles) {
    while (corners_.size() > 3 && corners_.size() <= largest_cut_at_ears) {
      const std::size_t ear = best_ear(), n = corners_.size();
      triangles.push_back({corners_[(ear + n - 1) % n], corners_[ear], corners_[(ear + 1) % n]});
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    for (std::size_t i = 2; i < corners_.size(); ++i)
      triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
  }

 private:
  const Vector& at(std::size_t i) const { return points_[static_cast<std::size_t>(corners_[i])]; }
  double side(const Vector& a, const Vector& b, const Vector& c) const {
    return dot(normal_, cross(b - a, c - a));
  }

  /// The corner that leaves the shortest diagonal, of those that no other lies in, if there are.
  std::size_t best_ear() const {
    const std::size_t n = corners_.size();
    std::size_t best = 1;
    bool found = false;
    double shortest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector &a = at((i + n - 1) % n), &b = at(i), &c = at((i + 1) % n);
      bool is_ear = side(a, b, c) > 0;
      for (std::size_t k = 2; is_ear && k + 1 < n; ++k) {
        const Vector& p = at((i + k) % n);
        is_ear = !(side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0);
      }
      const Vector diagonal = c - a;
      const double length = elementary::hypot(diagonal.x, diagonal.y, diagonal.z);
      if (is_ear && (!found || length < shortest)) best = i, shortest = length, found = true;
    }
    return best;
  }

  const std::vector<Vector>& points_;
  std::vector<Index> corners_;
  Vector normal_;
};

}  // namespace

std::vector<std::array<std::int32_t, 3>> triangulated(const SurfaceFile& file,
                                                      std::vector<std::size_t>* of) {
  Triangles triangles;
  const IndexLists& all = file.polygons;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t begin = all.begin_of(i);
    Polygon(file.points, std::span(all.points).subspan(begin, all.ends[i] - begin)).cut(triangles);
    if (of != nullptr) of->resize(triangles.size(), i);
  }
  return triangles;
}

}  // namespace tensortopo
