// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "calculix_files.hpp"
#include "reactions.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

Reactions reactions_in(const std::string& text) {
  const Folder folder;
  put(folder / "job.dat", text);
  return read_reactions(folder / "job.dat");
}

const std::string kNodes = " forces (fx,fy,fz) for set BOTTOM and time  0.1000000E+01\n\n";
const std::string kTotal = "\n total force (fx,fy,fz) for set BOTTOM and time  0.1000000E+01\n\n";

TEST(Reactions, EachAndTheTotalAreRead) {
  const Reactions written{{{0, {1, -2, 3}}, {6, {0.5, 0, 1e-30}}}, {1.5, -2, 3}};
  const Reactions found = reactions_in(dat_text(written));
  ASSERT_EQ(found.nodes.size(), 2u);
  EXPECT_EQ(found.nodes[1].point, 6);
  EXPECT_EQ(found.nodes[0].force, written.nodes[0].force);
  EXPECT_EQ(found.total, written.total);
}

TEST(Reactions, ExponentsOfThreeDigitsHaveNoLetter) {
  const auto found =
      reactions_in(kNodes + "  1  1.000000-120 -2.500000+101  3.0E+00\n" + kTotal + " 0.0 0.0 1-400\n");
  EXPECT_EQ(found.nodes.front().force, (Vector3<double>{1e-120, -2.5e101, 3}));
  EXPECT_EQ(found.total.z, 0);
}

TEST(Reactions, WhatIsMissingOrNoNumberIsRefused) {
  EXPECT_THROW(reactions_in(""), IoError);
  EXPECT_THROW(reactions_in(kNodes + "  1 1.0 2.0 3.0\n"), IoError);
  EXPECT_THROW(reactions_in(kTotal + " 1.0 2.0 3.0\n"), IoError);
  EXPECT_THROW(reactions_in(kNodes + "  1 1.0 NaN? 3.0\n" + kTotal + " 1 1 1\n"), IoError);
  EXPECT_THROW(reactions_in(kNodes + "  0 1.0 1.0 3.0\n" + kTotal + " 1 1 1\n"), IoError);
}

}  // namespace
}  // namespace tensortopo::test
