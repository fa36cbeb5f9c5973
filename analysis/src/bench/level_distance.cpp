// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/level_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "conformance/triangle_search.hpp"
#include "extract/level/level.hpp"

namespace tensortopo {
namespace {

using Vector = Vector3<double>;

/// The linear field of a tetrahedron, as a function of the place.
class LinearField {
 public:
  LinearField(const TetMesh& mesh, SurfaceMesh::Index tet) {
    const auto& v = mesh.tets[as_size(tet)];
    std::array<Vector, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = mesh.points[as_size(v[i])];
      tensors_[i] = deviator(mesh.tensors[as_size(v[i])]);
      scale_ = std::max(scale_, norm_form(tensors_[i]));
    }
    scale_ = scale_ > 0 ? 1 / std::sqrt(scale_) : 1;
    for (auto& t : tensors_) t = scale_ * t;
    origin_ = p[0];
    const double volume = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    gradients_[1] = (1 / volume) * cross(p[2] - p[0], p[3] - p[0]);
    gradients_[2] = (1 / volume) * cross(p[3] - p[0], p[1] - p[0]);
    gradients_[3] = (1 / volume) * cross(p[1] - p[0], p[2] - p[0]);
    gradients_[0] = -(gradients_[1] + gradients_[2] + gradients_[3]);
    size_ = std::cbrt(std::abs(volume));
  }

  double size() const { return size_; }

  std::array<double, 4> weights(const Vector& x) const {
    std::array<double, 4> w{};
    for (std::size_t i = 1; i < 4; ++i) w[i] = dot(gradients_[i], x - origin_);
    w[0] = 1 - w[1] - w[2] - w[3];
    return w;
  }

  /// The step of Newton's method towards the level, along the gradient.
  Vector step(const Vector& x, const Level<double>& level) const {
    const auto w = weights(x);
    Deviator<double> t{};
    for (std::size_t i = 0; i < 4; ++i) t = t + w[i] * tensors_[i];
    const auto known = level_slope(t, level);
    Vector gradient{};
    for (std::size_t i = 0; i < 4; ++i)
      gradient += inner(known.slope, thrice(tensors_[i])) * gradients_[i];
    return (-known.value / dot(gradient, gradient)) * gradient;
  }

 private:
  std::array<Deviator<double>, 4> tensors_;
  std::array<Vector, 4> gradients_{};
  Vector origin_{};
  double scale_ = 0, size_ = 0;
};

/// The foot on the level, if it is found inside the tetrahedron.
std::optional<Vector> foot_inside(const LinearField& field, const Level<double>& level, Vector x) {
  for (int step = 0; step < 30; ++step) {
    const Vector d = field.step(x, level);
    const double length = std::sqrt(dot(d, d));
    if (!(length < 2 * field.size())) return std::nullopt;
    x += d;
    if (length > 1e-11 * field.size()) continue;
    const auto w = field.weights(x);
    if (*std::min_element(w.begin(), w.end()) < -1e-9) return std::nullopt;
    return x;
  }
  return std::nullopt;
}

void add(Spread& spread, double distance, double area) {
  spread.area += area;
  spread.squares += area * distance * distance;
  spread.largest = std::max(spread.largest, distance);
  ++spread.samples;
}

std::array<Vector, 3> corners_of(const SurfaceMesh& surface, std::size_t i) {
  const auto& t = surface.triangles[i];
  return {surface.points[as_size(t[0])], surface.points[as_size(t[1])],
          surface.points[as_size(t[2])]};
}

double area_of(const std::array<Vector, 3>& c) {
  const Vector n = cross(c[1] - c[0], c[2] - c[0]);
  return length(n) / 2;
}

std::unique_ptr<TriangleSearch> search_in(const SurfaceMesh& surface) {
  return surface.triangles.empty() ? nullptr : std::make_unique<TriangleSearch>(surface);
}

}  // namespace

double Spread::root_mean_square() const { return area > 0 ? std::sqrt(squares / area) : 0; }

Spread& Spread::operator+=(const Spread& other) {
  area += other.area;
  squares += other.squares;
  largest = std::max(largest, other.largest);
  samples += other.samples;
  return *this;
}

double LevelDistance::root_mean_square() const {
  return std::max(to_level.root_mean_square(), from_level.root_mean_square());
}

double LevelDistance::largest() const { return std::max(to_level.largest, from_level.largest); }

LevelDistance& LevelDistance::operator+=(const LevelDistance& other) {
  to_level += other.to_level;
  from_level += other.from_level;
  not_projected += other.not_projected;
  return *this;
}

LevelDistance level_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             const TetMesh& reference_mesh, const SurfaceMesh& reference,
                             const ModeValue& mode) {
  const auto level = make_level<double>(mode);
  const auto in_surface = search_in(surface), in_reference = search_in(reference);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  LevelDistance result;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto c = corners_of(surface, i);
    const double area = area_of(c);
    if (!(area > 0)) continue;
    const LinearField field(mesh, surface.tet[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector x = (2.0 / 3) * c[k] + (1.0 / 6) * (c[(k + 1) % 3] + c[(k + 2) % 3]);
      double distance = infinite;
      if (const auto foot = foot_inside(field, level, x)) {
        distance = std::sqrt(dot(*foot - x, *foot - x));
      } else {
        ++result.not_projected;
        if (in_reference) distance = in_reference->nearest(x).distance;
      }
      add(result.to_level, distance, area / 3);
    }
  }
  for (std::size_t i = 0; i < reference.triangles.size(); ++i) {
    const auto c = corners_of(reference, i);
    const double area = area_of(c);
    if (!(area > 0)) continue;
    const Vector middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
    const auto foot = foot_inside(LinearField(reference_mesh, reference.tet[i]), level, middle);
    add(result.from_level,
        in_surface ? in_surface->nearest(foot.value_or(middle)).distance : infinite, area);
  }
  return result;
}

}  // namespace tensortopo
