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

/// Leaves out components of surfaces and curves that matter less than a command asks for. Those of
/// which it is not known how much they matter stay.
class PersistenceFilter {
 public:
  /// Throws UsageError if the method comes without proofs, or what is written must be all there is.
  explicit PersistenceFilter(const ExtractCommand& command);

  /// Nothing is asked for, and no member does anything.
  bool is_off() const { return !(least_ > 0); }

  std::optional<FilterReport> apply(const TetMesh& mesh, const ModeValue& mode,
                                    SurfaceMesh& surface);
  std::optional<FilterReport> apply(const TetMesh& mesh, const ModeValue& mode, CurveMesh& curves);

 private:
  void prepare(const TetMesh& mesh);

  double least_ = 0;
  std::optional<PersistenceInput> input_;  ///< once it is needed
  ModePersistence persistence_;
};

}  // namespace tensortopo
