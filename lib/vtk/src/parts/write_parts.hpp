// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parts/part_bytes.hpp"
#include "parts/parts_folder.hpp"
#include "ranks.hpp"
#include "tensortopo/certify/parts_certificate.hpp"
#include "whole_curves.hpp"
#include "whole_mesh.hpp"
#include "whole_surface.hpp"

namespace tensortopo::filters {

/// What the ranks' parts are parts of.
struct WholeOutput {
  std::string mode;      ///< exactly
  std::string role;      ///< "surface" or "polylines", as a certificate of parts has it
  XmlPieces pieces;      ///< what the parts have
  WholeNumbers numbers;  ///< that are claimed, besides tetrahedra
};

/// Where a certificate of parts and its files go.
/// @throws std::runtime_error for a wrong name or an empty mesh, and on the first rank if nothing can
///         be written there
PartsFiles require_parts_files(const std::string& certificate_file, const Ranks& ranks,
                               const WholeMesh& mesh);

/// What the parts of a surface are parts of.
WholeOutput whole_output(const ModeValue& mode, const WholeSurface& counts);
/// The same of curves.
WholeOutput whole_output(const ModeValue& mode, const WholeCurves& counts);

/// The numbers of those triangles or lines that lie in tetrahedra which a piece owns.
/// @param tets  of each triangle or line
std::vector<TetMesh::Index> of_own_cells(const MeshPiece& piece,
                                         const std::vector<TetMesh::Index>& tets,
                                         const std::vector<TetMesh::Index>& numbers);

/// Each rank that owns tetrahedra writes its part, with its field and its certificate, and the first
/// rank what is beside them: all files appear, or none. All ranks call it, and it throws
/// std::exception on all or none.
/// @param grid  of this rank
/// @param make  gives this rank's part; called where it owns tetrahedra
void write_parts(const Ranks& ranks, const WholeMesh& mesh, const PartsFiles& files,
                 const WholeOutput& whole, const TensorGrid& grid,
                 const std::function<PartBytes()>& make);

}  // namespace tensortopo::filters
