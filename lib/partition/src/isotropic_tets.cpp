// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "isotropic_tets.hpp"

#include <algorithm>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {

bool is_isotropic(const SymmetricTensor<double>& t) {
  return t.xx == t.yy && t.yy == t.zz && t.xy == 0 && t.yz == 0 && t.xz == 0;
}

std::size_t isotropic_tets(const TetMesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const auto& tet) {
        return std::all_of(tet.begin(), tet.end(), [&](TetMesh::Index v) {
          return is_isotropic(mesh.tensors[as_size(v)]);
        });
      }));
}

}  // namespace tensortopo
