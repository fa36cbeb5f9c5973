// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/extract_report.hpp"
#include "tensortopo/persistence/component_persistence.hpp"

namespace tensortopo {

/// Leaves out whole components of surfaces and curves that are smaller, or matter less, than a
/// command asks for. Those of which it is not known how much they matter stay.
class ComponentFilter {
 public:
  /// @param modes  of which an option must be able to have an effect
  /// Throws UsageError if the method comes without proofs, or what is written must be all there is.
  ComponentFilter(const ExtractCommand& command, std::span<const ModeValue> modes);

  std::optional<FilterReport> apply(const TetMesh& mesh, const ModeValue& mode,
                                    SurfaceMesh& surface);
  std::optional<FilterReport> apply(const TetMesh& mesh, const ModeValue& mode, CurveMesh& curves);

 private:
  void prepare(const TetMesh& mesh);

  double persistence_ = 0, area_ = 0, length_ = 0;  ///< least ones; 0 for any
  TetMesh mesh_;                                    ///< in canonical order, once it is needed
  std::vector<TetMesh::Index> numbers_;    ///< in `mesh_` of the vertices of the mesh given
  std::optional<PersistenceInput> input_;  ///< of `mesh_`
  ModePersistence mode_persistence_;
};

}  // namespace tensortopo
