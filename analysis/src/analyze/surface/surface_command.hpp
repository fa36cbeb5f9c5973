// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analyze/curvature/ridges.hpp"
#include "analyze/curvature/surface_curvature.hpp"
#include "analyze/surface/surface_quality.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/analysis/provenance.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {

/// Shape and quality of an extracted surface.
struct SurfaceCommand {
  std::filesystem::path surface;  ///< .vtp
  std::filesystem::path mesh;     ///< that it was extracted from; empty: no curvature of the field
  std::filesystem::path against;  ///< another .vtp to measure distances to; may be empty
  std::filesystem::path output;   ///< the surface with its curvature, .vtp; may be empty
  std::filesystem::path ridges;   ///< ridges and valleys of the surface, .vtp; may be empty
  RidgeFilter ridge_filter;       ///< of these
  bool recover = false;           ///< also the curvature by recovered derivatives; ridges by that
  bool smooth = false;            ///< also the curvature of the triangles as such
  ReadOptions read;               ///< of the mesh
  Provenance provenance;          ///< for the ridges
};

/// Over vertices at which a quantity is defined.
struct Quantiles {
  double least = 0, low = 0, median = 0, high = 0, greatest = 0;  ///< 0, 5, 50, 95, 100 %
};

struct CurvatureReport {
  std::size_t vertices = 0;  ///< with a curvature
  Quantiles first, second, mean, gauss;
  double total_gauss = 0;  ///< integral of the Gauss curvature, by thirds of the triangles' areas
};

/// What `RidgeLines` says of its lines.
struct RidgeReport {
  std::filesystem::path output;
  RidgeFilter filter;
  std::array<RidgeLines::Sum, 2> sums{};
  std::array<Quantiles, 2> strength{};  ///< of lines (the mean along each), before the filter
  std::size_t umbilic_triangles = 0, undefined_triangles = 0;
};

struct SurfaceAnalysis {
  std::filesystem::path surface;
  std::size_t vertices = 0, triangles = 0;
  SurfaceInvariants invariants;
  std::vector<double> part_modes;   ///< of each part, if the file has modes
  std::vector<double> part_values;  ///< and if it has values of another invariant
  TriangleQuality quality;

  std::optional<CurvatureReport> curvature;  ///< from the field
  Quantiles normal_jump;                     ///< in radians
  std::vector<Umbilic> umbilics;
  std::optional<CurvatureReport> recovered;  ///< from derivatives recovered at the mesh's vertices
  std::vector<Umbilic> recovered_umbilics;
  std::optional<RidgeReport> ridges;
  std::optional<CurvatureReport> smooth;  ///< from the triangles
  /// Between the mean curvatures of both, where both are defined: median of the differences.
  std::optional<double> median_difference;

  std::filesystem::path against;
  std::optional<SampledDistance> forth, back;
  std::filesystem::path output;
  std::vector<std::string> mesh_notes;  ///< of reading the mesh
  double seconds = 0;
};

/// Throws UsageError, IoError.
SurfaceAnalysis run_surface_analysis(const SurfaceCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const SurfaceAnalysis& analysis);
/// Tables for people. Ends with a newline.
std::string to_text(const SurfaceAnalysis& analysis);

}  // namespace tensortopo
