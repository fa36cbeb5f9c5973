// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tet/tet_legend.hpp"

#include "render/tet/sphere_scene.hpp"

namespace tensortopo {

void SphereSeen::add(const TetDirections& directions, const Vector3<double>& v, bool inside) {
  const bool neutral = directions.manifold().mode().sign == 0;
  if (const int sign = inside ? directions.sign_inside(v) : 0; sign != 0) {
    (neutral ? inside_neutral : sign > 0 ? inside_positive : inside_negative) = true;
    return;
  }
  switch (directions.kind(v)) {
    case DirectionKind::complex_domain:
      complex = true;
      break;
    case DirectionKind::positive:
      positive = true;
      break;
    case DirectionKind::negative:
      negative = true;
      break;
    case DirectionKind::mixed:
      (neutral ? neutral_mixed : mixed) = true;
      break;
  }
}

std::vector<LegendEntry> sphere_legend(const SphereSeen& seen, bool inside) {
  std::vector<LegendEntry> entries;
  const auto add = [&](bool there, const Colour& colour, const char* text) {
    if (there) entries.push_back({{colour, 1}, text});
  };
  const auto pale = [&](const Colour& c) { return inside ? mix(c, kWhite, kPale) : c; };
  add(seen.complex, inside ? mix(kComplexGrey, kWhite, kPaleGrey) : kComplexGrey, "complex domain");
  add(seen.positive, pale(kCyan), "two points of mode > 0");
  add(seen.negative, pale(kMagenta), "two points of mode < 0");
  add(seen.mixed, pale(kBlue), "one of each");
  add(seen.neutral_mixed, pale(kBlue), "one point of mode 0");
  add(seen.inside_positive, sheet_colour(1), "in the tetrahedron, mode > 0");
  add(seen.inside_negative, sheet_colour(-1), "in the tetrahedron, mode < 0");
  add(seen.inside_neutral, sheet_colour(0), "in the tetrahedron, mode 0");
  add(seen.curves, kFaceCurve, "mode curves on its faces");
  add(seen.boundary, kGreen, "complex domain's boundary in it");
  return entries;
}

std::vector<LegendEntry> space_legend(const std::vector<const TetSurface*>& surfaces, bool curves) {
  bool positive = false, negative = false, neutral = false, linear = false, planar = false;
  for (const TetSurface* one : surfaces) {
    for (const SurfaceMesh& surface : one->surfaces) {
      if (surface.triangles.empty()) continue;
      const double mode = surface.mode.front();
      (mode > 0 ? positive : mode < 0 ? negative : neutral) = true;
    }
    linear = linear || !one->curves[0].lines.empty();
    planar = planar || !one->curves[1].lines.empty();
  }
  std::vector<LegendEntry> entries;
  const auto add = [&](bool there, const Colour& colour, const char* text) {
    if (there) entries.push_back({{colour, 1}, text});
  };
  add(positive, sheet_colour(1), "mode > 0");
  add(negative, sheet_colour(-1), "mode < 0");
  add(neutral, sheet_colour(0), "mode 0, neutral");
  add(linear && curves, kGreen, "mode +1, linear degenerate");
  add(planar && curves, kYellow, "mode -1, planar degenerate");
  return entries;
}

}  // namespace tensortopo
