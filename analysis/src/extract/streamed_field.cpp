// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/streamed_field.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/field_pieces.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/partition/certify_pieces.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo {

namespace {

void require_streamable(const ExtractCommand& command, const std::vector<ModeValue>& modes) {
  const char* const option = command.other                  ? "--method"
                             : command.max_error > 0        ? "--max-error"
                             : command.pieces > 1           ? "--pieces"
                             : command.min_persistence > 0  ? "--min-persistence"
                             : !command.uncertainty.empty() ? "--uncertainty"
                                                            : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) +
                     ": needs the whole field, and does not go with --stream");
  if (modes.size() != 1 || is_degenerate(modes.front()))
    throw UsageError("--stream: extracts the surface of one mode at a time");
}

}  // namespace

StreamedField stream_field(const ExtractCommand& command, const std::vector<ModeValue>& modes,
                           const ExtractOptions& options, ExtractReport& report) {
  require_streamable(command, modes);
  const FieldPieces pieces(command.input, command.read);
  StreamedSurface made;
  try {
    made = extract_streamed({pieces.size(), [&](std::int32_t p) { return pieces.read(p); }},
                            modes.front(), options);
  } catch (const std::invalid_argument& error) {
    throw IoError(IoError::Kind::invalid, command.input, error.what());
  }
  StreamedField result;
  result.extraction = extraction_of(made.merged);
  result.read.report = pieces.report();
  result.read.sha256 = pieces.sha256();
  result.read.mesh = std::move(made.merged.cells);
  result.vertex_ids = std::move(made.merged.vertex_ids);
  CertificateSubject& subject = result.subject;
  subject.tensor = pieces.report().tensor_name;
  subject.components = name_of(pieces.report().components.order);
  subject.points = made.points, subject.tetrahedra = made.tets;
  subject.field_sha256 = std::move(made.field_sha256);

  report.provenance = command.provenance;
  report.sha256 = result.read.sha256;
  report.tensor_name = pieces.report().tensor_name;
  report.components = pieces.report().components;
  report.vertices = made.points, report.tetrahedra = made.tets;
  return result;
}

}  // namespace tensortopo
