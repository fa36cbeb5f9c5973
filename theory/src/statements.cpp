// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "groups.hpp"
#include "hypotheses/hypotheses.hpp"

namespace tensortopo::theory {
namespace {

std::vector<Statement> all_statements() {
  std::vector<Statement> all;
  for (auto group : {tensor_statements, stability_statements, field_statements, matrix_statements,
                     domain_statements, lift_statements, crossing_statements, chart_statements,
                     sphere_statements, topology_statements, planar_statements, star_statements}) {
    std::ranges::move(group(), std::back_inserter(all));
  }
  add_hypotheses(all);
  return all;
}

}  // namespace

std::string_view name(Flaw flaw) {
  switch (flaw) {
    case Flaw::wording:
      return "misprint or wording";
    case Flaw::projective:
      return "projective, not affine";
    case Flaw::exceptional:
      return "excluded by structural stability";
    case Flaw::substantive:
      break;
  }
  return "substantive";
}

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = all_statements();
  return all;
}

const Statement* find_statement(std::string_view id) {
  const auto& all = statements();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Statement& s) { return s.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<const Statement*> statements_called(std::string_view name) {
  if (const Statement* one = find_statement(name)) return {one};
  std::vector<const Statement*> result;
  if (name.size() != 1) return result;
  for (const Statement& s : statements()) {
    for (const std::string_view kind : {"Theorem ", "Corollary ", "Lemma "}) {
      const auto at = s.paper.find(kind);
      if (at == std::string::npos || at + kind.size() >= s.paper.size()) continue;
      if (s.paper.starts_with("none") || s.paper[at + kind.size()] != name.front()) continue;
      result.push_back(&s);
      break;
    }
  }
  return result;
}

}  // namespace tensortopo::theory
