// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "claims/compare_level.hpp"

namespace certificate {

/// Numbers for the closed curves of a face, in the order of the curves, that follow from places and
/// tensors of its corners only: meshes that number these otherwise have the same ones. Nothing if a
/// refinement with the corners in the order of places does not close.
std::vector<std::size_t> curve_numbers(const LevelCase& c, const FaceTopology& face);

}  // namespace certificate
