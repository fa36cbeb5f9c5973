// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "groups.hpp"

namespace tensortopo::theory {
namespace {

std::vector<Statement> all_statements() {
  std::vector<Statement> all;
  for (auto& group : {tensor_statements(), field_statements(), matrix_statements(),
                      domain_statements(), chart_statements()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = all_statements();
  return all;
}

}  // namespace tensortopo::theory
