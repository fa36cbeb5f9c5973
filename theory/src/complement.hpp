// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "tensors.hpp"

namespace tensortopo::theory {

/// A basis of the traceless tensors that are orthogonal to all of these, by elimination to reduced
/// echelon form. It shares nothing with the cross product of lib/field that it is compared to.
std::vector<Tensor> orthogonal_complement(std::span<const Tensor> tensors);

/// The same of a field's tensors.
std::vector<Tensor> orthogonal_complement(const TetrahedronField<Rational>& field);

}  // namespace tensortopo::theory
