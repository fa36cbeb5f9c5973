// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/level/tet_geometry.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo::detail {

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

/// One tetrahedron in space, whose corners of triangles move.
class CellInSpace {
 public:
  /// @param exponents  of scaled tensors, see `ScaledField`
  CellInSpace(const TetMesh& mesh, TetMesh::Index tet, const std::array<int, 4>& exponents)
      : vertices_(mesh.tets[as_size(tet)]), geometry_(points(mesh, vertices_), exponents) {}

  double size() const { return geometry_.longest_edge(); }

 protected:
  /// @param gradient_at  of the function along which it moves, in space, at some weights
  template <class Gradient>
  MovingCorner corner(const SurfaceMesh& surface, SurfaceMesh::Index vertex,
                      const Gradient& gradient_at) const {
    const auto& carrier = surface.carrier_vertices[as_size(vertex)];
    const auto& x = surface.points[as_size(vertex)];
    MovingCorner corner;
    std::array<bool, 4> carried;
    for (std::size_t i = 0; i < 4; ++i) {
      carried[i] = std::find(carrier.begin(), carrier.end(), vertices_[i]) != carrier.end();
      if (carried[i]) corner.weights[i] = std::max(0.0, geometry_.weight(i, x));
    }
    Vector3<double> direction = gradient_at(corner.weights);
    std::array<std::size_t, 4> on{}, off{};
    std::size_t on_count = 0, off_count = 0;
    for (std::size_t i = 0; i < 4; ++i) (carried[i] ? on[on_count++] : off[off_count++]) = i;
    if (off_count == 1) {
      const auto normal = unit_or_zero(geometry_.weight_gradient(off[0]));
      direction = direction - dot(direction, normal) * normal;
    } else if (off_count == 2) {
      const auto along =
          unit_or_zero(cross(geometry_.weight_gradient(off[0]), geometry_.weight_gradient(off[1])));
      direction = dot(direction, along) * along;
    }
    direction = unit_or_zero(direction);
    for (std::size_t k = 0; k < on_count; ++k)
      corner.step[on[k]] = dot(geometry_.weight_gradient(on[k]), direction);
    return corner;
  }

  const TetGeometry& geometry() const { return geometry_; }
  const std::array<TetMesh::Index, 4>& vertices() const { return vertices_; }

 private:
  static std::array<Vector3<double>, 4> points(const TetMesh& mesh,
                                               const std::array<TetMesh::Index, 4>& vertices) {
    std::array<Vector3<double>, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = mesh.points[as_size(vertices[i])];
    return result;
  }

  std::array<TetMesh::Index, 4> vertices_;
  TetGeometry geometry_;
};

inline Deviator<double> middle_of(const Deviator<double>& s, const Deviator<double>& t) {
  return 0.5 * (s + t);
}
inline std::array<double, 4> middle_of(const std::array<double, 4>& v,
                                       const std::array<double, 4>& w) {
  std::array<double, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = 0.5 * (v[i] + w[i]);
  return result;
}

/// Whether `is_proved` holds of a simplex, or of a segment or triangle in each part after up to so
/// many cuts; `is_right` says of a corner whether that is any use.
template <std::size_t Count, class Place, class IsRight, class IsProved>
bool is_proved_in_parts(const std::array<Place, Count>& t, int cuts, const IsRight& is_right,
                        const IsProved& is_proved) {
  for (const Place& corner : t)
    if (!is_right(corner)) return false;
  if constexpr (Count == 1) {
    return true;
  } else {
    if (is_proved(t)) return true;
    if (cuts == 0) return false;
    [[maybe_unused]] const auto part = [&](const std::array<Place, Count>& p) {
      return is_proved_in_parts(p, cuts - 1, is_right, is_proved);
    };
    if constexpr (Count == 2) {
      const Place middle = middle_of(t[0], t[1]);
      return part({t[0], middle}) && part({middle, t[1]});
    } else if constexpr (Count == 3) {
      const std::array<Place, 3> h{middle_of(t[1], t[2]), middle_of(t[2], t[0]),
                                   middle_of(t[0], t[1])};
      return part(h) && part({t[0], h[2], h[1]}) && part({t[1], h[0], h[2]}) &&
             part({t[2], h[1], h[0]});
    } else {
      return false;
    }
  }
}

/// The level of a mode in one tetrahedron.
class LevelInCell : public CellInSpace {
 public:
  LevelInCell(const TetMesh& mesh, const ScaledField<double>& field, const Level<double>& level,
              TetMesh::Index tet)
      : CellInSpace(mesh, tet, exponents(field, mesh.tets[as_size(tet)])), level_(level) {
    for (std::size_t i = 0; i < 4; ++i) tensors_[i] = field.tensors[as_size(vertices()[i])];
    // Errors of the weights count as those of exact weights do (see rounding_unit): four terms,
    // each below sqrt(12) times it.
    total_ = 1 + geometry().weight_error() / unit_roundoff<double>();
  }

  MovingCorner corner(const SurfaceMesh& surface, SurfaceMesh::Index vertex) const {
    return CellInSpace::corner(surface, vertex, [&](const std::array<double, 4>& weights) {
      return geometry().gradient(level_slope(geometry().tensor(weights, tensors_), level_).slope,
                                 tensors_);
    });
  }

  /// About how far the level is from a place, along the gradient.
  double distance(const std::array<double, 4>& weights) const {
    const auto at = level_slope(geometry().tensor(weights, tensors_), level_);
    const auto g = geometry().gradient(at.slope, tensors_);
    return std::abs(at.value) / length(g);
  }

  /// Whether a simplex is proved to lie on one side of the level.
  template <std::size_t Count>
  bool is_on_side(const std::array<std::array<double, 4>, Count>& corners, Verdict side) const {
    std::array<Deviator<double>, Count> t;
    for (std::size_t i = 0; i < Count; ++i) {
      for (const double w : corners[i])
        if (!(w >= 0)) return false;
      t[i] = geometry().tensor(corners[i], tensors_);
    }
    return is_proved_in_parts(
        t, kCuts, [&](const auto& c) { return side_of_level(c, level_, total_) == side; },
        [&](const auto& part) { return is_proved_empty(part, level_, total_); });
  }

 private:
  /// An isotropic vertex must not decide on the scale.
  static std::array<int, 4> exponents(const ScaledField<double>& field,
                                      const std::array<TetMesh::Index, 4>& vertices) {
    const auto other = *std::find_if(vertices.begin(), vertices.end(),
                                     [&](TetMesh::Index v) { return !field.is_zero[as_size(v)]; });
    std::array<int, 4> result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] =
          field.exponents[as_size(field.is_zero[as_size(vertices[i])] ? other : vertices[i])];
    return result;
  }

  const Level<double>& level_;
  std::array<Deviator<double>, 4> tensors_;
  double total_ = 1;
};

}  // namespace tensortopo::detail
