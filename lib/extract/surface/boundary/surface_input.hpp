// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "extract/level/critical/nearby_levels.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/extract/prepared_field.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

/// What every stage reads and none changes.
template <class Scalar>
struct SurfaceInput {
  using Index = TetMesh::Index;

  const TetMesh& mesh;
  const PreparedField<Scalar>& prepared;
  const ScaledField<Scalar>& field;
  const ExtractOptions& options;
  const Level<Scalar>& level;
  NearbyLevels<Scalar>& nearby_levels;  ///< made on demand; thread-safe

  /// The tensors at some vertices, as given.
  template <std::size_t Count>
  std::array<SymmetricTensor<double>, Count> tensors_of(
      const std::array<Index, Count>& vertices) const {
    std::array<SymmetricTensor<double>, Count> tensors;
    for (std::size_t i = 0; i < Count; ++i) tensors[i] = mesh.tensors[as_size(vertices[i])];
    return tensors;
  }

  /// The isotropic corners of a tetrahedron, as bits.
  unsigned zero_corners(const std::array<Index, 4>& tet) const {
    unsigned corners = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (field.is_zero[as_size(tet[i])]) corners |= 1u << i;
    return corners;
  }

  /// Whether one of some vertices is isotropic.
  template <std::size_t Count>
  bool has_zero_vertex(const std::array<Index, Count>& vertices) const {
    for (const Index v : vertices)
      if (field.is_zero[as_size(v)]) return true;
    return false;
  }

  const std::array<Index, 4>& vertices_of(const TetComplex& cells, std::size_t t) const {
    return mesh.tets[as_size(cells.tets[t])];
  }

  /// How densely a tetrahedron is sampled; a face as the denser one of its two.
  Sampling sampling_in(const TetComplex& cells, std::size_t t) const {
    Sampling sampling = options.sampling;
    if (!options.density.empty())
      sampling.resolution *= static_cast<double>(options.density[as_size(cells.tets[t])]);
    return sampling;
  }
  Sampling sampling_on(const TetComplex& cells, std::size_t f) const {
    Sampling sampling = options.sampling;
    if (options.density.empty()) return sampling;
    sampling.resolution = 0;
    for (const Index t : cells.face_tets[f])
      if (t >= 0)
        sampling.resolution =
            std::max(sampling.resolution, sampling_in(cells, as_size(t)).resolution);
    return sampling;
  }
};

}  // namespace tensortopo
