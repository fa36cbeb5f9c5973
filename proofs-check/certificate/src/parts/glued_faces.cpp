// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/glued_faces.hpp"

#include <algorithm>

namespace certificate {
namespace {

/// A point as one of the parts has it.
struct PointOfPart {
  BorderPlace place;
  std::size_t part, point;
  auto operator<=>(const PointOfPart&) const = default;
};

/// Points of different parts at one place have one tensor.
void compare_points(std::span<const MeshBorder* const> borders, Ledger& ledger) {
  std::vector<PointOfPart> all;
  for (std::size_t p = 0; p < borders.size(); ++p)
    for (std::size_t i = 0; i < borders[p]->points.size(); ++i)
      all.push_back({borders[p]->points[i].place, p, i});
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0, first = 0, end = 0; i < all.size(); ++i) {
    if (i == end) {
      first = i;
      while (end < all.size() && all[end].place == all[first].place) ++end;
    }
    const auto &a = all[first], &b = all[i];
    if (a.part == all[end - 1].part ||
        borders[a.part]->points[a.point].tensor == borders[b.part]->points[b.point].tensor)
      continue;
    ledger.refute("point " + place_text(a.place), "one tensor",
                  "different tensors in parts " + std::to_string(a.part) + " and " +
                      std::to_string(b.part));
  }
}

std::vector<FaceOfPart> faces_of(std::span<const MeshBorder* const> borders) {
  std::vector<FaceOfPart> faces;
  for (std::size_t p = 0; p < borders.size(); ++p)
    for (std::uint32_t f = 0; f < borders[p]->faces.size(); ++f) {
      const auto& points = borders[p]->faces[f].points;
      const auto& all = borders[p]->points;
      faces.push_back({{all[points[0]].place, all[points[1]].place, all[points[2]].place}, p, f});
    }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

std::vector<GluedFace> glued_faces(std::span<const MeshBorder* const> borders, Ledger& ledger) {
  compare_points(borders, ledger);
  const auto faces = faces_of(borders);
  std::vector<GluedFace> result;
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    while (end < faces.size() && faces[end].places == faces[i].places) ++end;
    if (faces[i].part == faces[end - 1].part) continue;  // of one part, which may be torn
    const auto same = std::span(faces).subspan(i, end - i);
    std::string name = "face " + place_text(same[0].places[0]) + ' ' +
                       place_text(same[0].places[1]) + ' ' + place_text(same[0].places[2]) +
                       " of parts";
    for (const FaceOfPart& f : same) name += ' ' + std::to_string(f.part);
    const FaceOfPart &a = same[0], &b = same[1];
    if (same.size() > 2)
      ledger.refute(name, "two tetrahedra", std::to_string(same.size()) + " tetrahedra");
    else if (borders[a.part]->faces[a.face].side == borders[b.part]->faces[b.face].side)
      ledger.refute(name, "a tetrahedron on each side", "both on the same side");
    else
      result.push_back({a, b, std::move(name)});
  }
  return result;
}

}  // namespace certificate
