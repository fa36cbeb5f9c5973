// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace tensortopo {

/// What a .vtp file holds for one mode: triangles or, for degenerate curves, polylines. Or what it
/// holds for one value of another invariant, or of ridges or valleys.
struct Sheet {
  std::optional<double> mode;  ///< nothing if the file has no array `mode`
  vtkSmartPointer<vtkPolyData> shape;
  std::optional<double> value = {};       ///< where it has an array `value` instead
  std::optional<double> ridge_kind = {};  ///< or `kind`: 1 ridges, -1 valleys
  bool is_unstable = false;  ///< cells whose array `stable` is 0, which are faded
};

/// What a .vtp file holds, with the types and marks of its arrays (integers as 64 bits); nothing,
/// where a field has no such surface. Throws IoError.
vtkSmartPointer<vtkPolyData> read_poly_data(const std::filesystem::path& file);

/// The sheets of what a file holds, by ascending mode (or value, or kind), with the normals that
/// the file gives; cells that the cell array `stable` says are not are sheets of their own; none if
/// that is neither triangles nor lines.
std::vector<Sheet> sheets_of(vtkPolyData* all);

}  // namespace tensortopo
