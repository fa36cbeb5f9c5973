// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analyze/curvature/level_curvature.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

/// First and second derivatives of the smooth field that a mesh samples, at its vertices: those of
/// the quadratic polynomial that fits the tensors around best, by least squares (Z. Zhang and
/// A. Naga, A new finite element gradient recovery method: superconvergence property, 2005).
///
/// For a field with three derivatives on meshes of shape-regular tetrahedra of size h the first
/// ones have an error of order h^2, the second ones of order h. A linear field's own are found
/// exactly, up to rounding.
class RecoveredDerivatives {
 public:
  /// Fits at the vertices of these tetrahedra. In parallel; the result does not depend on threads.
  RecoveredDerivatives(const TetMesh& mesh, const std::vector<TetMesh::Index>& tets);

  /// The curvature of the smooth field's level through a point of a tetrahedron: by its tensor
  /// there, and by the vertices' derivatives, interpolated.
  /// @return nothing if a vertex has too few others around, the deviator or the gradient vanishes
  std::optional<LevelCurvature<double>> curvature(TetMesh::Index tet,
                                                  const Vector3<double>& point) const;

 private:
  struct Jet {
    std::array<Deviator<double>, 3> first;
    std::array<Deviator<double>, 6> second;  ///< xx, yy, zz, xy, yz, xz
  };
  /// @param unit  the tensors are multiplied by this
  static std::optional<Jet> fitted(const TetMesh& mesh, double unit, TetMesh::Index vertex,
                                   const std::vector<TetMesh::Index>& around);

  const TetMesh& mesh_;
  double scale_ = 1;  ///< of the tensors: a power of two that takes the largest near to 1
  std::vector<std::optional<Jet>> jets_;  ///< one a vertex of the mesh
};

}  // namespace tensortopo
