// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "groups.hpp"

namespace tensortopo::theory {
namespace {

std::vector<Statement> all_statements() {
  std::vector<Statement> all;
  for (auto group :
       {tensor_statements, field_statements, matrix_statements, domain_statements, lift_statements,
        chart_statements, sphere_statements, topology_statements, planar_statements}) {
    std::ranges::move(group(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

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

}  // namespace tensortopo::theory
