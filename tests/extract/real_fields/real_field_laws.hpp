// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "symmetric_field.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo::test {

/// Laws that the everyday tests try on a part of the bundled fields and the long ones on more.

/// The bundled field of a compressed block, made symmetric.
const SymmetricField& symmetric_block();

/// The symmetric block's surface of a mode is flawless, and nothing is left out.
void expect_flawless_surface_of_symmetric_block(const std::string& mode);

/// So are its degenerate curves. The axis, which is a chain of edges, is a curve of mode -1.
void expect_axis_among_curves_of_symmetric_block(Degeneracy kind);

/// Where the curves of a field close to the symmetric block run, there are curves of the block.
void expect_curves_of_symmetric_block_near_those_of_general_fields(Degeneracy kind);

/// The degenerate curves of a bundled field pass through a face as often as exact counting says:
/// faces that they pass through, and others, as many as `most` of each.
/// @param name how the file's name begins
void expect_exact_counts_on_faces(const std::string& name, std::size_t most);

}  // namespace tensortopo::test
