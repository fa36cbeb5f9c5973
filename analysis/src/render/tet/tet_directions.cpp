// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/tet_directions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analyze/curvature/level_curvature.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {
namespace {

TetrahedronField<double> deviators(const TetField& field) {
  TetrahedronField<double> result;
  for (std::size_t k = 0; k < 4; ++k) result.vertex[k] = deviator(field.tensors[k]);
  return result;
}

CharacteristicTensor<double> characteristic_of(const TetField& field) {
  if (exact_rank(field.tensors) == 4)
    if (const auto tensor = characteristic_tensor(deviators(field))) return *tensor;
  throw std::invalid_argument("the deviators at its corners are dependent");
}

SymmetricTensor<double> combined(const TetField& field, const std::array<double, 4>& w) {
  return w[0] * field.tensors[0] + w[1] * field.tensors[1] + w[2] * field.tensors[2] +
         w[3] * field.tensors[3];
}

double sum_of(const std::array<double, 4>& w) { return w[0] + w[1] + w[2] + w[3]; }

// 1 or -1 if all weights have this sign.
int common_sign(const std::array<double, 4>& w) {
  const auto [least, greatest] = std::minmax_element(w.begin(), w.end());
  return *least >= 0 ? 1 : *greatest <= 0 ? -1 : 0;
}

}  // namespace

std::array<double, 4> TetField::weights(const Vector3<double>& point) const {
  const auto& c = corners;
  const Vector3<double> e1 = c[1] - c[0], e2 = c[2] - c[0], e3 = c[3] - c[0], x = point - c[0];
  const double volume = dot(e1, cross(e2, e3));
  const double a = dot(x, cross(e2, e3)) / volume, b = dot(e1, cross(x, e3)) / volume,
               d = dot(e1, cross(e2, x)) / volume;
  return {1 - a - b - d, a, b, d};
}

SymmetricTensor<double> TetField::at(const Vector3<double>& point) const {
  return combined(*this, weights(point));
}

TetField tet_field(const TetMesh& mesh, std::size_t tet) {
  TetField field;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto v = static_cast<std::size_t>(mesh.tets[tet][k]);
    field.corners[k] = mesh.points[v];
    field.tensors[k] = mesh.tensors[v];
  }
  return field;
}

TetDirections::TetDirections(const TetField& field, const ModeValue& mode)
    : field_(field),
      manifold_(characteristic_of(field), mode_parameter<double>(mode)),
      lift_(deviators(field)) {}

std::array<double, 4> TetDirections::weights(const Vector3<double>& v) const {
  return lift_.weights(manifold_.tensor_at(v));
}

DirectionKind TetDirections::kind(const Vector3<double>& v) const {
  if (!manifold_.in_real_domain(v)) return DirectionKind::complex_domain;
  const bool one = sum_of(weights(v)) > 0, other = sum_of(weights(-v)) > 0;
  if (one != other) return DirectionKind::mixed;
  return one ? DirectionKind::positive : DirectionKind::negative;
}

int TetDirections::sign_inside(const Vector3<double>& v) const {
  if (!manifold_.in_real_domain(v)) return 0;
  const int sign = common_sign(weights(v));
  return manifold_.mode().sign == 0 ? std::abs(sign) : sign;
}

int TetDirections::sign_inside_boundary(const Vector3<double>& v) const {
  return common_sign(lift_.weights(manifold_.tensor_at_boundary(v)));
}

std::optional<Vector3<double>> TetDirections::place(const Vector3<double>& v) const {
  if (!manifold_.in_real_domain(v)) return std::nullopt;
  const std::array<double, 4> w = weights(v);
  const double sum = sum_of(w);
  Vector3<double> point{};
  for (std::size_t k = 0; k < 4; ++k) point += (w[k] / sum) * field_.corners[k];
  if (!std::isfinite(dot(point, point))) return std::nullopt;
  return point;
}

Vector3<double> TetDirections::canonical(const Vector3<double>& v,
                                         const Vector3<double>& dominant) const {
  return manifold_.sigma(v, dominant) <= 0 ? v : -v;
}

Vector3<double> TetDirections::line(const Vector3<double>& v, Texture texture) const {
  if (texture == Texture::none || !manifold_.in_real_domain(v)) return {};
  if (texture == Texture::dominant) return manifold_.dominant_eigenvector(v);
  // Degenerate points fill no surface.
  if (manifold_.mode().abs_mu == 1) return {};
  const auto point = place(v);
  if (!point) return {};
  const auto curvature = level_curvature(field_.corners, field_.tensors, *point);
  if (!curvature) return {};
  const Vector3<double> d = medium_eigenvector_derivative(
      field_, *point, curvature->directions[texture == Texture::major ? 0 : 1]);
  const Vector3<double> tangent = d - dot(d, v) * v;
  if (!(length(tangent) > 0) || !std::isfinite(length(tangent))) return {};
  return unit(tangent);
}

Vector3<double> medium_eigenvector_derivative(const TetField& field, const Vector3<double>& point,
                                              const Vector3<double>& step) {
  std::array<double, 4> rate = field.weights(field.corners[0] + step);
  rate[0] -= 1;
  const SymmetricTensor<double> change = combined(field, rate);
  const auto [values, vectors] = eigen_decomposition(field.at(point));
  const Vector3<double> turned = change * vectors[1];
  Vector3<double> derivative{};
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}})
    derivative += (dot(vectors[k], turned) / (values[1] - values[k])) * vectors[k];
  return derivative;
}

}  // namespace tensortopo
