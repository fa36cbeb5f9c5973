// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "extract/curves/points/curve_in_tet.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/extract/scaled_field.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {

/// The tetrahedron of a line, and the proved points of its faces between which the line's arc is.
struct LineEnds {
  std::array<Vector3<double>, 4> points;           ///< vertices
  std::array<SymmetricTensor<double>, 4> tensors;  ///< as given
  std::array<ScaledTensor, 4> scaled;              ///< the same, each with its power of two
  BoundaryPoint begin, end;  ///< the curve enters at `begin`, and `end` is the next point after it
  bool is_reversed = false;  ///< the line runs from `end` to `begin`
};

/// Finds the ends of lines again, as the extraction found them.
class LineFinder {
 public:
  LineFinder(const TetMesh& mesh, Degeneracy kind);
  LineFinder(const LineFinder&) = delete;
  LineFinder& operator=(const LineFinder&) = delete;

  /// Nothing if the line is not one of a tetrahedron in general position.
  std::optional<LineEnds> find(const CurveMesh& curves, std::size_t line) const;

 private:
  using Index = TetMesh::Index;

  FacePoints points_on(const std::array<Index, 3>& face) const;
  ScaledTensor tensor_at(Index vertex) const;

  Degeneracy kind_;
  CanonicalMesh canonical_;
  ScaledField<double> field_;
  std::vector<Index>
      vertex_;              ///< the number in the canonical mesh of each vertex of the mesh given
  std::vector<Index> tet_;  ///< the same of tetrahedra
};

}  // namespace tensortopo
