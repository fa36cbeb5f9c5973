// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "members.hpp"
#include "random_tet.hpp"
#include "support/compared.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo::test {

/// Which members of a box a field is compared with.
struct MemberChoice {
  int at_random = 0;              ///< so many
  bool towards_critical = false;  ///< or those of `members_that_may_differ`
};

/// Compares random fields in one tetrahedron with members of their boxes: those called stable have
/// the same signature in all members.
/// @param draw  draw(random, k): the features that are looked at in the k-th field, with
///              - stability(field): what is said of the tetrahedron
///              - signature(mesh): what extraction proved of them, and whether there are any
///              - may_differ(mesh, radii): as `members_that_may_differ`
template <class Draw>
void expect_the_same_in_members(std::uint64_t seed, int fields, const MemberChoice& choice,
                                const Draw& draw, Compared& compared) {
  constexpr std::array<double, 4> kShares{1e-4, 1e-3, 1e-2, 1e-1};
  int stable = 0, present = 0, unstable = 0;
  for (int k = 0; k < fields; ++k) {
    Random random(seed + static_cast<std::uint64_t>(k));
    const TetMesh mesh = random_tet(random);
    const auto features = draw(random, k);
    const double share = kShares[static_cast<std::size_t>(random.integer(0, 3))];
    const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, share, {}});
    if (features.stability(UncertainField(mesh, radii)) != Stability::stable) {
      ++unstable;
      continue;
    }
    ++stable;
    const auto [own, is_present] = features.signature(mesh);
    if (!own) continue;
    present += is_present;
    const auto compare = [&, &text = own](const TetMesh& member) {
      const auto other = features.signature(member).first;
      if (!other) return;
      ++compared;
      EXPECT_EQ(*text, *other) << "seed " << seed + static_cast<std::uint64_t>(k) << ", share "
                               << share;
    };
    if (choice.towards_critical)
      for (const TetMesh& member : features.may_differ(mesh, radii)) compare(member);
    for (int i = 0; i < choice.at_random; ++i) compare(random_member(mesh, radii, random));
  }
  std::cout << stable << " stable, " << present << " of them with features, " << unstable
            << " not; " << compared.so_far() << " members compared\n";
}

}  // namespace tensortopo::test
