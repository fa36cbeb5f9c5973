// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// A field of which each deviator is in its ball around that of the mesh: on the sphere, or inside.
TetMesh random_member(const TetMesh& mesh, std::span<const double> radii, Random& random);

/// Members of the field in one tetrahedron that are likely to differ from it: at the places of its
/// vertices, edges, faces and inside at which the vertex tensors need the smallest changes, as
/// shares of their radii, for a critical point of mode mu, each vertex tensor is moved by its
/// radius along the mode's gradient there or against it, in all combinations.
///
/// @param places  how many such places of each simplex
std::vector<TetMesh> members_that_may_differ(const TetMesh& mesh, std::size_t tet,
                                             std::span<const double> radii, double mu,
                                             std::size_t places);
/// The same for degenerate curves: places at which the field, or a member, is nearly degenerate and
/// the changes needed for it not to be transverse there are smallest; each vertex tensor is moved
/// along a tensor that is orthogonal to the degenerate ones there.
std::vector<TetMesh> members_that_may_differ(const TetMesh& mesh, std::size_t tet,
                                             std::span<const double> radii, Degeneracy kind,
                                             std::size_t places);

}  // namespace tensortopo::test
