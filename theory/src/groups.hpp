// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/theory/statement.hpp"

namespace tensortopo::theory {

// The groups of statements, in the order of the paper; statements.cpp joins them.
std::vector<Statement> tensor_statements();
std::vector<Statement> stability_statements();
std::vector<Statement> field_statements();
std::vector<Statement> matrix_statements();
std::vector<Statement> domain_statements();
std::vector<Statement> lift_statements();
std::vector<Statement> crossing_statements();
std::vector<Statement> chart_statements();
std::vector<Statement> sphere_statements();
std::vector<Statement> topology_statements();
std::vector<Statement> planar_statements();
std::vector<Statement> star_statements();

}  // namespace tensortopo::theory
