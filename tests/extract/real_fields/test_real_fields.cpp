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

class RealFields : public testing::TestWithParam<const char*> {};

TEST_P(RealFields, GiveFlawlessSurfaces) {
  const std::string mode = GetParam();
  for (const auto& file : bundled_files()) {
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

INSTANTIATE_TEST_SUITE_P(Levels, RealFields, testing::ValuesIn(kLevels));

TEST(ExampleData, IsThere) { EXPECT_GE(bundled_files().size(), 1u); }

}  // namespace
}  // namespace tensortopo::test
