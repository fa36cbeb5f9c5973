// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "extract/level/level.hpp"
#include "tensortopo/certify/certified_level.hpp"
#include "tensortopo/extract/scaled_field.hpp"

namespace tensortopo {

/// As `find_brackets` does, for a mode.
std::optional<std::vector<DyadicBracket>> crossing_brackets(const LevelTopology::Edge& edge,
                                                            const ScaledField<double>& field,
                                                            const Level<double>& level);

}  // namespace tensortopo
