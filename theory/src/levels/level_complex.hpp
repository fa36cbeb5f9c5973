// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "levels/mode_level.hpp"
#include "levels/simplex_proof.hpp"

namespace tensortopo::theory {

/// A complex of tetrahedra with a level of the mode in it, refined until every cell is proved to
/// hold the level as marching tetrahedra draw it.
///
/// The field is linear in each tetrahedron, and known up to a positive factor at each vertex: so it
/// may be a field on a mesh, or on a sphere of tensors cut into spherical tetrahedra.
///
/// A cell is simple if it is proved empty; or if it is proved monotone, each of its faces is proved
/// empty or monotone (along a direction of its own), and each of its edges is proved to be crossed
/// at most once. Then a face holds one arc of the level between the two crossings of its edges, or
/// none: there are no closed curves, and arcs end on edges. So the arcs of the four faces make one
/// loop or none; and the level in the cell, a graph without closed pieces, is one disc or nothing.
///
/// A vertex exactly on the level counts as below it: the level is the one infinitesimally above.
/// All proofs but the sides of vertices hold for all levels close by, and cells that meet the level
/// are monotone, so the two are isotopic.
class LevelComplex {
 public:
  using Index = std::uint32_t;
  using Face = std::array<Index, 3>;
  using Cell = std::array<Index, 4>;

  explicit LevelComplex(const ModeLevel& level);

  /// For mode 0: a complex in which -t is a vertex for each vertex t, and so for cells, and stays
  /// so. Its vertices come in twins 2 k, 2 k + 1; of two on the level, the second counts as above.
  static LevelComplex antipodal();

  Index add_vertex(const Deviator<Integer>& tensor);
  /// The tensor and its opposite; the index of the first.
  Index add_twins(const Deviator<Integer>& tensor);
  /// Cells that share a face must share its three vertices.
  void add_cell(const Cell& cell);

  /// Cuts edges, with all cells around them, until every cell is simple; false if that takes more
  /// than `budget` cells, or too deep a refinement.
  ///
  /// @param is_resolved  what every face that the level meets must pass besides; none if empty
  bool refine(std::size_t budget, const std::function<bool(const Face&)>& is_resolved = {});

  bool is_antipodal() const { return antipodal_; }
  static Index twin(Index vertex) { return vertex ^ 1; }
  bool is_above(Index vertex) const { return vertices_[vertex].above; }
  bool is_met(const Face& face) const {
    return is_above(face[0]) != is_above(face[1]) || is_above(face[0]) != is_above(face[2]);
  }
  const Deviator<Integer>& tensor(Index vertex) const { return vertices_[vertex].tensor; }
  /// The present cells.
  std::vector<Cell> cells() const;

 private:
  struct Vertex {
    Deviator<Integer> tensor;
    long size;             ///< an exponent of two
    BoundedDeviator near;  ///< tensor / 2^size
    double norm;           ///< of `near`, rounded
    bool above;
  };
  struct Piece {
    Cell vertices;
    SimplexProof proof;
    bool alive;  ///< not cut
  };
  using Edge = std::array<Index, 2>;

  double squared_chord(Index u, Index v) const;
  Edge longest_edge(const Cell& cell) const;
  std::optional<Edge> edge_to_cut(Piece& piece,
                                  const std::function<bool(const Face&)>& is_resolved);
  std::optional<Edge> much_longer_edge(const Edge& edge) const;
  bool is_simple(const Edge& edge);
  bool is_simple(const Face& face);
  Deviator<Integer> cut_point(const Edge& edge) const;
  bool cut(const Edge& edge);
  void cut(const Edge& edge, Index at);
  void add_piece(const Piece& piece);

  ModeLevel level_;
  Bounded<double> square_;
  bool antipodal_ = false;
  std::vector<Vertex> vertices_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<Index>> pieces_at_;              ///< of each vertex, dead ones among them
  std::unordered_map<std::uint64_t, bool> edges_, faces_;  ///< whether proved simple
};

/// Numbers two or three vertices in any order; their indices must be below 2^21.
std::uint64_t simplex_key(const std::array<std::uint32_t, 2>& edge);
std::uint64_t simplex_key(const std::array<std::uint32_t, 3>& face);

}  // namespace tensortopo::theory
