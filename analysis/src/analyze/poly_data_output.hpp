// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analyze/curvature/ridges.hpp"
#include "tensortopo/io/write_surface.hpp"

namespace tensortopo {

/// Adds point data: an array of so many numbers a point.
void add_array(vtkPolyData& data, const std::string& name, int components, std::size_t count,
               const std::function<std::array<double, 3>(std::size_t)>& value);

/// Writes a .vtp, whole or not at all, with the notes as field data. Throws IoError.
void write_poly_data(vtkPolyData& data, const std::filesystem::path& file,
                     const std::vector<FileNote>& notes);

/// Writes ridges and valleys as polylines: point data `kind` (1 on ridges, -1 on valleys),
/// `curvature`, `other_curvature`, `strength`; cell data `kind`, `length`; field data: the notes.
/// Throws IoError.
void write_ridges(const RidgeLines& ridges, const std::filesystem::path& file,
                  const std::vector<FileNote>& notes);

}  // namespace tensortopo
