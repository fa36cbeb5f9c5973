// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "embedding/field_surface.hpp"
#include "extract/cases/bundled_fields.hpp"
#include "tensortopo/extract/embedded.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {
namespace {

struct Found {
  std::size_t triangles = 0, reported = 0;
};

/// Of all bundled fields (in the short suite of every other): no triangles intersect, all vertices
/// are on the level, and only in tetrahedra that are reported is a triangle against the gradient.
Found look_at(const std::string& text, const embedding::Mode& mode) {
  Found sum;
  for (const auto& file : tried_files()) {
    SCOPED_TRACE(file);
    const auto mesh = read(file);
    const auto field = embedding::field_of(mesh);
    const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse(text));
    const auto surface = embedding::surface_of(extraction.surface);
    const auto found = embedding::intersections(surface);
    EXPECT_GT(found.compared, surface.triangles.size());
    EXPECT_EQ(found.without_area, 0u);
    EXPECT_EQ(found.pairs.size(), 0u);
    EXPECT_TRUE(is_embedded(extraction.surface));
    const auto against = embedding::against_gradient(surface, field);
    EXPECT_EQ(against.compared, surface.triangles.size());
    const auto& reported = extraction.not_embedded;
    for (const auto t : against.at_centroid)
      EXPECT_TRUE(std::binary_search(reported.begin(), reported.end(), surface.tet[t]));
    EXPECT_EQ(tets_not_embedded(mesh, extraction.surface), reported);
    const auto off = embedding::residuals(surface, field, mode);
    EXPECT_EQ(off.compared, surface.points.size());
    EXPECT_EQ(off.off.size(), 0u);
    sum.triangles += surface.triangles.size();
    sum.reported += reported.size();
  }
  EXPECT_GT(sum.triangles, 0u);
  return sum;
}

TEST(BundledSurfaces, AreEmbeddedAtModeZero) { EXPECT_EQ(look_at("0", {0, 1}).reported, 0u); }

TEST(BundledSurfaces, AreEmbeddedAtModeOneHalf) {
  EXPECT_EQ(look_at("-1/2", {-1, 2}).reported, 0u);
}

TEST(BundledSurfaces, AreEmbeddedNextToModeOne) {
  EXPECT_EQ(look_at("999/1000", {999, 1000}).reported, 0u);
}

/// Without the option nothing is looked at, and what is wrong is there: the counter sees it.
TEST(BundledSurfaces, AreNotMendedUnlessAskedFor) {
  const auto mesh = read(bundled_files().front());
  ExtractOptions options;
  options.embedded = false;
  const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse("99/100"), options);
  EXPECT_TRUE(extraction.not_embedded.empty());
  EXPECT_GT(embedding::intersections(embedding::surface_of(extraction.surface)).pairs.size(), 0u);
  EXPECT_FALSE(is_embedded(extraction.surface));
  EXPECT_GT(tets_not_embedded(mesh, extraction.surface).size(), 0u);
}

}  // namespace
}  // namespace tensortopo::test
