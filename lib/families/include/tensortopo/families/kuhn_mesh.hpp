// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A lattice of hexahedra, each cut in six tetrahedra around the diagonal from its lowest to its
/// highest corner (Kuhn): conforming, positively oriented. Tensors are zero.
///
/// @param cells   hexahedra in x, y and z
/// @param place   position of the lattice point (i, j, k), 0 <= i <= cells[0] and so on; must keep
///                the orientation of the lattice
/// @param keep    whether the hexahedron with lowest corner (i, j, k) exists; all if empty
TetMesh kuhn_mesh(const std::array<int, 3>& cells,
                  const std::function<Vector3<double>(int, int, int)>& place,
                  const std::function<bool(int, int, int)>& keep = {});

/// The box from `low` to `high` cut in equal hexahedra.
TetMesh kuhn_box(const std::array<int, 3>& cells, const Vector3<double>& low,
                 const Vector3<double>& high);

/// One of so many slabs of `kuhn_box` across x, of equal numbers of hexahedra but for rounding: its
/// points have the same coordinates. Throws std::invalid_argument for more slabs than hexahedra.
TetMesh kuhn_slab(const std::array<int, 3>& cells, const Vector3<double>& low,
                  const Vector3<double>& high, int slab, int slabs);

/// The multiple m times `proportions` whose lattice has at least `tetrahedra` tetrahedra, m >= 1 as
/// small as can be.
std::array<int, 3> cells_for(const std::array<int, 3>& proportions, std::size_t tetrahedra);

/// Gives every vertex the value of a field there. In parallel.
void sample_field(TetMesh& mesh,
                  const std::function<SymmetricTensor<double>(const Vector3<double>&)>& field);

/// The meshes in one, in rows of a square sheet in x and -z, each scaled by a power of two to an
/// extent in (1/2, 1]. Topology and fields are those of the parts; coordinates are rounded
/// when they are moved. Vertices and tetrahedra follow in order.
TetMesh side_by_side(std::span<const TetMesh> meshes);

}  // namespace tensortopo
