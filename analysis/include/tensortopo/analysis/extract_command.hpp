// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tensortopo/analysis/extract_report.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// Samples per radian; a tetrahedron may take the square of ten times that.
inline constexpr double kLargestResolution = 1000;

/// Another way to a surface: with `points`, `triangles` and `tet`, as `baseline_surface` has them.
using Method = std::function<SurfaceMesh(const TetMesh&, const ModeValue&)>;

/// From a field in a file to the mode surfaces and degenerate curves in another.
struct ExtractCommand {
  std::filesystem::path input;
  std::filesystem::path output;  ///< .vtp, .ply, .obj, .off or .stl
  std::filesystem::path certificate;  ///< .json or .cbor; empty for none
  std::vector<ModeValue> modes;  ///< in this order; 1 and -1 are curves; repetitions count once
  Method other;          ///< instead of our own method
  int subdivisions = 0;  ///< of the mesh, in eight each time, for `other` alone
  bool only_neutral = false;  ///< `other` extracts mode 0 alone
  bool generalized = false;      ///< after each mode its opposite
  bool strict = false;           ///< write nothing if a tetrahedron stays unresolved
  ReadOptions read;
  Sampling sampling;
  MeshingMethod meshing = MeshingMethod::bisection;
  bool all_samples = false;  ///< `ExtractOptions::keep_samples`
  bool improve = false;  ///< surfaces by `improve_triangles`
  int pieces = 1;        ///< by `extract_in_pieces`, if more
  /// Most bytes that the program may hold; chooses `pieces`, which then must be 1. 0 for no limit.
  std::uint64_t memory = 0;
  bool stream = false;   ///< the field of a .pvtu piece by piece, by `extract_streamed`
  Provenance provenance;
  std::string uncertainty;  ///< of the field, as `parse_uncertainty` takes it, or array:NAME; empty for none
  /// Leave out components of less persistence, in radians of the signed Lode angle; 0 for none.
  double min_persistence = 0;
  double min_area = 0;    ///< leave out components of surfaces of less area; 0 for none
  double min_length = 0;  ///< leave out components of curves of less length; 0 for none
  double max_error = 0;  ///< largest distance to the level, proved; 0 for `sampling` alone
};

/// The mode that a person wrote, for surfaces and curves in double precision. Throws
/// std::invalid_argument as ModeValue::parse does, and for a mode that no double tells from 1 or
/// -1, whose surface would be a tube too thin to have triangles.
ModeValue parse_mode(std::string_view text);

/// Whether the mode is 1 or -1, exactly: where the field has it there are curves, not surfaces.
bool is_degenerate(const ModeValue& mode);

/// The kind of curves that such a mode stands for.
/// @param mode  degenerate
Degeneracy degeneracy_of(const ModeValue& mode);

/// The modes to extract, in order, each once. Throws UsageError for none.
std::vector<ModeValue> modes_to_extract(std::span<const ModeValue> modes, bool generalized);

/// Throws UsageError unless the extension names a format for surfaces, and for curves if they are
/// asked for.
void require_surface_extension(const std::filesystem::path& output, bool curves);

/// Reads, extracts each mode's surface or curves, and writes all of them to one file.
///
/// Laws      (1) the file depends on the input's bytes and the command only, not on the number of
///           threads; (2) on failure no file is left, and those that were there are untouched.
/// Throws    UsageError, IoError.
ExtractReport run_extract(const ExtractCommand& command, const Progress& progress = {});

}  // namespace tensortopo
