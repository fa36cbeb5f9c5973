// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "extract/surface/mesh_level.hpp"

namespace tensortopo {

/// Where the level runs through a vertex, samples of its edges fall together there, and a sheet
/// that is a cylinder around the vertex by the rule mu + 0 cannot be told from a cone. Around such
/// vertices a level next to mu is extracted instead, which keeps off them.
/// @return of each vertex of the mesh whether it is one of those; nothing if none is
template <class Scalar>
std::vector<char> keep_off_pinched(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                   const CellMeshes<Scalar>& meshes, VertexSides& sides);

/// Samples that are there only to leave no `PatchDefects` can be too close to each other for a
/// tetrahedron to be meshed with them. Around such a tetrahedron triangles stay as they are meshed
/// first.
/// @return as `keep_off_pinched`, the vertices of such tetrahedra
template <class Scalar>
std::vector<char> keep_as_meshed(const SurfaceInput<Scalar>& input, const TetComplex& cells,
                                 const CellMeshes<Scalar>& meshes, VertexSides& sides);

/// `mesh_level` after `keep_off_pinched` or `keep_as_meshed`, of those tetrahedra only that it
/// changes: those at the vertices, and those that share samples of a face with them. The result is
/// the one of all tetrahedra done again.
///
/// A tetrahedron depends on another only by samples that either asks for on their face, and by the
/// density of sampling, which a face has from the denser one. So tetrahedra go together where a
/// face between them got further samples, in the first pass or in this one, or where their
/// densities differ.
/// @param changed  see `keep_off_pinched`, `keep_as_meshed`
/// @return how many tetrahedra were done again
template <class Scalar>
std::size_t mesh_around(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                        const TetComplex& cells, const std::vector<char>& changed,
                        MeshedLevel<Scalar>& level, StageSeconds& seconds);

}  // namespace tensortopo
