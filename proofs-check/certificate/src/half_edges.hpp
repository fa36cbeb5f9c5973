// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>

#include "claims.hpp"
#include "vtk_xml.hpp"

namespace certificate {

/// The triangles of a level with their neighbours.
class HalfEdges {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  explicit HalfEdges(std::span<const Triangle> triangles);

  std::span<const Triangle> triangles() const { return triangles_; }
  /// The triangle at the other side of edge i of a triangle (from corner i to the next), or kNone.
  std::size_t across(std::size_t triangle, std::size_t i) const;
  /// What keeps it from being an oriented manifold with boundary, or nothing: two triangles with
  /// an edge in one direction, or a vertex around which they form more than one fan.
  std::string defect() const;
  /// Its components, in the order of their smallest vertices.
  std::vector<ComponentClaim> components() const;

 private:
  std::span<const Triangle> triangles_;
  std::unordered_map<std::uint64_t, std::size_t> by_edge_;
};

}  // namespace certificate
