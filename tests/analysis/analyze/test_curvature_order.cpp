// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "analyze/curvature/level_form.hpp"
#include "analyze/curvature/recovered_derivatives.hpp"
#include "analysis/analyze/level_cells.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/families/elastic_stress.hpp"
#include "tensortopo/families/kuhn_mesh.hpp"
#include "tensortopo/scalar/real.hpp"

namespace tensortopo::test {
namespace {

using Field = std::function<SymmetricTensor<Real50>(const Vector3<Real50>&)>;

// Neither is linear; the forces are outside the box.
SymmetricTensor<Real50> boussinesq(const Vector3<Real50>& x) {
  return boussinesq_stress<Real50>(x, Real50(1), Real50(3) / Real50(10));
}
SymmetricTensor<Real50> two_forces(const Vector3<Real50>& x) {
  const Vector3<Real50> place{Real50(2), Real50(0), Real50(1) / Real50(4)};
  return boussinesq(x) + kelvin_stress<Real50>(x - place, {Real50(1), Real50(-2), Real50(1)},
                                               Real50(3) / Real50(10));
}

SymmetricTensor<double> in_doubles(const SymmetricTensor<Real50>& t) {
  const auto d = [](const Real50& x) { return static_cast<double>(x); };
  return {d(t.xx), d(t.yy), d(t.zz), d(t.xy), d(t.yz), d(t.xz)};
}

// The curvature tensor of the field's own level, to some 20 digits: derivatives of the field by
// differences in 50.
SymmetricTensor<double> true_curvature(const Field& field, const Vector3<double>& point) {
  const Vector3<Real50> x = to<Real50>(point);
  const Real50 h("1e-10");
  const std::array<Vector3<Real50>, 3> axes{{{h, 0, 0}, {0, h, 0}, {0, 0, h}}};
  const auto t = [&](const Vector3<Real50>& p) { return deviator(field(p)); };
  const auto middle = t(x);
  std::array<Deviator<Real50>, 3> first;
  std::array<Deviator<Real50>, 6> second;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto forth = t(x + axes[i]), back = t(x - axes[i]);
    first[i] = Real50(1 / (2 * h)) * (forth - back);
    second[i] = Real50(1 / (h * h)) * (forth + back - Real50(2) * middle);
    const auto &a = axes[i], &b = axes[(i + 1) % 3];
    second[3 + i] =
        Real50(1 / (4 * h * h)) * (t(x + a + b) - t(x + a - b) - t(x - a + b) + t(x - a - b));
  }
  auto form = level_form(middle, first);
  const auto& s = second;
  form->hessian = form->hessian + SymmetricTensor<Real50>{form->along(s[0]), form->along(s[1]),
                                                          form->along(s[2]), form->along(s[3]),
                                                          form->along(s[4]), form->along(s[5])};
  return in_doubles(level_curvature(form->gradient, form->hessian)->tensor);
}

struct Errors {
  double of_pieces = 0, recovered = 0;  ///< root mean squares, of the mean square of the truth
};

// Over all corners of the triangles of one mode surface, on n x n x n lattices of tetrahedra.
Errors errors(const Field& field, const char* mode, int n) {
  TetMesh mesh = kuhn_box({n, n, n}, {0.2, 0.3, 0.5}, {1.2, 1.3, 1.5});
  sample_field(mesh, [&](const Vector3<double>& x) { return in_doubles(field(to<Real50>(x))); });
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse(mode)).surface;
  const RecoveredDerivatives derivatives(mesh, surface.tet);
  Errors sum;
  double size = 0;
  const auto difference = [](const SymmetricTensor<double>& s, const SymmetricTensor<double>& t) {
    return inner(s - t, s - t);
  };
  // Some hundred triangles tell as much as all.
  const std::size_t step = std::max<std::size_t>(1, surface.triangles.size() / 200);
  for (std::size_t i = 0; i < surface.triangles.size(); i += step) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(surface.tet[i])];
    Cell<double> cell;
    for (std::size_t k = 0; k < 4; ++k) {
      cell.points[k] = mesh.points[static_cast<std::size_t>(tet[k])];
      cell.tensors[k] = mesh.tensors[static_cast<std::size_t>(tet[k])];
    }
    for (const auto v : surface.triangles[i]) {
      const auto& x = surface.points[static_cast<std::size_t>(v)];
      const auto truth = true_curvature(field, x);
      sum.of_pieces += difference(cell.at(x)->tensor, truth);
      sum.recovered += difference(derivatives.curvature(surface.tet[i], x)->tensor, truth);
      size += inner(truth, truth);
    }
  }
  return {std::sqrt(sum.of_pieces / size), std::sqrt(sum.recovered / size)};
}

// A linear piece knows nothing of the field's second derivatives, which bend a level as much as the
// first ones do: its curvature is that of the piecewise linear field's surface, and no finer mesh
// brings it to that of the field which the mesh samples. With derivatives recovered at the vertices
// it converges; first order is what the theory gives for any mesh.
TEST(CurvatureOrder, OfRecoveredDerivativesIsAtLeastOne) {
  for (const auto& [field, mode] :
       {std::pair{Field(boussinesq), "-0.8"}, std::pair{Field(two_forces), "-0.5"}}) {
    const Errors coarse = errors(field, mode, 8), fine = errors(field, mode, 16);
    EXPECT_GT(fine.of_pieces, coarse.of_pieces / 1.5);
    EXPECT_LT(fine.recovered, coarse.recovered / 1.9);
  }
}

// Where the field is linear there is nothing to converge to.
TEST(CurvatureOrder, OfALinearFieldRecoveredDerivativesAreItsOwn) {
  const LinearField linear{
      {1, 0, -1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {1, -2, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0}};
  TetMesh mesh = kuhn_box({3, 3, 3}, {-1.1, -0.9, -1}, {1, 1.2, 1.1});
  sample_field(mesh, [&](const Vector3<double>& x) { return linear.at(x); });
  const SurfaceMesh surface = extract_mode_surface<double>(mesh, ModeValue::parse("1/5")).surface;
  ASSERT_GT(surface.triangles.size(), 100u);
  const RecoveredDerivatives derivatives(mesh, surface.tet);
  const auto cell = cell_of<double>(linear);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i]) {
      const auto& x = surface.points[static_cast<std::size_t>(v)];
      const auto k = derivatives.curvature(surface.tet[i], x);
      ASSERT_TRUE(k);
      EXPECT_NEAR(k->principal[0], cell.at(x)->principal[0], 1e-9);
      EXPECT_NEAR(k->principal[1], cell.at(x)->principal[1], 1e-9);
    }
}

}  // namespace
}  // namespace tensortopo::test
