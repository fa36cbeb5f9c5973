// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk/vtk_arrays.hpp"

#include <stdexcept>

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLWriter.h>

namespace tensortopo::detail {

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vector3<double>>& points) {
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  double* out = coordinates->GetPointer(0);
  for (const auto& p : points) *out++ = p.x, *out++ = p.y, *out++ = p.z;
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(coordinates);
  return result;
}

template <std::size_t Corners>
vtkSmartPointer<vtkCellArray> vtk_cells(
    const std::vector<std::array<std::int32_t, Corners>>& cells) {
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(cells.size() + 1));
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(cells.size() * Corners));
  for (std::size_t c = 0; c <= cells.size(); ++c)
    offsets->SetValue(static_cast<vtkIdType>(c), static_cast<vtkTypeInt64>(c * Corners));
  vtkIdType next = 0;
  for (const auto& cell : cells)
    for (const std::int32_t v : cell) connectivity->SetValue(next++, v);
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, connectivity);
  return result;
}

template vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<std::array<std::int32_t, 3>>&);
template vtkSmartPointer<vtkCellArray> vtk_cells(const std::vector<std::array<std::int32_t, 4>>&);

vtkSmartPointer<vtkCellArray> vtk_lines(const std::vector<std::vector<std::int32_t>>& lines,
                                        std::size_t first_point) {
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->InsertNextValue(0);
  for (const auto& line : lines) {
    for (const std::int32_t v : line)
      connectivity->InsertNextValue(static_cast<vtkTypeInt64>(first_point) + v);
    offsets->InsertNextValue(connectivity->GetNumberOfValues());
  }
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, connectivity);
  return result;
}

std::string run_vtk_writer(vtkXMLWriter& writer) {
  writer.WriteToOutputStringOn();  // a disk cannot fail it, and its messages stay unsaid
  // Some readers in use, ParaView 5.11 with a recent expat among them, refuse appended data.
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToZLib();
  writer.SetCompressionLevel(1);  // most digits are noise: more effort saves one byte in a hundred
  writer.SetHeaderTypeToUInt64();
  writer.SetByteOrderToLittleEndian();
  if (writer.Write() != 1) throw std::runtime_error("VTK's writer failed");
  return writer.GetOutputString();
}

}  // namespace tensortopo::detail
