// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// How far from a mode, towards zero, the levels of a tetrahedron keep their topology.
///
/// A mode m is measured by its gap 1 - m^2. The result g is such that the mode of the linear field
/// has no critical value with the sign of `mode` and a gap in [1 - mode^2, g): not inside the
/// tetrahedron, nor along one of its faces or edges, nor at a vertex. By Thom's first isotopy lemma
/// all levels in that range are isotopic, within the tetrahedron and within each face and edge.
///
/// Critical points come without a search in space. Inside there is one at most, whose tensor is
/// made from the characteristic tensor N; on a face those that are not degenerate are made from
/// the zeros of a binary cubic on the tensors N orthogonal to the face. Their gap is mode(N)^2,
/// which does not cancel near degenerate tensors. All of it is computed in intervals, so that the
/// answer is proved.
///
/// @param widest no gap beyond it is looked at, and the result is at most that
/// @return nothing if no such gap could be proved: a critical value is too close to the mode, or
///         the field of the tetrahedron or of a face is not of full rank, or only just
std::optional<double> uncritical_gap(const std::array<SymmetricTensor<double>, 4>& tensors,
                                     const ModeValue& mode, double widest);

}  // namespace tensortopo
