// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <stdexcept>

#include "field_files.hpp"
#include "write_case.hpp"

namespace tensortopo::test {
namespace {

TEST(WriteCurves, VtpHoldsLinesAndTrianglesWithTheirArrays) {
  const auto file = temporary("both.vtp");
  const SurfaceMesh s = surface_of_two();
  const CurveMesh c = curve_of_three();
  const WriteReport report = write_surface(s, c, mesh_of_two(), file);
  EXPECT_EQ(report.arrays.size(), 8u);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 7);
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  vtkIdType size = 0;
  const vtkIdType* cell = nullptr;
  data->GetLines()->GetCellAtId(0, size, cell);
  EXPECT_EQ(std::vector<vtkIdType>(cell, cell + size), (std::vector<vtkIdType>{6, 4, 5}));
  const auto points = [&](const char* name, vtkIdType i) {
    return data->GetPointData()->GetArray(name)->GetComponent(i, 0);
  };
  EXPECT_EQ(points("mode", 3), 0.5);
  EXPECT_EQ(points("mode", 4), 1);
  EXPECT_EQ(points("separation", 0), 0);
  EXPECT_EQ(points("separation", 5), -1e-9);
  EXPECT_EQ(points("normal", 3), 0.6);
  EXPECT_EQ(points("normal", 4), 0);
  EXPECT_EQ(points("dominant_eigenvector", 4), 1);
  const auto cells = [&](const char* name, vtkIdType i) {
    return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
  };
  EXPECT_EQ(cells("tet", 0), 70);
  EXPECT_EQ(cells("tet", 2), 5e9);
  EXPECT_EQ(cells("component", 0), 1);
  EXPECT_EQ(cells("component", 2), 0);
}

TEST(WriteCurves, VtpOfCurvesAloneHasNoArraysOfSurfaces) {
  const auto arrays =
      write_surface(SurfaceMesh{}, curve_of_three(), mesh_of_two(), temporary("c.vtp")).arrays;
  EXPECT_EQ(arrays, (std::vector<std::string>{"mode", "dominant_eigenvector", "separation",
                                              "residual", "tet", "component"}));
}

TEST(WriteCurves, ObjHasPolylinesAndPlyHasEdges) {
  write_surface(surface_of_two(), curve_of_three(), mesh_of_two(), temporary("c.obj"));
  write_surface(surface_of_two(), curve_of_three(), mesh_of_two(), temporary("c.ply"));
  const std::string obj = slurp(temporary("c.obj")), ply = slurp(temporary("c.ply"));
  EXPECT_NE(obj.find("\nl 7 5 6\nl 6 7\n"), std::string::npos);
  EXPECT_NE(ply.find("element edge 3\nproperty int vertex1\nproperty int vertex2\nend_header\n"),
            std::string::npos);
  const std::size_t body = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), body + 7 * 32 + 2 * 13 + 3 * 8);
  std::int32_t ends[2];
  std::memcpy(ends, ply.data() + body + 7 * 32 + 2 * 13, 8);
  EXPECT_EQ(ends[0], 6);
  EXPECT_EQ(ends[1], 4);
}

TEST(WriteCurves, AreRefusedWhereTheFormatHasNoLinesOrTheDataDoNotFit) {
  for (const char* name : {"c.stl", "c.off"})
    EXPECT_THROW(write_surface({}, curve_of_three(), mesh_of_two(), temporary(name)), IoError);
  CurveMesh c = curve_of_three();
  c.lines[1][1] = 3;
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
  c = curve_of_three();
  c.separation.pop_back();
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
  c = curve_of_three();
  c.lines.push_back({1});
  c.tet.push_back(0), c.component.push_back(0);
  EXPECT_THROW(write_surface({}, c, mesh_of_two(), temporary("x.vtp")), std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
