// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "grids/cell_kind.hpp"

#include <algorithm>
#include <cstddef>

namespace tensortopo::detail {
namespace {

using Index = TetMesh::Index;
using Faces = std::vector<std::vector<std::size_t>>;

/// Corners of each face, in order around it.
const Faces& faces_of(std::uint8_t vtk_type) {
  static const Faces voxel{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  static const Faces hexahedron{{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
  static const Faces wedge{{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
  static const Faces pyramid{{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static const Faces pentagonal{{0, 4, 3, 2, 1}, {5, 6, 7, 8, 9}, {0, 1, 6, 5}, {1, 2, 7, 6},
                                {2, 3, 8, 7},    {3, 4, 9, 8},    {4, 0, 5, 9}};
  static const Faces hexagonal{{0, 5, 4, 3, 2, 1}, {6, 7, 8, 9, 10, 11}, {0, 1, 7, 6},
                               {1, 2, 8, 7},       {2, 3, 9, 8},         {3, 4, 10, 9},
                               {4, 5, 11, 10},     {5, 0, 6, 11}};
  static const Faces none;
  switch (vtk_type) {
    case 11:
      return voxel;
    case 12:
      return hexahedron;
    case 13:
      return wedge;
    case 14:
      return pyramid;
    case 15:
      return pentagonal;
    case 16:
      return hexagonal;
    default:
      return none;
  }
}

}  // namespace

CellKind cell_kind(std::uint8_t vtk_type) {
  using enum CellKind::Use;
  switch (vtk_type) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:  // linear
    case 21:
    case 22:
    case 23:
    case 28:
    case 30:
    case 34:
    case 35:
    case 36:  // quadratic
    case 51:
    case 52:
    case 53:
    case 54:
    case 60:
    case 61:
    case 62:
    case 63:  // parametric
    case 68:
    case 69:
    case 70:
    case 75:
    case 76:
    case 77:  // Lagrange, Bezier
      return {"cells of dimension below 3", skip, 0};
    case 10:
      return {"tetrahedra", tetrahedron, 4};
    case 11:
      return {"voxels", split, 8};
    case 12:
      return {"hexahedra", split, 8};
    case 13:
      return {"wedges", split, 6};
    case 14:
      return {"pyramids", split, 5};
    case 15:
      return {"pentagonal prisms", split, 10};
    case 16:
      return {"hexagonal prisms", split, 12};
    case 24:
      return {"quadratic tetrahedra", refuse, 0};
    case 25:
      return {"quadratic hexahedra", refuse, 0};
    case 26:
      return {"quadratic wedges", refuse, 0};
    case 27:
      return {"quadratic pyramids", refuse, 0};
    case 29:
      return {"triquadratic hexahedra", refuse, 0};
    case 31:
      return {"quadratic linear wedges", refuse, 0};
    case 32:
      return {"biquadratic quadratic wedges", refuse, 0};
    case 33:
      return {"biquadratic quadratic hexahedra", refuse, 0};
    case 37:
      return {"triquadratic pyramids", refuse, 0};
    case 41:
      return {"convex point sets", refuse, 0};
    case 42:
      return {"polyhedra", refuse, 0};
    case 55:
      return {"parametric tetrahedra", refuse, 0};
    case 56:
      return {"parametric hexahedra", refuse, 0};
    case 64:
      return {"higher-order tetrahedra", refuse, 0};
    case 65:
      return {"higher-order wedges", refuse, 0};
    case 66:
      return {"higher-order pyramids", refuse, 0};
    case 67:
      return {"higher-order hexahedra", refuse, 0};
    case 71:
      return {"Lagrange tetrahedra", refuse, 0};
    case 72:
      return {"Lagrange hexahedra", refuse, 0};
    case 73:
      return {"Lagrange wedges", refuse, 0};
    case 74:
      return {"Lagrange pyramids", refuse, 0};
    case 78:
      return {"Bezier tetrahedra", refuse, 0};
    case 79:
      return {"Bezier hexahedra", refuse, 0};
    case 80:
      return {"Bezier wedges", refuse, 0};
    case 81:
      return {"Bezier pyramids", refuse, 0};
    default:
      return {"cells of unknown type", unknown, 0};
  }
}

std::vector<std::array<Index, 4>> quadrilaterals(std::uint8_t vtk_type,
                                                 std::span<const Index> corners) {
  std::vector<std::array<Index, 4>> result;
  for (const auto& face : faces_of(vtk_type))
    if (face.size() == 4)
      result.push_back({corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]});
  return result;
}

void split_cell(std::uint8_t vtk_type, std::span<const Index> corners,
                std::vector<std::array<Index, 4>>& tets) {
  const Index apex = *std::min_element(corners.begin(), corners.end());
  for (const auto& face : faces_of(vtk_type)) {
    const auto vertex = [&](std::size_t i) { return corners[face[i % face.size()]]; };
    std::size_t least = 0;
    for (std::size_t i = 1; i < face.size(); ++i)
      if (vertex(i) < vertex(least)) least = i;
    if (vertex(least) == apex) continue;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Index p = vertex(least), q = vertex(least + i), r = vertex(least + i + 1);
      if (p != q && q != r && r != p) tets.push_back({apex, p, q, r});
    }
  }
}

}  // namespace tensortopo::detail
