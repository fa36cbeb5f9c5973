// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/input/domain_boundary.hpp"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

namespace tensortopo {
namespace {

using Face = std::array<TetMesh::Index, 3>;

struct KeyedFace {
  Face key;   // ascending
  Face face;  // as seen from outside
};

/// For each point the first one at its place.
std::vector<TetMesh::Index> first_at_place(const TetMesh& mesh) {
  std::vector<TetMesh::Index> order(mesh.points.size()), first(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](TetMesh::Index v) {
    const auto& p = mesh.points[static_cast<std::size_t>(v)];
    return std::tuple{p.x, p.y, p.z, v};
  };
  std::sort(order.begin(), order.end(),
            [&](TetMesh::Index v, TetMesh::Index w) { return place(v) < place(w); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto v = static_cast<std::size_t>(order[i]);
    first[v] = order[i];
    if (i == 0) continue;
    const auto before = static_cast<std::size_t>(order[i - 1]);
    const auto &p = mesh.points[v], &q = mesh.points[before];
    if (p.x == q.x && p.y == q.y && p.z == q.z) first[v] = first[before];
  }
  return first;
}

std::vector<KeyedFace> all_faces(const TetMesh& mesh) {
  const std::vector<TetMesh::Index> first = first_at_place(mesh);
  // Of a positive tetrahedron, counter-clockwise seen from outside.
  constexpr std::array<std::array<std::size_t, 3>, 4> outward{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::vector<KeyedFace> faces;
  faces.reserve(4 * mesh.tets.size());
  for (const auto& tet : mesh.tets) {
    for (const auto& corner : outward) {
      Face face;
      for (std::size_t i = 0; i < 3; ++i)
        face[i] = first[static_cast<std::size_t>(tet[corner[i]])];
      Face key = face;
      std::sort(key.begin(), key.end());
      faces.push_back({key, face});
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const KeyedFace& a, const KeyedFace& b) { return a.key < b.key; });
  return faces;
}

}  // namespace

vtkSmartPointer<vtkPolyData> domain_boundary(const TetMesh& mesh) {
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  const auto polygons = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> number(mesh.points.size(), -1);
  const auto point_of = [&](TetMesh::Index v) {
    vtkIdType& n = number[static_cast<std::size_t>(v)];
    if (n < 0) {
      const auto& p = mesh.points[static_cast<std::size_t>(v)];
      n = points->InsertNextPoint(p.x, p.y, p.z);
    }
    return n;
  };
  const std::vector<KeyedFace> faces = all_faces(mesh);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool same_as_last = i > 0 && faces[i - 1].key == faces[i].key;
    const bool same_as_next = i + 1 < faces.size() && faces[i + 1].key == faces[i].key;
    if (same_as_last || same_as_next) continue;
    const std::array<vtkIdType, 3> ids{point_of(faces[i].face[0]), point_of(faces[i].face[1]),
                                       point_of(faces[i].face[2])};
    polygons->InsertNextCell(3, ids.data());
  }
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  boundary->SetPoints(points);
  boundary->SetPolys(polygons);
  return boundary;
}

}  // namespace tensortopo
