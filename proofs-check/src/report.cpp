// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "proof_steps/report.hpp"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

namespace proofs {
namespace {

const char* words(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::corrected:
      return "holds as corrected";
    case Verdict::refuted:
      return "refuted";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

/// What the witness field says of a step of this verdict.
const char* witness_label(Verdict verdict) { return is_established(verdict) ? "witness" : "why"; }

std::string totals(const std::vector<StepResult>& results) {
  std::ostringstream out;
  out << results.size() << " steps";
  for (const Verdict verdict :
       {Verdict::holds, Verdict::corrected, Verdict::refuted, Verdict::undecided}) {
    const auto number = std::count_if(results.begin(), results.end(),
                                      [&](const StepResult& r) { return r.verdict == verdict; });
    out << (verdict == Verdict::holds ? ": " : ", ") << number << ' ' << name(verdict);
  }
  return out.str();
}

/// A string of JSON. The texts are ASCII without control characters.
std::string quoted(const std::string& text) {
  std::string result(1, '"');
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// Inside a line of Markdown.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '_' || c == '|' || c == '<' || c == '[' || c == ']' || c == '\\')
      result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

std::string to_text(const std::vector<StepResult>& results) {
  std::ostringstream out;
  out << std::left << std::fixed << std::setprecision(3);
  const auto columns = [&](const std::string& id, const char* verdict,
                           const char* kind) -> std::ostream& {
    return out << std::setw(32) << id << ' ' << std::setw(18) << verdict << ' ' << std::setw(10)
               << kind << ' ';
  };
  columns("id", "verdict", "kind") << "seconds  in the paper | claim\n";
  for (const StepResult& r : results) {
    columns(r.id, words(r.verdict), name(r.kind))
        << std::right << std::setw(7) << r.seconds << std::left;
    out << "  " << r.theorem << " | " << r.claim << '\n';
    if (!r.corrected.empty()) out << "    corrected: " << r.corrected << '\n';
    if (!r.witness.empty()) out << "    " << witness_label(r.verdict) << ": " << r.witness << '\n';
  }
  out << totals(results) << '\n';
  return out.str();
}

std::string to_text(const std::vector<MutationResult>& results) {
  std::ostringstream out;
  std::size_t changes = 0, overlooked = 0, failed = 0, hypotheses = 0, unneeded = 0;
  for (const MutationResult& r : results) {
    out << (r.passed() ? "noticed     " : "FAILED      ") << r.id << ": " << r.changes
        << " changes of a constant, " << r.overlooked.size() << " overlooked; " << r.hypotheses
        << " hypotheses dropped, " << r.unneeded.size() << " overlooked"
        << (r.established ? "" : ", and the step itself is not established") << '\n';
    for (const std::size_t i : r.overlooked)
      out << "  overlooked: the change of constant " << i << '\n';
    for (const std::string& name : r.unneeded) out << "  overlooked: the loss of " << name << '\n';
    changes += r.changes;
    overlooked += r.overlooked.size();
    hypotheses += r.hypotheses;
    unneeded += r.unneeded.size();
    if (!r.passed()) ++failed;
  }
  out << changes << " changes, " << overlooked << " overlooked; " << hypotheses
      << " hypotheses dropped, " << unneeded << " overlooked; " << failed << " steps failed\n";
  return out.str();
}

std::string to_markdown(const std::vector<StepResult>& results) {
  std::ostringstream out;
  out << "# The steps\n\nWritten by `tensortopo_proofs --markdown`; a test compares the two.\n"
      << totals(results) << ".\n";
  std::string theorem;
  for (const StepResult& r : results) {
    if (r.theorem != theorem) out << "\n## " << escaped(theorem = r.theorem) << "\n\n";
    out << "- `" << r.id << "` (" << name(r.kind) << ", " << name(r.verdict)
        << "): " << escaped(r.claim) << '\n';
    if (!r.corrected.empty()) out << "  - corrected: " << escaped(r.corrected) << '\n';
    if (!r.witness.empty())
      out << "  - " << witness_label(r.verdict) << ": " << escaped(r.witness) << '\n';
  }
  return out.str();
}

std::string to_text(const std::vector<MachineChecked>& theorems) {
  std::ostringstream out;
  out << "Checked by Coq (ctest -L coq compiles them again)\n" << std::left;
  std::set<std::string> statements;
  for (const MachineChecked& t : theorems) {
    out << std::setw(32) << t.statement << ' ' << t.wording << "\n    " << t.theorem << " in "
        << t.file << ".v; axioms: " << (t.axioms.empty() ? "none" : t.axioms) << '\n';
    statements.insert(t.statement);
  }
  out << theorems.size() << " theorems on " << statements.size() << " statements\n";
  return out.str();
}

std::string to_json(const std::vector<StepResult>& results,
                    const std::vector<MachineChecked>& theorems) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(6) << "{\n  \"steps\": [";
  const auto field = [&](const char* key, const std::string& value, const char* end = ",\n") {
    out << "      \"" << key << "\": " << (value.empty() ? "null" : quoted(value)) << end;
  };
  for (const StepResult& r : results) {
    out << (&r == results.data() ? "\n" : ",\n") << "    {\n";
    field("id", r.id);
    field("theorem", r.theorem);
    field("claim", r.claim);
    field("corrected", r.corrected);
    field("kind", name(r.kind));
    field("verdict", name(r.verdict));
    field("witness", r.witness);
    out << "      \"seconds\": " << r.seconds << "\n    }";
  }
  out << (results.empty() ? "],\n" : "\n  ],\n") << "  \"theorems\": [";
  for (const MachineChecked& t : theorems) {
    out << (&t == theorems.data() ? "\n" : ",\n") << "    {\n";
    field("statement", t.statement);
    field("file", t.file);
    field("theorem", t.theorem);
    field("says", t.wording);
    field("axioms", t.axioms, "\n");
    out << "    }";
  }
  out << (theorems.empty() ? "]\n}" : "\n  ]\n}");
  return out.str();
}

}  // namespace proofs
