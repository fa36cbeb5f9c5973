// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/mesh/torn_faces.hpp"
#include "tensortopo/tensor/component_order.hpp"

namespace tensortopo {

/// What is made of quadratic cells.
enum class QuadraticCells {
  split,    ///< linear parts around all their nodes
  corners,  ///< linear cells of their corners; the other nodes are left out
};

/// What several tensors of one vertex count for in their mean.
enum class MeanWeights {
  plain,   ///< each the same
  volume,  ///< the volume of the cells that they belong to
};

/// What an array on cells holds.
enum class CellValues {
  one,     ///< a tensor for each cell
  nodes,   ///< one for each node of each cell, one after the other, in VTK's order
  points,  ///< one for each integration point, the same number in each cell
};

/// What a reader is told of a file.
struct ReadOptions {
  /// Name of the tensor array; empty for the only array that has 6 or 9 components. Or of six
  /// arrays of one component each: `S_{xx,yy,zz,xy,yz,xz}` stands for S_xx, S_yy, ..., in any order
  /// that `component_order` knows; the names say which component each is.
  std::string tensor;
  /// Order of 6 components; empty for the one that the file names, else VTK's. Refused
  /// (inapplicable) if the array has 9, or if the file names its components otherwise.
  std::optional<ComponentOrder> components;
  /// Take (T + T^t) / 2 of a 3x3 tensor that is asymmetric by more than 1e-9 of its norm.
  bool symmetrize = false;
  /// Take components of less than this, in absolute value, as zero, and then tensors whose deviator's
  /// norm is less as isotropic; 0: none. In the tensor's units.
  double zero_below = 0;
  /// Let tensors on cells stand: each vertex gets the mean over the 3D cells around it, see
  /// `materials`. Of integration points each cell has their plain mean first.
  bool cell_to_point = false;
  /// What an array on cells holds; if not one tensor each, `tensor` names it, and `cell_to_point`
  /// is meant.
  CellValues cell_values = CellValues::one;
  /// Of `cell_to_point`: plain by default. With `merge_points`: makes one of points in the same
  /// place even if their tensors differ, and gives it their mean.
  std::optional<MeanWeights> mean;
  /// An array on cells, of one component: means are taken over cells of the same value only, and
  /// vertices between cells of several values become one for each value, so that the field may jump
  /// there. `none` takes means over all. Without either, means are refused if the file has an array
  /// that by its name tells materials apart, with several values.
  std::string materials;
  /// Make one of points in the same place with the same tensor.
  bool merge_points = false;
  /// Split other linear 3D cells into tetrahedra.
  bool tetrahedralize = false;
  QuadraticCells quadratic = QuadraticCells::split;  ///< what becomes of quadratic cells
  /// Of formats with several states of a field: which, counted from 1; the last by default.
  std::optional<std::size_t> step;
  /// Of NIfTI images: an image of the same voxels; cubes with a corner where it is 0 are left out.
  std::filesystem::path mask;
  /// Which cells are taken: the name of an array, or an expression of arrays of one component, as
  /// `anisotropy > 0.2 and mask`; empty for all. A cell is taken where it is neither 0 nor NaN at all its
  /// nodes (of arrays on cells: in the cell). `x`, `y`, `z` are the place of a node; `magnitude`,
  /// `deviator_magnitude`, `anisotropy` and `mode` belong to its tensor, or to the cell's if tensors
  /// are on cells. The syntax is that of ExprTk; a name that is no identifier stands between double
  /// quotation marks. Means are taken over all cells.
  std::string where;

  /// The option, as the program calls it, by which the mesh is not the file's as it is; null if
  /// there is none.
  const char* making_others() const;
};

/// What reading did beyond copying; all counts are zero for a plain file.
struct ReadReport {
  std::string tensor_name;  ///< the array that was taken
  TensorComponents components;  ///< their order, and who said so
  std::size_t skipped_cells_2d_1d = 0;  ///< points, lines, faces
  std::size_t skipped_ghost_cells = 0;  ///< marked as another piece's by `vtkGhostType`
  std::size_t cells_left_out = 0;       ///< by `ReadOptions::where`
  std::size_t split_cells = 0;          ///< cells that became several tetrahedra
  std::size_t quadratic_cells = 0;      ///< of these, or taken by their corners
  std::size_t added_vertices = 0;       ///< centres of faces and of quadratic cells
  std::size_t curved_edges = 0;         ///< of quadratic cells, taken as two straight ones, or as one
  std::size_t reoriented_cells = 0;     ///< negative volume as listed; see repair_orientation
  std::size_t symmetrized_tensors = 0;  ///< xy and yx (or another pair) differed
  std::size_t tensors_with_zeros = 0;   ///< changed by `ReadOptions::zero_below`
  std::size_t averaged_vertices = 0;    ///< got their tensor from cells
  std::size_t merged_points = 0;        ///< points dropped as copies of another
  std::size_t doubled_vertices = 0;     ///< added between materials
  std::size_t unreferenced_points = 0;  ///< in no tetrahedron; kept
  TornFaces torn_faces;  ///< faces that lie on others without being shared
  std::vector<std::string> notes;  ///< the same for people, one line each

  /// The same, with what was taken for the components unless it goes without saying (VTK's order,
  /// named in the file, or a matrix), for those who do not report that elsewhere.
  std::vector<std::string> all_notes() const;
};

/// The note where several pieces have points, but none in common.
inline constexpr const char* kPiecesDoNotMeet =
    "pieces do not meet: no point has the coordinates of another's";

/// A field, and what reading did.
struct ReadResult {
  TetMesh mesh;  ///< valid, see `validate`
  ReadReport report;  ///< what reading did
  /// SHA-256 of the file's bytes, in hexadecimal; of a .pvtu: of its bytes followed by the bytes
  /// of its pieces, in order; with a mask: followed by the mask's.
  std::string sha256;
};

/// The tetrahedral mesh and tensor field that a file of one of `field_formats` holds.
///
/// Laws      (1) the numbers are exactly those of the file: float32 and integers are widened, and
///           text is rounded once, to the type that the file declares; (2) the mesh passes
///           `validate`; (3) the result depends on the bytes only; (4) any bytes whatever give a
///           result or an IoError, with memory in proportion to the file.
/// Tensors   9 components are a row-major 3x3 matrix; a pair that differs within the tolerance is
///           replaced by its mean. 6 components are in the order that their names in the file spell
///           (`S11 S22 ...`, `stress_xx ...`), else in `options.components` order, else in VTK's.
///           Names that spell no order are refused unless the caller gives one. Tensors that
///           belong to points win over tensors that belong to cells, which a note says.
/// Cells     Splitting joins each cell's smallest vertex to the faces away from it, and each face
///           is split from its own smallest vertex, so cells that share a face agree on it. Parts
///           of a cell with coinciding corners that have no volume are left out. Quadratic cells
///           (tetrahedra of 10 nodes, hexahedra of 20 and 27, wedges of 15, pyramids of 13) are
///           split around their nodes, with the centres that they have no nodes for, or taken by
///           their corners (always if the tensors are on cells); others of higher order, and
///           polyhedra, are refused. `cell_ids` count the cells of the file from 0 (of a
///           file in pieces: through all pieces in order).
/// Pieces    Points of different pieces that agree in position and tensor become one. Equal
///           position and different tensors is an error: the field would be torn there.
/// Throws    IoError, `unreadable`, `invalid` or `inapplicable`.
ReadResult read_mesh(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace tensortopo
