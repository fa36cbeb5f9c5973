// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/curve_checks.hpp"
#include "extract/cases/extract_case.hpp"
#include "real_field_laws.hpp"
#include "support/compared.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

class CurvesOfRealFields : public testing::TestWithParam<int> {};

TEST_P(CurvesOfRealFields, AreFlawlessAndComplete) {
  const Degeneracy kind = GetParam() > 0 ? Degeneracy::linear : Degeneracy::planar;
  for (const auto& file : tried_files()) {
    SCOPED_TRACE(file.filename().string());
    const TetMesh mesh = read(file);
    const auto extraction = extract_degenerate_curves(mesh, kind);
    const auto known = curve_invariants(extraction.curves);
    std::cout << file.filename().string() << ": " << extraction.curves.lines.size() << " lines, "
              << known.components << " components, " << known.closed_components << " closed, "
              << extraction.unresolved.size() << " unresolved\n";
    EXPECT_EQ(flaws(extraction, mesh, GetParam()), "");
    EXPECT_TRUE(extraction.unresolved.empty());
  }
}

// By continuity: between a point of mode 1 and a vertex below 0.999 there is one of mode 0.999.
TEST_P(CurvesOfRealFields, RunInsideTheTubesOfTheNearestModes) {
  Compared compared("pieces of curves", 10);
  const Degeneracy kind = GetParam() > 0 ? Degeneracy::linear : Degeneracy::planar;
  // Fields with planes of symmetry (s2, s3) take long so near to 1.
  for (const char* name : full_or_short<std::vector<const char*>>({"s1", "s4"}, {"s4"})) {
    const auto file = bundled_file(name);
    SCOPED_TRACE(file.filename().string());
    const TetMesh mesh = read(file);
    const auto extraction = extract_degenerate_curves(mesh, kind);
    const Extraction tubes = extract(mesh, GetParam() > 0 ? "999/1000" : "-999/1000");
    std::set<Index> crossed(tubes.surface.tet.begin(), tubes.surface.tet.end());
    for (const auto& cell : tubes.unresolved) crossed.insert(cell.tet);
    for (const Index t : extraction.curves.tet) {
      double least = 1;
      for (const Index v : mesh.tets[static_cast<std::size_t>(t)])
        least =
            std::min(least, GetParam() * mode(deviator(mesh.tensors[static_cast<std::size_t>(v)])));
      ++compared;
      EXPECT_TRUE(least >= 0.9989 || crossed.contains(t)) << "tetrahedron " << t;
    }
  }
}

TEST(FacesOfRealFields, ArePassedThroughAsOftenAsExactCountsSay) {
  for (const char* name : {"s1", "s2", "s3", "s4"}) expect_exact_counts_on_faces(name, 40);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CurvesOfRealFields, testing::Values(1, -1),
                         [](const auto& mode) { return mode.param > 0 ? "Linear" : "Planar"; });

}  // namespace
}  // namespace tensortopo::test
