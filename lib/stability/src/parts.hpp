// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "box_simplex.hpp"

namespace tensortopo::stability {

/// The two corners between which the angle is largest.
template <std::size_t Vertices>
std::pair<std::size_t, std::size_t> longest_edge(const Part<Vertices, Vertices>& part) {
  std::pair<std::size_t, std::size_t> edge{0, 1};
  double least = 2;
  for (std::size_t a = 0; a < Vertices; ++a)
    for (std::size_t b = a + 1; b < Vertices; ++b) {
      const double cosine =
          inner(part.tensors[a], part.tensors[b]) / (part.norms[a] * part.norms[b]);
      if (cosine < least) {
        least = cosine;
        edge = {a, b};
      }
    }
  return edge;
}

/// True only if a simplex consists of parts in each of which something is proved; it is bisected
/// until that is so.
///
/// @param parts      most parts to look at
/// @param holds      is it proved in a part?
/// @param may_hold   of a part's centre: could it be proved in a small part around? If not, the
///                   search ends: it is not the part's size that is at fault.
template <std::size_t Vertices, class Holds, class MayHold>
bool holds_in_parts(const BoxSimplex<Vertices>& simplex, int parts, const Holds& holds,
                    const MayHold& may_hold) {
  std::array<Place<Vertices>, Vertices> whole{};
  for (std::size_t i = 0; i < Vertices; ++i) whole[i][i] = 1;
  std::vector<std::array<Place<Vertices>, Vertices>> open{whole};
  for (int count = 0; !open.empty(); ++count) {
    if (count == parts) return false;
    const auto places = open.back();
    open.pop_back();
    const auto part = part_of(simplex, places);
    if (holds(part)) continue;
    if (!may_hold(centre_of(simplex, part))) return false;
    const auto [a, b] = longest_edge(part);
    Place<Vertices> middle;
    for (std::size_t i = 0; i < Vertices; ++i) middle[i] = (places[a][i] + places[b][i]) / 2;
    for (const std::size_t corner : {a, b}) {
      open.push_back(places);
      open.back()[corner] = middle;
    }
  }
  return true;
}

}  // namespace tensortopo::stability
