// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tensortopo/persistence/mode_homology.hpp"

namespace tensortopo {

/// What each dimension counts, as people read it.
inline constexpr std::array<const char*, 3> kFeatureNames{"components", "loops", "voids"};

/// Persistence diagrams and barcodes, in the mode and in the signed Lode angle, as the bytes of a
/// PNG: components as dots and full bars, loops as crosses and dashed bars, voids as squares and
/// dotted bars; and the Betti numbers. Throws std::runtime_error if there is no display (see
/// `DisplayServer`).
std::string persistence_chart(const std::vector<PersistencePair>& pairs,
                              const ModeHomology& homology);

}  // namespace tensortopo
