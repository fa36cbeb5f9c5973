// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Where the topology of a tetrahedron's levels can change, seen from one level.
///
/// A mode m is measured by its gap 1 - m^2; all modes here have one sign. Critical values are those
/// of the mode of the linear field inside the tetrahedron, along its faces and edges, and at its
/// vertices. By Thom's first isotopy lemma, levels without a critical value between them are
/// isotopic, within the tetrahedron and within each face and edge.
struct CriticalGaps {
  /// Proved: no critical value has a gap from that of the level up to, but not including, this.
  double open_until = 0;
  /// Proved: none is closer to +-1 than the level, other than +-1 itself inside or on a face. So
  /// the level surrounds the degenerate curve and nothing else.
  bool none_beyond = false;
};

/// The critical gaps around the level of a mode.
///
/// Critical points come without a search in space. Inside there is one at most, whose tensor is
/// made from the characteristic tensor N; on a face those that are not degenerate are made from
/// the zeros of a binary cubic on the tensors N orthogonal to the face. Their gap is mode(N)^2,
/// which does not cancel near degenerate tensors. All of it is computed in intervals, so that the
/// answer is proved.
///
/// @param widest no gap beyond it is looked at, and `open_until` is at most that
/// @return nothing if the level cannot be told from a critical one, or the field of the tetrahedron
///         or of a face is not of full rank, or only just
std::optional<CriticalGaps> critical_gaps(const std::array<SymmetricTensor<double>, 4>& tensors,
                                          const ModeValue& mode, double widest);

}  // namespace tensortopo
