// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology/loop_tetrahedron.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo::theory {
namespace {

// Coordinates of a tensor of the span: along D = diag(l2 - l3, l3 - l1, l1 - l2), xy, yz and xz,
// all of norm one.
using Coordinates = Eigen::Vector4d;

struct Loop {
  std::array<double, 3> l;
  double s;
  int side;

  Eigen::Vector3d saddle() const { return {l[1] - l[2], l[2] - l[0], l[0] - l[1]}; }

  // The tensor of mode mu at a boundary vector.
  Coordinates tensor(const Eigen::Vector3d& v) const {
    const Eigen::Vector3d values = {l[0], l[1], l[2]};
    const Eigen::Matrix3d n = values.asDiagonal(), along = v * v.transpose(),
                          plane = Eigen::Matrix3d::Identity() - along;
    const double alpha = v.dot(n * v);
    const Eigen::Matrix3d t =
        -(plane * n * plane + alpha / 2 * (1 + s * s / 3) * plane - s * s / 3 * alpha * along);
    const double root = std::sqrt(2.0);
    const Coordinates c = {t.diagonal().dot(saddle().normalized()), root * t(0, 1), root * t(1, 2),
                           root * t(0, 2)};
    return c / c.norm();
  }

  // Lemma 4: squares of coordinates as functions of alpha, over its whole interval and back.
  std::vector<Eigen::Vector3d> vectors(int parts) const {
    const double low = -2 * l[1] / (1 - s), high = -2 * l[1] / (1 + s);
    const double half = (l[0] * l[0] + l[1] * l[1] + l[2] * l[2]) / 2;
    std::vector<Eigen::Vector3d> result;
    for (int k = 0; k < 2 * parts; ++k) {
      // Points at the ends are square roots of distances in alpha.
      const double phase = k * std::acos(-1.0) / parts;
      const double alpha = (low + high) / 2 + (high - low) / 2 * std::cos(phase);
      Eigen::Vector3d v;
      for (int i = 0; i < 3; ++i) {
        const double li = l[static_cast<std::size_t>(i)];
        const double square =
            ((1 - s * s) * alpha * alpha / 4 + li * alpha + li * li) / (3 * li * li - half);
        v[i] = std::sqrt(std::max(square, 0.0));
      }
      if (k >= parts) v.y() = -v.y();
      v.z() *= side;
      result.push_back(v);
    }
    return result;
  }

  std::vector<Coordinates> points(int parts) const {
    std::vector<Coordinates> result;
    for (const Eigen::Vector3d& v : vectors(parts)) result.push_back(tensor(v));
    return result;
  }
};

Loop loop_of(const std::array<Rational, 3>& values, const Rational& s, int side) {
  Loop loop{{}, s.convert_to<double>(), side};
  for (std::size_t i = 0; i < 3; ++i) loop.l[i] = values[i].convert_to<double>();
  return loop;
}

// The matrix that maps coordinates to weights of the vertices.
Eigen::Matrix4d weights_of(const LoopTetrahedron& t, const Loop& loop) {
  Eigen::Matrix4d columns;
  const double root = std::sqrt(2.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto d = tensor_cast<double>(t.vertices[i]);
    columns.col(static_cast<Eigen::Index>(i))
        << Eigen::Vector3d(d.xx, d.yy, d.zz).dot(loop.saddle().normalized()),
        root * d.xy, root * d.yz, root * d.xz;
  }
  return columns.inverse();
}

double unit(Random& random) { return random.integer(-10000, 10000) / 10000.0; }

// A functional that is positive at all points, by a perceptron from a random start.
std::optional<Coordinates> positive_on(const std::vector<Coordinates>& points, Random& random) {
  Coordinates n;
  for (int i = 0; i < 4; ++i) n[i] = unit(random);
  for (int step = 0; step < 4000; ++step) {
    const auto worst = std::min_element(points.begin(), points.end(),
                                        [&](auto& p, auto& q) { return n.dot(p) < n.dot(q); });
    n.normalize();
    if (n.dot(*worst) > 0.01) return n;
    n += 0.3 * *worst;
  }
  return std::nullopt;
}

// Corners of a tetrahedron of random planes around the points of a chart.
std::optional<std::array<Eigen::Vector3d, 4>> corners_around(
    const std::vector<Eigen::Vector3d>& points, Random& random) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread /
                                                            static_cast<double>(points.size()));
  const Eigen::Vector3d scale = axes.eigenvalues().cwiseMax(1e-9).cwiseSqrt();
  const Eigen::Matrix3d to_space = axes.eigenvectors() * scale.asDiagonal();
  const Eigen::Matrix3d to_round = to_space.inverse();

  std::array<Eigen::Vector3d, 4> normal;
  normal[3] = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    normal[i] = Eigen::Vector3d(unit(random), unit(random), unit(random)).normalized();
    normal[3] -= (0.4 + std::abs(unit(random))) * normal[i];
  }
  normal[3].normalize();
  std::array<double, 4> reach;
  for (std::size_t i = 0; i < 4; ++i) {
    double least = 1e9, most = -1e9;
    for (const auto& p : points) {
      const double at = normal[i].dot(to_round * (p - mean));
      least = std::min(least, at), most = std::max(most, at);
    }
    reach[i] = most + (0.1 + 0.5 * std::abs(unit(random))) * (most - least);
  }
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    Eigen::Matrix3d rows;
    Eigen::Vector3d values;
    for (std::size_t k = 0, row = 0; k < 4; ++k) {
      if (k == i) continue;
      rows.row(static_cast<Eigen::Index>(row)) = normal[k].transpose();
      values[static_cast<Eigen::Index>(row++)] = reach[k];
    }
    if (std::abs(rows.determinant()) < 0.05) return std::nullopt;
    corners[i] = mean + to_space * rows.inverse() * values;
  }
  return corners;
}

Tensor tensor_of_integers(const std::array<Rational, 3>& l, const std::array<long, 4>& c) {
  const Rational d(c[0]);
  return {d * (l[1] - l[2]), d * (l[2] - l[0]), d * (l[0] - l[1]),
          Rational(c[1]),    Rational(c[2]),    Rational(c[3])};
}

LoopTetrahedron of_corners(const std::array<int, 3>& l, const Rational& s,
                           const std::array<int, 3>& corner) {
  LoopTetrahedron result;
  for (std::size_t i = 0; i < 3; ++i) result.values[i] = l[i];
  result.s = s;
  // x D - (1 + l1 x) xz + y xy + z yz at (+-x, +-y, +-z) with an even number of minus signs.
  for (std::size_t i = 0; i < 4; ++i) {
    const int sign_x = i < 2 ? 1 : -1, sign_y = i % 2 == 0 ? 1 : -1;
    const long x = sign_x * corner[0], y = sign_y * corner[1], z = sign_x * sign_y * corner[2];
    result.vertices[i] = tensor_of_integers(result.values, {x, y, z, -(1 + l[0] * x)});
  }
  return result;
}

}  // namespace

std::array<Deviator<Rational>, 4> LoopTetrahedron::deviators() const {
  return {deviator(vertices[0]), deviator(vertices[1]), deviator(vertices[2]),
          deviator(vertices[3])};
}

LoopTetrahedron LoopTetrahedron::opposite() const {
  LoopTetrahedron result = *this;
  for (Tensor& t : result.vertices) t = Rational(-1) * t;
  return result;
}

namespace {

// A chart of space, its plane at infinity where a functional vanishes.
struct Chart {
  Coordinates infinity, origin;
  Eigen::Matrix<double, 4, 3> axes;
  Eigen::Matrix<double, 3, 4> inverse;

  explicit Chart(const Coordinates& n) : infinity(n), origin(n / n.squaredNorm()) {
    axes = Eigen::FullPivLU<Eigen::Matrix<double, 1, 4>>(n.transpose()).kernel();
    inverse = (axes.transpose() * axes).inverse() * axes.transpose();
  }
  Eigen::Vector3d place(const Coordinates& p) const {
    return inverse * (p / infinity.dot(p) - origin);
  }
};

// The tetrahedron with these corners. A vertex may be scaled by itself: 1000 units for its largest
// coordinate are enough.
std::array<Tensor, 4> rounded(const std::array<Eigen::Vector3d, 4>& corners, const Chart& chart,
                              const Loop& loop, const std::array<Rational, 3>& values) {
  const double root = std::sqrt(2.0);
  std::array<Tensor, 4> vertices;
  for (std::size_t i = 0; i < 4; ++i) {
    const Coordinates t = chart.origin + chart.axes * corners[i];
    const Eigen::Vector4d entries = {t[0] / loop.saddle().norm(), t[1] / root, t[2] / root,
                                     t[3] / root};
    const double size = 1000 / entries.cwiseAbs().maxCoeff();
    std::array<long, 4> whole;
    for (std::size_t k = 0; k < 4; ++k) {
      whole[k] = std::lround(size * entries[static_cast<Eigen::Index>(k)]);
    }
    vertices[i] = tensor_of_integers(values, whole);
  }
  return vertices;
}

// Whether all samples of the loop are inside by a few hundredths.
bool seems_inside(const LoopTetrahedron& t, const Loop& loop) {
  const Eigen::Matrix4d weights = weights_of(t, loop);
  for (const Coordinates& p : loop.points(150)) {
    const Eigen::Vector4d w = weights * p;
    if (w.minCoeff() < 0.03 * w.cwiseAbs().maxCoeff()) return false;
  }
  return true;
}

constexpr int kAttempts = 40;

}  // namespace

std::optional<LoopTetrahedron> tetrahedron_around_loop(const std::array<Rational, 3>& values,
                                                       const Rational& s, int side,
                                                       Random& random) {
  const Loop loop = loop_of(values, s, side);
  const std::vector<Coordinates> points = loop.points(60);
  LoopTetrahedron result{values, s, {}, side};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto infinity = positive_on(points, random);
    if (!infinity) continue;
    const Chart chart(*infinity);
    std::vector<Eigen::Vector3d> in_chart;
    for (const Coordinates& p : points) in_chart.push_back(chart.place(p));
    const auto corners = corners_around(in_chart, random);
    if (!corners) continue;
    result.vertices = rounded(*corners, chart, loop, values);
    if (field_rank(TetrahedronField<Rational>{result.deviators()}) != 4) continue;
    if (seems_inside(result, loop)) return result;
  }
  return std::nullopt;
}

const LoopTetrahedron& loop_of_handle() {
  static const LoopTetrahedron t = of_corners({5, 3, -8}, fraction(6, 25), {3, 24, 11});
  return t;
}

const LoopTetrahedron& loop_of_wide_handle() {
  static const LoopTetrahedron t = of_corners({2, 1, -3}, fraction(1, 4), {4, 12, 8});
  return t;
}

const LoopTetrahedron& loop_of_tube() {
  static const LoopTetrahedron t = {{Rational(2), Rational(1), Rational(-3)},
                                    fraction(1, 4),
                                    {{{8, -10, 2, -11, 6, -5},
                                      {-12, 15, -3, -5, 3, 7},
                                      {-4, 5, -1, 8, -5, 1},
                                      {12, -15, 3, 10, -5, -8}}},
                                    1};
  return t;
}

const LoopTetrahedron& loop_of_another_tube() {
  static const LoopTetrahedron t = {{Rational(3), Rational(1), Rational(-4)},
                                    fraction(11, 24),
                                    {{{-5, 7, -2, -11, 9, 3},
                                      {5, -7, 2, 9, -7, -2},
                                      {10, -14, 4, -7, 5, -7},
                                      {-15, 21, -6, 6, -5, 7}}},
                                    1};
  return t;
}

std::string text(const LoopTetrahedron& t) {
  return "characteristic tensor diag" +
         text(Vector3<Rational>{t.values[0], t.values[1], t.values[2]}) + ", s = " + t.s.str() +
         ", vertex tensors " + text(TetrahedronField<Rational>{t.deviators()});
}

}  // namespace tensortopo::theory
