// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// The lattice of a NIfTI-1 or NIfTI-2 image (`.nii`, `.nii.gz`) with 6 or 9 values at each voxel, in
/// the fourth dimension, or the fifth after a fourth of 1. Voxel centres are the vertices.
///
/// Values   widened exactly; slope and intercept are applied, if there are any (rounded once).
/// Order    of 6: the lower triangle if the image's intent is a symmetric matrix, else the caller
///          must say. Tensors are not turned: the mode does not depend on their frame.
/// Places   by sform, else by qform, else by the sizes of voxels alone; in the image's unit.
/// Mask     `options.mask`: an image of the same lattice; cubes with a corner where it is zero or
///          no number are left out.
/// Throws   IoError.
/// Source   nifti1.h and nifti2.h of the NIfTI Data Format Working Group.
std::vector<RawGrid> read_nifti(const FieldSource& source);

}  // namespace tensortopo::detail
