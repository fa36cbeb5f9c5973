// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

#include "tensortopo/sweep/local_change.hpp"

namespace tensortopo::test {
namespace {

Verdict verdict_of(char c) {
  return c == '+' ? Verdict::positive : c == '-' ? Verdict::negative : Verdict::unknown;
}

/// An octahedron with these signs at the ends of its three axes; half of it leaves out the last.
SignedLink octahedron(const std::string& signs, bool half = false) {
  SignedLink link;
  for (const char c : signs) link.signs.push_back(verdict_of(c));
  for (int x = 0; x < 2; ++x)
    for (int y = 2; y < 4; ++y)
      for (int z = 4; z < (half ? 5 : 6); ++z) link.triangles.push_back({x, y, z});
  return link;
}

void expect(const SignedLink& link, LocalChange change, int euler_change) {
  const LocalEffect effect = local_effect(link);
  EXPECT_EQ(name_of(effect.change), name_of(change));
  EXPECT_EQ(effect.euler_change, euler_change);
}

// Inside: a sphere is born, or dies; two discs become a tube, or the reverse.
TEST(LocalChange, InsideIsThatOfMorseTheory) {
  expect(octahedron("++++++"), LocalChange::birth, 2);
  expect(octahedron("++++--"), LocalChange::join, -2);
  expect(octahedron("++----"), LocalChange::split, 2);
  expect(octahedron("------"), LocalChange::death, -2);
  expect(octahedron("+-+-+-"), LocalChange::regular, 0);
  expect(octahedron("++++-+"), LocalChange::regular, 0);
}

// On the boundary, the mesh being on the side of the fifth vertex: a disc is born; a hole opens in
// a sheet; strips join and split; and where the mode passes through nothing happens.
TEST(LocalChange, OnTheBoundaryIsThatOfMorseTheory) {
  expect(octahedron("+++++", true), LocalChange::birth, 1);
  expect(octahedron("++++-", true), LocalChange::open, -1);
  expect(octahedron("----+", true), LocalChange::close, 1);
  expect(octahedron("-----", true), LocalChange::death, -1);
  expect(octahedron("++--+", true), LocalChange::join, -1);
  expect(octahedron("++---", true), LocalChange::split, 1);
  expect(octahedron("+-+++", true), LocalChange::regular, 0);
  EXPECT_TRUE(local_effect(octahedron("++++-", true)).on_boundary);
}

// Two sheets that are joined may be one elsewhere; a sheet that is born is one more for certain. No
// boundary loop is made inside.
TEST(LocalChange, BoundsTheGrowthOfComponentsAndLoops) {
  const auto bounds = [](const std::string& signs, bool half) {
    const LocalEffect effect = local_effect(octahedron(signs, half));
    return std::array{effect.components.least, effect.components.most, effect.boundary_loops.least,
                      effect.boundary_loops.most};
  };
  using Bounds = std::array<int, 4>;
  EXPECT_EQ(bounds("++++++", false), (Bounds{1, 1, 0, 0}));
  EXPECT_EQ(bounds("------", false), (Bounds{-1, -1, 0, 0}));
  EXPECT_EQ(bounds("++++--", false), (Bounds{-1, 0, 0, 0}));
  EXPECT_EQ(bounds("++----", false), (Bounds{0, 1, 0, 0}));
  EXPECT_EQ(bounds("+++++", true), (Bounds{1, 1, 1, 1}));
  EXPECT_EQ(bounds("++++-", true), (Bounds{0, 0, 1, 1}));
  EXPECT_EQ(bounds("----+", true), (Bounds{0, 0, -1, -1}));
  EXPECT_EQ(bounds("++--+", true), (Bounds{-1, 0, -1, 1}));
}

TEST(LocalChange, IsUndecidedWithoutSignsOrManifold) {
  expect(octahedron("+++++?"), LocalChange::undecided, 0);
  SignedLink two = octahedron("++++++");  // two spheres: a mesh pinched at a vertex
  const SignedLink other = two;
  for (const auto& t : other.triangles) two.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  two.signs.insert(two.signs.end(), other.signs.begin(), other.signs.end());
  expect(two, LocalChange::undecided, 0);
}

// The opposite mode runs the other way: births are deaths, and so on.
RC_GTEST_PROP(LocalChange, OfOppositeSignsIsOpposite, (const std::vector<bool>& up, bool half)) {
  RC_PRE(up.size() >= 6);
  std::string signs, opposite;
  for (std::size_t i = 0; i < (half ? 5u : 6u); ++i) {
    signs += up[i] ? '+' : '-';
    opposite += up[i] ? '-' : '+';
  }
  const auto one = local_effect(octahedron(signs, half)),
             other = local_effect(octahedron(opposite, half));
  RC_ASSERT(one.euler_change == -other.euler_change);
  const auto reverse = [](LocalChange change) {
    switch (change) {
      case LocalChange::birth:
        return LocalChange::death;
      case LocalChange::death:
        return LocalChange::birth;
      case LocalChange::join:
        return LocalChange::split;
      case LocalChange::split:
        return LocalChange::join;
      case LocalChange::open:
        return LocalChange::close;
      case LocalChange::close:
        return LocalChange::open;
      default:
        return change;
    }
  };
  RC_ASSERT(one.change == reverse(other.change));
}

}  // namespace
}  // namespace tensortopo::test
