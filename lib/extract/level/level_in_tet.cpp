// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/level/level_in_tet.hpp"

#include <cmath>
#include <limits>

#include "extract/level/mode_forms.hpp"
#include "extract/level/position.hpp"

namespace tensortopo {
namespace {

/// Closer to a side of the tetrahedron or face triangles would be thin.
constexpr double kLeastWeight = 1e-4;

template <class Value>
std::array<Value, 4> at_corners(const std::vector<Value>& values,
                                const std::array<TetMesh::Index, 4>& v) {
  return {values[as_size(v[0])], values[as_size(v[1])], values[as_size(v[2])],
          values[as_size(v[3])]};
}

}  // namespace

SymmetricTensor<double> mode_slope(const Deviator<double>& t) {
  // P dQ - (3/2) Q dP with Q = det m, P = |m|^2 / 3, dQ = <adj m, dm> and dP = (2/3) <m, dm>.
  const auto m = thrice(t);
  const auto adjugate = detail::polar_adjugate(m, m);  // twice the adjugate
  return (norm_form(t) / 2) * adjugate - (inner(adjugate, m) / 6) * m;
}

LevelInTet::LevelInTet(const TetMesh& mesh, const ScaledField<double>& field, TetMesh::Index tet,
                       const Level<double>& level)
    : points_(at_corners(mesh.points, mesh.tets[as_size(tet)])),
      tensors_(at_corners(field.tensors, mesh.tets[as_size(tet)])),
      geometry_(points_, at_corners(field.exponents, mesh.tets[as_size(tet)])),
      level_(&level) {}

Deviator<double> LevelInTet::tensor(const Vector3<double>& x) const {
  return geometry_.tensor(x, tensors_);
}

Vector3<double> LevelInTet::mode_gradient(const Vector3<double>& x) const {
  return geometry_.gradient(mode_slope(geometry_.balanced_tensor(x, tensors_)), tensors_);
}

double LevelInTet::distance(const Vector3<double>& x) const {
  const auto at = level_slope(tensor(x), *level_);
  const auto g = geometry_.gradient(at.slope, tensors_);
  const double length = std::sqrt(dot(g, g));
  return length > 0 ? std::abs(at.value) / length : std::numeric_limits<double>::infinity();
}

double LevelInTet::residual(const Vector3<double>& x) const {
  return mode_difference(geometry_.balanced_tensor(x, tensors_), *level_);
}

std::optional<Vector3<double>> LevelInTet::on_level(Vector3<double> x, std::size_t across) const {
  const double size = geometry_.longest_edge();
  constexpr int kMostSteps = 12;
  bool is_found = false;
  for (int step = 0; step < kMostSteps && !is_found; ++step) {
    const auto at = level_slope(tensor(x), *level_);
    auto g = geometry_.gradient(at.slope, tensors_);
    if (across < 4) {
      const auto& n = geometry_.weight_gradient(across);
      g = g - (dot(g, n) / dot(n, n)) * n;
    }
    const auto d = (-at.value / dot(g, g)) * g;
    const double length = std::sqrt(dot(d, d));
    if (!(length < size)) return std::nullopt;
    x += d;
    is_found = length < 1e-14 * size;
  }
  if (!is_found) return std::nullopt;
  std::array<double, 4> weights;
  for (std::size_t i = 0; i < 4; ++i) {
    weights[i] = i == across ? 0 : geometry_.weight(i, x);
    if (i != across && !(weights[i] > kLeastWeight)) return std::nullopt;
  }
  return position_at(weights, std::array{0, 0, 0, 0}, points_);
}

}  // namespace tensortopo
