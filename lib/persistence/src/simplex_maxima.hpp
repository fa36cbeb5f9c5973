// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::persistence {

/// How large the mode may be at a point.
struct ModeBound {
  double high = 1;     ///< the mode is not larger,
  double gap_low = 0;  ///< and 1 - mode^2 not smaller
};

/// A point that may be a local maximum of the mode along an edge or a face.
struct SimplexMaximum {
  ModeBound bound;                  ///< of the mode there
  std::array<double, 4> weights{};  ///< about where
};

/// All local maxima of the mode along edges and faces, and perhaps other points. They are computed
/// when first asked for: not for several threads at once.
class SimplexMaxima {
 public:
  using Index = TetMesh::Index;
  /// Vertices in ascending order, -1 before them.
  using Simplex = std::array<Index, 4>;

  explicit SimplexMaxima(const TetMesh& mesh) : mesh_(mesh) {}
  /// The weights are those of the vertices in their order, and zero before them.
  const std::vector<SimplexMaximum>& along(const Simplex& simplex);

 private:
  const TetMesh& mesh_;
  std::map<Simplex, std::vector<SimplexMaximum>> maxima_;
};

/// The vertices of a simplex, without what fills up.
inline std::span<const TetMesh::Index> vertices_of(const SimplexMaxima::Simplex& simplex) {
  return {std::find_if(simplex.begin(), simplex.end(), [](TetMesh::Index v) { return v >= 0; }),
          simplex.end()};
}

/// The edges, faces and the whole of a tetrahedron.
std::array<SimplexMaxima::Simplex, 11> simplices_of(const TetMesh& mesh, TetMesh::Index tet);

}  // namespace tensortopo::persistence
