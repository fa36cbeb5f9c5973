// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/compare_embedding.hpp"

#include <span>
#include <string>

#include "surface/embedded.hpp"

namespace certificate {

void compare_embedding(const LevelCase& c, bool claimed, Ledger& ledger) {
  const std::span triangles =
      std::span(c.surface.triangles).subspan(c.triangles.first, c.triangles.count);
  ledger.of_level().claims_embedded = true;
  if (!claimed) return ledger.refute("embedded", "false", "the key is left out instead");
  const EmbeddingResult result = find_conflict(c.surface.points, triangles);
  const auto name = [&](std::size_t t) {
    return std::to_string(c.triangles.first + t) + ' ' + Json(triangles[t]).dump();
  };
  if (result.conflict) {
    const auto [s, t] = *result.conflict;
    ledger.refute("embedded", "triangles that meet in common vertices and edges only",
                  s == t ? "triangle " + name(s) + " has no area"
                         : "triangles " + name(s) + " and " + name(t) + " meet elsewhere");
  } else if (!result.decided) {
    ledger.leave_open("embedded", "more triangles near each other than the budget allows");
  } else {
    ledger.of_level().embedded = true;
    ledger.certify();
  }
}

}  // namespace certificate
