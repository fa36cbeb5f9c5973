// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "departures.hpp"
#include "landmarks.hpp"
#include "numeric_mode.hpp"
#include "simplex_maxima.hpp"

namespace tensortopo::persistence {

/// A point in a tetrahedron; the weights are exact.
struct TetPlace {
  TetMesh::Index tet = -1;
  TetWeights weights{};
};

/// Finds and proves paths that lead up to maxima of the mode. Not for several threads at once.
class Ascent {
 public:
  Ascent(const TetMesh& mesh, const VertexStars& stars, const Landmarks& landmarks,
         SimplexMaxima& along)
      : mesh_(mesh), stars_(stars), landmarks_(landmarks), along_(along) {}

  /// The vertex is a maximum itself.
  void set_maximum(TetMesh::Index vertex, std::size_t maximum) { known_[vertex] = maximum; }

  /// A maximum that a path leads to from a vertex, on which the mode is larger than there.
  std::optional<std::size_t> from_vertex(TetMesh::Index vertex);
  /// The same from any point, the mode being above a level on all of the path but the point.
  std::optional<std::size_t> from_place(const TetPlace& place, double level);
  /// The same from a critical point.
  std::optional<std::size_t> leave(const TetDeparture& way, double level);

 private:
  using Index = TetMesh::Index;
  /// Where a path has come to: a vertex of the mesh, or a maximum.
  struct Reached {
    std::optional<Index> vertex;
    std::optional<std::size_t> maximum;
    explicit operator bool() const { return vertex || maximum; }
  };
  struct Move {
    double angle = 0;
    TetPlace to;
  };

  Reached climb(TetPlace& place, double level) const;
  std::optional<std::size_t> walk(const TetPlace& start, double level);
  Reached step_from_vertex(Index vertex);
  std::optional<std::size_t> finish(const Reached& reached);

  std::vector<Index> star_of(const TetPlace& place) const;
  TetPlace seen_from(const TetPlace& place, Index tet) const;
  Reached maximum_in_sight(const TetPlace& place, const std::vector<Index>& star,
                           double level) const;
  Reached vertex_in_sight(const TetPlace& place, const std::vector<Index>& star,
                          double level) const;
  std::vector<Move> moves(const TetPlace& place, const std::vector<Index>& star,
                          double level) const;
  bool is_above(Index tet, const TetWeights& from, const TetWeights& to, double level) const;

  const TetMesh& mesh_;
  const VertexStars& stars_;
  const Landmarks& landmarks_;
  SimplexMaxima& along_;
  std::unordered_map<Index, std::optional<std::size_t>> known_;
};

}  // namespace tensortopo::persistence
