// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/poly_data_output.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo {
namespace {

int number_of(RidgeKind kind) { return kind == RidgeKind::ridge ? 1 : -1; }

}  // namespace

void add_array(vtkPolyData& data, const std::string& name, int components, std::size_t count,
               const std::function<std::array<double, 3>(std::size_t)>& value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto numbers = value(i);
    for (int k = 0; k < components; ++k)
      array->SetComponent(static_cast<vtkIdType>(i), k, numbers[static_cast<std::size_t>(k)]);
  }
  data.GetPointData()->AddArray(array);
}

void write_poly_data(vtkPolyData& data, const std::filesystem::path& file,
                     const std::vector<FileNote>& notes) {
  for (const FileNote& note : notes) {
    vtkNew<vtkStringArray> text;
    text->SetName(note.name.c_str());
    text->InsertNextValue(note.text);
    data.GetFieldData()->AddArray(text);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&data);
  writer->WriteToOutputStringOn();
  // ParaView 5.11 with a recent expat reads no appended data.
  writer->SetDataModeToBinary();
  if (writer->Write() == 0)
    throw IoError(IoError::Kind::unwritable, file, "VTK could not write it");
  write_text(file, writer->GetOutputString());
}

void write_ridges(const RidgeLines& ridges, const std::filesystem::path& file,
                  const std::vector<FileNote>& notes) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : ridges.points) points->InsertNextPoint(p.x, p.y, p.z);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> kinds, kinds_of_points;
  vtkNew<vtkDoubleArray> lengths, strengths;
  kinds->SetName("kind");
  kinds_of_points->SetName("kind");
  kinds_of_points->SetNumberOfValues(static_cast<vtkIdType>(ridges.points.size()));
  kinds_of_points->FillValue(0);
  lengths->SetName("length");
  strengths->SetName("line_strength");
  for (const auto& line : ridges.lines) {
    cells->InsertNextCell(static_cast<int>(line.points.size()));
    for (const auto v : line.points) {
      cells->InsertCellPoint(v);
      kinds_of_points->SetValue(v, number_of(line.kind));
    }
    kinds->InsertNextValue(number_of(line.kind));
    lengths->InsertNextValue(line.length);
    strengths->InsertNextValue(line.strength);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetCellData()->AddArray(kinds);
  data->GetCellData()->AddArray(lengths);
  data->GetCellData()->AddArray(strengths);
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    add_array(*data, name, 1, values.size(), [&](std::size_t i) {
      return std::array{values[i], 0.0, 0.0};
    });
  };
  data->GetPointData()->AddArray(kinds_of_points);
  add("curvature", ridges.curvature);
  add("other_curvature", ridges.other_curvature);
  add("strength", ridges.strength);
  data->GetPointData()->SetActiveScalars("curvature");
  write_poly_data(*data, file, notes);
}

}  // namespace tensortopo
