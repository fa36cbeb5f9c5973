// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_difference.hpp"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tensortopo::scenarios {

namespace {

using Tensor = SymmetricTensor<double>;

/// A mesh's tensors anywhere in it.
class Field {
 public:
  explicit Field(const TetMesh& mesh) : mesh_(mesh) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& p : mesh.points) points->InsertNextPoint(p.x, p.y, p.z);
    grid_->SetPoints(points);
    grid_->Allocate(static_cast<vtkIdType>(mesh.tets.size()));
    for (const auto& tet : mesh.tets) {
      const std::array<vtkIdType, 4> corners{tet[0], tet[1], tet[2], tet[3]};
      grid_->InsertNextCell(VTK_TETRA, 4, corners.data());
    }
    locator_->SetDataSet(grid_);
    locator_->BuildLocator();
  }

  Tensor at(const Vector3<double>& place) {
    const double x[3] = {place.x, place.y, place.z};
    double nearest[3], squared = 0, parametric[3], weights[4];
    vtkIdType found = -1;
    int part = 0;
    locator_->FindClosestPoint(x, nearest, cell_, found, part, squared);
    if (found < 0 || !(std::sqrt(squared) <= 1e-6 * grid_->GetLength()))
      throw std::invalid_argument(
          fmt::format("({}, {}, {}) is not in the other mesh", place.x, place.y, place.z));
    cell_->EvaluatePosition(nearest, nullptr, part, parametric, squared, weights);
    Tensor tensor{};
    for (std::size_t i = 0; i < 4; ++i)
      tensor = tensor + weights[i] * mesh_.tensors[as_size(mesh_.tets[as_size(found)][i])];
    return tensor;
  }

 private:
  const TetMesh& mesh_;
  vtkNew<vtkUnstructuredGrid> grid_;
  vtkNew<vtkStaticCellLocator> locator_;
  vtkNew<vtkGenericCell> cell_;
};

}  // namespace

std::vector<Tensor> tensors_at(const std::vector<Vector3<double>>& points, const TetMesh& mesh) {
  Field field(mesh);
  std::vector<Tensor> tensors;
  for (const auto& p : points) tensors.push_back(field.at(p));
  return tensors;
}

std::vector<double> deviator_differences(const TetMesh& at, const TetMesh& other) {
  const std::vector<Tensor> tensors = tensors_at(at.points, other);
  std::vector<double> differences;
  for (std::size_t v = 0; v < at.points.size(); ++v) {
    Tensor d = at.tensors[v] - tensors[v];
    const double mean = trace(d) / 3;
    d.xx -= mean, d.yy -= mean, d.zz -= mean;
    differences.push_back(std::sqrt(inner(d, d)) * (1 + 1e-12));
  }
  return differences;
}

}  // namespace tensortopo::scenarios
