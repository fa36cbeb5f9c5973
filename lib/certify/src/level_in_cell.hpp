// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/extract/simple_simplex.hpp"
#include "tensortopo/extract/tet_geometry.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::detail {

inline std::size_t at(TetMesh::Index i) { return static_cast<std::size_t>(i); }

inline Vector3<double> unit(const Vector3<double>& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : Vector3<double>{0, 0, 0};
}

/// A corner of a triangle: its weights in the tetrahedron, exactly 0 off its carrier, and how they
/// change along the unit direction in which it may move.
struct MovingCorner {
  std::array<double, 4> weights{}, step{};

  std::array<double, 4> moved(double by) const {
    std::array<double, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = weights[i] + by * step[i];
    return result;
  }
  /// How far it may move both ways without leaving the carrier.
  double room() const {
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i)
      if (step[i] != 0) room = std::min(room, weights[i] / std::abs(step[i]));
    return room;
  }
};

/// How often a moved triangle is cut in four for the proof that the level does not meet it.
inline constexpr int kCuts = 2;

/// One tetrahedron and the level in it.
class LevelInCell {
 public:
  LevelInCell(const TetMesh& mesh, const ScaledField<double>& field, TetMesh::Index tet)
      : vertices_(mesh.tets[at(tet)]), geometry_(points(mesh), exponents(field)) {
    for (std::size_t i = 0; i < 4; ++i) tensors_[i] = field.tensors[at(vertices_[i])];
    // Errors of the weights count as those of exact weights do (see rounding_unit): four terms,
    // each below sqrt(12) times it.
    total_ = 1 + geometry_.weight_error() / unit_roundoff<double>();
  }

  MovingCorner corner(const SurfaceMesh& surface, SurfaceMesh::Index vertex,
                      const Level<double>& level) const {
    const auto& carrier = surface.carrier_vertices[at(vertex)];
    const auto& x = surface.points[at(vertex)];
    MovingCorner corner;
    std::array<bool, 4> carried;
    for (std::size_t i = 0; i < 4; ++i) {
      carried[i] = std::find(carrier.begin(), carrier.end(), vertices_[i]) != carrier.end();
      if (carried[i]) corner.weights[i] = std::max(0.0, geometry_.weight(i, x));
    }
    const auto at = level_slope(geometry_.tensor(corner.weights, tensors_), level);
    auto direction = geometry_.gradient(at.slope, tensors_);
    std::array<std::size_t, 4> on{}, off{};
    std::size_t on_count = 0, off_count = 0;
    for (std::size_t i = 0; i < 4; ++i) (carried[i] ? on[on_count++] : off[off_count++]) = i;
    if (off_count == 1) {
      const auto normal = unit(geometry_.weight_gradient(off[0]));
      direction = direction - dot(direction, normal) * normal;
    } else if (off_count == 2) {
      const auto along = unit(cross(geometry_.weight_gradient(off[0]),
                                    geometry_.weight_gradient(off[1])));
      direction = dot(direction, along) * along;
    }
    direction = unit(direction);
    for (std::size_t k = 0; k < on_count; ++k)
      corner.step[on[k]] = dot(geometry_.weight_gradient(on[k]), direction);
    return corner;
  }

  /// About how far the level is from a place, along the gradient.
  double distance(const std::array<double, 4>& weights, const Level<double>& level) const {
    const auto at = level_slope(geometry_.tensor(weights, tensors_), level);
    const auto g = geometry_.gradient(at.slope, tensors_);
    return std::abs(at.value) / std::sqrt(dot(g, g));
  }

  /// Whether a triangle, segment or point is proved to lie on one side of the level.
  template <std::size_t Count>
  bool is_on_side(const std::array<std::array<double, 4>, Count>& corners, Verdict side,
                  const Level<double>& level) const {
    std::array<Deviator<double>, Count> t;
    for (std::size_t i = 0; i < Count; ++i) {
      for (const double w : corners[i])
        if (!(w >= 0)) return false;
      t[i] = geometry_.tensor(corners[i], tensors_);
    }
    return is_on_side(t, side, level, kCuts);
  }

  double size() const { return geometry_.longest_edge(); }

 private:
  template <std::size_t Count>
  bool is_on_side(const std::array<Deviator<double>, Count>& t, Verdict side,
                  const Level<double>& level, int cuts) const {
    for (const auto& corner : t)
      if (side_of_level(corner, level, total_) != side) return false;
    if constexpr (Count == 1) {
      return true;
    } else {
      return is_proved_empty(t, level, total_) ||
             (cuts > 0 && are_parts_on_side(t, side, level, cuts - 1));
    }
  }
  bool are_parts_on_side(const std::array<Deviator<double>, 2>& t, Verdict side,
                         const Level<double>& level, int cuts) const {
    const auto middle = 0.5 * (t[0] + t[1]);
    return is_on_side(std::array{t[0], middle}, side, level, cuts) &&
           is_on_side(std::array{middle, t[1]}, side, level, cuts);
  }
  bool are_parts_on_side(const std::array<Deviator<double>, 3>& t, Verdict side,
                         const Level<double>& level, int cuts) const {
    const std::array<Deviator<double>, 3> h{0.5 * (t[1] + t[2]), 0.5 * (t[2] + t[0]),
                                            0.5 * (t[0] + t[1])};
    return is_on_side(h, side, level, cuts) &&
           is_on_side(std::array{t[0], h[2], h[1]}, side, level, cuts) &&
           is_on_side(std::array{t[1], h[0], h[2]}, side, level, cuts) &&
           is_on_side(std::array{t[2], h[1], h[0]}, side, level, cuts);
  }

  std::array<Vector3<double>, 4> points(const TetMesh& mesh) const {
    std::array<Vector3<double>, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = mesh.points[at(vertices_[i])];
    return result;
  }
  /// A vertex without deviator must not decide on the scale.
  std::array<int, 4> exponents(const ScaledField<double>& field) const {
    const auto other = *std::find_if(vertices_.begin(), vertices_.end(), [&](TetMesh::Index v) {
      return !field.is_zero[at(v)];
    });
    std::array<int, 4> result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = field.exponents[at(field.is_zero[at(vertices_[i])] ? other : vertices_[i])];
    return result;
  }

  std::array<TetMesh::Index, 4> vertices_;
  TetGeometry geometry_;
  std::array<Deviator<double>, 4> tensors_;
  double total_ = 1;
};

}  // namespace tensortopo::detail
