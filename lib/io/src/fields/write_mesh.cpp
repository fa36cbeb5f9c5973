// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/write_mesh.hpp"

#include <array>
#include <stdexcept>

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "output/atomic_file.hpp"
#include "vtk/vtk_arrays.hpp"

namespace tensortopo {

void write_mesh(const TetMesh& mesh, const std::filesystem::path& file,
                const std::string& tensor_name) {
  if (mesh.tensors.size() != mesh.points.size())
    throw std::invalid_argument("write_mesh: the tensors are not one for each point");
  for (const auto& tet : mesh.tets)
    for (const auto v : tet)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.points.size())
        throw std::invalid_argument("write_mesh: a tetrahedron names a point that does not exist");

  vtkNew<vtkDoubleArray> tensors;
  tensors->SetName(tensor_name.c_str());
  tensors->SetNumberOfComponents(6);
  constexpr std::array names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  for (std::size_t i = 0; i < names.size(); ++i)
    tensors->SetComponentName(static_cast<vtkIdType>(i), names[i]);
  tensors->SetNumberOfTuples(static_cast<vtkIdType>(mesh.tensors.size()));
  double* out = tensors->GetPointer(0);
  for (const auto& t : mesh.tensors)
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) *out++ = x;

  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(detail::vtk_points(mesh.points));
  grid->SetCells(VTK_TETRA, detail::vtk_cells(mesh.tets));
  grid->GetPointData()->AddArray(tensors);
  grid->GetPointData()->SetActiveTensors(tensor_name.c_str());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  detail::write_atomically(file, detail::run_vtk_writer(*writer));
}

}  // namespace tensortopo
