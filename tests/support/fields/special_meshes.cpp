// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "special_meshes.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
using Cell = std::array<int, 3>;

Tensor integers(Random& random, int bound) {
  const auto entry = [&] { return static_cast<double>(random.integer(-bound, bound)); };
  Tensor t;
  for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = entry();
  return t;
}

Tensor sparse(Random& random) {
  constexpr std::array<double, 6> kEntries{0, 0, 0, 1, -1, 2};
  Tensor t;
  for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
    *x = kEntries[static_cast<std::size_t>(random.integer(0, 5))];
  return t;
}

Tensor special_or_normal(Random& random) {
  switch (random.integer(0, 5)) {
    case 0:
      return {0, 0, 0, 0, 0, 0};
    case 1:
      return {2, -1, -1, 0, 0, 0};
    case 2:
      return {1, -1, 0, 0, 0, 0};
    default:
      return random.tensor();
  }
}

/// Where a vertex of a box of so many cubes is mirrored to, the middle planes left in place.
Cell representative(const Cell& at, const Cell& cubes) {
  return {std::min(at[0], cubes[0] - at[0]), std::min(at[1], cubes[1] - at[1]), at[2]};
}

/// Mirroring x changes the signs of xy and xz, mirroring y those of xy and yz.
Tensor mirrored(Tensor t, const Cell& at, const Cell& cubes) {
  const auto side = [&](std::size_t i) { return (2 * at[i] > cubes[i]) - (2 * at[i] < cubes[i]); };
  const int x = side(0), y = side(1);
  t.xy *= x * y;
  t.xz *= x;
  t.yz *= y;
  return t;
}

Tensor tensor_at(const Cell& at, const Cell& cubes, MeshKind kind, Random& random,
                 std::map<Cell, Tensor>& drawn) {
  switch (kind) {
    case MeshKind::ones:
      return integers(random, 1);
    case MeshKind::small_integers:
      return integers(random, 2);
    case MeshKind::sparse:
      return sparse(random);
    case MeshKind::mirrored: {
      const Cell same = representative(at, cubes);
      if (!drawn.contains(same)) drawn[same] = integers(random, 3);
      return mirrored(drawn[same], at, cubes);
    }
    case MeshKind::plane_stress: {
      Tensor t = integers(random, 3);
      t.zz = random.integer(0, 1);
      t.yz = t.xz = 0;
      return t;
    }
    case MeshKind::antiplane: {
      Tensor t = integers(random, 2);
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy}) *x *= at[2];
      return t;
    }
    case MeshKind::special_tensors:
      return special_or_normal(random);
  }
  std::abort();
}

}  // namespace

const std::vector<MeshKind>& all_mesh_kinds() {
  static const std::vector<MeshKind> kinds{MeshKind::ones,           MeshKind::small_integers,
                                           MeshKind::sparse,         MeshKind::mirrored,
                                           MeshKind::plane_stress,   MeshKind::antiplane,
                                           MeshKind::special_tensors};
  return kinds;
}

std::string name_of(MeshKind kind) {
  switch (kind) {
    case MeshKind::ones:
      return "ones";
    case MeshKind::small_integers:
      return "small integers";
    case MeshKind::sparse:
      return "sparse";
    case MeshKind::mirrored:
      return "mirrored";
    case MeshKind::plane_stress:
      return "plane stress";
    case MeshKind::antiplane:
      return "antiplane";
    case MeshKind::special_tensors:
      return "special tensors";
  }
  std::abort();
}

TetMesh special_mesh(MeshKind kind, Random& random) {
  constexpr std::array<Cell, 4> kBoxes{{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {2, 2, 2}}};
  const Cell cubes = kBoxes[static_cast<std::size_t>(random.integer(0, 3))];
  const TetMesh whole = cube_mesh(2);
  const auto is_inside = [&](const Vector3<double>& p) {
    return p.x <= cubes[0] && p.y <= cubes[1] && p.z <= cubes[2];
  };
  TetMesh mesh;
  std::map<Cell, Tensor> drawn;
  std::vector<TetMesh::Index> number(whole.points.size(), -1);
  for (std::size_t v = 0; v < whole.points.size(); ++v) {
    const Vector3<double>& p = whole.points[v];
    if (!is_inside(p)) continue;
    number[v] = static_cast<TetMesh::Index>(mesh.points.size());
    mesh.points.push_back(p);
    const Cell at{static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)};
    mesh.tensors.push_back(tensor_at(at, cubes, kind, random, drawn));
  }
  for (auto tet : whole.tets) {
    for (auto& v : tet) v = number[static_cast<std::size_t>(v)];
    if (std::ranges::none_of(tet, [](auto v) { return v < 0; })) mesh.tets.push_back(tet);
  }
  return mesh;
}

}  // namespace tensortopo::test
