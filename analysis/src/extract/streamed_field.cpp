// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/streamed_field.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "extract/read_field.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/field_pieces.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/partition/common_cells.hpp"
#include "tensortopo/partition/extract_streamed.hpp"

namespace tensortopo {

namespace {

void require_streamable(const ExtractCommand& command) {
  const char* const option = command.other                  ? "--method"
                             : command.max_error > 0        ? "--max-error"
                             : command.pieces > 1           ? "--pieces"
                             : command.min_persistence > 0  ? "--min-persistence"
                             : !command.uncertainty.empty() ? "--uncertainty"
                                                            : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) +
                     ": needs the whole field, and does not go with --stream");
}

}  // namespace

StreamedField stream_field(const ExtractCommand& command, const std::vector<ModeValue>& modes,
                           const ExtractOptions& options,
                           const std::function<void(const ModeValue&)>& begin,
                           ExtractReport& report) {
  require_streamable(command);
  const FieldPieces pieces(command.input, command.read);
  StreamedField result;
  CertificateSubject& subject = result.subject;
  std::vector<std::variant<MergedSurface, MergedCurves>> merged;
  try {
    const StreamedMesh mesh({pieces.size(), [&](std::int32_t p) { return pieces.read(p); }});
    report.torn_faces = mesh.torn_faces();
    refuse_torn(command, report.torn_faces);
    if (report.torn_faces.count > 0) report.notes.push_back(report.torn_faces.text());
    if (mesh.is_in_parts()) report.notes.emplace_back(kPiecesDoNotMeet);
    for (const ModeValue& mode : modes) {
      begin(mode);
      if (is_degenerate(mode))
        merged.emplace_back(extract_streamed(mesh, degeneracy_of(mode), options));
      else
        merged.emplace_back(extract_streamed(mesh, mode, options));
    }
    subject.points = mesh.points(), subject.tetrahedra = mesh.tets();
    if (options.keep_topology) subject.field_sha256 = mesh.field_sha256();
  } catch (const std::invalid_argument& error) {
    throw IoError(IoError::Kind::invalid, command.input, error.what());
  }
  CommonCells common = in_common_cells(std::move(merged));
  result.extractions = std::move(common.levels);
  result.read.report = pieces.report();
  result.read.sha256 = pieces.sha256();
  result.read.mesh = std::move(common.cells);
  result.vertex_ids = std::move(common.vertex_ids);
  subject.tensor = pieces.report().tensor_name;
  subject.components = name_of(pieces.report().components.order);

  report.provenance = command.provenance;
  report.sha256 = result.read.sha256;
  report.tensor_name = pieces.report().tensor_name;
  report.components = pieces.report().components;
  report.vertices = subject.points, report.tetrahedra = subject.tetrahedra;
  return result;
}

}  // namespace tensortopo
