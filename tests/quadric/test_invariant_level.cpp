// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "convex_level.hpp"

namespace tensortopo {
namespace {

TEST(InvariantLevel, IsExact) {
  const auto level = InvariantLevel::parse(Invariant::magnitude, "0.3e9");
  EXPECT_EQ(level.text(), "300000000");
  EXPECT_EQ(InvariantLevel::parse(Invariant::anisotropy, "0.9").text(), "9/10");
}

TEST(InvariantLevel, RefusesWhatIsNoSurface) {
  for (const auto* text : {"0", "-1", "x", "", "1/0"})
    EXPECT_THROW(InvariantLevel::parse(Invariant::magnitude, text), std::invalid_argument) << text;
  EXPECT_NO_THROW(InvariantLevel::parse(Invariant::deviator_magnitude, "7"));
  EXPECT_THROW(InvariantLevel::parse(Invariant::anisotropy, "1"), std::invalid_argument);
  EXPECT_THROW(ConvexLevel(InvariantLevel::parse(Invariant::anisotropy, "1/2"), 0),
               std::invalid_argument);
}

TEST(InvariantLevel, NamesAreReadBack) {
  for (const auto which :
       {Invariant::magnitude, Invariant::deviator_magnitude, Invariant::anisotropy})
    EXPECT_EQ(invariant_named(name_of(which)), which);
  EXPECT_EQ(invariant_named("mode"), std::nullopt);
}

TEST(Invariant, OfKnownTensors) {
  const SymmetricTensor<double> t{1, 1, 4, 0, 0, 0};
  const SymmetricTensor<double> none{std::nan(""), 1, 1, 1, 1, 1};
  for (const auto invariant :
       {Invariant::magnitude, Invariant::deviator_magnitude, Invariant::anisotropy})
    EXPECT_TRUE(std::isnan(invariant_of(invariant, none)));
  EXPECT_DOUBLE_EQ(invariant_of(Invariant::magnitude, t), std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(invariant_of(Invariant::deviator_magnitude, t), std::sqrt(6.0));
  EXPECT_DOUBLE_EQ(invariant_of(Invariant::anisotropy, t), std::sqrt(1.0 / 3));
  const auto large = 1e300 * t;
  EXPECT_DOUBLE_EQ(invariant_of(Invariant::magnitude, large), 1e300 * std::sqrt(18.0));
  EXPECT_EQ(invariant_of(Invariant::anisotropy, {}), 0);
}

TEST(CellForm, KnowsWhatIsExactlyOnTheLevel) {
  const SymmetricTensor<double> on{3, 0, 0, 0, 2, 2}, off{3, 0, 0x1p-40, 0, 2, 2};  // |on| = 5
  const ConvexLevel five(InvariantLevel::parse(Invariant::magnitude, "5"), 0);
  const CellForm form(five, {&on, &off, &on, &off});
  EXPECT_EQ(form.side({1, 0, 0, 0}), Side::inside);
  EXPECT_TRUE(form.is_on_level({1, 0, 0, 0}));
  EXPECT_EQ(form.side({0, 1, 0, 0}), Side::outside);
  EXPECT_FALSE(form.is_on_level({0, 1, 0, 0}));
  EXPECT_GT(form.exact_answers(), 0u);
}

TEST(CellForm, TellsTheNappesOfAnAnisotropyApart) {
  const SymmetricTensor<double> up{1, 1, 1, 0, 0, 0}, down{-1, -1, -1, 0, 0, 0},
      across{1, -1, 0, 0, 0, 0}, zero{};
  const ConvexLevel half(InvariantLevel::parse(Invariant::anisotropy, "1/2"), -1);
  const CellForm form(half, {&up, &down, &across, &zero});
  EXPECT_EQ(form.side({1, 0, 0, 0}), Side::opposite);
  EXPECT_EQ(form.side({0, 1, 0, 0}), Side::inside);
  EXPECT_EQ(form.side({0, 0, 1, 0}), Side::outside);
  EXPECT_EQ(form.side({0, 0, 0, 1}), Side::zero);
  EXPECT_EQ(form.side({1, 1, 0, 0}), Side::zero);
  EXPECT_TRUE(form.holds_zero());
}

TEST(CellForm, FindsTheZeroTensorInATetrahedronAndOnlyThere) {
  const ConvexLevel half(InvariantLevel::parse(Invariant::anisotropy, "1/2"), 1);
  const SymmetricTensor<double> a{1, 2, 3, 4, 5, 6}, b{0, 1, -1, 2, 0, 3}, c{7, 0, 1, -2, 3, 0};
  const auto combined = [&](double x, double y, double z) { return x * a + y * b + z * c; };
  const auto inside = combined(-1, -2, -3), on_face = combined(-1, -2, 0),
             on_edge = combined(-4, 0, 0), beyond = combined(-1, 2, -3), apart = combined(1, 1, 1);
  EXPECT_TRUE(CellForm(half, {&a, &b, &c, &inside}).holds_zero());
  EXPECT_TRUE(CellForm(half, {&a, &on_face, &b, &c}).holds_zero());
  EXPECT_TRUE(CellForm(half, {&on_edge, &a, &b, &c}).holds_zero());
  EXPECT_FALSE(CellForm(half, {&a, &b, &beyond, &c}).holds_zero());
  EXPECT_FALSE(CellForm(half, {&a, &b, &c, &apart}).holds_zero());
  EXPECT_FALSE(CellForm(half, {&a, &a, &a, &a}).holds_zero());
}

}  // namespace
}  // namespace tensortopo
