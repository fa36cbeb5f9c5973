// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "parts/xml_piece.hpp"
#include "tensor_grid.hpp"
#include "tensortopo/partition/piece_curves.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo::filters {

/// The files of a rank's part, as bytes. The part is the tetrahedra that the rank owns.
struct PartBytes {
  std::string field;        ///< .vtu
  std::string output;       ///< .vtp
  std::string certificate;  ///< .json
};

/// @param surface     what the rank owns, with proofs
/// @param components  of each triangle of the surface, its component in the whole
PartBytes part_bytes(const TensorGrid& grid, const PieceSurface& surface, const ModeValue& mode,
                     std::span<const SurfaceMesh::Index> components);
/// @param components  of each line of the curves, its component in the whole
PartBytes part_bytes(const TensorGrid& grid, const PieceCurves& curves,
                     std::span<const CurveMesh::Index> components);

XmlPieces field_pieces(const std::string& tensor);  ///< what fields of parts have
/// What surfaces, or curves, of parts have.
XmlPieces surface_pieces();
XmlPieces curve_pieces();

/// What a part calls the tensors.
std::string tensor_name(const TensorGrid& grid);

}  // namespace tensortopo::filters
