// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tensortopo {

/// A file that a certificate of parts names.
struct CertifiedFile {
  std::string name;    ///< relative, with `/` between its parts
  std::string sha256;  ///< of all its bytes, in hexadecimal
};

/// What a certificate of parts says of one part.
struct CertifiedPart {
  CertifiedFile input;        ///< the piece of the field
  CertifiedFile output;       ///< the part of the surface, or of the curves
  CertifiedFile certificate;  ///< of the part
};

/// Numbers of the whole by their names, in the order of the file.
using WholeNumbers = std::vector<std::pair<std::string, std::int64_t>>;

/// A certificate of parts as a file's bytes; proofs-check describes the format.
/// @param mode   exactly
/// @param role   what the outputs are: "surface" or "polylines"
/// @param parts  in the order of the pieces
/// @throws std::exception if a name is no UTF-8
std::string parts_certificate_bytes(const std::string& mode, const std::string& role,
                                    std::span<const CertifiedPart> parts,
                                    const WholeNumbers& whole);

}  // namespace tensortopo
