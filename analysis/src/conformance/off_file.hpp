// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace tensortopo {

/// The polygons of an .off file, its coordinates in double. VTK 9.1 has no reader of them.
///
/// Read is the text of Geomview's OFF with three coordinates a vertex: a vertex or a face a line,
/// `#` begins a comment. Normals and colours (NOFF, COFF, CNOFF) are passed over.
/// Throws IoError: another kind of OFF, less in the file than it declares, a number that is none, a
/// face that names a point that is not there.
vtkSmartPointer<vtkPolyData> read_off(const std::filesystem::path& file);

}  // namespace tensortopo
