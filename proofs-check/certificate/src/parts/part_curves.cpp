// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/part_curves.hpp"

#include <algorithm>

#include "claims/point_boxes.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

/// The components, and which one each vertex is in.
void count_curves(const CurveCase& c, PartCurves& part) {
  const auto& lines = c.curves.lines;
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  part.component.assign(c.curves.points.size(), kNone);
  part.line_ends.assign(c.curves.points.size(), 0);
  std::vector<std::uint32_t> number(c.curves.points.size(), kNone);
  const Array* whole = nullptr;
  for (const Array& array : c.curves.arrays)
    if (array.name == "whole_component" && array.of == "lines" && array.components == 1)
      whole = &array;
    else if (array.name == "whole_component")
      part.whole_is_elsewhere = true;
  UnionFind classes;
  for (const auto& line : lines)
    for (const std::uint32_t v : line) classes.join(line[0], v);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::uint32_t& known = number[classes.find(lines[l][0])];
    if (known == kNone) {
      known = static_cast<std::uint32_t>(part.components.size());
      part.components.emplace_back();
      if (whole != nullptr) part.components.back().said.whole = whole->numbers[l];
    }
    PartCurve& own = part.components[known];
    ++own.lines;
    if (whole != nullptr) own.said.hear(whole->numbers[l]);
    for (const std::uint32_t v : lines[l]) {
      if (part.component[v] == kNone) ++own.vertices;
      part.component[v] = known;
    }
    ++part.line_ends[lines[l].front()], ++part.line_ends[lines[l].back()];
  }
}

}  // namespace

void add_curves(const CurveCase& c, PartCurves& part) {
  count_curves(c, part);
  const auto faces = outer_faces(c.input);
  for (const Json& claim : c.claims["faces"]) {
    const std::array<Vertex, 3> vertices{claim[0].get<Vertex>(), claim[1].get<Vertex>(),
                                         claim[2].get<Vertex>()};
    const auto at = std::lower_bound(
        faces.begin(), faces.end(), vertices,
        [](const auto& face, const FaceCorners& corners) { return face.first < corners; });
    const CurveFace* const face = c.topology.face(vertices);
    if (face == nullptr || at == faces.end() || at->first != vertices) continue;
    const auto numbers = point_numbers(c, *face, claim);
    for (std::size_t n = 3; n < claim.size(); ++n) {
      const auto vertex = claim[n][0].get<std::uint32_t>();
      BorderCurvePoint& end = part.ends.emplace_back();
      end.face = static_cast<std::uint32_t>(at - faces.begin());
      if (numbers) end.number = (*numbers)[n - 3];
      end.vertex = vertex;
      end.place = place_of(c.curves.points[vertex]);
    }
  }
}

}  // namespace certificate
