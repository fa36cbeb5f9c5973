// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "tensortopo/tensor/mode_parameter.hpp"
#include "tensortopo/tensor/symmetric_tensor.hpp"

namespace tensortopo {

/// Which end of a range of modes belongs to it as well as the other.
enum class OwnLevel { excluded, included };

/// Whether the mode of the linear field on a simplex, or on one of its faces, edges and vertices,
/// is certainly free of critical values from one level to another, `other` included. By Thom's
/// first isotopy lemma such levels are isotopic, within the simplex and within each of its faces,
/// if the deviator vanishes nowhere in it: with mu excluded and `other` larger, `other` has the
/// topology of mu + 0.
///
/// All of it is decided in rationals. The critical values of the mode on a linear space of
/// deviators are known from few numbers: on a line there is one; on a plane those at the zeros of a
/// binary cubic; if N runs through the tensors orthogonal to three (one N if to four), then they
/// are +-sqrt(1 - mode(N)^2) at the zeros of a binary cubic (at the one N), and +-1. Zeros are
/// counted by the theorem of Sturm and Tarski. As these count for the whole span of the vertex
/// tensors and for either sign, an answer `false` may be due to a point outside the simplex.
///
/// @param tensors one to four, with nonzero deviators
/// @param mu,other of modulus below 1, and neither is the opposite of the other's sign
bool is_free_of_critical_values(std::span<const SymmetricTensor<double>> tensors,
                                const ModeValue& mu, const ModeValue& other, OwnLevel own);

/// Whether mu, exactly, is the value of the mode at a critical point inside an edge.
/// @param first,second with nonzero deviators, not opposite
bool is_critical_on_edge(const SymmetricTensor<double>& first,
                         const SymmetricTensor<double>& second, const ModeValue& mu);

/// Whether mu or -mu, exactly, is the value of the mode at a critical point of the plane of a
/// triangle.
bool is_critical_on_plane(const std::array<SymmetricTensor<double>, 3>& tensors,
                          const ModeValue& mu);

}  // namespace tensortopo
