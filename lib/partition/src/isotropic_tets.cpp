// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotropic_tets.hpp"

#include <algorithm>
#include <utility>

#include "owned_part.hpp"
#include "tensortopo/mesh/as_size.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {

bool is_isotropic(const SymmetricTensor<double>& t) { return deviator(t) == Deviator<double>{}; }

std::vector<std::array<std::int64_t, 2>> isotropic_ids_of(const MeshPiece& piece) {
  std::vector<std::int64_t> ids;
  for (std::size_t t = 0; t < piece.mesh.tets.size(); ++t) {
    const auto& tet = piece.mesh.tets[t];
    if (piece.is_owned[t] != 0 && std::all_of(tet.begin(), tet.end(), [&](TetMesh::Index v) {
          return is_isotropic(piece.mesh.tensors[as_size(v)]);
        }))
      ids.push_back(piece.mesh.cell_ids[t]);
  }
  return runs_of(std::move(ids));
}

}  // namespace tensortopo
