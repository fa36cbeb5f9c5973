// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/certify/certificate.hpp"

namespace tensortopo {

/// The surface of a field that was never in memory as a whole, and what is left of the field.
struct StreamedField {
  ReadResult read;  ///< the tetrahedra that the surface crosses alone; `cell_ids` are the file's
  Extraction extraction;                 ///< of these
  std::vector<std::int64_t> vertex_ids;  ///< of their vertices
  CertificateSubject subject;            ///< what a certificate says of the whole field
};

/// Reads a field piece by piece and extracts the surface of one mode. Throws UsageError for options
/// that need the whole field, IoError, and std::invalid_argument as `extract_streamed`.
/// @param options  of the extraction
/// @param report  what reading has to say, filled in
StreamedField stream_field(const ExtractCommand& command, const std::vector<ModeValue>& modes,
                           const ExtractOptions& options, ExtractReport& report);

}  // namespace tensortopo
