// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "degenerate_point_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "exact_degenerate_points.hpp"
#include "extract/cases/extract_case.hpp"
#include "tensortopo/field/critical_values.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {

namespace {

double mode_of_corner(const SymmetricTensor<double>& t) { return mode(deviator(t)); }

}  // namespace

void expect_a_loop_around_each_degenerate_point(const std::string& mode, int count,
                                                std::uint64_t seed) {
  SCOPED_TRACE("mode " + mode + ", " + announce(seed));
  Random random(seed);
  const ModeValue level = ModeValue::parse(mode);
  const bool is_linear = level.sign() > 0;
  const ModeValue end = ModeValue::parse((is_linear ? "0." : "-0.") + std::string(30, '9'));
  ExtractOptions options;
  options.keep_topology = true;
  int loops = 0, faces = 0;
  for (int trial = 0; trial < count; ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const auto extraction =
        extract_mode_surface<double>(reference_tet_mesh(tensors), level, options);
    ASSERT_EQ(unresolved_text(extraction), "");
    for (std::size_t omitted = 0; omitted < 4; ++omitted) {
      std::array<TetMesh::Index, 3> vertices{};
      std::array<SymmetricTensor<double>, 3> corners;
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != omitted) {
          vertices[k] = static_cast<TetMesh::Index>(i);
          corners[k++] = tensors[i];
        }
      const auto& all = extraction.topology.faces;
      const auto found = std::find_if(all.begin(), all.end(),
                                      [&](const auto& f) { return f.vertices == vertices; });
      if (found != all.end() && !found->arcs.empty()) continue;
      if (std::abs(mode_of_corner(corners[0])) > std::abs(level.approx())) continue;
      if (!is_free_of_critical_values(corners, level, end, OwnLevel::included)) continue;
      const auto exact = exact_degenerate_points(corners);
      if (!exact || exact->on_a_side) continue;
      const int seen = found == all.end() ? 0 : static_cast<int>(found->loops.size());
      EXPECT_EQ(seen, is_linear ? exact->linear : exact->planar) << exact_text(tensors);
      loops += seen;
      ++faces;
    }
  }
  std::cout << "mode " << mode << ": " << loops << " loops in " << faces << " faces\n";
  EXPECT_GT(2 * faces, count);
  EXPECT_GT(10 * loops, count);
}

}  // namespace tensortopo::test
