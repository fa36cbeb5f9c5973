// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/persistence/persistence_command.hpp"

#include <chrono>
#include <stdexcept>

#include "analyze/persistence/persistence_chart.hpp"
#include "analyze/persistence/persistence_output.hpp"
#include "origin_notes.hpp"
#include "require_folder.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/lower_extension.hpp"
#include "tensortopo/io/write_text.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"

namespace tensortopo {
namespace {

void require_name(const std::filesystem::path& file, const char* extension) {
  if (file.empty()) return;
  if (lower_extension(file) != extension)
    throw UsageError(file.string() + ": the name must end in " + extension);
  require_folder(file);
}

void draw(const PersistenceReport& report, const std::filesystem::path& file) {
  try {
    write_text(file, persistence_chart(report.pairs(), report.homology));
  } catch (const IoError&) {
    throw;
  } catch (const std::runtime_error& problem) {
    throw IoError(IoError::Kind::unwritable, file, problem.what());
  }
}

}  // namespace

bool PersistenceReport::adds_up() const { return homology.adds_up[0] && homology.adds_up[1]; }

bool PersistenceReport::is_proved() const {
  for (std::size_t side = 0; side < 2; ++side)
    if (!persistence.not_proved[side].empty() || persistence.unresolved_curve_cells[side] > 0 ||
        homology.not_proved[side] > 0)
      return false;
  return homology.has_known_curves && homology.isotropic_vertices == 0;
}

std::vector<PersistencePair> PersistenceReport::pairs() const {
  std::vector<PersistencePair> all = persistence.pairs;
  all.insert(all.end(), homology.pairs.begin(), homology.pairs.end());
  return all;
}

PersistenceReport run_persistence(const PersistenceCommand& command, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  require_name(command.output, ".vtp");
  require_name(command.picture, ".png");
  if (progress) progress("reading", 0);
  PersistenceReport report;
  report.provenance = command.provenance;
  // In this order the result does not depend on how the mesh is numbered.
  TetMesh mesh = in_canonical_order(read_analyzed(command.input, command.read, report).mesh);
  const PersistenceInput found = persistence_input(mesh, progress);
  report.persistence = mode_persistence(mesh, found);
  report.homology = mode_homology(mesh, found);
  report.cell_ids = std::move(mesh.cell_ids);
  if (!command.output.empty()) write_pairs(report.pairs(), command.output, origin_notes(report));
  if (!command.picture.empty()) draw(report, command.picture);
  report.output = command.output;
  report.picture = command.picture;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tensortopo
