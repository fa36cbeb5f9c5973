// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/match_chains.hpp"

#include <array>
#include <set>

namespace certificate {

/// The search of Knuth, Morris and Pratt: `border[i]` is the length of the longest part in front of
/// the first i places that also ends there.
std::optional<std::size_t> turn_between(const BorderChain& chain, const BorderChain& other) {
  const auto &places = chain.places, &others = other.places;
  const std::size_t count = places.size();
  if (others.size() != count || other.curve.is_closed != chain.curve.is_closed) return std::nullopt;
  std::vector<std::size_t> border(count + 1);
  for (std::size_t i = 1, length = 0; i < count; border[++i] = length) {
    while (length > 0 && places[i] != places[length]) length = border[length];
    if (places[i] == places[length]) ++length;
  }
  const std::size_t most = chain.curve.is_closed ? 2 * count - 1 : count;
  for (std::size_t i = 0, length = 0; i < most; ++i) {
    const BorderPlace& place = others[(2 * count - 1 - i) % count];
    while (length > 0 && place != places[length]) length = border[length];
    if (place == places[length]) ++length;
    if (length == count) return (2 * count - 1 - (i + 1 - count)) % count;
  }
  return std::nullopt;
}

std::size_t first_difference(const BorderChain& chain, const BorderChain& other) {
  std::set<std::array<BorderPlace, 2>> known;
  const auto count = other.places.size();
  for (std::size_t i = 0; i < other.edges(); ++i)
    known.insert({other.places[(i + 1) % count], other.places[i]});
  for (std::size_t i = 0; i < chain.edges(); ++i)
    if (!known.contains({chain.places[i], chain.places[(i + 1) % chain.places.size()]})) return i;
  return 0;
}

}  // namespace certificate
