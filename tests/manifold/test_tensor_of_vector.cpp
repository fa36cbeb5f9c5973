// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "../field/witness.hpp"
#include "manifold_case.hpp"
#include "support/compared.hpp"
#include "tensortopo/manifold/asymmetric_field.hpp"
#include "tensortopo/tensor/eigen_decomposition.hpp"

namespace tensortopo {
namespace {

using Manifold = MediumEigenvectorManifold<Real50>;

RC_GTEST_PROP(TensorOfVector, IsAUnitFieldDirectionWithTheModeAndMediumEigenvectorAsked, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  RC_PRE(m.in_real_domain(v));
  const auto t = m.tensor_at(v);
  const auto& l = c.mode.eigenvalues;
  RC_ASSERT(abs(trace(t)) < tiny());
  RC_ASSERT(abs(Real50(norm(t) - 1)) < tiny());
  RC_ASSERT(norm(t * v - l[1] * v) < tiny());
  RC_ASSERT(abs(inner(t, c.characteristic->tensor)) < tiny());
  RC_ASSERT(abs(Real50(mode(deviator(t)) - c.mode.abs_mu)) < tiny());
}

RC_GTEST_PROP(TensorOfVector, HasTheMajorEigenvectorOfTheAsymmetricTensor, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  RC_PRE(m.boundary_function(v) > Real50("1e-12"));
  const auto basis = plane_basis(v);
  RC_ASSERT(norm(cross(basis[0], basis[1]) - v) < tiny());
  const auto eigen = real_eigensystem(asymmetric_tensor(*c.characteristic, c.mode, basis));
  RC_ASSERT(eigen.has_value());
  const auto in_space = [&](const std::array<Real50, 2>& x) {
    return x[0] * basis[0] + x[1] * basis[1];
  };
  // The field's dominant eigenvector is the major one of a tensor of positive mode.
  const Real50& largest = c.mode.eigenvalues[0];
  const auto major = in_space(eigen->vectors[0]), minor = in_space(eigen->vectors[1]);
  RC_ASSERT(norm(m.tensor_at(v) * major - largest * major) < tiny());
  RC_ASSERT(norm(m.tensor_at(-v) * minor - largest * minor) < tiny());
  const auto d = m.dominant_eigenvector(v);
  RC_ASSERT(abs(dot(d, v)) < tiny());
  RC_ASSERT(norm(cross(d, major)) < tiny());
}

RC_GTEST_PROP(TensorOfVector, AntipodalAsymmetricTensorIsTheAdjugate, ()) {
  const ManifoldCase c;
  c.manifold();
  const auto v = random_unit_vector();
  const auto [e1, e2] = plane_basis(v);
  const auto a = asymmetric_tensor(*c.characteristic, c.mode, {e1, e2});
  // (e2, e1) is right-handed about -v; back in the basis (e1, e2) rows and columns swap.
  const auto b = asymmetric_tensor(*c.characteristic, c.mode, {e2, e1});
  const Matrix2<Real50> swapped = {b.d, b.c, b.b, b.a};
  RC_ASSERT(abs(Real50(swapped.a - a.d)) < tiny() && abs(Real50(swapped.d - a.a)) < tiny());
  RC_ASSERT(abs(Real50(swapped.b + a.b)) < tiny() && abs(Real50(swapped.c + a.c)) < tiny());
}

RC_GTEST_PROP(TensorOfVector, BoundaryFunctionIsTheTheoremsPolynomial, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  const auto& t = c.characteristic->tensor;
  const Real50 alpha = dot(v, t * v), beta = dot(t * v, t * v);
  const Real50 expected = Real50(1) / 2 - beta + c.mode.cos_theta_squared * alpha * alpha / 4;
  RC_ASSERT(abs(Real50(m.boundary_function(v) - expected)) < tiny());
  RC_ASSERT(abs(Real50(m.boundary_function(-v) - expected)) < tiny());
}

RC_GTEST_PROP(TensorOfVector, RealDomainIsWhereTheAsymmetricTensorHasRealEigenvalues, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  RC_PRE(abs(m.boundary_function(v)) > tiny());
  const auto a = asymmetric_tensor(*c.characteristic, c.mode, plane_basis(v));
  RC_ASSERT(real_eigensystem(a).has_value() == m.in_real_domain(v));
  // A quarter of the discriminant of A's characteristic polynomial.
  const Real50 half = (a.a - a.d) / 2;
  RC_ASSERT(abs(Real50(half * half + a.b * a.c - m.boundary_function(v))) < tiny());
}

RC_GTEST_PROP(TensorOfVector, SigmaIsTheSignedRootOfTheBoundaryFunction, ()) {
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  RC_PRE(m.in_real_domain(v));
  const auto d = eigen_decomposition(m.tensor_at(v)).vectors[0];
  RC_PRE(c.mode.one_minus_s > 0);
  const auto& t = c.characteristic->tensor;
  const Real50 sigma = m.sigma(v, d);
  RC_ASSERT(abs(Real50(sigma - dot(d, t * cross(v, d)))) < tiny());
  RC_ASSERT(abs(Real50(sigma * sigma - m.boundary_function(v))) < tiny());
  RC_ASSERT(sigma <= tiny());
  RC_ASSERT(abs(Real50(m.sigma(-v, d) + sigma)) < tiny());
  // The eigenvalue of A on d is tr A / 2 - sigma.
  const auto basis = plane_basis(v);
  const auto a = asymmetric_tensor(*c.characteristic, c.mode, basis);
  const Real50 x = dot(basis[0], d), y = dot(basis[1], d);
  const Real50 value = x * (a.a * x + a.b * y) + y * (a.c * x + a.d * y);
  RC_ASSERT(abs(Real50(value - ((a.a + a.d) / 2 - sigma))) < Real50("1e-24"));
}

RC_GTEST_PROP(TensorOfVector, EqualsTheClosedFormWithoutSingularities, ()) {
  // t = -(l2/2) P + l2 v v^T + ((l1 - l3)/2) [(alpha s / 2) M + sqrt(Delta) [v]x M] / gs^2, as
  // matrices.
  const ManifoldCase c;
  const Manifold m = c.manifold();
  const auto v = random_unit_vector();
  const auto& tb = c.characteristic->tensor;
  const Real50 alpha = dot(v, tb * v), beta = dot(tb * v, tb * v);
  const Real50 gs2 = Real50(1) / 2 - beta + alpha * alpha / 4;
  const Real50 delta = gs2 - (c.mode.s * alpha / 2) * (c.mode.s * alpha / 2);
  RC_PRE(delta >= 0 && gs2 > Real50("1e-4"));
  const auto& l = c.mode.eigenvalues;
  const auto t = m.tensor_at(v);
  for (const auto& x :
       {Vector3<Real50>{1, 0, 0}, Vector3<Real50>{0, 1, 0}, Vector3<Real50>{0, 0, 1}}) {
    const auto px = x - dot(v, x) * v;
    const auto tpx = tb * px;
    const auto mx = tpx - dot(v, tpx) * v + Real50(alpha / 2) * px;
    const auto expected = Real50(-l[1] / 2) * px + Real50(l[1] * dot(v, x)) * v +
                          Real50((l[0] - l[2]) / 2 / gs2) * (Real50(alpha * c.mode.s / 2) * mx +
                                                             Real50(sqrt(delta)) * cross(v, mx));
    RC_ASSERT(norm(t * x - expected) < Real50("1e-38"));
  }
}

TEST(TensorOfVector, OfTheSingularitiesNeighbourhoodStaysExactInDoubles) {
  const auto characteristic =
      characteristic_tensor(witness::unit_tetrahedron<double>(witness::generic_1));
  const auto mode_1e9 = mode_parameter<double>(ModeValue::parse("1e-9"));
  const MediumEigenvectorManifold<double> m(*characteristic, mode_1e9);
  for (int i = 0; i < 100; ++i) {
    const auto v = m.boundary_point(i % 2, 0.0628 * i);
    EXPECT_LT(norm(v - m.singularities()[0]) < 1 ? norm(v - m.singularities()[0])
                                                 : norm(v - m.singularities()[1]),
              1e-8);
    for (const auto& t : {m.tensor_at(v), m.tensor_at(-v), m.tensor_at_boundary(v)}) {
      EXPECT_NEAR(norm(t), 1, 2e-15);
      EXPECT_LT(norm(t * v - mode_1e9.eigenvalues[1] * v), 2e-15);
      EXPECT_NEAR(mode(deviator(t)), 1e-9, 4e-15);
      EXPECT_NEAR(inner(t, characteristic->tensor), 0, 2e-15);
    }
  }
}

TEST(TensorOfVector, DoubleAgreesWithFiftyDigits) {
  test::Compared compared("tensors", 1000);
  for (const auto& f : witness::full_rank)
    for (const char* text : {"0", "0.2", "0.5", "0.95"}) {
      const MediumEigenvectorManifold<double> coarse(
          *characteristic_tensor(witness::unit_tetrahedron<double>(f)),
          mode_parameter<double>(ModeValue::parse(text)));
      const Manifold fine(*characteristic_tensor(witness::unit_tetrahedron<Real50>(f)),
                          mode_parameter<Real50>(ModeValue::parse(text)));
      // A neutral characteristic tensor has two signs, which rounding may choose differently.
      if (fine.characteristic().eigenvalues[1] < Real50("1e-12")) continue;
      for (int i = 0; i < 200; ++i) {
        const double z = (i - 99.5) / 100, a = 2.4 * i;
        const double r = std::sqrt(1 - z * z);
        const auto v = unit_vector<double>(r * std::cos(a), r * std::sin(a), z);
        const auto w = unit_vector<Real50>(v.x, v.y, v.z);
        const double delta = static_cast<double>(fine.boundary_function(w));
        EXPECT_NEAR(coarse.boundary_function(v), delta, 1e-15) << f.name;
        if (delta < 1e-6) continue;
        const auto t = coarse.tensor_at(v);
        const auto u = fine.tensor_at(w);
        const SymmetricTensor<Real50> difference = {t.xx - u.xx, t.yy - u.yy, t.zz - u.zz,
                                                    t.xy - u.xy, t.yz - u.yz, t.xz - u.xz};
        // The root at the boundary amplifies errors by 1 / sqrt(Delta).
        ++compared;
        EXPECT_LT(static_cast<double>(norm(difference)), 4e-15 / std::sqrt(delta))
            << f.name << ' ' << text << ' ' << delta;
      }
    }
}

}  // namespace
}  // namespace tensortopo
