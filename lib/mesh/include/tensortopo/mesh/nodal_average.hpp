// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// Sums of tensors at nodes, of which means are taken.
class NodalSums {
 public:
  /// Of this many nodes, without any tensor yet.
  explicit NodalSums(std::size_t nodes) : sums_(nodes), weights_(nodes, 0) {}

  /// Adds a cell's tensors to its nodes: one each, or one for all of them. A node that the cell lists
  /// twice gets the first of its tensors only.
  /// Requires  `tensors` has as many entries as `nodes`, or one; a positive weight.
  void add(std::span<const TetMesh::Index> nodes, std::span<const SymmetricTensor<double>> tensors,
           double weight);

  /// The weighted mean at each node; zero at nodes without a tensor.
  std::vector<SymmetricTensor<double>> means() const;

  /// Whether a node got a tensor.
  bool has(std::size_t node) const { return weights_[node] != 0; }

 private:
  std::vector<SymmetricTensor<double>> sums_;
  std::vector<double> weights_;
};

/// The plain mean of tensors, as of a cell's integration points.
/// Requires  at least one.
SymmetricTensor<double> plain_mean(std::span<const SymmetricTensor<double>> tensors);

/// The volume of each tetrahedron, rounded; positive for valid meshes.
std::vector<double> tet_volumes(const TetMesh& mesh);

/// Cells of any kind, each with the same number of nodes, and tensors in them.
struct CellTensors {
  std::size_t nodes_per_cell = 4;     ///< at least 1
  std::vector<TetMesh::Index> nodes;  ///< of one cell after the other, numbered from 0
  std::size_t tensors_per_cell = 1;   ///< at least 1
  std::vector<SymmetricTensor<double>> tensors;  ///< of one cell after the other
  /// Whether the tensors of a cell are at its nodes, in their order; else at integration points.
  bool at_nodes = false;
};

/// What tensors count for in a mean, and over which cells it is taken.
struct NodalAverageOptions {
  /// Of each cell, positive, as its volume (`tet_volumes`); none for plain means.
  std::vector<double> weights;
  /// Of each cell. Means are never taken over cells of several materials: a node between such cells
  /// becomes one for each. None makes all cells one material.
  std::vector<std::int64_t> materials;
};

/// Tensors at nodes.
struct NodalAverage {
  /// Of each node: those given, then those added between materials. Zero at nodes without a cell.
  std::vector<SymmetricTensor<double>> tensors;
  std::vector<TetMesh::Index> nodes;   ///< as in `CellTensors`, with the nodes added
  std::vector<TetMesh::Index> origin;  ///< the node given whose place each node has
};

/// The means at nodes of the tensors of the cells around them: stresses at integration points, or at
/// the nodes of elements, made a field that is continuous within each material.
///
/// Of several integration points a cell has the plain mean first, which all of its nodes take. Cells
/// are taken in their order, and so are materials: a node keeps its number for the material of its
/// first cell, nodes added get the next numbers.
///
/// Laws      (1) a constant field keeps its tensor, up to rounding; (2) of plain means, the order of
///           a cell's nodes does not matter; (3) cells of one material have the same means whatever
///           tensors the others have.
/// Requires  finite tensors.
/// Throws    std::invalid_argument where counts, weights or numbers of nodes are not as required.
/// Source    lib/io does the same with what it reads (`ReadOptions::cell_to_point`).
NodalAverage nodal_average(std::size_t node_count, const CellTensors& cells,
                           const NodalAverageOptions& options = {});

}  // namespace tensortopo
