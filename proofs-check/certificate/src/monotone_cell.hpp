// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "face_level.hpp"

namespace certificate {

/// A closed curve of the level on the boundary of a cell, by a crossing on it, or by its number in
/// the face of which it is a closed curve.
struct RimCurve {
  unsigned simplex = 0;  ///< a bit for each corner of the edge or face
  std::size_t number = 0;
};

/// Which of the closed curves on the boundary of a monotone cell bound the same piece of the level
/// in it: for each curve a number. Nothing if a face takes too many parts.
///
/// Along its direction each point above can be moved to the upper part of the boundary, from where
/// larger modes leave the cell, and stays above; so the points above fall into the components that
/// are seen in the upper part. A region of the boundary that lies below that part belongs to where
/// any of its points comes out. The same holds for points below and the lower part. A curve
/// separates two components, one of each side, and a piece of the level is bounded by all the
/// curves between the same two, because the cell is simply connected.
///
/// @param corners  of the cell, as points of the refinement, ascending
/// @param faces  of which corner i is no part
/// @param direction  in which it is monotone, in weights of the refinement's roots
std::optional<std::vector<std::size_t>> pieces_of_cell(const Level& level,
                                                       const Refinement& refinement,
                                                       const std::array<Refinement::Id, 4>& corners,
                                                       const std::array<const FaceLevel*, 4>& faces,
                                                       const std::array<mpz_class, 4>& direction,
                                                       const std::vector<RimCurve>& curves);

/// A face of a cell: its corners' places among the cell's four, all but one.
constexpr std::array<std::size_t, 3> without(std::size_t opposite) {
  std::array<std::size_t, 3> face{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != opposite) face[n++] = i;
  return face;
}
/// The bits of a face's corners as bits of the cell's.
constexpr unsigned in_cell(unsigned bits, std::size_t opposite) {
  const unsigned low = bits & ((1U << opposite) - 1);
  return low | (bits ^ low) << 1;
}

}  // namespace certificate
