// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Lists of claims against lists of what was derived.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "files/document.hpp"
#include "run/ledger.hpp"

namespace certificate {

using Number = std::uint64_t;

/// Walks along two ascending lists, and settles each claim, each simplex that is crossed but not
/// listed, and the claim that the others are not crossed.
/// @param key  the numbers that name a simplex
/// @param settle  what to do with a crossed simplex that is listed
/// @param witness  of a simplex, by its numbers, and whether it is one of `truth`: why it is not as
///                 the list says
template <std::size_t Count, class Simplex, class Key, class Settle, class Witness>
void compare_list(const char* kind, const Json& claims, const std::vector<Simplex>& truth,
                  const Key& key, const Settle& settle, const Witness& witness, Ledger& ledger) {
  bool complete = true;
  const auto compare = [&](const Simplex* simplex, const Json* claim,
                           const std::array<Number, Count>& numbers) {
    if (simplex != nullptr && simplex->is_decided() && simplex->is_crossed() && claim != nullptr)
      return settle(*simplex, *claim, kind + Json(numbers).dump());
    if (simplex != nullptr && simplex->is_decided() && !simplex->is_crossed() && claim == nullptr)
      return;
    complete = false;
    if (simplex != nullptr && !simplex->is_decided())
      return ledger.leave_open(kind + Json(numbers).dump(), "no proof closes");
    ledger.refute(kind + Json(numbers).dump(), claim != nullptr ? claim->dump() : "not listed",
                  claim == nullptr ? "crossed" : "not crossed, or not in the mesh but for what is left out",
                  [&] { return witness(numbers); });
  };
  auto next = truth.begin();
  for (const Json& claim : claims) {
    std::array<Number, Count> numbers;
    for (std::size_t i = 0; i < Count; ++i) numbers[i] = claim[i].get<Number>();
    for (; next != truth.end() && key(*next) < numbers; ++next)
      compare(&*next, nullptr, key(*next));
    const bool found = next != truth.end() && key(*next) == numbers;
    compare(found ? &*next : nullptr, &claim, numbers);
    if (found) ++next;
  }
  for (; next != truth.end(); ++next) compare(&*next, nullptr, key(*next));
  if (complete) ledger.certify();
}

template <class Simplex>
auto numbers_of(const Simplex& simplex) {
  std::array<Number, std::tuple_size_v<decltype(simplex.vertices)>> numbers;
  std::copy(simplex.vertices.begin(), simplex.vertices.end(), numbers.begin());
  return numbers;
}

}  // namespace certificate
