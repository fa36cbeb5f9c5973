// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analyze/analyzed_mesh.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/persistence/mode_homology.hpp"

namespace tensortopo {

/// Persistence of the mode of a field.
struct PersistenceCommand {
  std::filesystem::path input;
  ReadOptions read;
  Provenance provenance;          ///< for the output
  std::filesystem::path output;   ///< .vtp, for the pairs; may be empty
  std::filesystem::path picture;  ///< .png; may be empty
};

struct PersistenceReport : AnalyzedMesh {
  std::vector<std::int64_t> cell_ids;
  ModePersistence persistence;
  ModeHomology homology;
  std::filesystem::path output, picture;
  double seconds = 0;

  /// All points and paths are proved, all curves known, and a mode is everywhere.
  bool is_proved() const;
  /// The changes that were found add up to the Betti numbers of the mesh.
  bool adds_up() const;
  /// Both.
  bool is_complete() const { return is_proved() && adds_up(); }
  /// Of all dimensions: first those of dimension 0.
  std::vector<PersistencePair> pairs() const;
};

/// Throws UsageError, IoError.
PersistenceReport run_persistence(const PersistenceCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const PersistenceReport& report);
/// Tables for people. Ends with a newline.
std::string to_text(const PersistenceReport& report);

}  // namespace tensortopo
