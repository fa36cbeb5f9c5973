// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "ascent.hpp"
#include "simplex_maxima.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/sweep/mesh_critical_values.hpp"
#include "vertex_stars.hpp"

namespace tensortopo::persistence {

/// Which components of {mode >= m} a critical point may touch whose link is not known, or from
/// which a path is not found: all of them, and perhaps others.
///
/// A component that touches the point meets tetrahedra around it. Its largest mode in these is
/// at a vertex, at a critical point along an edge or a face, or 1: there is no maximum inside a
/// tetrahedron, and where the mode is constant along lines it is on their ends, too. Where it is at
/// a vertex, a path from there leads to a maximum of the component. Where there is no path, and
/// inside edges and faces, the tetrahedra around that place are added, until all that is left are
/// maxima of the mesh. Next to mode 1 modes are compared by 1 - mode^2, which tells apart what
/// modes in doubles do not.
///
/// Points that are not known to be maxima are not among them. Not for several threads at once.
class TouchedMaxima {
 public:
  using Index = TetMesh::Index;
  /// @param curves  those of mode 1: each component is the maximum of its number
  TouchedMaxima(const TetMesh& mesh, const VertexStars& stars, Ascent& ascent, SimplexMaxima& along,
                const CurveMesh& curves);
  /// A point that is a maximum.
  void add(const MeshCriticalPoint& point, std::size_t maximum);

  /// In order; nothing if too many tetrahedra would have to be looked at.
  std::optional<std::vector<std::size_t>> at(const MeshCriticalPoint& point);
  /// The maximum of the component in a tetrahedron around the point that touches it there; nothing
  /// if there is more than one that it may be.
  std::optional<std::size_t> only_one_from(Index tet, const MeshCriticalPoint& point);

 private:
  using Simplex = SimplexMaxima::Simplex;
  struct Region;

  bool look_around(Region& region, const MeshCriticalPoint& point, std::size_t most_maxima);
  void look_at(Index tet, const MeshCriticalPoint& point, Region& region);
  void add_maxima(const std::set<std::size_t>& maxima, const MeshCriticalPoint& point,
                  Region& region) const;
  static bool may_be_above(const ModeBound& bound, const MeshCriticalPoint& point);
  static Simplex sorted(Simplex simplex);

  const TetMesh& mesh_;
  const VertexStars& stars_;
  Ascent& ascent_;
  SimplexMaxima& along_;
  std::unordered_map<Index, std::set<std::size_t>> in_tets_;  ///< maxima
  std::map<Simplex, std::set<std::size_t>> on_carriers_;      ///< curves, on edges and faces
  std::unordered_map<std::size_t, ModeBound> bounds_;         ///< of maxima that are points
};

}  // namespace tensortopo::persistence
