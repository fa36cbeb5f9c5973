// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/persistence/mode_persistence.hpp"

namespace tensortopo {

/// Writes pairs as lines from the place of birth to that of death, in order; of a pair without a
/// known death a line of no length. Point data: `mode`. Cell data, of each pair: `dimension` (0 a
/// component, 1 a loop, 2 a void), `kind` (1 superlevel, -1 sublevel, 0 extended), `birth`, `death`
/// (NaN if there is none, or none known), `lasting` (1: there is none), `angle_persistence`,
/// `survives`, `curve` (-1 if it is none), `tie` and `certain`. Field data: the notes. Throws
/// IoError.
void write_pairs(const std::vector<PersistencePair>& pairs, const std::filesystem::path& file,
                 const std::vector<FileNote>& notes);

}  // namespace tensortopo
