// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/report/reports_of.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tensortopo/certify/residual_bound.hpp"

namespace tensortopo {

SurfaceReport surface_report(const TetMesh& mesh, const ModeValue& mode,
                             const Extraction& extraction) {
  SurfaceReport report;
  report.mode = mode;
  report.vertices = extraction.surface.points.size();
  report.triangles = extraction.surface.triangles.size();
  tbb::parallel_invoke(
      [&] {
        report.invariants = surface_invariants(extraction.surface);
        report.invariants.component.clear();
      },
      [&] {
        // Another method does not know.
        report.max_abs_residual = extraction.surface.residual.empty() && report.vertices > 0
                                      ? std::numeric_limits<double>::quiet_NaN()
                                      : residual_bound(mesh, mode, extraction.surface);
      });
  for (const UnresolvedCell& cell : extraction.unresolved) {
    ++report.unresolved[std::string(name_of(cell.reason))];
  }
  report.statistics = extraction.statistics;
  return report;
}

double share_outside(const SurfaceMesh& surface, const std::vector<TetMesh::Index>& tets) {
  double outside = 0, all = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    const auto& p = surface.points[as_size(t[0])];
    const auto n = cross(surface.points[as_size(t[1])] - p, surface.points[as_size(t[2])] - p);
    const double area = std::sqrt(dot(n, n)) / 2;
    all += area;
    if (!std::binary_search(tets.begin(), tets.end(), surface.tet[i])) outside += area;
  }
  return all > 0 ? outside / all : 1;
}

CurveReport curve_report(const ModeValue& mode, const CurveExtraction& extraction) {
  CurveReport report;
  report.mode = mode;
  report.invariants = curve_invariants(extraction.curves);
  for (const double r : extraction.curves.residual) {
    report.max_residual = std::max(report.max_residual, r);
  }
  for (const UnresolvedCurve& cell : extraction.unresolved) {
    ++report.unresolved[std::string(name_of(cell.obstacle))];
  }
  report.statistics = extraction.statistics;
  return report;
}

}  // namespace tensortopo
