// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/fields/random_fields.hpp"
#include "tensortopo/extract/curve_arcs.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"

namespace tensortopo::test {
namespace {

TetMesh random_cube() {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20261129);
  return mesh;
}

TEST(ExtractOptions, ThatDoNotFitTheMeshAreRefused) {
  const TetMesh mesh = random_cube();
  const std::size_t tets = mesh.tets.size();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<ExtractOptions> wrong;
  const auto add = [&](const std::function<void(ExtractOptions&)>& change) {
    change(wrong.emplace_back());
  };
  for (const std::size_t length : {std::size_t{1}, tets - 1, tets + 1, std::size_t{5000}}) {
    add([&](ExtractOptions& o) { o.density.assign(length, 2.f); });
    add([&](ExtractOptions& o) { o.part.assign(length, 1); });
  }
  for (const double value : {0.0, -1.0, std::nan(""), kInfinity}) {
    add([&](ExtractOptions& o) { o.sampling.resolution = value; });
    add([&](ExtractOptions& o) {
      o.density.assign(tets, 1.f);
      o.density.back() = static_cast<float>(value);
    });
  }
  const ModeValue mode = ModeValue::parse("1/4");
  for (const ExtractOptions& options : wrong) {
    EXPECT_THROW(extract_mode_surface<double>(mesh, mode, options), std::invalid_argument);
    EXPECT_THROW(extract_degenerate_curves(mesh, Degeneracy::linear, options),
                 std::invalid_argument);
  }
  ExtractOptions right;
  right.density.assign(tets, 1.f);
  right.part.assign(tets, 0);
  EXPECT_EQ(extract_mode_surface<double>(mesh, mode, right).surface.triangles,
            extract_mode_surface<double>(mesh, mode).surface.triangles);
}

TEST(CurveArcs, OfLinesThatThereAreNotAreRefused) {
  const TetMesh mesh = random_cube();
  const CurveExtraction found = extract_degenerate_curves(mesh, Degeneracy::linear);
  const CurveArcs arcs(mesh, Degeneracy::linear, found.curves);
  ASSERT_FALSE(found.curves.lines.empty());
  EXPECT_THROW(arcs.separation(found.curves.lines.size()), std::invalid_argument);
  EXPECT_THROW(arcs.enclosed(found.curves.lines.size(), 1), std::invalid_argument);
  for (const int depth : {-1, CurveArcs::kDeepest + 1})
    EXPECT_THROW(arcs.enclosed(0, depth), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
