// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Which of the simplices of a certificate are claimed to be crossed alike in all fields.
#include <algorithm>

#include "tensortopo/certify/certified_curves.hpp"
#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

namespace {

/// @param simplices  with `vertices`, ascending by these
/// @return those that a claim names, as indices
template <class Simplex>
std::vector<std::size_t> named_by(const std::optional<StabilityClaim>& claim,
                                  const std::vector<Simplex>& simplices) {
  std::vector<std::size_t> places;
  if (!claim) return places;
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    std::array<TetMesh::Index, 3> vertices{-1, -1, -1};
    std::copy(simplices[i].vertices.begin(), simplices[i].vertices.end(), vertices.begin());
    if (std::binary_search(claim->crossed_simplices.begin(), claim->crossed_simplices.end(),
                           vertices))
      places.push_back(i);
  }
  return places;
}

}  // namespace

std::vector<std::size_t> CertifiedLevel::claimed_crossings() const {
  return named_by(stability, topology.edges);
}

std::vector<std::size_t> CertifiedCurves::claimed_crossings() const {
  return named_by(stability, faces);
}

}  // namespace tensortopo
