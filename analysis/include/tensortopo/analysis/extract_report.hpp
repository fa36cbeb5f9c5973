// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/analysis/certificate_report.hpp"
#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/extract/predicate_counts.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"
#include "tensortopo/stability/stability_run.hpp"

namespace tensortopo {

/// What holds of a level for all fields within radii of the one that was read.
struct StabilityReport {
  std::string radius;  ///< as it was asked for
  StabilitySummary summary;
  double seconds = 0;
};

/// Components that were left out because they are too small or matter too little.
struct FilterReport {
  /// What was asked for of one measure.
  struct Limit {
    double least = 0;             ///< of the components that stay
    std::size_t left_out = 0;     ///< components
    std::size_t not_known = 0;    ///< components that stay because their measure is not known
    double largest_left_out = 0;  ///< measure
  };
  std::optional<Limit> size;         ///< area, or of curves length, in units of the mesh
  std::optional<Limit> persistence;  ///< in radians of the signed Lode angle

  /// The report, unless nothing was asked for.
  std::optional<FilterReport> of_filters() const {
    return size || persistence ? std::optional(*this) : std::nullopt;
  }
};

/// What is known of one extracted mode surface.
struct SurfaceReport {
  ModeValue mode;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  SurfaceInvariants invariants;  ///< `component` is left empty
  double max_abs_residual = 0;   ///< see `residual_bound`; NaN of the methods to compare
  std::optional<double> distance_bound;  ///< to the level, both ways, if proved
  std::size_t tets_farther = 0;  ///< tetrahedra without the distance that was asked for
  double area_within = 0;  ///< share of the area in the other tetrahedra, if a distance was asked for
  std::optional<std::int64_t> first_farther;  ///< the first of these, a cell of the file
  std::optional<std::size_t> not_embedded;  ///< see `Extraction`; not of the methods to compare
  /// See `is_embedded`; known if it was to be certified, or with --strict.
  std::optional<bool> embedded;
  std::map<std::string, std::size_t> unresolved;  ///< by the name of the reason
  std::optional<StabilityReport> stability;       ///< if the field was said to be uncertain
  std::optional<FilterReport> filter;             ///< if a filter was asked for
  std::optional<ImprovementCounts> improvement;   ///< if better triangles were asked for
  ExtractStatistics statistics;
};

/// What is known of the degenerate curves of one kind.
struct CurveReport {
  ModeValue mode;
  CurveInvariants invariants;
  double max_residual = 0;  ///< largest sqrt(1 - mode^2) at a vertex
  std::optional<StabilityReport> stability;  ///< if the field was said to be uncertain
  std::optional<FilterReport> filter;  ///< if a filter was asked for
  std::map<std::string, std::size_t> unresolved;
  CurveStatistics statistics;
};

/// A tetrahedron that some mode's surface or curve leaves out.
struct UnresolvedReport {
  std::int64_t cell = 0;  ///< id in the input file
  std::string reason;
  std::vector<ModeValue> modes;  ///< for which it is unresolved
};

/// What came of a limit of the memory.
struct MemoryReport {
  std::uint64_t limit = 0;      ///< bytes that were asked for
  std::uint64_t estimated = 0;  ///< bytes, before the extraction
  std::uint64_t peak = 0;       ///< bytes that the program has held; 0 where nothing was written
};

/// What `run_extract` did.
struct ExtractReport {
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

  std::int32_t pieces = 1;             ///< of the mesh, extracted one after the other
  std::optional<MemoryReport> memory;  ///< if a limit was asked for
  std::vector<SurfaceReport> surfaces;       ///< one for each mode between -1 and 1
  std::vector<CurveReport> curves;           ///< one for each of the modes 1 and -1
  std::vector<UnresolvedReport> unresolved;  ///< by cell id, then reason

  std::optional<CertificateReport> certificate;

  std::filesystem::path output;
  bool written = false;
  std::uintmax_t bytes = 0;

  PredicateCounts predicates;  ///< of surfaces and their certificates

  double seconds_read = 0, seconds_invariants = 0, seconds_write = 0;
  double seconds_extract = 0;  ///< all stages of all modes, by the clock
};

/// The number of tetrahedra unresolved for each reason, each counted once whatever the modes.
std::map<std::string, std::size_t> count_unresolved(const ExtractReport& report);

/// The statistics of all surfaces, added up; the seconds are those of curves too.
ExtractStatistics total_statistics(const ExtractReport& report);

/// One JSON object, with the keys that the command line's contract names. Ends without newline.
std::string to_json(const ExtractReport& report);

/// A table for people, one row a mode. Ends with a newline.
std::string to_text(const ExtractReport& report);

/// "12 of 7200 tetrahedra unresolved (10 budget_exhausted, ...)"; empty if there are none.
std::string unresolved_line(const ExtractReport& report);

/// Where tetrahedra are unresolved because the mode is constant on edges, on faces or in them: what
/// one can ask for instead. Empty if there are none of these.
std::string unresolved_advice(const ExtractReport& report);

/// What makes a surface useless to the eye though its topology is proved: vertices off the level, as
/// next to tensors that are isotropic but for rounding, triangles that are not embedded, a field
/// without a mode. One line each.
std::vector<std::string> doubtful_lines(const ExtractReport& report);

/// Whether no tetrahedron is unresolved, or farther from the level than was asked for, and no surface
/// doubtful: else `--strict` writes nothing.
bool is_flawless(const ExtractReport& report);

}  // namespace tensortopo
