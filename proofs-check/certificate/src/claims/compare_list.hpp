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
#include "run/parallel.hpp"

namespace certificate {

using Number = std::uint64_t;

/// Walks along two ascending lists, and settles each claim, each simplex that is crossed but not
/// listed, and the claim that the others are not crossed.
/// @param key  the numbers that name a simplex
/// @param agrees  whether a crossed simplex is as a claim says; asked for several at the same time.
///                False may also mean that `settle` has to look
/// @param accept  takes note of a claim that agrees. False, without any note, if `settle` has to
///                look
/// @param settle  what to do with all other crossed simplices that are listed
/// @param witness  of a simplex, by its numbers, and whether it is one of `truth`: why it is not as
///                 the list says
template <std::size_t Count, class Simplex, class Key, class Agrees, class Accept, class Settle,
          class Witness>
void compare_list(const char* kind, const Json& claims, const std::vector<Simplex>& truth,
                  const Key& key, const Agrees& agrees, const Accept& accept, const Settle& settle,
                  const Witness& witness, Ledger& ledger) {
  struct Pair {
    const Simplex* simplex;
    const Json* claim;
    std::array<Number, Count> numbers;
    bool agrees;

    bool is_crossed() const { return simplex->is_decided() && simplex->is_crossed(); }
  };
  std::vector<Pair> pairs;
  pairs.reserve(claims.size());
  const auto add = [&](const Simplex* simplex, const Json* claim,
                       const std::array<Number, Count>& numbers) {
    const bool is_empty = simplex != nullptr && simplex->is_decided() && !simplex->is_crossed();
    if (claim != nullptr || !is_empty) pairs.push_back({simplex, claim, numbers, false});
  };
  auto next = truth.begin();
  for (const Json& claim : claims) {
    std::array<Number, Count> numbers;
    for (std::size_t i = 0; i < Count; ++i) numbers[i] = claim[i].get<Number>();
    for (; next != truth.end() && key(*next) < numbers; ++next) add(&*next, nullptr, key(*next));
    const bool found = next != truth.end() && key(*next) == numbers;
    add(found ? &*next : nullptr, &claim, numbers);
    if (found) ++next;
  }
  for (; next != truth.end(); ++next) add(&*next, nullptr, key(*next));

  parallel_for(pairs.size(), [&](std::size_t i) {
    Pair& pair = pairs[i];
    if (pair.simplex != nullptr && pair.claim != nullptr && pair.is_crossed())
      pair.agrees = agrees(*pair.simplex, *pair.claim);
  });
  bool complete = true;
  for (const auto& [simplex, claim, numbers, agreed] : pairs) {
    if (agreed && accept(*simplex, *claim)) {
      ledger.certify();
      continue;
    }
    const std::string name = kind + Json(numbers).dump();
    if (simplex != nullptr && simplex->is_decided() && simplex->is_crossed() && claim != nullptr) {
      settle(*simplex, *claim, name);
      continue;
    }
    complete = false;
    if (simplex != nullptr && !simplex->is_decided()) {
      ledger.leave_open(name, "no proof closes");
      continue;
    }
    ledger.refute(name, claim != nullptr ? claim->dump() : "not listed",
                  claim == nullptr
                      ? "crossed"
                      : "not crossed, or not in the mesh but for what is left out",
                  [&, &which = numbers] { return witness(which); });
  }
  if (complete) ledger.certify();
}

/// The same where each claim is settled one after the other.
template <std::size_t Count, class Simplex, class Key, class Settle, class Witness>
void compare_list(const char* kind, const Json& claims, const std::vector<Simplex>& truth,
                  const Key& key, const Settle& settle, const Witness& witness, Ledger& ledger) {
  const auto never = [](const Simplex&, const Json&) { return false; };
  compare_list<Count>(kind, claims, truth, key, never, never, settle, witness, ledger);
}

template <class Simplex>
auto numbers_of(const Simplex& simplex) {
  std::array<Number, std::tuple_size_v<decltype(simplex.vertices)>> numbers{};
  std::copy(simplex.vertices.begin(), simplex.vertices.end(), numbers.begin());
  return numbers;
}

}  // namespace certificate
