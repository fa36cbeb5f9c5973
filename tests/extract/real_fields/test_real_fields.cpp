// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

class RealFields : public testing::TestWithParam<std::size_t> {};

/// Each level on every other field, so that each field has every other level; in the short suite on
/// one.
TEST_P(RealFields, GiveFlawlessSurfaces) {
  const std::string mode = kLevels[GetParam()];
  const auto files = bundled_files();
  const std::size_t step = full_or_short<std::size_t>(2, 4);
  for (std::size_t f = GetParam() % step; f < files.size(); f += step) {
    const auto& file = files[f];
    SCOPED_TRACE(file.filename().string() + " at " + mode);
    const TetMesh mesh = read(file);
    const Extraction extraction = extract(mesh, mode);
    std::cout << file.filename().string() << " at " << mode << ": " << mesh.tets.size()
              << " tetrahedra, " << extraction.surface.triangles.size() << " triangles, "
              << summary(extraction.surface).components.size() << " components, "
              << extraction.unresolved.size() << " unresolved\n";
    EXPECT_EQ(flaws(extraction, mesh), "");
    EXPECT_EQ(extraction.statistics.vertices_on_level, 0u);
    // Symmetric bodies too: rounding breaks their symmetry.
    EXPECT_EQ(unresolved_text(extraction), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, RealFields, testing::Range(std::size_t{0}, kLevels.size()),
                         [](const auto& level) { return "level_" + std::to_string(level.param); });

TEST(ExampleData, IsThere) { EXPECT_GE(bundled_files().size(), 2u); }

}  // namespace
}  // namespace tensortopo::test
