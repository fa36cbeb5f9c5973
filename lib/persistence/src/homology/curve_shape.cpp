// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "homology/curve_shape.hpp"

#include <algorithm>
#include <optional>

#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo::persistence {
namespace {

/// The boundary surface that holds the least simplex with two vertices of a curve.
std::optional<std::size_t> surface_of(const CurveMesh& curves, const MeshBoundary& boundary,
                                      std::size_t v, std::size_t w) {
  std::vector<TetMesh::Index> vertices;
  for (const std::size_t x : {v, w})
    for (const auto i : curves.carrier_vertices[x])
      if (i >= 0) vertices.push_back(i);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return boundary.surface_of(vertices);
}

}  // namespace

CurveShapes curve_shapes(const CurveExtraction& extraction, const MeshBoundary& boundary) {
  const CurveMesh& curves = extraction.curves;
  CurveShapes result;
  std::size_t count = 0;
  for (const auto c : curves.component) count = std::max(count, as_size(c) + 1);
  std::vector<CurveShape>& shapes = result.shapes;
  shapes.resize(count);
  // Only in these a curve runs in a face.
  std::vector<TetMesh::Index> special;
  for (const UnresolvedCurve& cell : extraction.special) special.push_back(cell.tet);
  std::vector<std::ptrdiff_t> component_of(curves.points.size(), -1);
  UnionFind touching(curves.points.size());
  for (std::size_t line = 0; line < curves.lines.size(); ++line) {
    const auto& row = curves.lines[line];
    const auto component = as_size(curves.component[line]);
    const bool is_special = std::binary_search(special.begin(), special.end(), curves.tet[line]);
    for (std::size_t i = 0; i < row.size(); ++i) {
      component_of[as_size(row[i])] = static_cast<std::ptrdiff_t>(component);
      if (i == 0) continue;
      ++shapes[component].loops;  // an edge
      if (!is_special || !surface_of(curves, boundary, as_size(row[i - 1]), as_size(row[i])))
        continue;
      result.are_known &= row.size() > 2;
      touching.unite(static_cast<std::uint32_t>(row[i - 1]), static_cast<std::uint32_t>(row[i]));
    }
  }
  for (std::size_t v = 0; v < component_of.size(); ++v) {
    if (component_of[v] < 0) continue;
    CurveShape& shape = shapes[static_cast<std::size_t>(component_of[v])];
    --shape.loops;
    if (touching.find(static_cast<std::uint32_t>(v)) != v) continue;
    if (const auto surface = surface_of(curves, boundary, v, v)) shape.contacts.push_back(*surface);
  }
  for (CurveShape& shape : shapes) ++shape.loops;
  return result;
}

}  // namespace tensortopo::persistence
