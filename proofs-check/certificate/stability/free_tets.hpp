// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Tetrahedra in which the level, or degenerate curves, are the same for all members.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "field.hpp"
#include "free_simplex.hpp"

namespace certificate {

/// The largest Frobenius norm of a deviator's error at a vertex.
struct Radius {
  bool of_deviator = false;  ///< a share of the vertex' own deviator, else in units of the tensor
  double value = 0;          ///< finite, not negative
  /// In units of the tensor, one for each point, in place of `value`; or none.
  std::vector<double> each = {};

  double at(std::uint32_t vertex) const { return each.empty() ? value : each[vertex]; }
};

/// What is derived of some tetrahedra.
struct Freedom {
  /// No: a vertex has members on both sides, or degenerate or isotropic ones.
  Answer answer = Answer::yes;
  std::string place;            ///< of the first simplex that is not known to be free
};

/// The deviator at a vertex, three times, in the unit of the field's ball, with the radius in that.
Widened widened(const Field& field, std::uint32_t vertex, const Radius& radius);

/// Are tetrahedra, with their faces, edges and vertices, free for all members?
/// @pre the field is of a mode's tensors
Freedom are_free(const Input& input, const Field& field, const ModeBall& mode, const Radius& radius,
                 const std::vector<std::size_t>& tets, const ForAll& for_all);

/// The same of edges of the mesh and their vertices.
Freedom are_free(const Field& field, const ModeBall& mode, const Radius& radius,
                 const std::vector<std::array<std::uint32_t, 2>>& edges, const ForAll& for_all);

/// Are all members, in tetrahedra, their faces, edges and vertices, transverse to the linear (or planar)
/// degenerate tensors, and nowhere zero? On edges and at vertices: not degenerate.
/// @pre the field is of a mode's tensors
Freedom are_transverse(const Input& input, const Field& field, bool planar, const Radius& radius,
                       const std::vector<std::size_t>& tets, const ForAll& for_all);

/// The same of faces of the mesh, their edges and vertices.
Freedom are_transverse(const Field& field, bool planar, const Radius& radius,
                       const std::vector<std::array<std::uint32_t, 3>>& faces,
                       const ForAll& for_all);

}  // namespace certificate
