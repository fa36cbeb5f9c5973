// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/surface_file.hpp"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>
#include <set>
#include <utility>

#include "tensortopo/io/io_error.hpp"

namespace tensortopo {
namespace {

// Notes that an algorithm complained, instead of printing it.
class Complaint : public vtkCommand {
 public:
  static Complaint* New() { return new Complaint; }
  void Execute(vtkObject*, unsigned long, void*) override { heard = true; }
  bool heard = false;
};

// The cells whose first point has the number.
vtkSmartPointer<vtkCellArray> select(vtkCellArray* cells, vtkDataArray* numbers, double number) {
  const auto selected = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
    cells->GetCellAtId(i, size, points);
    if (size > 0 && numbers->GetComponent(points[0], 0) == number) {
      selected->InsertNextCell(size, points);
    }
  }
  return selected;
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file) {
  if (!std::ifstream(file, std::ios::binary)) {
    throw IoError(IoError::Kind::unreadable, file, "cannot open");
  }
  vtkNew<Complaint> complaint;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, complaint);
  reader->AddObserver(vtkCommand::WarningEvent, complaint);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (complaint->heard || reader->GetErrorCode() != vtkErrorCode::NoError) {
    throw IoError(IoError::Kind::invalid, file, "is no readable .vtp file");
  }
  return reader->GetOutput();
}

std::vector<Sheet> read_sheets(const std::filesystem::path& file) {
  return sheets_of(read_poly_data(file));
}

std::vector<Sheet> sheets_of(vtkPolyData* all) {
  if (all->GetNumberOfPolys() + all->GetNumberOfLines() == 0) return {};
  vtkPointData* const data = all->GetPointData();
  if (vtkDataArray* const normals = data->GetArray("normal");
      normals != nullptr && normals->GetNumberOfComponents() == 3) {
    data->SetNormals(normals);
  }
  // What tells sheets apart: the first of these that the file has.
  for (const auto& [name, member] :
       {std::pair{"mode", &Sheet::mode}, {"value", &Sheet::value}, {"kind", &Sheet::ridge_kind}}) {
    vtkDataArray* const numbers = data->GetArray(name);
    if (numbers == nullptr) continue;
    std::set<double> values;
    for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      values.insert(numbers->GetComponent(i, 0));
    std::vector<Sheet> sheets;
    for (const double value : values) {
      const auto part = vtkSmartPointer<vtkPolyData>::New();
      part->SetPoints(all->GetPoints());
      part->GetPointData()->ShallowCopy(data);
      part->SetPolys(select(all->GetPolys(), numbers, value));
      part->SetLines(select(all->GetLines(), numbers, value));
      vtkNew<vtkCleanPolyData> used;  // drops the points of the others
      used->PointMergingOff();
      used->SetInputData(part);
      used->Update();
      sheets.push_back({std::nullopt, used->GetOutput()});
      sheets.back().*member = value;
    }
    return sheets;
  }
  return {{std::nullopt, all}};
}

}  // namespace tensortopo
