// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/single_tets.hpp"

#include <stdexcept>
#include <utility>

#include "tensortopo/families/kuhn_mesh.hpp"

namespace tensortopo {

namespace {

using Tensor = SymmetricTensor<double>;

constexpr Tensor kShearXy{0, 0, 0, 1, 0, 0}, kShearYz{0, 0, 0, 0, 1, 0}, kShearXz{0, 0, 0, 0, 0, 1};

// The field constant + x dx + y dy on a triangle of the plane.
struct PlanarField {
  Tensor constant, dx, dy;
  std::array<std::array<double, 2>, 3> triangle;
};

PlanarField planar_field(int extrema) {
  switch (extrema) {
    case 2:  // A ring of extrema, perturbed so that one maximum and one saddle remain on it.
      return {{10, 10, -20, 0, 0, 0},
              {10, -10, 0, 0, 0, 1},
              {0, 0, 0, 10, 1, 0},
              {{{-16, -8}, {16, -8}, {0, 20}}}};
    case 3:  // One of the three is not degenerate.
      return {{-1, 2, -1, 0, 1, 1},
              {0, 1, -1, 2, 0, 1},
              {1, 0, -1, -1, 1, 2},
              {{{-3, -3}, {3, -3}, {0, 4}}}};
    case 4:  // Mode 3 sqrt(3) xy / (1 + x^2 + y^2)^(3/2): extrema at (+-1, +-1).
      return {kShearXy, kShearXz, kShearYz, {{{-4, -2}, {4, -2}, {0, 5}}}};
    default:
      throw std::invalid_argument("planar_extrema_tet: 2, 3 or 4 extrema");
  }
}

}  // namespace

TetMesh single_tet(const std::array<Vector3<double>, 4>& points,
                   const std::array<Tensor, 4>& tensors) {
  TetMesh mesh;
  mesh.points.assign(points.begin(), points.end());
  mesh.tensors.assign(tensors.begin(), tensors.end());
  const double volume =
      dot(points[1] - points[0], cross(points[2] - points[0], points[3] - points[0]));
  mesh.tets = {{0, 1, 2, 3}};
  if (volume < 0) std::swap(mesh.tets[0][2], mesh.tets[0][3]);
  mesh.cell_ids = {0};
  return mesh;
}

TetMesh random_tet(RandomSource& random) {
  std::array<Tensor, 4> tensors;
  for (auto& t : tensors) t = random.tensor();
  return single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, tensors);
}

TetMesh saddle_tet(double s, RandomSource& random) {
  constexpr double r = 0.5;  // half an edge of the cube that the tetrahedron stands in
  const std::array<Vector3<double>, 4> points{{{r, r, r}, {r, -r, -r}, {-r, r, -r}, {-r, -r, r}}};
  const auto q = random.quaternion();
  std::array<Tensor, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& p = points[i];
    tensors[i] = turned({3 + s, s - 3, -2 * s, p.x, p.z, p.y}, q);
  }
  return single_tet(points, tensors);
}

TetMesh planar_extrema_tet(int extrema, RandomSource& random) {
  const PlanarField field = planar_field(extrema);
  const auto q = random.quaternion();
  std::array<Vector3<double>, 4> points;
  std::array<Tensor, 4> tensors;
  Vector3<double> centre;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [x, y] = field.triangle[i];
    points[i] = {x, y, 0};
    centre = centre + 0.25 * points[i];
    const Tensor t = field.constant + x * field.dx + y * field.dy;
    tensors[i] = turned(t + 0x1p-6 * random.tensor(), q);
    tensors[3] = tensors[3] + 0.25 * tensors[i];
  }
  const double height = field.triangle[1][0] - field.triangle[0][0];
  points[3] = {centre.x, centre.y, height / 2};
  const double size = extrema == 2 ? 40 : 4;
  tensors[3] = tensors[3] + turned(size * random.tensor(), q);
  return single_tet(points, tensors);
}

TetMesh smooth_cube(int cells, RandomSource& random) {
  TetMesh mesh = kuhn_box({cells, cells, cells}, {-1, -1, -1}, {1, 1, 1});
  struct Term {
    int x, y, z;
    Tensor coefficient;
  };
  std::vector<Term> terms;
  for (int x = 0; x <= 3; ++x)
    for (int y = 0; x + y <= 3; ++y)
      for (int z = 0; x + y + z <= 3; ++z) terms.push_back({x, y, z, random.tensor()});
  const auto power = [](double b, int n) {
    double result = 1;
    for (int i = 0; i < n; ++i) result *= b;
    return result;
  };
  sample_field(mesh, [&](const Vector3<double>& p) {
    Tensor t;
    for (const Term& term : terms)
      t = t + (power(p.x, term.x) * power(p.y, term.y) * power(p.z, term.z)) * term.coefficient;
    return t;
  });
  return mesh;
}

TetMesh rough_cube(int cells, RandomSource& random) {
  TetMesh mesh = kuhn_box({cells, cells, cells}, {-1, -1, -1}, {1, 1, 1});
  for (auto& t : mesh.tensors) t = random.tensor();
  return mesh;
}

}  // namespace tensortopo
