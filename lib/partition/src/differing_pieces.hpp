// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is said of pieces that do not agree where they meet.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// @param what  ends before the remedy
[[noreturn]] inline void refuse_differing(const std::string& what) {
  throw PiecesDiffer("pieces: " + what +
                     ": they were extracted with other options, or need more layers of ghosts");
}

/// @param what  what differs
/// @param ids  vertices of a simplex; -1 fills up
[[noreturn]] inline void refuse_simplex(const std::string& what,
                                        std::span<const std::int64_t> ids) {
  std::string text = what + " at the simplex of vertices";
  for (const std::int64_t id : ids)
    if (id >= 0) text += " " + std::to_string(id);
  refuse_differing(text);
}

/// Of triangles in two cells that have no side in common.
[[noreturn]] inline void refuse_sides(std::int64_t cell, std::int64_t ghost) {
  refuse_differing("the triangles of cells " + std::to_string(cell) + " and " +
                   std::to_string(ghost) + " do not meet");
}

}  // namespace tensortopo
