// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/theory/verify.hpp"

namespace tensortopo {

/// The tensors at the vertices of a tetrahedron.
std::array<SymmetricTensor<double>, 4> tensors_of_tet(const TetMesh& mesh, std::size_t tet);

/// Fields of tetrahedra that lie evenly in the order of the mesh.
///
/// Of two in a row the first is the tetrahedron's, exactly. The second is moved, by about a
/// hundred-thousandth of its size, to one whose characteristic tensor has rational eigenvectors,
/// eigenvalues and singularities, so that statements about those can be tried too. (One of a rank
/// below 4 stays.)
theory::Trials mesh_trials(std::shared_ptr<const TetMesh> mesh, std::uint64_t seed,
                           std::size_t wanted);

}  // namespace tensortopo
