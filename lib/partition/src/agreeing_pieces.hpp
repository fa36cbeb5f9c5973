// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo {

/// The options for one of several pieces: progress says which.
inline ExtractOptions options_of_piece(const ExtractOptions& options, std::int32_t number,
                                       std::int32_t pieces) {
  ExtractOptions own = options;
  if (options.progress)
    own.progress = [&options, label = "piece " + std::to_string(number + 1) + " of " +
                                      std::to_string(pieces) +
                                      ": "](std::string_view stage, double fraction) {
      options.progress(label + std::string(stage), fraction);
    };
  return own;
}

/// The merged surface of pieces with as few layers of ghosts as they need to agree.
/// @param pieces  pieces(layers): the surfaces of all pieces
/// @param most_layers  with so many no piece can grow any more
template <class Pieces>
MergedSurface merge_agreeing_pieces(const Pieces& pieces, std::size_t most_layers) {
  for (int layers = 1;; ++layers) {
    try {
      return merge_pieces(pieces(layers));
    } catch (const PiecesDiffer&) {
      if (as_size(layers) > most_layers) throw;
    }
  }
}

}  // namespace tensortopo
