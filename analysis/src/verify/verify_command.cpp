// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "verify/verify_command.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/field/characteristic_tensor.hpp"
#include "tensortopo/field/field_strata.hpp"
#include "verify/mesh_trials.hpp"

namespace tensortopo {
namespace {

void refuse_unknown(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (!theory::statements_called(id).empty()) continue;
    std::string known;
    for (const theory::Statement& s : theory::statements()) {
      known += (known.empty() ? "" : ", ") + s.id;
    }
    throw UsageError("verify: no statement is called '" + id +
                     "'; there are the paper's numbers 1 to 6, and " + known);
  }
}

theory::Arithmetic arithmetic_of(const std::string& name) {
  if (const auto arithmetic = theory::arithmetic_called(name)) return *arithmetic;
  throw UsageError("verify: there is no --scalar '" + name +
                   "'; there are rational, interval, real100 and double");
}

MeshStrata strata_of(const TetMesh& mesh, const Progress& progress) {
  MeshStrata strata;
  strata.tetrahedra = mesh.tets.size();
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    if (progress && i % 1024 == 0) {
      progress("strata", static_cast<double>(i) / static_cast<double>(mesh.tets.size()));
    }
    const auto tensors = tensors_of_tet(mesh, i);
    const FieldStrata s = field_strata(tensors);
    ++strata.of_rank[static_cast<std::size_t>(s.rank)];
    strata.with_zero_vertex += s.zero_vertices > 0 ? 1 : 0;
    strata.with_common_eigenvector += s.common_eigenvector ? 1 : 0;
    strata.neutral_characteristic += s.neutral_characteristic ? 1 : 0;
    strata.degenerate_characteristic += s.degenerate_characteristic ? 1 : 0;
    if (s.rank < 4) continue;
    TetrahedronField<double> field;
    for (std::size_t k = 0; k < 4; ++k) field.vertex[k] = deviator(tensors[k]);
    const double mode = characteristic_tensor(field)->mode;
    auto& [least, greatest] = strata.characteristic_modes
                                  ? *strata.characteristic_modes
                                  : strata.characteristic_modes.emplace(std::array{mode, mode});
    least = std::min(least, mode), greatest = std::max(greatest, mode);
  }
  return strata;
}

}  // namespace

bool VerifyReport::all_established() const {
  return std::all_of(statements.begin(), statements.end(), [](const theory::Verification& v) {
    return v.verdict == theory::StatementVerdict::holds ||
           v.verdict == theory::StatementVerdict::corrected;
  });
}

VerifyReport run_verify(const VerifyCommand& command, const Progress& progress) {
  VerifyReport report;
  report.arithmetic = arithmetic_of(command.scalar);
  refuse_unknown(command.theorems);
  theory::Trials trials = theory::random_trials(command.seed, command.fields);
  if (!command.input.empty()) {
    if (progress) progress("reading", 0);
    ReadResult read = read_mesh(command.input, command.read);
    const auto mesh = std::make_shared<const TetMesh>(std::move(read.mesh));
    report.mesh = strata_of(*mesh, progress);
    report.mesh->file = command.input;
    report.mesh->sha256 = std::move(read.sha256);
    report.mesh->components = read.report.components;
    report.mesh->notes = read.report.all_notes();
    trials = mesh_trials(mesh, command.seed, command.fields);
    report.mesh->tried = trials.count;
  }
  std::set<const theory::Statement*> wanted;
  for (const std::string& name : command.theorems) {
    for (const theory::Statement* s : theory::statements_called(name)) wanted.insert(s);
  }
  std::vector<const theory::Statement*> chosen;
  for (const theory::Statement& statement : theory::statements()) {
    if (wanted.empty() || wanted.count(&statement) > 0) chosen.push_back(&statement);
  }
  for (const theory::Statement* statement : chosen) {
    const auto done = static_cast<double>(report.statements.size());
    if (progress) progress(statement->id, done / static_cast<double>(chosen.size()));
    report.statements.push_back(theory::verify(*statement, trials, report.arithmetic));
  }
  return report;
}

}  // namespace tensortopo
