// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/extract/level_simplex.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The deviators at the vertices of a mesh, each scaled by its own power of two to P in [3, 12).
///
/// Scaling a vertex tensor by a positive number is a projective change of the barycentric
/// coordinates in every simplex around it. It moves no level set and no sign, and keeps products
/// of degree six away from overflow whatever the magnitudes are.
template <class Scalar>
struct ScaledField {
  /// Takes the deviators of a valid mesh, which is kept by reference.
  explicit ScaledField(const TetMesh& mesh);

  const TetMesh* mesh;                    ///< the mesh that it was made of
  std::vector<Deviator<Scalar>> tensors;  ///< one for each vertex, scaled
  std::vector<int> exponents;  ///< tensors[i] = 2^exponents[i] * deviator of mesh->tensors[i]
  std::vector<char> is_zero;   ///< the deviator vanishes, exactly; no mode there

  /// The simplex on some vertices of the mesh; `above` is one flag a mesh vertex.
  template <std::size_t Vertices, class Container>
  LevelSimplex<Scalar, Vertices> simplex(const Container& vertices,
                                         const std::vector<char>& above) const {
    LevelSimplex<Scalar, Vertices> result;
    for (std::size_t i = 0; i < Vertices; ++i) {
      const auto v = static_cast<std::size_t>(vertices[i]);
      result.tensors[i] = tensors[v];
      result.above[i] = above[v] != 0;
      result.exact[i] = &mesh->tensors[v];
      result.exponents[i] = exponents[v];
    }
    return result;
  }
};

}  // namespace tensortopo
