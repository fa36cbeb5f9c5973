// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/subdivide.hpp"

#include <numeric>

#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {

TetMesh subdivide(const TetMesh& mesh) {
  using Index = TetMesh::Index;
  const auto as_size = [](auto i) { return static_cast<std::size_t>(i); };
  std::vector<Index> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), 0);
  const TetComplex complex = tet_complex(mesh, all);
  TetMesh fine;
  fine.points = mesh.points;
  fine.tensors = mesh.tensors;
  for (const auto& [a, b] : complex.edges) {
    fine.points.push_back(0.5 * (mesh.points[as_size(a)] + mesh.points[as_size(b)]));
    fine.tensors.push_back(0.5 * (mesh.tensors[as_size(a)] + mesh.tensors[as_size(b)]));
  }
  const auto first = static_cast<Index>(mesh.points.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    const auto m = [&](int i, int j) {
      return first + complex.tet_edges[t][as_size(tet_edge(i, j))];
    };
    const std::array<std::array<Index, 4>, 8> parts{{{v[0], m(0, 1), m(0, 2), m(0, 3)},
                                                     {m(0, 1), v[1], m(1, 2), m(1, 3)},
                                                     {m(0, 2), m(1, 2), v[2], m(2, 3)},
                                                     {m(0, 3), m(1, 3), m(2, 3), v[3]},
                                                     {m(0, 2), m(1, 3), m(0, 1), m(1, 2)},
                                                     {m(0, 2), m(1, 3), m(1, 2), m(2, 3)},
                                                     {m(0, 2), m(1, 3), m(2, 3), m(0, 3)},
                                                     {m(0, 2), m(1, 3), m(0, 3), m(0, 1)}}};
    for (const auto& part : parts) {
      fine.tets.push_back(part);
      fine.cell_ids.push_back(mesh.cell_ids[t]);
    }
  }
  return fine;
}

}  // namespace tensortopo
