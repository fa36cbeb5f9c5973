// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "slab_grid.hpp"
#include "vtkTensorModeSurface.h"

namespace tensortopo {
namespace {

/// Two pieces with a layer of ghost cells and global ids: together, the triangles of the whole.
TEST(VtkFilters, TrianglesOfGhostsAreLeftOut) {
  using Triangle = std::vector<double>;
  const auto triangles = [](vtkPolyData* data) {
    std::vector<Triangle> list;
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
      Triangle t;
      for (int k = 0; k < 3; ++k) {
        double p[3];
        data->GetPoint(data->GetCell(i)->GetPointId(k), p);
        t.insert(t.end(), p, p + 3);
      }
      list.push_back(t);
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto extract = [&](vtkUnstructuredGrid* grid) {
    vtkNew<vtkTensorModeSurface> filter;
    filter->SetInputData(grid);
    filter->SetModes("0.5");
    filter->SetAllSamples(true);
    filter->Update();
    return triangles(filter->GetOutput(0));
  };
  const TetMesh& mesh = slab();
  std::vector<Triangle> both;
  for (int piece = 0; piece < 2; ++piece) {
    const auto is_own = [&](std::size_t t) {
      return (mesh.points[static_cast<std::size_t>(mesh.tets[t][0])].x < 50) == (piece == 0);
    };
    std::vector<int> used(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (is_own(t))
        for (const auto v : mesh.tets[t]) used[static_cast<std::size_t>(v)] = 1;
    const auto whole = grid_of(mesh);
    const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(whole->GetPoints());
    grid->GetPointData()->AddArray(whole->GetPointData()->GetArray("S"));
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const auto& v = mesh.tets[t];
      if (!is_own(t) && std::none_of(v.begin(), v.end(), [&](auto i) {
            return used[static_cast<std::size_t>(i)] == 1;
          }))
        continue;
      const vtkIdType ids[4]{v[0], v[1], v[2], v[3]};
      grid->InsertNextCell(VTK_TETRA, 4, ids);
      ghosts->InsertNextValue(is_own(t) ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    grid->GetCellData()->AddArray(ghosts);
    const auto part = extract(grid);
    EXPECT_GT(part.size(), 10u);
    both.insert(both.end(), part.begin(), part.end());
  }
  std::sort(both.begin(), both.end());
  EXPECT_EQ(both, extract(grid_of(mesh)));
}

}  // namespace
}  // namespace tensortopo
