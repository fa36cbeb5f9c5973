// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/restrict_piece.hpp"

namespace tensortopo {

/// The part of a surface that lies in some tetrahedra of a piece, as its file has it.
struct SurfacePart {
  MergedSurface surface;  ///< of the part's mesh, in the part's ids; normals are those of the whole
  std::vector<SurfaceMesh::Index> whole_component;  ///< of each triangle, in the whole surface
};

/// Takes a part out of the surface of a piece (see `restrict_piece`).
/// @param components  of each triangle of the piece, its component in the whole surface
/// @throws std::invalid_argument as `restrict_piece`, or if the components are too few or many
SurfacePart part_of(const PieceSurface& piece, const PartNumbers& numbers,
                    std::span<const SurfaceMesh::Index> components);

/// The part of degenerate curves that lies in some tetrahedra of a piece, as its file has it.
struct CurvePart {
  MergedCurves curves;  ///< of the part's mesh, in the part's ids
  std::vector<CurveMesh::Index> whole_component;  ///< of each line, in the whole curves
};

/// Takes a part out of the curves of a piece (see `restrict_piece`).
/// @param components  of each line of the piece, its component in the whole curves
/// @throws std::invalid_argument as above
CurvePart part_of(const PieceCurves& piece, const PartNumbers& numbers,
                  std::span<const CurveMesh::Index> components);

/// The certificate of a surface put together from pieces, as a file of JSON.
/// @param field  what is known of the input; the other numbers are filled in
/// @throws std::invalid_argument as `certify`
std::string certificate_bytes(const MergedSurface& merged, const ModeValue& mode,
                              CertificateSubject field);
/// That of curves put together from pieces.
std::string certificate_bytes(const MergedCurves& merged, CertificateSubject field);

/// The certificate of a part, about the part's mesh and the arrays of the part's file: its normals
/// are called `whole_normal`, and there is `whole_component`.
std::string certificate_bytes(const SurfacePart& part, const ModeValue& mode,
                              CertificateSubject field);
/// That of a part of curves.
std::string certificate_bytes(const CurvePart& part, CertificateSubject field);

}  // namespace tensortopo
