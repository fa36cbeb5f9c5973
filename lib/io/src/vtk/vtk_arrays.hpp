// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include "tensortopo/tensor/vector3.hpp"

class vtkXMLWriter;

namespace tensortopo::detail {

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vector3<double>>& points);

/// Cells of the same number of corners.
template <std::size_t Corners>
vtkSmartPointer<vtkCellArray> vtk_cells(
    const std::vector<std::array<std::int32_t, Corners>>& cells);

/// Polylines; their points are counted from `first_point`.
vtkSmartPointer<vtkCellArray> vtk_lines(const std::vector<std::vector<std::int32_t>>& lines,
                                        std::size_t first_point);

/// What a VTK writer writes: little endian, inline binary, zlib with 64-bit headers.
std::string run_vtk_writer(vtkXMLWriter& writer);

}  // namespace tensortopo::detail
