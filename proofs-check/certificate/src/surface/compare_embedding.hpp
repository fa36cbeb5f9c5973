// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "claims/compare_level.hpp"

namespace certificate {

/// Do the level's triangles meet in common vertices and edges only, exactly?
/// @param claimed  only true is a claim that means something
void compare_embedding(const LevelCase& c, bool claimed, Ledger& ledger);

}  // namespace certificate
