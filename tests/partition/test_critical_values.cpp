// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The events of a sweep, from pieces: each depends on the tetrahedra around one simplex.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pieces_of_fields.hpp"
#include "support/compared.hpp"
#include "support/trials.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"

namespace tensortopo::test {
namespace {

using Ids = std::array<std::int64_t, 4>;

/// All that a sweep takes from a critical point, with ids.
struct Event {
  double low, high;
  std::array<double, 3> point;
  std::array<double, 4> weights;
  bool is_certain;
  int index, dimension;
  std::vector<std::int64_t> around;
  LocalChange change;
  std::array<long, 5> growth;

  friend bool operator==(const Event&, const Event&) = default;
};

/// By the vertices of the simplex, ascending by mode.
using Events = std::map<Ids, std::vector<Event>>;

Ids ids_of(const MeshCriticalPoint& p, const std::vector<std::int64_t>& vertex_ids) {
  Ids ids{-1, -1, -1, -1};
  for (std::size_t k = 0; k < 4; ++k)
    if (p.vertices[k] >= 0) ids[k] = vertex_ids[static_cast<std::size_t>(p.vertices[k])];
  return ids;
}

Event event_of(const MeshCriticalPoint& p, const std::vector<std::int64_t>& vertex_ids) {
  Event event{p.low,
              p.high,
              {p.point.x, p.point.y, p.point.z},
              p.weights,
              p.is_certain,
              p.index,
              p.dimension,
              {},
              p.effect.change,
              {p.effect.euler_change, p.effect.components.least, p.effect.components.most,
               p.effect.boundary_loops.least, p.effect.boundary_loops.most}};
  for (const auto v : p.around) event.around.push_back(vertex_ids[static_cast<std::size_t>(v)]);
  return event;
}

/// Whether all vertices of the simplex are of one tetrahedron that the piece owns: then the piece
/// has all tetrahedra around it.
bool is_seen_whole(const MeshCriticalPoint& p, const MeshPiece& piece) {
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t) {
    if (piece.is_owned[t] == 0) continue;
    const auto& tet = piece.mesh.tets[t];
    if (std::all_of(p.vertices.begin(), p.vertices.end(), [&](TetMesh::Index v) {
          return v < 0 || std::find(tet.begin(), tet.end(), v) != tet.end();
        }))
      return true;
  }
  return false;
}

TEST(CriticalValuesOfPieces, AreThoseOfTheWholeMesh) {
  const int fields = trials(12);
  Compared shared("simplices with critical points that two pieces or more have",
                  static_cast<std::size_t>(fields)),
      changing("critical points that change the topology", static_cast<std::size_t>(fields));
  for (int field = 0; field < fields; ++field) {
    Random random(20261127u + static_cast<unsigned>(field));
    const TetMesh mesh = field_of_any_kind(random, random.integer(1, 3));
    const RenumberedMesh other = renumbered_mesh(mesh, random);
    const int pieces = random.integer(2, 16), kind = random.integer(0, 2);
    const auto owner = owners_of_kind(kind, other.mesh, pieces, random);
    std::vector<std::int64_t> own_numbers(mesh.points.size());
    for (std::size_t v = 0; v < own_numbers.size(); ++v)
      own_numbers[v] = static_cast<std::int64_t>(v);
    Events whole, found;
    for (const auto& p : mesh_critical_values(mesh, -1, 1).points) {
      whole[ids_of(p, own_numbers)].push_back(event_of(p, own_numbers));
      changing.count(p.effect.change != LocalChange::undecided);
    }
    for (int p = 0; p < pieces; ++p) {
      const MeshPiece piece = piece_of_renumbered(other, owner, p);
      Events here;
      for (const auto& point : mesh_critical_values(piece.mesh, -1, 1).points)
        if (is_seen_whole(point, piece))
          here[ids_of(point, piece.vertex_ids)].push_back(event_of(point, piece.vertex_ids));
      for (const auto& [simplex, events] : here) {
        const auto [place, is_new] = found.insert({simplex, events});
        EXPECT_TRUE(place->second == events) << "field " << field << ", piece " << p;
        shared.count(!is_new);
      }
    }
    EXPECT_TRUE(whole == found) << "field " << field;
  }
}

}  // namespace
}  // namespace tensortopo::test
