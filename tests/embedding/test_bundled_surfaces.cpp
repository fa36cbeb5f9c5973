// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "embedding/field_surface.hpp"
#include "extract/bundled_fields.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {
namespace {

struct Defects {
  std::size_t pairs = 0, against = 0, off = 0, triangles = 0;
};

/// Of all bundled fields; vertices off the level and pairs in different tetrahedra there are none.
Defects defects(const std::string& text, const embedding::Mode& mode) {
  Defects sum;
  for (const auto& file : bundled_files()) {
    const auto mesh = read(file);
    const auto field = embedding::field_of(mesh);
    const auto surface = embedding::surface_of(
        extract_mode_surface<double>(mesh, ModeValue::parse(text)).surface);
    const auto found = embedding::intersections(surface);
    EXPECT_GT(found.compared, surface.triangles.size());
    EXPECT_EQ(found.without_area, 0u);
    for (const auto& pair : found.pairs)
      EXPECT_EQ(pair.where, embedding::Intersection::Where::one_sheet);
    const auto against = embedding::against_gradient(surface, field);
    EXPECT_EQ(against.compared, surface.triangles.size());
    const auto off = embedding::residuals(surface, field, mode);
    EXPECT_EQ(off.compared, surface.points.size());
    EXPECT_EQ(off.off, 0u);
    sum.pairs += found.pairs.size();
    sum.against += against.at_centroid.size();
    sum.triangles += surface.triangles.size();
  }
  EXPECT_GT(sum.triangles, 0u);
  return sum;
}

// Upper bounds that may only become smaller.
TEST(BundledSurfaces, AreEmbeddedAtModeZero) {
  const auto found = defects("0", {0, 1});
  EXPECT_EQ(found.pairs, 0u);
  EXPECT_LE(found.against, 54u);
}

TEST(BundledSurfaces, AreEmbeddedAtModeOneHalf) {
  const auto found = defects("-1/2", {-1, 2});
  EXPECT_LE(found.pairs, 17u);
  EXPECT_LE(found.against, 140u);
}

TEST(BundledSurfaces, AreEmbeddedNextToModeOne) {
  const auto found = defects("999/1000", {999, 1000});
  EXPECT_LE(found.pairs, 2769u);
  EXPECT_LE(found.against, 2198u);
}

}  // namespace
}  // namespace tensortopo::test
