// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A bundled field as a grid of VTK.
#pragma once

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

inline const std::string kField = TENSORTOPO_DATA "/s4_slab_small_C3D8I.vtu";

/// The mesh as a grid of tensors "S", without any reader of VTK.
inline vtkSmartPointer<vtkUnstructuredGrid> grid_of(const TetMesh& mesh) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> tensors;
  tensors->SetName("S");
  tensors->SetNumberOfComponents(6);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    points->InsertNextPoint(p.x, p.y, p.z);
    const auto& t = mesh.tensors[v];
    const double row[6]{t.xx, t.yy, t.zz, t.xy, t.yz, t.xz};
    tensors->InsertNextTuple(row);
  }
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(tensors);
  for (const auto& t : mesh.tets) {
    const vtkIdType v[4]{t[0], t[1], t[2], t[3]};
    grid->InsertNextCell(VTK_TETRA, 4, v);
  }
  return grid;
}

inline const TetMesh& slab() {
  static const TetMesh mesh = read_mesh(kField).mesh;
  return mesh;
}

}  // namespace tensortopo
