// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "files/document.hpp"
#include "input.hpp"
#include "run/ledger.hpp"

namespace certificate {

/// The tetrahedra about which a level claims nothing. False if there is no such tetrahedron.
/// @param reason_in  the reason that an entry gives
template <class Reason>
bool mark_left_out(const Json& claims, const Input& input, const Reason& reason_in,
                   std::vector<bool>& left_out, Ledger& ledger) {
  for (const Json& entry : claims["undecided"]) {
    const std::string reason = reason_in(entry[1]), name = "tetrahedron " + entry[0].dump();
    const std::size_t tet = input.tet_at(entry[0].get<Number>());
    if (tet == Input::kNone)
      return ledger.refute(
                 name, reason,
                 "no such tetrahedron, the input has " + std::to_string(input.tets.size())),
             false;
    left_out[tet] = true;
    ledger.of_level().left_out[reason].push_back(entry[0].get<Number>());
    ledger.leave_open(name, reason);
  }
  return true;
}

}  // namespace certificate
