// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Tensors and fields that lack one hypothesis of a statement, and violate it.
#pragma once

#include "tensortopo/theory/outcome.hpp"

namespace tensortopo::theory {

// Of single tensors.
Outcome identity_as_a_tensor();
Outcome equal_pair_with_trace();
Outcome parameter_beyond_one();
Outcome discriminant_with_trace();
Outcome lode_angles_with_trace();
Outcome zero_tensor();
Outcome line_of_one_tensor();
Outcome maxima_that_do_not_last();

// Of fields.
Outcome two_orthogonal_tensors();
Outcome isotropic_across_vector();
Outcome vanishing_boundary_tensor();
Outcome boundary_of_one_point();
Outcome singularities_that_coincide();
Outcome level_through_the_saddle();
Outcome degenerate_saddle();
Outcome dual_of_degenerate_tensor();
Outcome third_equation_fails();

}  // namespace tensortopo::theory
