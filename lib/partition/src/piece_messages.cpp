// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "piece_messages.hpp"

#include <algorithm>
#include <string>

#include "differing_pieces.hpp"
#include "tensortopo/partition/curve_seam.hpp"
#include "tensortopo/partition/surface_seam.hpp"

namespace tensortopo {

namespace {

/// A run of ids that one piece owns.
struct OwnedRun {
  std::int64_t first, last;
  std::size_t piece;
};

/// Which pieces own which ids, ascending.
template <class Piece>
std::vector<OwnedRun> owned_runs(std::span<const Piece> pieces) {
  std::vector<OwnedRun> runs;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (const auto& [first, last] : pieces[p].owned_ids) runs.push_back({first, last, p});
  std::sort(runs.begin(), runs.end(),
            [](const OwnedRun& a, const OwnedRun& b) { return a.first < b.first; });
  return runs;
}

/// The piece that owns an id, or none.
std::optional<std::size_t> owner_of(std::int64_t id, std::span<const OwnedRun> runs) {
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), id,
                       [](std::int64_t cell, const OwnedRun& run) { return cell < run.first; });
  if (after == runs.begin() || std::prev(after)->last < id) return std::nullopt;
  return std::prev(after)->piece;
}

/// The first message that only one of two lists has, both ascending.
const PieceMessage* difference(std::span<const PieceMessage> a, std::span<const PieceMessage> b) {
  const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (i != a.end()) return &*i;
  return j != b.end() ? &*j : nullptr;
}

}  // namespace

void add_messages(const MeshPiece& piece, std::span<const MeshingMessage> messages,
                  std::vector<PieceMessage>& told, std::vector<PieceMessage>& heard) {
  for (const MeshingMessage& message : messages) {
    const auto from = as_size(message.from), to = as_size(message.to);
    const bool is_own = piece.is_owned[from] != 0;
    if (is_own == (piece.is_owned[to] != 0)) continue;
    (is_own ? told : heard)
        .push_back({piece.mesh.cell_ids[from], piece.mesh.cell_ids[to], message.pass, message.round,
                    message.digest});
  }
  std::sort(told.begin(), told.end());
  std::sort(heard.begin(), heard.end());
}

template <class Piece>
void require_same_messages(std::span<const Piece> pieces) {
  const auto runs = owned_runs(pieces);
  std::vector<std::vector<PieceMessage>> to_hear(pieces.size());
  for (const Piece& piece : pieces)
    for (const PieceMessage& message : piece.told)
      if (const auto owner = owner_of(message.to_cell, runs)) to_hear[*owner].push_back(message);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::sort(to_hear[p].begin(), to_hear[p].end());
    if (const PieceMessage* message = difference(to_hear[p], pieces[p].heard))
      refuse_differing("cell " + std::to_string(message->from_cell) +
                       " was not treated alike by all that have it");
  }
}

template void require_same_messages(std::span<const PieceSurface> pieces);
template void require_same_messages(std::span<const SurfaceSeam> seams);
template void require_same_messages(std::span<const PieceCurves> pieces);
template void require_same_messages(std::span<const CurveSeam> seams);

}  // namespace tensortopo
