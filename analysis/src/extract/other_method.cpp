// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/other_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/mesh/subdivide.hpp"

namespace tensortopo {

namespace {

constexpr std::size_t kMostTetrahedra = 100'000'000;

}  // namespace

Extraction OtherMethod::operator()(const TetMesh& mesh, const ModeValue& mode) {
  if (!fine_ && command_.subdivisions > 0) {
    if (mesh.tets.size() > kMostTetrahedra >> (3 * command_.subdivisions))
      throw UsageError(fmt::format("--subdivide: more than {} tetrahedra", kMostTetrahedra));
    fine_ = subdivide(mesh);
    for (int i = 1; i < command_.subdivisions; ++i) fine_ = subdivide(*fine_);
  }
  Extraction extraction;
  extraction.surface = command_.other(fine_ ? *fine_ : mesh, mode);
  // The parts of a tetrahedron follow each other.
  auto& tets = extraction.surface.tet;
  for (auto& t : tets) t >>= 3 * command_.subdivisions;
  auto crossed = tets;
  std::sort(crossed.begin(), crossed.end());
  const auto end = std::unique(crossed.begin(), crossed.end());
  extraction.statistics.tets_crossed = static_cast<std::size_t>(end - crossed.begin());
  return extraction;
}

}  // namespace tensortopo
