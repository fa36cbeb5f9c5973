// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <variant>
#include <vector>

#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/certify/certificate.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo {

/// Surfaces and curves of a field that was never in memory as a whole, and what is left of the field.
struct StreamedField {
  ReadResult read;  ///< the tetrahedra that these need alone; `cell_ids` are the file's
  /// Of these, in the order of the modes.
  std::vector<std::variant<Extraction, CurveExtraction>> extractions;
  std::vector<std::int64_t> vertex_ids;  ///< of their vertices
  CertificateSubject subject;            ///< what a certificate says of the whole field
};

/// Reads a field piece by piece and extracts surfaces and curves, one mode after the other. Throws
/// UsageError for options that need the whole field, and IoError.
/// @param options  of the extraction
/// @param begin  called with each mode before its pieces are extracted
/// @param report  what reading has to say, filled in
StreamedField stream_field(const ExtractCommand& command, const std::vector<ModeValue>& modes,
                           const ExtractOptions& options,
                           const std::function<void(const ModeValue&)>& begin,
                           ExtractReport& report);

}  // namespace tensortopo
