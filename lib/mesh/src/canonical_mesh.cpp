// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/canonical_mesh.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// Ascends with the number; 0 and -0 have one.
std::uint64_t key_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  return bits == kSign || (bits & kSign) == 0 ? bits | kSign : ~bits;
}

std::array<std::uint64_t, 6> keys_of(const SymmetricTensor<double>& t) {
  return {key_of(t.xx), key_of(t.yy), key_of(t.zz), key_of(t.xy), key_of(t.yz), key_of(t.xz)};
}

struct KeyedPoint {
  std::array<std::uint64_t, 3> key;
  Index vertex;
};

std::vector<Index> order_of_vertices(const TetMesh& mesh) {
  std::vector<KeyedPoint> keyed(mesh.points.size());
  tbb::parallel_for(std::size_t{0}, keyed.size(), [&](std::size_t v) {
    const auto& p = mesh.points[v];
    keyed[v] = {{key_of(p.x), key_of(p.y), key_of(p.z)}, static_cast<Index>(v)};
  });
  tbb::parallel_sort(keyed.begin(), keyed.end(), [&](const KeyedPoint& p, const KeyedPoint& q) {
    if (p.key != q.key) return p.key < q.key;
    const auto s = keys_of(mesh.tensors[as_size(p.vertex)]);
    const auto t = keys_of(mesh.tensors[as_size(q.vertex)]);
    return s != t ? s < t : p.vertex < q.vertex;
  });
  std::vector<Index> order(keyed.size());
  for (std::size_t i = 0; i < keyed.size(); ++i) order[i] = keyed[i].vertex;
  return order;
}

/// Sorts the corners of a tetrahedron, but for the last two if that turned it around.
void sort_corners(std::array<Index, 4>& v) {
  bool is_even = true;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (v[i] > v[j]) std::swap(v[i], v[j]), is_even = !is_even;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  if (!is_even) std::swap(v[2], v[3]);
}

/// A tetrahedron filed under its smallest vertex: the others, ascending, and its position.
struct FiledTet {
  std::uint64_t middle;  ///< the two vertices between the smallest and the largest
  Index largest, tet;
  friend bool operator<(const FiledTet& s, const FiledTet& t) {
    if (s.middle != t.middle) return s.middle < t.middle;
    return s.largest != t.largest ? s.largest < t.largest : s.tet < t.tet;
  }
};

FiledTet filed(const std::array<Index, 4>& v, std::size_t tet) {
  return {std::uint64_t{as_size(v[1])} << 32 | as_size(std::min(v[2], v[3])), std::max(v[2], v[3]),
          static_cast<Index>(tet)};
}

}  // namespace

std::vector<Index> inverse_permutation(const std::vector<Index>& permutation) {
  std::vector<Index> result(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i)
    result[as_size(permutation[i])] = static_cast<Index>(i);
  return result;
}

CanonicalMesh canonical_mesh(const TetMesh& mesh) {
  CanonicalMesh result;
  result.vertices = order_of_vertices(mesh);
  const std::size_t count = mesh.points.size();
  result.mesh.points.resize(count);
  result.mesh.tensors.resize(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t v) {
    result.mesh.points[v] = mesh.points[as_size(result.vertices[v])];
    result.mesh.tensors[v] = mesh.tensors[as_size(result.vertices[v])];
  });
  const auto rank = inverse_permutation(result.vertices);

  // By smallest vertex with a counting sort, then each short list by the other three.
  std::vector<std::size_t> begin(count + 1, 0);
  const auto corners_of = [&](std::size_t t) {
    std::array<Index, 4> v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = rank[as_size(mesh.tets[t][i])];
    sort_corners(v);
    return v;
  };
  std::vector<std::array<Index, 4>> corners(mesh.tets.size());
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(),
                    [&](std::size_t t) { corners[t] = corners_of(t); });
  for (const auto& v : corners) ++begin[as_size(v[0]) + 1];
  for (std::size_t v = 0; v < count; ++v) begin[v + 1] += begin[v];
  std::vector<FiledTet> files(mesh.tets.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    files[next[as_size(corners[t][0])]++] = filed(corners[t], t);
  result.tets.resize(mesh.tets.size());
  result.mesh.tets.resize(mesh.tets.size());
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t v) {
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              files.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]));
    for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
      result.tets[i] = files[i].tet;
      result.mesh.tets[i] = corners[as_size(files[i].tet)];
    }
  });
  return result;
}

TetMesh in_canonical_order(const TetMesh& mesh) {
  CanonicalMesh canonical = canonical_mesh(mesh);
  if (!mesh.cell_ids.empty())
    for (const Index t : canonical.tets)
      canonical.mesh.cell_ids.push_back(mesh.cell_ids[as_size(t)]);
  return std::move(canonical.mesh);
}

}  // namespace tensortopo
