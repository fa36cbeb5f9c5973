// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace certificate {

/// What is not as it should be.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An edge of a triangle on the boundary of a piece of triangles.
struct BoundaryEdge {
  std::uint32_t from, to;
  std::size_t across;  ///< the triangle at the other side, or kNone
};

/// A connected piece of triangles.
struct Piece {
  long euler_characteristic = 0;
  std::size_t triangles = 0;
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::vector<std::vector<BoundaryEdge>> loops;
  std::vector<std::size_t> members;  ///< its triangles, if it has no loops
};

/// Triangles with their neighbours.
class HalfEdges {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  explicit HalfEdges(std::span<const Triangle> triangles);

  std::span<const Triangle> triangles() const { return triangles_; }
  /// Throws Wrong unless they are an oriented manifold with boundary: no two triangles have an
  /// edge in one direction, and around each vertex they form one fan.
  void require_manifold() const;
  /// Are the same triangles neighbours, across the same edges?
  bool has_neighbours_of(const HalfEdges& other) const {
    return across_ == other.across_ && double_edge_.has_value() == other.double_edge_.has_value();
  }
  /// The pieces of some triangles, in the order of their vertices. Throws Wrong if the boundary of
  /// one passes a vertex twice.
  /// @param some  ascending
  /// @param joined  are triangle t and this other one beside its edge i of one piece?
  std::vector<Piece> pieces(
      std::span<const std::size_t> some,
      const std::function<bool(std::size_t t, std::size_t i, std::size_t other)>& joined) const;

 private:
  std::span<const Triangle> triangles_;
  std::size_t vertices_ = 0;  ///< all have smaller numbers
  /// The triangles at the other sides of the edges (from corner i to the next), or kNone.
  std::vector<std::array<std::size_t, 3>> across_;
  std::optional<std::array<std::uint32_t, 2>> double_edge_;  ///< of two triangles in one direction
};

}  // namespace certificate
