// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/analysis/certificate_report.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/quadric/extract_invariant_surface.hpp"

namespace tensortopo {

/// From a field in a file to level surfaces of an invariant other than the mode.
struct InvariantCommand {
  std::filesystem::path input;
  std::filesystem::path output;        ///< .vtp, .ply, .obj, .off or .stl
  std::vector<InvariantLevel> levels;  ///< in this order; repetitions count once
  int pieces = 2;                      ///< as in InvariantOptions
  std::filesystem::path certificate;   ///< .json or .cbor; empty: none
  bool strict = false;                 ///< write nothing if a tetrahedron stays unresolved
  ReadOptions read;
  Provenance provenance;
};

/// What is known of one surface.
struct InvariantSurfaceReport {
  InvariantLevel level;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  SurfaceInvariants topology;  ///< `component` is left empty
  double max_abs_residual = 0;
  std::size_t unresolved = 0;  ///< tetrahedra left out: they hold the zero tensor
  InvariantStatistics statistics;
};

/// What `run_invariant_extract` did.
struct InvariantReport {
  Provenance provenance;
  std::filesystem::path input;
  std::string sha256;
  std::string tensor_name;
  TensorComponents components;  ///< in the input
  std::size_t vertices = 0;
  std::size_t tetrahedra = 0;
  std::vector<std::string> notes;  ///< what reading repaired or skipped
  std::size_t cells_left_out = 0;  ///< of the input, by a condition
  TornFaces torn_faces;            ///< of the input

  std::vector<InvariantSurfaceReport> surfaces;
  std::vector<std::int64_t> unresolved;  ///< input ids of tetrahedra that some level omits

  std::filesystem::path output;
  bool written = false;
  std::uintmax_t bytes = 0;
  std::optional<CertificateReport> certificate;
  double seconds_read = 0, seconds_extract = 0, seconds_write = 0;
};

/// Reads, extracts each level's surface, and writes all of them to one file.
///
/// Laws      as those of `run_extract`.
/// Throws    UsageError, IoError.
InvariantReport run_invariant_extract(const InvariantCommand& command,
                                      const Progress& progress = {});

/// One JSON object with the keys of an `ExtractReport`; surfaces have `invariant`, `value` and
/// `value_exact` in place of `mode` and `mode_exact`. Ends without newline.
std::string to_json(const InvariantReport& report);

/// A table for people, one row a level. Ends with a newline.
std::string to_text(const InvariantReport& report);

/// "12 of 7200 tetrahedra unresolved (12 zero_tensor)"; empty if there are none.
std::string unresolved_line(const InvariantReport& report);

}  // namespace tensortopo
