// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// What the linear field of a tetrahedron lacks of being general.
struct FieldStrata {
  /// Dimension of the span of the four deviators; the paper's statements ask for 4.
  int rank = 0;
  /// Vertices whose deviator is zero: they have no mode.
  int zero_vertices = 0;
  /// All tensors have an eigenvector in common, as on a plane of symmetry or in plane strain; the
  /// rank is then at most 3. True as well if all deviators are zero.
  bool common_eigenvector = false;
  /// Of rank 4, and the characteristic tensor has determinant 0: both signs of it will do.
  bool neutral_characteristic = false;
  /// Of rank 4, and the characteristic tensor has mode -1: two of its eigenvalues are equal.
  bool degenerate_characteristic = false;

  /// None of these.
  bool is_general() const {
    return rank == 4 && zero_vertices == 0 && !neutral_characteristic && !degenerate_characteristic;
  }
  /// Member by member.
  friend bool operator==(const FieldStrata&, const FieldStrata&) = default;
};

/// Decided without error: in doubles with a proved bound and in intervals where these can tell, in
/// rationals otherwise. Throws std::invalid_argument if an entry is not finite.
FieldStrata field_strata(const std::array<SymmetricTensor<double>, 4>& tensors);

}  // namespace tensortopo
