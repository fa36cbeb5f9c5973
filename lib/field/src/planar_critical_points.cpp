// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/planar_critical_points.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "tensortopo/field/binary_cubic.hpp"
#include "tensortopo/scalar/constants.hpp"
#include "tensortopo/scalar/instantiations.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo {
namespace {

template <class Scalar>
using Point5 = std::array<Scalar, 5>;

template <class Scalar>
Scalar dot5(const Point5<Scalar>& x, const Point5<Scalar>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3] + x[4] * y[4];
}

/// x - k y.
template <class Scalar>
Point5<Scalar> minus(const Point5<Scalar>& x, const Scalar& k, const Point5<Scalar>& y) {
  return {x[0] - k * y[0], x[1] - k * y[1], x[2] - k * y[2], x[3] - k * y[3], x[4] - k * y[4]};
}

/// What counts as zero for numbers of order 1 that a few hundred operations produced.
template <class Scalar>
Scalar noise() {
  return Scalar(256) * std::numeric_limits<Scalar>::epsilon();
}

template <class Scalar>
SymmetricTensor<Scalar> tensor_of(const Point5<Scalar>& x) {
  return to_tensor(from_orthonormal_coordinates(x));
}

/// An orthonormal basis of deviators: three that span the field, two across it.
template <class Scalar>
struct PlaneFrame {
  std::array<Point5<Scalar>, 5> basis{};
  /// Vertex tensor i is the sum over j <= i of triangle[j][i] basis[j].
  std::array<std::array<Scalar, 3>, 3> triangle{};

  /// Weights of the tensor with these coordinates along the field's part of the basis.
  std::array<Scalar, 3> weights(const std::array<Scalar, 3>& x) const {
    std::array<Scalar, 3> w{};
    for (std::size_t i = 3; i-- > 0;) {
      Scalar rest = x[i];
      for (std::size_t j = i + 1; j < 3; ++j) rest = rest - triangle[i][j] * w[j];
      w[i] = rest / triangle[i][i];
    }
    return w;
  }
};

template <class Scalar>
std::optional<PlaneFrame<Scalar>> plane_frame(const TriangleField<Scalar>& field) {
  using std::sqrt;
  PlaneFrame<Scalar> frame;
  // Orthogonalises x against the first `count` basis vectors, twice so that the result is
  // orthogonal to rounding even if little of x remains; returns the norm of the remainder.
  const auto append = [&](Point5<Scalar> x, std::size_t count, std::size_t column) {
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t j = 0; j < count; ++j) {
        const Scalar k = dot5(x, frame.basis[j]);
        x = minus(x, k, frame.basis[j]);
        if (column < 3) frame.triangle[j][column] = frame.triangle[j][column] + k;
      }
    const Scalar norm = sqrt(dot5(x, x));
    if (norm > Scalar(0)) x = minus(Point5<Scalar>{}, Scalar(Scalar(-1) / norm), x);
    frame.basis[count] = x;
    return norm;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point5<Scalar> x = orthonormal_coordinates(field.vertex[i]);
    frame.triangle[i][i] = append(x, i, i);
    if (!(frame.triangle[i][i] > noise<Scalar>() * sqrt(dot5(x, x)))) return std::nullopt;
  }
  for (std::size_t i = 3; i < 5; ++i) {
    // The axis with the largest remainder keeps at least a third of its length.
    std::size_t best = 0;
    Scalar largest(-1);
    for (std::size_t axis = 0; axis < 5; ++axis) {
      Scalar remainder(1);
      for (std::size_t j = 0; j < i; ++j) remainder = remainder - squared(frame.basis[j][axis]);
      if (remainder > largest) largest = remainder, best = axis;
    }
    Point5<Scalar> x{};
    x[best] = Scalar(1);
    append(x, i, 5);
  }
  return frame;
}

/// tr N1^3, tr N1^2 N2, tr N1 N2^2, tr N2^3 of the two tensors across the field.
template <class Scalar>
std::array<Scalar, 4> cubic_traces(const SymmetricTensor<Scalar>& n1,
                                   const SymmetricTensor<Scalar>& n2) {
  const auto q1 = square(n1), q2 = square(n2);
  return {inner(q1, n1), inner(q1, n2), inner(q2, n1), inner(q2, n2)};
}

template <class Scalar>
bool vanishes(const std::array<Scalar, 4>& coefficients) {
  using std::abs;
  for (const Scalar& c : coefficients)
    if (abs(c) > noise<Scalar>()) return false;
  return true;
}

template <class Scalar>
std::array<Scalar, 3> field_coordinates(const PlaneFrame<Scalar>& frame,
                                        const SymmetricTensor<Scalar>& t) {
  const Point5<Scalar> x = orthonormal_coordinates(deviator(t));
  return {dot5(x, frame.basis[0]), dot5(x, frame.basis[1]), dot5(x, frame.basis[2])};
}

/// Derivatives of tr T^3 on the unit sphere of the field's span, in a tangent basis (x, y) at a
/// unit t: along a great circle from T towards X the first is 3 tr(T^2 X), the second 6 tr(T X^2) -
/// 3 tr(T^3).
template <class Scalar>
struct SphereDerivatives {
  Vector3<Scalar> x, y;
  Scalar gx, gy, hxx, hxy, hyy;

  Scalar determinant() const { return hxx * hyy - hxy * hxy; }
  bool singular() const {
    using std::abs;
    return abs(determinant()) <= Scalar(64) * noise<Scalar>();
  }
};

template <class Scalar>
SphereDerivatives<Scalar> derivatives(const PlaneFrame<Scalar>& frame, const Vector3<Scalar>& t) {
  using std::abs;
  using std::sqrt;
  const Scalar zero(0), one(1), three(3), six(6);
  Vector3<Scalar> axis = {one, zero, zero};
  if (abs(t.y) < abs(t.x) && abs(t.y) <= abs(t.z))
    axis = {zero, one, zero};
  else if (abs(t.z) < abs(t.x))
    axis = {zero, zero, one};
  SphereDerivatives<Scalar> d{};
  d.x = cross(t, axis);
  d.x = unit(d.x);
  d.y = cross(t, d.x);
  const auto embedded = [&](const Vector3<Scalar>& v) {
    Point5<Scalar> p = minus(Point5<Scalar>{}, Scalar(-v.x), frame.basis[0]);
    p = minus(p, Scalar(-v.y), frame.basis[1]);
    return tensor_of(minus(p, Scalar(-v.z), frame.basis[2]));
  };
  const auto tensor = embedded(t), tx = embedded(d.x), ty = embedded(d.y);
  const auto t2 = square(tensor);
  const Scalar radial = three * inner(t2, tensor);
  d.gx = three * inner(t2, tx);
  d.gy = three * inner(t2, ty);
  d.hxx = six * inner(tensor, square(tx)) - radial;
  d.hyy = six * inner(tensor, square(ty)) - radial;
  d.hxy = three * inner(tensor, square(tx + ty) - square(tx) - square(ty));
  return d;
}

/// Newton's method for the gradient on the sphere, from a point that is already close.
template <class Scalar>
Vector3<Scalar> polished(const PlaneFrame<Scalar>& frame, Vector3<Scalar> t) {
  t = unit(t);
  for (int step = 0; step < 3; ++step) {
    const auto d = derivatives(frame, t);
    if (d.singular()) break;
    const Scalar determinant = d.determinant();
    const Scalar dx = (d.hxy * d.gy - d.hyy * d.gx) / determinant;
    const Scalar dy = (d.hxy * d.gx - d.hxx * d.gy) / determinant;
    // Far from quadratic convergence the start is better than the step.
    if (dx * dx + dy * dy > Scalar(1) / Scalar(10000)) break;
    t = unit(t + dx * d.x + dy * d.y);
  }
  return t;
}

template <class Scalar>
CriticalType classify(const PlaneFrame<Scalar>& frame, const Vector3<Scalar>& t) {
  const auto d = derivatives(frame, t);
  if (d.singular()) return CriticalType::undecided;
  return d.determinant() > Scalar(0) ? CriticalType::extremum : CriticalType::saddle;
}

/// The critical tensor that belongs to a tensor n across the field, or zero if there is a curve of
/// them.
///
/// N^2 - (|N|^2/3) I - (tr N^3/|N|^2) N for a unit N, of squared length (1 - mode(N)^2) / 6. A
/// degenerate N ~ e e^T - I/3 gives zero; then T^2 ~ I - e e^T is solved by the neutral tensors
/// with kernel e, and one of these is orthogonal to the other tensor across the field.
template <class Scalar>
SymmetricTensor<Scalar> critical_tensor(const SymmetricTensor<Scalar>& n,
                                        const SymmetricTensor<Scalar>& other) {
  using std::abs;
  const auto t = square(n) - inner(square(n), n) * n;
  const auto d = deviator(t);
  if (norm_form(d) > noise<Scalar>()) return t;
  const auto [values, vectors] = eigen_decomposition(n);
  const bool planar = values[0] - values[1] < values[1] - values[2];
  const auto& p = vectors[planar ? 0 : 1];
  const auto& q = vectors[planar ? 1 : 2];
  // Neutral tensors with kernel e: u (p p - q q) + w (p q + q p).
  const Scalar u = Scalar(-2) * dot(p, other * q);
  const Scalar w = dot(p, other * p) - dot(q, other * q);
  if (abs(u) + abs(w) <= noise<Scalar>()) return {};
  const auto entry = [&](const Scalar& pi, const Scalar& qi, const Scalar& pj, const Scalar& qj) {
    return Scalar(u * (pi * pj - qi * qj) + w * (pi * qj + qi * pj));
  };
  return {entry(p.x, q.x, p.x, q.x), entry(p.y, q.y, p.y, q.y), entry(p.z, q.z, p.z, q.z),
          entry(p.x, q.x, p.y, q.y), entry(p.y, q.y, p.z, q.z), entry(p.x, q.x, p.z, q.z)};
}

template <class Scalar>
PlanarCriticalPoint<Scalar> point_at(const TriangleField<Scalar>& field,
                                     const PlaneFrame<Scalar>& frame,
                                     const std::array<Scalar, 3>& coordinates) {
  using std::abs;
  PlanarCriticalPoint<Scalar> point;
  point.weights = frame.weights(coordinates);
  Scalar largest(0);
  for (const Scalar& w : point.weights)
    if (abs(w) > largest) largest = abs(w);
  for (Scalar& w : point.weights) w = w / largest;
  point.weight_sum = point.weights[0] + point.weights[1] + point.weights[2];
  if (point.weight_sum < Scalar(0)) {
    for (Scalar& w : point.weights) w = -w;
    point.weight_sum = -point.weight_sum;
  }
  point.tensor = field.at(point.weights);
  point.mode = mode(point.tensor);
  return point;
}

}  // namespace

template <RealScalar Scalar>
std::vector<PlanarCriticalPoint<Scalar>> nondegenerate_critical_points(
    const TriangleField<Scalar>& field) {
  const auto frame = plane_frame(field);
  if (!frame) return {};
  const auto n1 = tensor_of(frame->basis[3]), n2 = tensor_of(frame->basis[4]);
  const auto [t111, t112, t122, t222] = cubic_traces(n1, n2);
  const Scalar two(2);
  const std::array<Scalar, 4> cubic = {-t112, t111 - two * t122, two * t112 - t222, t122};
  if (vanishes(cubic)) return {};
  std::vector<PlanarCriticalPoint<Scalar>> points;
  for (const auto& [k1, k2] : binary_cubic_zeros(cubic)) {
    const auto t = critical_tensor<Scalar>(k1 * n1 + k2 * n2, k1 * n2 - k2 * n1);
    const auto start = field_coordinates(*frame, t);
    if (start[0] == Scalar(0) && start[1] == Scalar(0) && start[2] == Scalar(0)) continue;
    const auto direction = polished(*frame, Vector3<Scalar>{start[0], start[1], start[2]});
    auto point = point_at(field, *frame, {direction.x, direction.y, direction.z});
    point.type = classify(*frame, direction);
    points.push_back(point);
  }
  return points;
}

namespace {

/// A common zero of two forms that also solves the other one, on the plane spanned by orthonormal p
/// and q.
template <class Scalar>
struct PlaneZeros {
  std::vector<Vector3<Scalar>> zeros;
  bool everywhere = false;
};

template <class Scalar>
PlaneZeros<Scalar> zeros_on_plane(const SymmetricTensor<Scalar>& form, const Vector3<Scalar>& p,
                                  const Vector3<Scalar>& q) {
  using std::abs;
  using std::sqrt;
  const Scalar a = dot(p, form * p), b = dot(p, form * q), c = dot(q, form * q);
  const Scalar zero(0);
  PlaneZeros<Scalar> result;
  if (abs(a) + abs(b) + abs(c) <= noise<Scalar>()) {
    result.everywhere = true;
    return result;
  }
  const Scalar discriminant = b * b - a * c;
  if (discriminant < zero) return result;
  const Scalar root = sqrt(discriminant);
  const Scalar k = b > zero ? Scalar(-b - root) : Scalar(root - b);
  const auto add = [&](const Scalar& x, const Scalar& y) {
    const Scalar norm = sqrt(x * x + y * y);
    if (norm == zero) return;
    result.zeros.push_back(Scalar(x / norm) * p + Scalar(y / norm) * q);
  };
  add(k, a);
  add(c, k);
  return result;
}

/// The zero of a pencil's cubic where the cubic is steepest, or (1, 0) if the cubic vanishes.
template <class Scalar>
std::array<Scalar, 2> steepest_zero(const std::array<Scalar, 4>& f) {
  using std::abs;
  std::array<Scalar, 2> best = {Scalar(1), Scalar(0)};
  Scalar steepest(-1);
  if (vanishes(f)) return best;
  for (const auto& [x, y] : binary_cubic_zeros(f)) {
    const Scalar fx = Scalar(3) * f[0] * x * x + Scalar(2) * f[1] * x * y + f[2] * y * y;
    const Scalar fy = f[1] * x * x + Scalar(2) * f[2] * x * y + Scalar(3) * f[3] * y * y;
    const Scalar slope = abs(fx * y - fy * x);
    if (slope > steepest) steepest = slope, best = {x, y};
  }
  return best;
}

}  // namespace

template <RealScalar Scalar>
PlanarDegeneratePoints<Scalar> degenerate_points(const TriangleField<Scalar>& field) {
  using std::abs;
  using std::sqrt;
  PlanarDegeneratePoints<Scalar> result;
  const auto frame = plane_frame(field);
  if (!frame) return result;
  const auto n1 = tensor_of(frame->basis[3]), n2 = tensor_of(frame->basis[4]);
  const auto [t111, t112, t122, t222] = cubic_traces(n1, n2);
  const Scalar three(3);
  // A neutral member of the pencil is f f^T - g g^T up to a factor: its zeros are two real planes.
  const auto [k1, k2] = steepest_zero<Scalar>({t111, three * t112, three * t122, t222});
  const auto eigen = eigen_decomposition(k1 * n1 + k2 * n2);
  const auto other = Scalar(-k2) * n1 + k1 * n2;
  const Scalar half_root = sqrt(Scalar(1) / Scalar(2));
  const auto& [major, medium, minor] = eigen.vectors;
  const Vector3<Scalar> plus = half_root * (major + minor), minus_ = half_root * (major - minor);
  const auto first = zeros_on_plane(other, medium, plus);
  const auto second = zeros_on_plane(other, medium, minus_);
  result.isolated = !first.everywhere && !second.everywhere;
  std::vector<Vector3<Scalar>> zeros;
  const auto add = [&](const Vector3<Scalar>& e) {
    // A zero on a plane that is degenerate as a whole is not isolated; one on both planes comes
    // twice.
    if (first.everywhere && abs(dot(e, minus_)) <= noise<Scalar>()) return;
    if (second.everywhere && abs(dot(e, plus)) <= noise<Scalar>()) return;
    for (const auto& former : zeros) {
      const auto difference = cross(e, former);
      if (dot(difference, difference) <= squared(noise<Scalar>())) return;
    }
    zeros.push_back(e);
  };
  for (const auto& e : first.zeros) add(e);
  for (const auto& e : second.zeros) add(e);
  for (const auto& e : zeros) {
    const SymmetricTensor<Scalar> t = {e.x * e.x, e.y * e.y, e.z * e.z,
                                       e.x * e.y, e.y * e.z, e.x * e.z};
    auto point = point_at(field, *frame, field_coordinates(*frame, t));
    point.mode = point.mode < Scalar(0) ? Scalar(-1) : Scalar(1);
    point.type = CriticalType::extremum;
    result.points.push_back(point);
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                             \
  template std::vector<PlanarCriticalPoint<Scalar>> nondegenerate_critical_points( \
      const TriangleField<Scalar>&);                                               \
  template PlanarDegeneratePoints<Scalar> degenerate_points(const TriangleField<Scalar>&);
TENSORTOPO_FOR_EACH_REAL(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
