// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "distances/distance_proof.hpp"

#include <cmath>

#include "distances/reach_search.hpp"

namespace tensortopo {

namespace {

struct ModeCells {
  const TetMesh& mesh;
  const ScaledField<double>& field;
  const Level<double>& level;

  detail::LevelInCell at(TetMesh::Index tet) const { return {mesh, field, level, tet}; }
  bool is_undefined_at(TetMesh::Index vertex) const { return field.is_zero[as_size(vertex)] != 0; }
};

}  // namespace

double reach_length(int n) {
  const int exponent = n >= 0 ? n / 4 : -((3 - n) / 4);
  return std::ldexp(static_cast<double>(4 + (n - 4 * exponent)), exponent);
}

int reach_of(double length) {
  int n = 4 * (std::ilogb(length) - 2);
  while (reach_length(n) < length) ++n;
  return n;
}

DistanceClaim prove_distance(const TetMesh& mesh, const SurfaceMesh& surface,
                             std::span<const std::size_t> triangles, const LevelTopology& topology,
                             const ScaledField<double>& field, const Level<double>& level,
                             double wanted) {
  return detail::distance_claim(mesh, surface, triangles, topology, ModeCells{mesh, field, level},
                                wanted);
}

MovedPlaces moved_places(const TetMesh& mesh, const SurfaceMesh& surface,
                         std::span<const int> reach, const ScaledField<double>& field,
                         const Level<double>& level) {
  return detail::places_moved(mesh, surface, reach, ModeCells{mesh, field, level});
}

}  // namespace tensortopo
