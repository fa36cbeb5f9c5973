// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

/// Which numbers a certificate is about.
struct CertificateSubject {
  std::string tensor;             ///< name of the array
  std::string components;         ///< "vtk", "voigt", "abaqus", "nifti", "fsl" or "full"
  /// Numbers of the input.
  std::size_t points = 0, tetrahedra = 0;
  std::string field_sha256;  ///< hash of the input's numbers, in hexadecimal
  /// Numbers of the surface, or polylines; cells are triangles, or lines.
  std::size_t vertices = 0, cells = 0;
  std::string output_sha256;            ///< of the surface, or polylines

  /// A further array of the output's file.
  struct Array {
    std::string of;  ///< "points", "triangles" or "lines"
    std::string name;  ///< its name
    std::size_t components = 1;  ///< numbers for each point or cell
    std::string sha256;  ///< hash of its numbers, in hexadecimal
  };
  std::vector<Array> arrays;  ///< ascending by `of` and `name`
};

enum class CertificateEncoding { json, cbor };

/// The certificate as a file's bytes. The format is described in proofs-check; equal claims give
/// equal bytes.
/// @param levels  in the order of the surface's vertices and triangles
std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedLevel> levels, const TetMesh& mesh,
                              CertificateEncoding encoding);
/// @param kinds  in the order of the polylines' vertices and lines
std::string certificate_bytes(const CertificateSubject& subject,
                              std::span<const CertifiedCurves> kinds, const TetMesh& mesh,
                              CertificateEncoding encoding);

}  // namespace tensortopo
