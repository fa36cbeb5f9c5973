// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Random fields of all kinds, and their surfaces in pieces.
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "support/random_fields.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo::test {

inline TetMesh random_field(Random& random, int cubes) {
  TetMesh mesh = cube_mesh(cubes);
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  const int kind = random.integer(0, 3);
  if (kind == 0)
    fill_with_normal_tensors(mesh, seed);
  else
    fill_with_smooth_tensors(mesh, seed);
  if (kind == 2)
    for (auto& t : mesh.tensors) t = rounded(t, 1);
  if (kind == 3)
    for (auto& t : mesh.tensors)
      if (random.integer(0, 19) == 0) t = {2, 2, 2, 0, 0, 0};
  return mesh;
}

inline std::vector<std::int32_t> random_owners(const TetMesh& mesh, int pieces, Random& random) {
  std::vector<std::int32_t> owner(mesh.tets.size());
  for (auto& o : owner) o = random.integer(0, pieces - 1);
  return owner;
}

inline std::vector<PieceSurface> extract_pieces(const TetMesh& mesh,
                                                const std::vector<std::int32_t>& owner, int pieces,
                                                const ModeValue& mode,
                                                const ExtractOptions& options = {}) {
  std::vector<PieceSurface> surfaces;
  for (int p = 0; p < pieces; ++p)
    surfaces.push_back(extract_piece(cut_piece(mesh, owner, p), mode, options));
  return surfaces;
}

inline ModeValue arbitrary_mode() {
  return ModeValue::parse(*rc::gen::element<std::string>("0", "1/10", "-1/10", "1/2", "-1/2",
                                                         "9/10", "-9/10", "99/100", "-9999/10000"));
}

}  // namespace tensortopo::test
