// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "origin_notes.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {

/// Throws IoError for a torn mesh if the command is strict.
template <class Command>
void refuse_torn(const Command& command, const TornFaces& torn) {
  if (command.strict && torn.count > 0)
    throw IoError(IoError::Kind::invalid, command.input, torn.text());
}

/// Reads the field of an extraction, and says in the report what there is to say of it. Throws
/// IoError, also for a torn mesh if the command is strict.
template <class Command, class Report>
ReadResult read_field(const Command& command, Report& report) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ReadResult read = read_mesh(command.input, command.read);
  report.seconds_read = std::chrono::duration<double>(Clock::now() - start).count();
  report.provenance = command.provenance;
  report.sha256 = read.sha256;
  report.tensor_name = read.report.tensor_name;
  report.components = read.report.components;
  report.notes = read.report.notes;
  report.cells_left_out = read.report.cells_left_out;
  report.torn_faces = read.report.torn_faces;
  report.vertices = read.mesh.points.size();
  report.tetrahedra = read.mesh.tets.size();
  refuse_torn(command, report.torn_faces);
  return read;
}

/// What a surface file says of its origin.
/// @param levels  the values extracted, exactly
template <class Report>
std::vector<FileNote> file_notes(const Report& report, const std::string& levels) {
  std::vector<FileNote> notes = origin_notes(report);
  notes.push_back({"levels", levels});
  return notes;
}

}  // namespace tensortopo
