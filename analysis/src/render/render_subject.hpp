// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

#include "render/input/surface_input.hpp"
#include "render/render_command.hpp"

namespace tensortopo {

/// What a command draws, read once and drawn at one mode after the other.
class RenderSubject {
 public:
  /// Reads the files. Throws UsageError (no such tetrahedron), IoError.
  explicit RenderSubject(const RenderCommand& command);

  /// What there is to say of reading the mesh.
  const std::vector<std::string>& mesh_notes() const { return mesh_notes_; }

  /// The surfaces that hold neither triangles nor lines.
  const std::vector<std::filesystem::path>& empty() const { return empty_; }

  /// One picture; adds to the report's modes and notes. Needs a display. Throws IoError where a
  /// tetrahedron has no manifold, std::runtime_error where nothing can be drawn.
  vtkSmartPointer<vtkImageData> picture(const std::vector<ModeValue>& modes, RenderReport& report);

 private:
  std::vector<Sheet> extracted(const ModeValue& mode, RenderReport& report) const;
  Sheet extracted(const InvariantLevel& level, RenderReport& report) const;

  const RenderCommand& command_;
  TetMesh mesh_;
  FieldOrigin field_;
  std::vector<std::string> mesh_notes_;
  std::vector<Sheet> sheets_;
  std::vector<std::filesystem::path> empty_;
  vtkSmartPointer<vtkPolyData> domain_;
  std::size_t tet_ = 0;
};

}  // namespace tensortopo
