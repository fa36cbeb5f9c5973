// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Degenerate curves are counted in field arrays, one number for each kind.
#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include "slab_grid.hpp"
#include "tensortopo/modes/mode_extractor.hpp"
#include "vtkTensorDegenerateCurves.h"
#include "vtkTensorModeSurface.h"

namespace tensortopo {
namespace {

void expect_counted(vtkPolyData* output, const DegenerateCurves& expected) {
  vtkFieldData* data = output->GetFieldData();
  ASSERT_EQ(expected.parts.size(), 2u);
  for (vtkIdType i = 0; i < 2; ++i) {
    const auto number = [&](const char* name) { return data->GetArray(name)->GetComponent(i, 0); };
    const ModePart& part = expected.parts[static_cast<std::size_t>(i)];
    EXPECT_EQ(number("curve_mode"), part.mode.approx());
    EXPECT_EQ(number("components"), static_cast<double>(part.curve_invariants.components));
    EXPECT_EQ(number("closed_components"),
              static_cast<double>(part.curve_invariants.closed_components));
  }
}

TEST(VtkFilters, CountTheWholeCurves) {
  CurveRequest request;
  request.planar = true;
  const DegenerateCurves expected = ModeExtractor(slab()).curves(request);
  EXPECT_GT(expected.parts.front().curve_invariants.components, 1u);
  vtkNew<vtkTensorDegenerateCurves> curves;
  curves->SetInputData(grid_of(slab()));
  curves->Update();
  expect_counted(curves->GetOutput(0), expected);
  vtkNew<vtkTensorModeSurface> surface;
  surface->SetInputData(grid_of(slab()));
  surface->SetModes("0.5");
  surface->SetCurves(3);
  surface->Update();
  expect_counted(surface->GetOutput(1), expected);
}

}  // namespace
}  // namespace tensortopo
