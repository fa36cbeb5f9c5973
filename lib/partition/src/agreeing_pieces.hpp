// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tensortopo/partition/piece_curves.hpp"
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

inline MergedSurface merged_of(const std::vector<PieceSurface>& pieces) {
  return merge_pieces(pieces);
}
inline MergedCurves merged_of(const std::vector<PieceCurves>& pieces) {
  return merge_curve_pieces(pieces);
}

/// The merged surface, or curves, of pieces with as few layers of ghosts as they need to agree.
/// @param pieces  pieces(layers): the surfaces or curves of all pieces
/// @param most_layers  with so many no piece can grow any more
template <class Pieces>
auto merge_agreeing_pieces(const Pieces& pieces, std::size_t most_layers) {
  for (int layers = 1;; ++layers) {
    try {
      return merged_of(pieces(layers));
    } catch (const PiecesDiffer&) {
      if (as_size(layers) > most_layers) throw;
    }
  }
}

}  // namespace tensortopo
