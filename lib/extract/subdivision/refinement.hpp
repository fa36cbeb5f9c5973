// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/level/level.hpp"
#include "extract/level/proofs/simple_simplex.hpp"
#include "extract/subdivision/exact_weights.hpp"
#include "extract/subdivision/known_simple.hpp"
#include "tensortopo/extract/level_simplex.hpp"

namespace tensortopo {

/// A place in a simplex of the mesh and the field there.
template <class Scalar, std::size_t Vertices>
struct RefinementVertex {
  ExactWeights<Vertices> place;
  std::array<double, Vertices> weights;  ///< its coordinates; homogeneous, the nearest doubles
  std::array<double, Vertices> rest{};   ///< what the coordinates are more than these
  Deviator<Scalar> tensor;               ///< at the place itself; P in [3, 12) unless it vanishes
  double total = 1;  ///< the tensor's error is as at exact coordinates of this sum
  bool above;

  ExactPlace<Vertices> exact() const { return {weights, rest}; }
};

/// A conforming subdivision of a triangle or tetrahedron into simple simplices (see
/// `SimplexProof`). A cell that is not simple has an edge cut, and all cells around that edge with
/// it: one with several crossings, between two of them, or if there is none the longest, length
/// being the angle between tensors. That one is cut where the angle is about halved: the tensors at
/// its ends are brought to about the same norm and added. So cells have one size in angles
/// everywhere, also where the field comes close to zero and all angles happen within a short way.
/// Where it nearly vanishes on the edge, the cut goes there; where it does inside a face or a cell,
/// a vertex is put there. For levels next to modes 1 and -1 cells are longer along the degenerate
/// curve than across it.
///
/// What is proved of the cells fixes the topology of the level in the simplex: it is the one that
/// marching tetrahedra (triangles) give on the signs at the vertices.
///
/// @tparam Vertices of the simplex of the mesh
/// @tparam Corners  of what is refined: that simplex, or a triangle in it
template <class Scalar, std::size_t Vertices, std::size_t Corners = Vertices>
class Refinement {
 public:
  using Vertex = RefinementVertex<Scalar, Vertices>;
  struct Cell {
    std::array<std::uint32_t, Corners> vertices;  ///< oriented as the simplex is
    SimplexProof<Scalar, Corners> proof;
    bool alive = true;  ///< not cut
  };

  Refinement() = default;
  Refinement(const LevelSimplex<Scalar, Vertices>& simplex,
             const Level<Scalar>& level) requires(Vertices == Corners);
  Refinement(const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
             const std::array<Vertex, Corners>& corners);

  /// Starts anew; memory is kept. The simplex and the level have to live as long as it is used.
  void reset(const LevelSimplex<Scalar, Vertices>& simplex,
             const Level<Scalar>& level) requires(Vertices == Corners);
  void reset(const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
             const std::array<Vertex, Corners>& corners);

  /// Refines until every cell is simple; false if that takes more than `budget` cells, where four
  /// in the refinement of a face of a cell count as one, or cells too small for the coordinates of
  /// their corners to be exact. May be called again, to go on with a greater budget.
  ///
  /// @param smallest  squared angle: also false where the largest cell not yet proved has none as
  ///     large, which is so around a single point at which no size is small enough
  bool run(std::size_t budget, double smallest = 0);

  /// Cuts some of the cells, and refines again until every cell is simple. If that takes a new
  /// start (see `run`), the cells of then are simple as well, but the cuts are forgotten.
  /// @return false as for `run`
  bool cut_cells(const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level,
                 std::span<const std::uint32_t> cells, std::size_t budget);

  /// The same, where the level may come close to one that crosses itself along a line: vertices are
  /// put where such a line meets the faces, and edges are as long as the mode bends along them, so
  /// that cells are long along the line. Of a refinement that has just begun.
  ///
  /// @param saddles  places in edges and faces: shares of the corners, 0 for those they are without
  bool run_along_saddles(
      std::size_t budget,
      std::span<const std::array<std::int64_t, 4>> saddles) requires(Vertices == 4 && Corners == 4);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  using Ends = std::array<std::uint32_t, 2>;
  struct Edge {
    Ends ends;
    double squared_length;
    bool operator<(const Edge& other) const { return squared_length < other.squared_length; }
  };

  std::uint32_t add_vertex(const Vertex& v);
  void add_cell(const Cell& cell);
  bool restart();
  /// The edge to cut next if the cell is not proved simple.
  std::optional<Edge> edge_to_cut(Cell& cell);
  bool is_simple_edge(const Ends& ends);
  /// Which edge of a cell holds several crossings, or may do so for all that is proved.
  std::optional<std::size_t> edge_in_the_way(const std::array<std::uint32_t, Corners>& cell);
  bool is_simple_face(const std::array<std::uint32_t, 3>& face);
  bool has_no_loop(const std::array<std::uint32_t, 3>& face);
  template <std::size_t Part>
  SimplexProof<Scalar, Part> prove(const std::array<std::uint32_t, Part>& part) const;
  /// Crossings of the level between two places, 2 for more than one or not known.
  int crossings_between(const Vertex& u, const Vertex& v, int depth) const;
  /// Of the chord between the unit tensors at two vertices, or next to the degenerate curve of
  /// what counts there.
  double squared_length(std::uint32_t u, std::uint32_t v) const;
  /// In the order of `kTetEdges`.
  std::array<Edge, Corners*(Corners - 1) / 2> edges_of(
      const std::array<std::uint32_t, Corners>& cell) const;
  Edge longest_edge(const std::array<std::uint32_t, Corners>& cell) const {
    const auto edges = edges_of(cell);
    return *std::max_element(edges.begin(), edges.end());
  }
  /// An edge of a cell around this one that should be cut before it.
  std::optional<Edge> much_longer_edge(const Edge& edge) const;
  /// How much of its corners the place has where the field nearly vanishes in a part of a cell.
  template <std::size_t Part>
  std::optional<std::array<std::int64_t, Part>> shares_of_small_field(
      const std::array<std::uint32_t, Part>& part) const;
  bool is_next_cut_uneven() const;
  std::array<std::int64_t, 2> shares_on(const Ends& ends,
                                        const std::array<std::int64_t, 2>& usual) const;
  /// Nothing if the field does not nearly vanish around the edge; else whether it could be cut.
  std::optional<bool> cut_at_small_field(const Ends& ends);
  /// Nothing if the edge is simple, or no place is found on it between two crossings; else whether
  /// it could be cut.
  std::optional<bool> cut_between_crossings(const Ends& ends);
  bool cut_edge(const Ends& ends);
  template <std::size_t Part>
  bool cut(const std::array<std::uint32_t, Part>& part,
           const std::array<std::int64_t, Part>& shares);
  template <std::size_t Part>
  void add_child(const Cell& cell, const std::array<std::size_t, Part>& at, std::size_t lost,
                 std::uint32_t m, const std::array<double, Part>& parts);
  template <std::size_t Part>
  std::array<const Vertex*, Part> pointers_to(const std::array<std::uint32_t, Part>& part) const;

  const LevelSimplex<Scalar, Vertices>* simplex_ = nullptr;
  const Level<Scalar>* level_ = nullptr;
  std::vector<Vertex> vertices_;
  std::vector<Deviator<double>> offsets_;  ///< of them from the degenerate curve, if that is near
  std::vector<Cell> cells_;
  /// Cells of each vertex, dead ones among them.
  std::vector<std::vector<std::uint32_t>> cells_at_;
  KnownSimple edges_, faces_;
  std::size_t face_cells_ = 0;      ///< made for faces of cells
  std::size_t first_cut_ = 0;       ///< with which of the uneven cuts to begin
  bool by_hessian_metric_ = false;  ///< `run_along_saddles`
};

}  // namespace tensortopo
