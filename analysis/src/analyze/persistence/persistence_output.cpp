// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/persistence/persistence_output.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <limits>
#include <string>

#include "analyze/poly_data_output.hpp"

namespace tensortopo {
namespace {

int number_of_kind(PairKind kind) {
  return kind == PairKind::superlevel ? 1 : kind == PairKind::sublevel ? -1 : 0;
}

}  // namespace

void write_pairs(const std::vector<PersistencePair>& pairs, const std::filesystem::path& file,
                 const std::vector<FileNote>& notes) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const PersistencePair& pair : pairs) {
    const auto& end = pair.has_death ? pair.death_point : pair.birth_point;
    cells->InsertNextCell(2);
    cells->InsertCellPoint(
        points->InsertNextPoint(pair.birth_point.x, pair.birth_point.y, pair.birth_point.z));
    cells->InsertCellPoint(points->InsertNextPoint(end.x, end.y, end.z));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  const auto death_of = [](const PersistencePair& pair) {
    return pair.has_death ? pair.death.middle() : std::numeric_limits<double>::quiet_NaN();
  };
  add_array(*data, "mode", 1, 2 * pairs.size(), [&](std::size_t i) {
    const PersistencePair& pair = pairs[i / 2];
    return std::array{i % 2 == 0 ? pair.birth.middle() : death_of(pair), 0.0, 0.0};
  });
  const auto fill = [&](auto& array, const char* name, const auto& value) {
    array->SetName(name);
    for (const PersistencePair& pair : pairs) array->InsertNextValue(value(pair));
    data->GetCellData()->AddArray(array);
  };
  const auto add = [&](const char* name, const auto& value) {
    vtkNew<vtkDoubleArray> array;
    fill(array, name, value);
  };
  const auto add_integers = [&](const char* name, const auto& value) {
    vtkNew<vtkIntArray> array;
    fill(array, name, value);
  };
  add_integers("dimension", [](const auto& pair) { return pair.dimension; });
  add_integers("kind", [](const auto& pair) { return number_of_kind(pair.kind); });
  add("birth", [](const auto& pair) { return pair.birth.middle(); });
  add("death", death_of);
  add_integers("lasting", [](const auto& pair) { return pair.is_lasting ? 1 : 0; });
  add("angle_persistence", [](const auto& pair) { return angle_persistence(pair); });
  add("survives", [](const auto& pair) { return survived_noise(pair); });
  add_integers("curve",
               [](const auto& pair) { return pair.curve ? static_cast<int>(*pair.curve) : -1; });
  add_integers("tie", [](const auto& pair) { return pair.is_tie ? 1 : 0; });
  add_integers("certain", [](const auto& pair) { return pair.is_certain ? 1 : 0; });
  data->GetPointData()->SetActiveScalars("mode");
  write_poly_data(*data, file, notes);
}

}  // namespace tensortopo
