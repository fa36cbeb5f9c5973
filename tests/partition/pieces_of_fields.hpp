// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces of fields in pieces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "support/fields/field_of_any_kind.hpp"
#include "support/fields/renumbered_mesh.hpp"
#include "tensortopo/partition/mesh_piece.hpp"
#include "tensortopo/partition/piece_surface.hpp"

namespace tensortopo::test {

inline std::vector<std::int32_t> random_owners(const TetMesh& mesh, int pieces, Random& random) {
  std::vector<std::int32_t> owner(mesh.tets.size());
  for (auto& o : owner) o = random.integer(0, pieces - 1);
  return owner;
}

/// By halving the longer side of the box around a part's centres again and again.
inline std::vector<std::int32_t> bisected(const TetMesh& mesh, int pieces) {
  std::vector<std::int32_t> owner(mesh.tets.size(), 0);
  const auto centre = [&](std::size_t t) {
    Vector3<double> sum{};
    for (const auto v : mesh.tets[t]) sum += mesh.points[static_cast<std::size_t>(v)];
    return sum;
  };
  const auto split = [&](const auto& self, std::vector<std::size_t> tets, int first,
                         int count) -> void {
    if (count == 1 || tets.empty()) {
      for (const std::size_t t : tets) owner[t] = first;
      return;
    }
    const std::array<double Vector3<double>::*, 3> axes{&Vector3<double>::x, &Vector3<double>::y,
                                                        &Vector3<double>::z};
    const auto extent = [&](double Vector3<double>::*axis) {
      double low = centre(tets[0]).*axis, high = low;
      for (const std::size_t t : tets)
        low = std::min(low, centre(t).*axis), high = std::max(high, centre(t).*axis);
      return high - low;
    };
    const auto axis = *std::max_element(axes.begin(), axes.end(),
                                        [&](auto a, auto b) { return extent(a) < extent(b); });
    std::stable_sort(tets.begin(), tets.end(), [&](std::size_t s, std::size_t t) {
      return centre(s).*axis < centre(t).*axis;
    });
    const auto middle =
        tets.begin() + static_cast<std::ptrdiff_t>(tets.size()) * (count / 2) / count;
    self(self, {tets.begin(), middle}, first, count / 2);
    self(self, {middle, tets.end()}, first + count / 2, count - count / 2);
  };
  std::vector<std::size_t> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  split(split, std::move(all), 0, pieces);
  return owner;
}

/// A piece of a renumbered mesh, by the ids of the mesh given.
inline MeshPiece piece_of_renumbered(const RenumberedMesh& other,
                                     const std::vector<std::int32_t>& owner, int p) {
  MeshPiece piece = cut_piece(other.mesh, owner, p);
  for (auto& id : piece.vertex_ids) id = other.vertices[static_cast<std::size_t>(id)];
  for (auto& id : piece.mesh.cell_ids) id = other.tets[static_cast<std::size_t>(id)];
  return piece;
}

/// Slabs, by bisection, or at random.
inline std::vector<std::int32_t> owners_of_kind(int kind, const TetMesh& mesh, int pieces,
                                                Random& random) {
  return kind == 0   ? slabs(mesh, pieces)
         : kind == 1 ? bisected(mesh, pieces)
                     : random_owners(mesh, pieces, random);
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

/// The modes at which fields are extracted here.
inline constexpr std::array kModes{"0",    "1/10",  "-1/10",  "1/2",        "-1/2",
                                   "9/10", "-9/10", "99/100", "-9999/10000"};

inline ModeValue random_mode(Random& random) {
  return ModeValue::parse(
      kModes[static_cast<std::size_t>(random.integer(0, static_cast<int>(kModes.size()) - 1))]);
}

}  // namespace tensortopo::test
