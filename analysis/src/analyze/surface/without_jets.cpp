// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// In the place of jet_curvature.cpp if what is under the GPL is not built.
#include "analyze/curvature/surface_curvature.hpp"
#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

void require_jets() {
  throw UsageError(
      "--smooth: this program was built without CGAL's jets (TENSORTOPO_WITH_CGAL_GPL=OFF); build "
      "it with ON, or take the curvature of the field (--mesh, --recover)");
}

std::vector<std::optional<LevelCurvature<double>>> jet_curvature(const SurfaceMesh&, std::size_t) {
  require_jets();
  return {};
}

}  // namespace tensortopo
