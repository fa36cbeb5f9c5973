// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tensortopo/extract/level.hpp"
#include "tensortopo/extract/simple_simplex.hpp"

namespace tensortopo {

/// What a simplex of the mesh is to the extraction: its vertex tensors, each scaled by a power of
/// two to P in [3, 12), and the sides of its vertices.
template <class Scalar, std::size_t Vertices>
struct LevelSimplex {
  std::array<Deviator<Scalar>, Vertices> tensors;
  std::array<bool, Vertices> above;  ///< mode > mu at the vertex (a vertex on the level is below)
  std::array<const SymmetricTensor<double>*, Vertices> exact;  ///< the input's tensors
  std::array<int, Vertices> exponents;  ///< tensors[i] = deviator of exact[i] * 2^exponents[i]
};

/// A conforming subdivision of a triangle or tetrahedron into simple simplices (see
/// `SimplexProof`), by bisection of the longest edge, length being the angle between tensors.
///
/// What is proved of the cells fixes the topology of the level in the simplex: it is the one that
/// marching tetrahedra (triangles) give on the signs at the vertices.
template <class Scalar, std::size_t Vertices>
class Refinement {
 public:
  struct Vertex {
    std::array<Scalar, Vertices> weights;  ///< barycentric, exact dyadic numbers
    Deviator<Scalar> tensor;
    bool above;
  };
  struct Cell {
    std::array<std::uint32_t, Vertices> vertices;  ///< oriented as the simplex is
    SimplexProof<Scalar, Vertices> proof;
    bool alive = true;
    bool checked = false;
    std::uint32_t seen = 0;  ///< bisections of edges when the cell was last found conforming
  };

  Refinement(const LevelSimplex<Scalar, Vertices>& simplex, const Level<Scalar>& level);

  /// Refines until every cell is simple; false if that takes more than `budget` cells, or cells
  /// too small for their corners to be exact.
  bool run(std::size_t budget);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  using EdgeKey = std::uint64_t;
  static constexpr std::uint32_t kNone = 0xffffffffu;
  struct EdgeRecord {
    std::uint32_t middle = kNone;
    signed char simple = -1;  // unknown
  };

  static EdgeKey key(std::uint32_t u, std::uint32_t v) {
    return u < v ? (EdgeKey{u} << 32 | v) : (EdgeKey{v} << 32 | u);
  }
  bool is_simple(Cell& cell);
  template <std::size_t Part>
  SimplexProof<Scalar, Part> prove(const std::array<std::uint32_t, Part>& part) const;
  bool edges_are_simple(const Cell& cell);
  bool faces_are_simple(const Cell& cell) const;
  bool has_hanging_vertex(Cell& cell) const;
  bool bisect(std::size_t cell);
  std::uint32_t middle(std::uint32_t u, std::uint32_t v);
  Scalar length(std::uint32_t u, std::uint32_t v) const;

  const LevelSimplex<Scalar, Vertices>* simplex_;
  const Level<Scalar>* level_;
  std::vector<Vertex> vertices_;
  std::vector<Cell> cells_;
  std::unordered_map<EdgeKey, EdgeRecord> edges_;
  std::uint32_t bisections_ = 0;
  std::vector<std::uint32_t> last_bisection_;  ///< of an edge at each vertex
};

/// Side of the level for the field of a simplex at exact barycentric weights; all tiers.
template <class Scalar, std::size_t Vertices>
bool is_above(const LevelSimplex<Scalar, Vertices>& simplex, const Deviator<Scalar>& tensor,
              const std::array<Scalar, Vertices>& weights, const Level<Scalar>& level);

/// The field of a simplex at barycentric weights.
template <class Scalar, std::size_t Vertices>
Deviator<Scalar> tensor_at(const std::array<Deviator<Scalar>, Vertices>& tensors,
                           const std::array<Scalar, Vertices>& weights) {
  Deviator<Scalar> t = weights[0] * tensors[0];
  for (std::size_t i = 1; i < Vertices; ++i) t = t + weights[i] * tensors[i];
  return t;
}

}  // namespace tensortopo
