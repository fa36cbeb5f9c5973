// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/fill_loop.hpp"

#include <array>
#include <vector>

#include "extract/patch/fill/polygon.hpp"
#include "extract/run/extractor_scalars.hpp"

namespace tensortopo {

template <class Scalar>
bool fill_loop(std::span<const BoundaryVertex> boundary, Patch<Scalar>& out) {
  // Nearly all boundary loops are short, and there are very many.
  std::array<PolygonCorner, kSmallPolygon> few;
  std::vector<PolygonCorner> many(boundary.size() > few.size() ? boundary.size() : 0);
  const auto corners = many.empty() ? std::span(few.data(), boundary.size()) : std::span(many);
  for (std::size_t i = 0; i < boundary.size(); ++i) corners[i] = {boundary[i].position, boundary[i].faces};
  const auto triangles = cut_polygon(corners);
  out.triangles.reserve(out.triangles.size() + triangles.size());
  for (const auto& t : triangles)
    out.triangles.push_back({boundary[static_cast<std::size_t>(t[0])].id,
                             boundary[static_cast<std::size_t>(t[1])].id,
                             boundary[static_cast<std::size_t>(t[2])].id});
  return !triangles.empty();
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template bool fill_loop(std::span<const BoundaryVertex>, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
