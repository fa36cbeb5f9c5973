// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "extract/patch/patch.hpp"
#include "tensortopo/extract/extract_options.hpp"

namespace tensortopo {

/// True if a sheet is a disc that needs no inner samples: the eigenvectors turn less along its
/// boundary loop than from one sample to the next or so (the dominant one by twice that).
bool is_small_disc(const SheetTopology& sheet, std::span<const BoundaryVertex> boundary,
                   const Sampling& sampling);

}  // namespace tensortopo
