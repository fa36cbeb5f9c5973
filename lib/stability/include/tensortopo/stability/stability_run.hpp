// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/mesh/cell_array.hpp"
#include "tensortopo/stability/level_stability.hpp"

namespace tensortopo {

/// What is stable of one level, or of degenerate curves of one kind.
struct StabilitySummary {
  /// Of all tetrahedra of the mesh.
  std::size_t stable_tets = 0, unstable_tets = 0;
  std::size_t crossed_stable_tets = 0;  ///< of those that hold triangles, or lines
  /// Vertices of a surface on edges of the mesh, or of curves on faces; and those of them of which
  /// the edge, or face, is crossed alike by all members.
  std::size_t crossings = 0, stable_crossings = 0;
  std::map<std::string, std::size_t> reasons;  ///< unstable tetrahedra by the reason's name
  std::map<std::string, std::size_t> crossing_reasons;  ///< crossings that are not stable, as well
  std::vector<SurfaceMesh::Index> components;  ///< stable ones, by smallest vertex, ascending
  /// The edges, or faces, with crossings of which a certificate claims that they are stable: their
  /// vertices, ascending (of edges the last is -1).
  std::vector<std::array<TetMesh::Index, 3>> crossed_simplices;
};

/// Components that are in every field whose deviators differ by at most a radius at each vertex:
/// what a certificate claims.
struct StabilityClaim {
  bool of_deviator = false;  ///< the radius is a share of each vertex' deviator, else absolute
  double radius = 0;         ///< in the Frobenius norm
  std::vector<SurfaceMesh::Index> components;  ///< as in `StabilitySummary`
  /// In place of `radius`, the input's array that has one for each vertex, and the SHA-256 of these
  /// (`numbers_sha256`); else empty.
  std::string array = {}, radii_sha256 = {};
  std::vector<std::array<TetMesh::Index, 3>> crossed_simplices = {};  ///< as in `StabilitySummary`
};

/// What is stable of surfaces and degenerate curves of one mesh, for reports and files.
class StabilityRun {
 public:
  /// Throws std::invalid_argument as `vertex_radii` does.
  /// @param mesh  valid (see `validate`); kept by reference
  StabilityRun(const TetMesh& mesh, const Uncertainty& uncertainty);

  /// The next level's surface, as it is written.
  /// @param options  its `progress` only
  StabilitySummary add(const ModeValue& mode, const ExtractOptions& options,
                       const Extraction& extraction);

  /// The next kind's degenerate curves, as they are written.
  /// @param options  its `progress` only
  StabilitySummary add(Degeneracy kind, const ExtractOptions& options,
                       const CurveExtraction& extraction);

  /// Of all triangles and lines so far: `instability`, the number of the reason (see `Stability`),
  /// and `stable`, 1 where that is 0, else 0. Of all vertices: `crossing_instability` and
  /// `crossing_stable`, the same of crossings (see `crossing_stability`), and -1 for other vertices.
  const std::vector<CellArray>& arrays() const { return arrays_; }

  /// What a certificate claims: not of components that are, or have a face in common with, what it
  /// leaves undecided, which may be more than what the extraction left out.
  /// Nothing if each vertex has a radius of its own, from no array of the input.
  /// @param summary    of the surface, or of the curves
  /// @param undecided  tetrahedra
  std::optional<StabilityClaim> claim(const StabilitySummary& summary, const SurfaceMesh& surface,
                                      const std::vector<TetMesh::Index>& undecided) const;
  /// The same of curves.
  std::optional<StabilityClaim> claim(const StabilitySummary& summary, const CurveMesh& curves,
                                      const std::vector<TetMesh::Index>& undecided) const;

 private:
  std::optional<StabilityClaim> claim(const StabilitySummary& summary,
                                      const std::vector<SurfaceMesh::Index>& beside) const;

  Uncertainty::Kind kind_;
  double value_;
  std::string array_, radii_sha256_;
  UncertainField field_;
  std::vector<CellArray> arrays_;
};

}  // namespace tensortopo
