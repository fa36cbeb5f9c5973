// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "tensors.hpp"

namespace tensortopo::theory {

/// How often one of the two loops of the complex domain's boundary leaves a tetrahedron: the number
/// of its arcs in the surface of mode mu there, if it is not inside throughout. Nothing if that is
/// not proved, or from the critical mode on.
///
/// The loop is given by an angle, with alpha = middle + half cos(angle) and y a multiple of its
/// sine, and cut into parts on each of which it is proved to be inside, or outside; or to have a
/// single weight of unknown sign, with a derivative of one sign, the others being those of a tensor
/// inside. Along neighbouring parts of the last kind, of one weight and one sign, it enters or
/// leaves once if the parts before and after them differ, and else not at all. Where two such parts
/// of different weights meet, it is inside. In intervals.
///
/// Parameters as of `mode_of_loop_inside`.
std::optional<int> arcs_of_loop(const std::array<Rational, 3>& values, const Rational& s,
                                const std::array<Tensor, 4>& vertices, int side);

}  // namespace tensortopo::theory
