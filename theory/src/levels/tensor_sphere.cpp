// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/tensor_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tensortopo::theory {
namespace {

constexpr std::array<Integer Deviator<Integer>::*, 5> kEntries = {
    &Deviator<Integer>::a, &Deviator<Integer>::b, &Deviator<Integer>::xy, &Deviator<Integer>::yz,
    &Deviator<Integer>::xz};

// By elimination at the entry that is largest for the normal, in units of the entry's length.
SpanBasis echelon_basis(const Deviator<Integer>& normal) {
  std::array<Deviator<Integer>, 5> unit{};
  std::array<Integer, 5> along;
  std::size_t pivot = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    unit[i].*kEntries[i] = 1;
    along[i] = norm_form(normal, unit[i]);
    const Integer gain = along[i] * along[i] * norm_form(unit[pivot]);
    if (gain > along[pivot] * along[pivot] * norm_form(unit[i])) pivot = i;
  }
  SpanBasis basis;
  for (std::size_t i = 0, row = 0; i < 5; ++i) {
    if (i != pivot) basis[row++] = primitive(along[pivot] * unit[i] - along[i] * unit[pivot]);
  }
  return basis;
}

using Square = std::array<std::array<double, 4>, 4>;

// Rows of coefficients that make a basis nearly orthonormal, from a general start.
Square orthonormal_rows(const std::array<Deviator<double>, 4>& basis) {
  Square rows = {{{{7, 3, -2, 4}}, {{-3, 6, 5, 1}}, {{2, -4, 7, 3}}, {{-5, 1, -3, 8}}}};
  const auto inner_of = [&](const std::array<double, 4>& p, const std::array<double, 4>& q) {
    Deviator<double> s{}, t{};
    for (std::size_t k = 0; k < 4; ++k) s = s + p[k] * basis[k], t = t + q[k] * basis[k];
    return norm_form(s, t);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double share = inner_of(rows[i], rows[j]);
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] -= share * rows[j][k];
    }
    const double length = std::sqrt(inner_of(rows[i], rows[i]));
    for (double& x : rows[i]) x /= length;
  }
  return rows;
}

double as_double(const Integer& v) { return v.convert_to<double>(); }

Deviator<double> unit_tensor(const Deviator<Integer>& t) {
  const Deviator<double> d = {as_double(t.a), as_double(t.b), as_double(t.xy), as_double(t.yz),
                              as_double(t.xz)};
  return 1 / std::sqrt(norm_form(d)) * d;
}

Integer determinant_of(const std::array<std::array<Integer, 4>, 4>& m) {
  // By minors of the first two and of the last two rows.
  const auto minor = [&](std::size_t row, std::size_t i, std::size_t j) {
    return Integer(m[row][i] * m[row + 1][j] - m[row][j] * m[row + 1][i]);
  };
  return minor(0, 0, 1) * minor(2, 2, 3) - minor(0, 0, 2) * minor(2, 1, 3) +
         minor(0, 0, 3) * minor(2, 1, 2) + minor(0, 1, 2) * minor(2, 0, 3) -
         minor(0, 1, 3) * minor(2, 0, 2) + minor(0, 2, 3) * minor(2, 0, 1);
}

// The cells of the 16-cell, of which 2 i and 2 i + 1 are opposite vertices.
void add_orthants(LevelComplex& complex) {
  for (unsigned signs = 0; signs < 16; ++signs) {
    complex.add_cell({signs & 1, 2 + (signs >> 1 & 1), 4 + (signs >> 2 & 1), 6 + (signs >> 3)});
  }
}

std::optional<LevelSurface> refined_surface(LevelComplex complex, std::size_t budget) {
  if (!complex.refine(budget)) return std::nullopt;
  return level_surface(complex);
}

}  // namespace

SpanBasis span_basis(const Deviator<Rational>& normal) {
  const SpanBasis echelon = echelon_basis(primitive(normal));
  std::array<Deviator<double>, 4> unit;
  std::array<double, 4> size;
  for (std::size_t k = 0; k < 4; ++k) {
    unit[k] = unit_tensor(echelon[k]);
    size[k] = std::sqrt(as_double(norm_form(echelon[k])));
  }
  const Square rows = orthonormal_rows(unit);
  const double largest = *std::max_element(size.begin(), size.end());
  // Finer, until the rounded rows are independent; the first is fine enough as a rule.
  for (double parts = 64;; parts *= 64) {
    std::array<std::array<Integer, 4>, 4> whole;
    SpanBasis basis;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        whole[i][k] = Integer(std::round(parts * rows[i][k] * (largest / size[k])));
        basis[i] = basis[i] + whole[i][k] * echelon[k];
      }
      basis[i] = primitive(basis[i]);
    }
    if (determinant_of(whole) != 0) return basis;
  }
}

LevelComplex tensor_sphere(const SpanBasis& basis, const ModeLevel& level) {
  LevelComplex complex(level);
  for (const auto& b : basis) {
    complex.add_vertex(b);
    complex.add_vertex(Integer(-1) * b);
  }
  add_orthants(complex);
  return complex;
}

LevelComplex antipodal_sphere(const SpanBasis& basis) {
  LevelComplex complex = LevelComplex::antipodal();
  for (const auto& b : basis) complex.add_twins(b);
  add_orthants(complex);
  return complex;
}

LevelComplex tensor_tetrahedron(const std::array<Deviator<Rational>, 4>& vertices,
                                const ModeLevel& level) {
  LevelComplex complex(level);
  LevelComplex::Cell cell;
  for (std::size_t i = 0; i < 4; ++i) cell[i] = complex.add_vertex(primitive(vertices[i]));
  complex.add_cell(cell);
  return complex;
}

std::optional<LevelSurface> sphere_surface(const SpanBasis& basis, const ModeLevel& level,
                                           std::size_t budget) {
  return refined_surface(tensor_sphere(basis, level), budget);
}

std::optional<LevelSurface> projective_neutral_surface(const SpanBasis& basis, std::size_t budget) {
  return refined_surface(antipodal_sphere(basis), budget);
}

std::optional<LevelSurface> tetrahedron_surface(const std::array<Deviator<Rational>, 4>& vertices,
                                                const ModeLevel& level, std::size_t budget) {
  return refined_surface(tensor_tetrahedron(vertices, level), budget);
}

}  // namespace tensortopo::theory
