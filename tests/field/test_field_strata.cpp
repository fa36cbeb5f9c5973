// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>

#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/field/field_strata.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "witness.hpp"

namespace tensortopo {
namespace {

using Tensors = std::array<SymmetricTensor<double>, 4>;

// Fields orthogonal to diag(l1, l2, l3), and so with this characteristic tensor up to a factor.
Tensors orthogonal_to_diagonal(double l1, double l2, double l3) {
  return {{{l2 - l3, l3 - l1, l1 - l2, 0, 0, 0},
           {0, 0, 0, 1, 0, 0},
           {0, 0, 0, 0, 1, 0},
           {0, 0, 0, 0, 0, 1}}};
}

TEST(FieldStrata, OfAGeneralField) {
  const FieldStrata strata = field_strata(orthogonal_to_diagonal(2, 1, -3));
  EXPECT_TRUE(strata.is_general());
  EXPECT_EQ(strata, (FieldStrata{.rank = 4}));
}

TEST(FieldStrata, OfSpecialCharacteristicTensors) {
  EXPECT_EQ(field_strata(orthogonal_to_diagonal(1, 0, -1)),
            (FieldStrata{.rank = 4, .neutral_characteristic = true}));
  EXPECT_EQ(field_strata(orthogonal_to_diagonal(1, 1, -2)),
            (FieldStrata{.rank = 4, .degenerate_characteristic = true}));
  // Next to them in doubles is not on them.
  const double above = 1 + std::numeric_limits<double>::epsilon();
  EXPECT_TRUE(field_strata(orthogonal_to_diagonal(above, 1, -1 - above)).is_general());
  EXPECT_TRUE(field_strata(orthogonal_to_diagonal(1, above - 1, -above)).is_general());
}

TEST(FieldStrata, OfAPlaneOfSymmetryAndOfCommutingTensors) {
  const Tensors block = {
      {{1, 2, 0, 3, 0, 0}, {0, 1, 5, 1, 0, 0}, {2, 2, 1, 7, 0, 0}, {1, 0, 0, 2, 0, 0}}};
  EXPECT_EQ(field_strata(block), (FieldStrata{.rank = 3, .common_eigenvector = true}));
  const Tensors diagonal = {
      {{1, 2, 0, 0, 0, 0}, {0, 1, 5, 0, 0, 0}, {2, 2, 1, 0, 0, 0}, {1, 0, 0, 0, 0, 0}}};
  EXPECT_EQ(field_strata(diagonal), (FieldStrata{.rank = 2, .common_eigenvector = true}));
}

TEST(FieldStrata, OfZeroVertices) {
  Tensors t = orthogonal_to_diagonal(2, 1, -3);
  t[1] = {7, 7, 7, 0, 0, 0};
  EXPECT_EQ(field_strata(t), (FieldStrata{.rank = 3, .zero_vertices = 1}));
  EXPECT_EQ(field_strata(Tensors{}),
            (FieldStrata{.rank = 0, .zero_vertices = 4, .common_eigenvector = true}));
}

TEST(FieldStrata, RefuseWhatIsNotFinite) {
  Tensors t = orthogonal_to_diagonal(2, 1, -3);
  t[2].xy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(field_strata(t), std::invalid_argument);
}

Rational random_rational() { return Rational(*rc::gen::inRange(-3, 4)); }

RC_GTEST_PROP(FieldStrata, AgreeWithRationals, ()) {
  Tensors tensors;
  TetrahedronField<Rational> field;
  for (std::size_t i = 0; i < 4; ++i) {
    const SymmetricTensor<Rational> t = {random_rational(), random_rational(), random_rational(),
                                         random_rational(), random_rational(), random_rational()};
    const auto number = [](const Rational& q) { return q.convert_to<double>(); };
    tensors[i] = {number(t.xx), number(t.yy), number(t.zz),
                  number(t.xy), number(t.yz), number(t.xz)};
    field.vertex[i] = deviator(t);
  }
  const FieldStrata strata = field_strata(tensors);
  const Deviator<Rational> direction = characteristic_direction(field);
  RC_ASSERT(strata.rank == field_rank(field));
  if (strata.rank == 4) {
    RC_ASSERT(strata.neutral_characteristic == (determinant_form(direction) == 0));
    RC_ASSERT(strata.degenerate_characteristic == (discriminant_form(direction) == 0));
  }
}

RC_GTEST_PROP(FieldStrata, CommonEigenvectorsSurviveARationalRotation, ()) {
  // (1, 2, 2), (2, 1, -2), (2, -2, 1) are orthogonal and of length 3: tensors with the first as an
  // eigenvector, in integers.
  const Vector3<double> e[3] = {{1, 2, 2}, {2, 1, -2}, {2, -2, 1}};
  const bool common = *rc::gen::arbitrary<bool>();
  Tensors tensors;
  for (auto& t : tensors) {
    const auto add = [&](const Vector3<double>& u, const Vector3<double>& w) {
      const double k = *rc::gen::inRange(-5, 6);
      t = t + SymmetricTensor<double>{2 * k * u.x * w.x,           2 * k * u.y * w.y,
                                      2 * k * u.z * w.z,           k * (u.x * w.y + u.y * w.x),
                                      k * (u.y * w.z + u.z * w.y), k * (u.x * w.z + u.z * w.x)};
    };
    add(e[0], e[0]), add(e[1], e[1]), add(e[1], e[2]);
    if (!common) add(e[0], e[1]), add(e[0], e[2]), add(e[2], e[2]);
  }
  const FieldStrata strata = field_strata(tensors);
  if (common) RC_ASSERT(strata.common_eigenvector && strata.rank <= 3);
  if (strata.rank == 4) RC_ASSERT(!strata.common_eigenvector);
}

}  // namespace
}  // namespace tensortopo
