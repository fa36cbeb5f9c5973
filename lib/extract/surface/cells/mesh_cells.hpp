// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/patch/patch.hpp"
#include "extract/surface/cells/boundary_vertices.hpp"
#include "tensortopo/extract/meshing_message.hpp"

namespace tensortopo {

/// How the sheets of a tetrahedron were meshed.
enum class Mesher {
  tubes,
  small_disc,
  bisected,
  graph,
  manifold,
  dominant,
  subdivision,
  fan,
  loops,
  cone
};

/// The triangles of one tetrahedron.
template <class Scalar>
struct CellMesh {
  Patch<Scalar> patch;
  Mesher mesher = Mesher::small_disc;
  int sheets = 0;                              ///< how many were proved
  bool refined = false;                        ///< by a refinement
  std::optional<UnresolvedReason> unresolved;  ///< not proved, or proved and not meshed
  bool was_mended = false;                     ///< other triangles were tried because of defects
  bool has_defects = false;                    ///< the patch has `PatchDefects`
  bool has_doubled_boundary = false;  ///< and cannot be without, see `has_doubled_boundary`
};

/// The triangles of all tetrahedra, with the sampling of faces that meshing needed.
template <class Scalar>
struct CellMeshes {
  std::vector<CellMesh<Scalar>> cells;
  LevelBoundary<Scalar> boundary;
  BoundaryVertices vertices;
  std::vector<MeshingMessage> messages;  ///< between parts, of tetrahedra of the complex
};

/// Meshes what is proved. A tetrahedron that cannot be meshed with the samples that its faces have
/// asks for more, which its neighbours then have as well, and are meshed again. Few rounds are
/// needed.
///
/// @param proofs  subdivisions are added where meshing needs them
template <class Scalar>
CellMeshes<Scalar> mesh_cells(const SurfaceInput<Scalar>& input, const VertexSides& sides,
                              const TetComplex& cells, LevelBoundary<Scalar> boundary,
                              std::vector<CellProof<Scalar>>& proofs);

}  // namespace tensortopo
