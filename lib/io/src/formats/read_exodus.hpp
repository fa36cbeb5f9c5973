// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "formats/field_format.hpp"

namespace tensortopo::detail {

/// The mesh of an Exodus II file (.e, .exo) in a classic format of NetCDF, and the results of one
/// time: scalars, and the tensors that their names spell (`add_joined_scalars`), at nodes and of
/// elements. The cell array `ObjectId` has the number of each element's block. A block without a
/// variable has no number there. Nodes and elements are in the order of the file. Throws IoError.
/// Source  L. Schoof and V. Yarberry, "EXODUS II: a finite element data model", SAND92-2137.
std::vector<RawGrid> read_exodus(const FieldSource& source);

/// What each of its steps is.
std::vector<std::string> exodus_steps(const std::shared_ptr<const InputFile>& file);

}  // namespace tensortopo::detail
