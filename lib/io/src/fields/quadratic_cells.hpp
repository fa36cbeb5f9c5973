// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

/// How many corners and nodes a quadratic cell type of VTK has; zeros for types that are not split:
/// tetrahedra of 10 nodes, hexahedra of 20 or 27, wedges of 15, pyramids of 13.
struct QuadraticKind {
  std::size_t corners = 0, nodes = 0;
  std::uint8_t linear_type = 0;  ///< of the cell of its corners
};
QuadraticKind quadratic_kind(std::uint8_t vtk_type);

/// Splits quadratic cells into linear parts around their nodes, and these into tetrahedra.
///
/// Each edge is halved, each triangle cut in four, each quadrilateral in four quadrilaterals around
/// its centre, so that cells that share a face split it alike (see `split_cell`). A centre that a
/// cell has no node for becomes a vertex of the mesh: place and tensor are those of the serendipity
/// functions, of a face the same from both sides. Of an octahedron inside, the diagonal from its
/// smallest vertex is taken.
class QuadraticSplitter {
 public:
  using Index = TetMesh::Index;

  /// @param mesh  has its points and tensors
  explicit QuadraticSplitter(TetMesh& mesh) : mesh_(mesh) {}

  /// Counts the cell's edges that are curved, each edge once.
  void count_curved(std::uint8_t vtk_type, std::span<const Index> nodes);

  /// Appends to `tets`. Orientation is as may be.
  /// @param nodes  of the mesh, as VTK orders them
  void split(std::uint8_t vtk_type, std::span<const Index> nodes,
             std::vector<std::array<Index, 4>>& tets);

  std::size_t added_vertices() const { return added_; }
  /// Edges whose node is farther from their middle than a hundredth of their length.
  std::size_t curved_edges() const { return curved_; }

 private:
  Index vertex_at(const std::vector<std::pair<Index, double>>& weights);
  Index face_centre(std::array<Index, 4> corners, std::array<Index, 4> middles);
  void count_curved(Index a, Index b, Index middle);
  void split_tetrahedron(std::span<const Index> n, std::vector<std::array<Index, 4>>& tets);
  void split_hexahedron(std::span<const Index> n, std::vector<std::array<Index, 4>>& tets);
  void split_wedge(std::span<const Index> n, std::vector<std::array<Index, 4>>& tets);
  void split_pyramid(std::span<const Index> n, std::vector<std::array<Index, 4>>& tets);

  TetMesh& mesh_;
  std::map<std::array<Index, 8>, Index> face_centres_;
  std::map<std::array<Index, 2>, Index> middles_;
  std::size_t added_ = 0, curved_ = 0;
};

}  // namespace tensortopo::detail
