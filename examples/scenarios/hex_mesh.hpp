// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::scenarios {

using Index = TetMesh::Index;

/// A conforming mesh of hexahedra with planar faces.
struct HexMesh {
  std::vector<Vector3<double>> points;
  /// Corners as finite-element codes list them: around the bottom, counterclockwise seen from
  /// above, then the four above them.
  std::vector<std::array<Index, 8>> hexes;
  std::vector<int> materials;  ///< one per hexahedron, counted from 0
};

/// The box from 0 to `size`, cut in equal hexahedra; x varies fastest, z slowest. One material.
HexMesh box_mesh(const std::array<int, 3>& cells, const Vector3<double>& size);

/// A block with a slanted slab on its top, as a tread block carries its rib.
struct SlabShape {
  Vector3<double> block;    ///< size of the block, from 0
  double width = 0;         ///< of the slab in x
  double height = 0;        ///< of the slab
  double slope = 0;         ///< dx/dy of the slab's edges; the slab is centred on the block
  double stiff_height = 0;  ///< hexahedra with their middle below it are of material 1
};

/// Thirds of the lattice lie before, under and behind the slab, so that its edges are edges of the
/// mesh; the lattice is sheared to them, and all faces stay planar. The slab's points and
/// hexahedra come after those of the block.
/// Requires  cells[0] a multiple of 3 (std::invalid_argument).
HexMesh slab_mesh(const std::array<int, 3>& cells, int slab_layers, const SlabShape& shape);

/// Each hexahedron as six tetrahedra around the diagonal from corner 0 to corner 6 (Kuhn), the same
/// way everywhere: conforming on a lattice, positively oriented. Tensors are left empty.
TetMesh to_tets(const HexMesh& mesh);

/// The hexahedra whose top face is as high as the mesh, in order.
std::vector<Index> highest_hexes(const HexMesh& mesh);

/// Corners of a hexahedron's top face.
std::array<Vector3<double>, 4> top_face(const HexMesh& mesh, Index hex);

/// The points at the height of the lowest, in order.
std::vector<Index> lowest_points(const HexMesh& mesh);

}  // namespace tensortopo::scenarios
