// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The method that a command names, as if it were the extraction: it leaves nothing out, and counts
/// nothing but the tetrahedra with triangles.
class OtherMethod {
 public:
  /// @param command  outlives this; it names a method if this is called
  explicit OtherMethod(const ExtractCommand& command) : command_(command) {}

  /// The surface of a mode, in numbers of the mesh, which has to be the same in each call.
  /// @throws UsageError if it has to be subdivided into too many tetrahedra
  Extraction operator()(const TetMesh& mesh, const ModeValue& mode);

 private:
  const ExtractCommand& command_;
  std::optional<TetMesh> fine_;  ///< the mesh subdivided, if the command asks for that
};

}  // namespace tensortopo
