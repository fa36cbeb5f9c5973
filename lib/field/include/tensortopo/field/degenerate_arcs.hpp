// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"
#include "tensortopo/tensor/vector3.hpp"

namespace tensortopo {

/// Where the degenerate curve of a tetrahedron's field leaves it.
struct DegenerateEnd {
  int face = 0;  ///< the one opposite this vertex
  /// Next to the end, in that face: homogeneous weights. From here to the end itself the mode stays
  /// beyond the mode asked for.
  std::array<double, 4> weights{};
};

/// A part of the degenerate curve inside a tetrahedron, from one face to another (or the same).
struct DegenerateArc {
  std::array<DegenerateEnd, 2> ends;  ///< where it enters and leaves
  /// Unit dominant eigenvectors along it, from the first end to the last, at small angles to each
  /// other; rounded.
  std::vector<Vector3<double>> dominant;
};

/// The parts of the curve of mode 1 (-1 if `mode` is negative) inside a tetrahedron: all of them,
/// and which ends each joins, proved.
///
/// The curve is a conic seen from the dominant eigenvectors: T = e e^T - |e|^2 I / 3 is in the
/// field exactly if e N e = 0, N being the characteristic tensor. Along the conic the barycentric
/// weights of T are quadratic forms of e, and an interval in which all are positive is one arc. At
/// its ends the curve crosses the face transversally.
///
/// @param exponents weights refer to `tensors[i] * 2^exponents[i]`
/// @return nothing if the curve passes too close to an edge or touches a face, so that nothing is
///         proved, or if the rank of the field is not certainly 4
std::optional<std::vector<DegenerateArc>> degenerate_arcs(
    const std::array<SymmetricTensor<double>, 4>& tensors, const std::array<int, 4>& exponents,
    const ModeValue& mode);

}  // namespace tensortopo
