// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

#include "bundled_fields.hpp"
#include "curve_checks.hpp"
#include "extract_case.hpp"
#include "symmetric_field.hpp"

// A compressed block with exact planes of symmetry and an axis that is degenerate all along.

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;

const SymmetricField& compressed_block() {
  static const SymmetricField field = [] {
    for (const auto& file : bundled_files())
      if (file.filename().string().rfind("s1_compress_off", 0) == 0)
        return made_symmetric(read(file));
    throw std::runtime_error("no bundled field of a compressed block");
  }();
  return field;
}

const SymmetricTensor<double>& tensor_at(const TetMesh& mesh, Index v) {
  return mesh.tensors[static_cast<std::size_t>(v)];
}

TEST(SymmetricTensors, AreDegenerateOnTheAxisAndSymmetricAcrossMirrors) {
  const auto& [mesh, axis] = compressed_block();
  EXPECT_EQ(axis.size(), 13u);
  for (const Index v : axis) {
    const auto& t = tensor_at(mesh, v);
    EXPECT_TRUE(t.xx == t.yy && t.xy == 0 && t.yz == 0 && t.xz == 0);
    EXPECT_LT(t.zz, t.xx);  // pressed: of mode -1, all along
  }
  std::size_t on_mirrors = 0;
  const auto expect_mirrored = [&](bool holds) {
    EXPECT_TRUE(holds);
    ++on_mirrors;
  };
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& [p, t] = std::pair{mesh.points[v], mesh.tensors[v]};
    if (p.x == 50) expect_mirrored(t.xy == 0 && t.xz == 0);
    if (p.y == 50) expect_mirrored(t.xy == 0 && t.yz == 0);
    if (p.x == p.y) expect_mirrored(t.xx == t.yy && t.xz == t.yz);
    if (p.x + p.y == 100) expect_mirrored(t.xx == t.yy && t.xz == -t.yz);
  }
  EXPECT_EQ(on_mirrors, 4u * 11 * 13);
}

class LevelsOfSymmetricBlock : public testing::TestWithParam<const char*> {};

TEST_P(LevelsOfSymmetricBlock, AreFlawlessSurfaces) {
  const TetMesh& mesh = compressed_block().mesh;
  const Extraction extraction = extract(mesh, GetParam());
  std::map<std::string, int> reasons;
  for (const auto& cell : extraction.unresolved) ++reasons[std::string(name_of(cell.reason))];
  std::cout << extraction.surface.triangles.size() << " triangles, "
            << summary(extraction.surface).components.size() << " components, "
            << extraction.statistics.vertices_on_level << " vertices on the level; left out:";
  for (const auto& [reason, count] : reasons) std::cout << ' ' << reason << ' ' << count;
  std::cout << '\n';
  EXPECT_EQ(flaws(extraction, mesh), "");
  EXPECT_FALSE(extraction.surface.triangles.empty());
  EXPECT_EQ(unresolved_text(extraction), "");
}

// The axis is a chain of edges of the mesh.
TEST(SymmetricBlock, HasItsAxisAmongItsPlanarDegenerateCurves) {
  const auto& [mesh, axis] = compressed_block();
  for (const Degeneracy kind : {Degeneracy::planar, Degeneracy::linear}) {
    const double mode = kind == Degeneracy::planar ? -1 : 1;
    SCOPED_TRACE(mode);
    const auto extraction = extract_degenerate_curves(mesh, kind);
    const auto known = curve_invariants(extraction.curves);
    std::cout << "mode " << mode << ": " << extraction.curves.lines.size() << " lines, "
              << known.components << " components, " << known.closed_components << " closed\n";
    for (const auto& cell : extraction.unresolved)
      std::cout << cell.tet << ' ' << name_of(cell.obstacle) << '\n';
    EXPECT_TRUE(extraction.unresolved.empty());
    EXPECT_EQ(flaws(extraction, mesh, mode), "");
    std::multiset<std::pair<Index, Index>> along;
    for (const auto& line : extraction.curves.lines) {
      const auto vertex = [&](Index v) {
        const auto& on = extraction.curves.carrier_vertices[static_cast<std::size_t>(v)];
        return on[1] < 0 ? on[0] : -1;
      };
      if (line.size() == 2) along.insert(std::minmax(vertex(line[0]), vertex(line[1])));
    }
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      EXPECT_EQ(along.count(std::minmax(axis[i], axis[i + 1])), mode < 0 ? 1u : 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, LevelsOfSymmetricBlock,
                         testing::Values("0", "1/2", "-1/2", "9/10", "-9/10", "999/1000", "-999/1000", "999999/1000000", "-999999/1000000"));

}  // namespace
}  // namespace tensortopo::test
