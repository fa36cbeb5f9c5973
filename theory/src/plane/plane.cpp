// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "plane/plane.hpp"

#include <utility>
#include <vector>

namespace tensortopo::theory {
namespace {

using Row = std::array<Rational, 5>;

std::array<Rational*, 5> entries(Deviator<Rational>& d) {
  return {&d.a, &d.b, &d.xy, &d.yz, &d.xz};
}

// The inner product with d as a linear function of the five entries.
Row functional(const Deviator<Rational>& d) {
  Row row;
  for (std::size_t i = 0; i < 5; ++i) {
    Deviator<Rational> unit;
    *entries(unit)[i] = 1;
    row[i] = norm_form(d, unit);
  }
  return row;
}

// A basis of the vectors on which all rows vanish.
std::vector<Row> null_space(std::vector<Row> rows) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < 5; ++column) {
    const std::size_t next = pivots.size();
    std::size_t found = next;
    while (found < rows.size() && rows[found][column] == 0) ++found;
    if (found == rows.size()) continue;
    std::swap(rows[next], rows[found]);
    const Rational pivot = rows[next][column];
    for (Rational& x : rows[next]) x = x / pivot;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == next) continue;
      const Rational factor = rows[i][column];
      for (std::size_t j = 0; j < 5; ++j) rows[i][j] = rows[i][j] - factor * rows[next][j];
    }
    pivots.push_back(column);
  }
  std::vector<Row> basis;
  for (std::size_t column = 0, pivot = 0; column < 5; ++column) {
    if (pivot < pivots.size() && pivots[pivot] == column) {
      ++pivot;
      continue;
    }
    Row vector;
    vector[column] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) vector[pivots[i]] = -rows[i][column];
    basis.push_back(vector);
  }
  return basis;
}

// A positive number that makes the entries of all these integers.
Integer common_denominator(std::vector<Deviator<Rational>> all) {
  Integer common(1);
  for (Deviator<Rational>& d : all) {
    for (const Rational* entry : entries(d)) common = lcm(common, Integer(denominator(*entry)));
  }
  return common;
}

IntegerTensor integral(const Deviator<Rational>& d, const Integer& factor) {
  const auto t = Rational(factor) * thrice(d);
  const auto whole = [](const Rational& x) { return Integer(numerator(x)); };
  return {whole(t.xx), whole(t.yy), whole(t.zz), whole(t.xy), whole(t.yz), whole(t.xz)};
}

}  // namespace

std::optional<Plane> plane_of(const TriangleField<Rational>& field) {
  const auto& d = field.vertex;
  const auto normal = null_space({functional(d[0]), functional(d[1]), functional(d[2])});
  if (normal.size() != 2) return std::nullopt;
  Plane plane;
  const Integer factor = common_denominator({d[0], d[1], d[2]});
  for (std::size_t i = 0; i < 3; ++i) plane.basis[i] = integral(d[i], factor);
  for (std::size_t i = 0; i < 2; ++i) {
    Deviator<Rational> n;
    for (std::size_t j = 0; j < 5; ++j) *entries(n)[j] = normal[i][j];
    plane.complement[i] = integral(n, common_denominator({n}));
  }
  return plane;
}

std::optional<Plane> plane_of(const TetrahedronField<Rational>& field) {
  return plane_of(first_face(field));
}

TriangleField<Rational> first_face(const TetrahedronField<Rational>& field) {
  return {{field.vertex[0], field.vertex[1], field.vertex[2]}};
}

IntegerTensor gram_matrix(const std::array<IntegerTensor, 3>& b) {
  return {inner(b[0], b[0]), inner(b[1], b[1]), inner(b[2], b[2]),
          inner(b[0], b[1]), inner(b[1], b[2]), inner(b[0], b[2])};
}

}  // namespace tensortopo::theory
