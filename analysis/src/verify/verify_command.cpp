// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "verify/verify_command.hpp"

#include <algorithm>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

void refuse_unknown(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (theory::find_statement(id) != nullptr) continue;
    std::string known;
    for (const theory::Statement& s : theory::statements()) {
      known += (known.empty() ? "" : ", ") + s.id;
    }
    throw UsageError("verify: no statement is called '" + id + "'; there are " + known);
  }
}

}  // namespace

bool VerifyReport::all_established() const {
  return std::all_of(statements.begin(), statements.end(), [](const theory::Verification& v) {
    return v.verdict == theory::StatementVerdict::holds ||
           v.verdict == theory::StatementVerdict::corrected;
  });
}

VerifyReport run_verify(const VerifyCommand& command) {
  if (command.scalar != "rational") {
    throw UsageError("verify: statements are decided over --scalar rational only, not '" +
                     command.scalar + "'");
  }
  refuse_unknown(command.theorems);
  const std::vector<std::string>& wanted = command.theorems;
  VerifyReport report;
  for (const theory::Statement& statement : theory::statements()) {
    const bool chosen =
        wanted.empty() || std::find(wanted.begin(), wanted.end(), statement.id) != wanted.end();
    if (!chosen) continue;
    report.statements.push_back(theory::verify(statement, command.seed, command.fields));
  }
  return report;
}

}  // namespace tensortopo
