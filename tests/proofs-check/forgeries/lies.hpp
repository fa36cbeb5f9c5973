// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Directed forgeries: for each field of a certificate and of its surface the lies about it that
// would change the claimed topology, position, orientation, mode or extent.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "forgery.hpp"

namespace tensortopo::test {

/// Random choices.
class Pick {
 public:
  explicit Pick(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
  bool coin() { return below(2) == 0; }
  /// -1 or 1.
  int step() { return coin() ? 1 : -1; }

 private:
  std::mt19937_64 random_;
};

/// One row of the table in FORGERIES.md: a field, and how to lie about it.
struct LieRow {
  std::string field;
  /// Alters the exhibit such that it says something false. False if it has nothing to lie about.
  std::function<bool(Exhibit&, Pick&)> tell;
};

/// About what the certificate's fields say.
std::vector<LieRow> lies_of_claims();
/// About claims that may be left out: embedded, isotopic, stable, near.
std::vector<LieRow> lies_of_optional_claims();
/// About points, triangles and the field, with counts, components and hashes made right again.
std::vector<LieRow> lies_of_files();
/// Several fields at once, so that they agree with each other.
std::vector<LieRow> lies_across();
/// Numbers and texts in other forms, which a reader may take for something else.
std::vector<LieRow> lies_of_forms();
/// Meshes and surfaces of another shape, with all else made to fit.
std::vector<LieRow> lies_of_shapes();

/// Any level of the certificate.
nlohmann::json& any_level(Exhibit& e, Pick& pick);
/// Adds to an integer of a document.
inline void add(nlohmann::json& number, std::int64_t step) {
  number = number.get<std::int64_t>() + step;
}
/// No distance is claimed, nor what rests on it: what is left are claims about topology and places.
void drop_distances(Exhibit& e);
/// Makes the last level's ranges, the counts, the components and the hashes fit the triangles.
void make_consistent(Exhibit& e);

}  // namespace tensortopo::test
