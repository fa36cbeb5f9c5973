// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What of a part is needed to put parts together: its border, and numbers of its surface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "claims/compare_level.hpp"
#include "parts/mesh_border.hpp"
#include "parts/whole_numbers.hpp"
#include "surface/compare_surface.hpp"

namespace certificate {

/// An end of a curve on a face of the border: a crossing of an edge of the face, or its vertex with
/// zero deviator.
struct ChainEnd {
  /// Which one it is on its edge, from 1, counted from the end of smaller place. Else 0.
  std::uint32_t crossing = 0;
  std::array<BorderPlace, 2> edge{};  ///< the ends of that edge, ascending

  auto operator<=>(const ChainEnd&) const = default;
};

/// Which curve of a face it is. An arc is known by its ends, as no other has the same crossing.
struct CurveOfFace {
  bool is_closed = false;
  std::array<ChainEnd, 2> ends{};  ///< of an arc, in the direction of the triangles
  /// Of a closed one: its number, the same for all parts that have the face. Nothing if that is not
  /// known.
  std::optional<std::size_t> number;

  auto operator<=>(const CurveOfFace&) const = default;
};

/// Edges of one triangle each, along a curve on a face of the border, in the direction of the
/// triangles.
struct BorderChain {
  std::uint32_t face = 0;
  CurveOfFace curve;
  std::vector<BorderPlace> places;      ///< of the vertices, those of a closed curve each once
  std::vector<std::uint32_t> vertices;  ///< of the part's surface
  std::uint32_t component = 0;          ///< of the part's surface

  std::size_t edges() const { return vertices.size() - (curve.is_closed ? 0 : 1); }
};

/// A component of the part's surface.
struct PartComponent {
  std::size_t vertices = 0, edges = 0, triangles = 0;
  SaidNumber said;
};

struct PartBorder : MeshBorder {
  std::vector<BorderChain> chains;
  std::vector<PartComponent> components;
  /// Whether all edges of one triangle are in these chains. Those beside tetrahedra that are
  /// left out are not, nor those between two vertices with zero deviator.
  bool is_complete = false;
  /// The array `whole_component` is there, but not one number of each triangle.
  bool whole_is_elsewhere = false;
};

/// Adds what a level's triangles have there, after these were found to be as claimed.
void add_surface(const LevelCase& c, const CrossingVertices& vertices, const PlacedSurface& placed,
                 PartBorder& border);

}  // namespace certificate
