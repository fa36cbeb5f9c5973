// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/tet_complex.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "tensortopo/mesh/as_size.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

/// An edge or face of one tetrahedron, filed under its least vertex.
struct Use {
  std::uint64_t rest;  ///< its other vertices, the lesser one first
  Index tet;
  std::int32_t place;  ///< which edge or face of the tetrahedron
  friend bool operator<(const Use& p, const Use& q) {
    return std::tie(p.rest, p.tet, p.place) < std::tie(q.rest, q.tet, q.place);
  }
};

template <class Body>
void for_each_index(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// The uses of edges or faces in the order of the vertices, and of the tetrahedra.
struct SortedUses {
  std::vector<std::size_t> begin;  ///< of each least vertex its first use; at last, how many
  std::vector<std::size_t> first;  ///< of each least vertex its first simplex; at last, how many
  std::vector<Use> uses;

  std::size_t simplices() const { return first.back(); }

  /// Calls `visit(simplex, use, is_first)` for each use, in parallel: those of a simplex by one
  /// thread, in order.
  template <class Visit>
  void for_each_use(const Visit& visit) const {
    for_each_index(begin.size() - 1, [&](std::size_t v) {
      std::size_t next = first[v];
      for (std::size_t u = begin[v]; u < begin[v + 1]; ++u) {
        const bool is_first = u == begin[v] || uses[u].rest != uses[u - 1].rest;
        next += is_first;
        visit(v, next - 1, uses[u], is_first);
      }
    });
  }
};

/// @param count   simplices of a tetrahedron
/// @param key_of  the least vertex of one of them, and the rest
template <class KeyOf>
SortedUses sorted_uses(std::size_t vertices, std::span<const Index> tets, std::size_t count,
                       const KeyOf& key_of) {
  SortedUses sorted;
  sorted.begin.assign(vertices + 1, 0);
  sorted.uses.resize(count * tets.size());
  const auto take_next = [](std::size_t& counter) {
    return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
  };
  for_each_index(tets.size(), [&](std::size_t t) {
    for (std::size_t k = 0; k < count; ++k) take_next(sorted.begin[key_of(t, k).first + 1]);
  });
  std::partial_sum(sorted.begin.begin(), sorted.begin.end(), sorted.begin.begin());
  std::vector<std::size_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  // In no order yet.
  for_each_index(tets.size(), [&](std::size_t t) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto [least, rest] = key_of(t, k);
      sorted.uses[take_next(next[least])] = {rest, static_cast<Index>(t),
                                             static_cast<std::int32_t>(k)};
    }
  });
  // How many simplices each vertex is the least of, then sums.
  sorted.first.assign(vertices + 1, 0);
  for_each_index(vertices, [&](std::size_t v) {
    const auto begin = sorted.uses.begin() + static_cast<std::ptrdiff_t>(sorted.begin[v]),
               end = sorted.uses.begin() + static_cast<std::ptrdiff_t>(sorted.begin[v + 1]);
    std::sort(begin, end);
    for (auto use = begin; use != end; ++use)
      sorted.first[v + 1] += use == begin || use->rest != std::prev(use)->rest;
  });
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  return sorted;
}

// Edges come before faces, not beside them: the lists of uses are larger than what becomes of them.
void collect_edges(const TetMesh& mesh, TetComplex& complex) {
  const auto& tets = complex.tets;
  const auto uses = sorted_uses(mesh.points.size(), tets, 6, [&](std::size_t t, std::size_t e) {
    const auto& v = mesh.tets[as_size(tets[t])];
    const Index a = v[as_size(kTetEdges[e][0])], b = v[as_size(kTetEdges[e][1])];
    return std::pair{as_size(std::min(a, b)), std::uint64_t{as_size(std::max(a, b))}};
  });
  complex.edges.resize(uses.simplices());
  complex.tet_edges.resize(tets.size());
  uses.for_each_use([&](std::size_t least, std::size_t edge, const Use& use, bool is_first) {
    if (is_first) complex.edges[edge] = {static_cast<Index>(least), static_cast<Index>(use.rest)};
    complex.tet_edges[as_size(use.tet)][as_size(use.place)] = static_cast<Index>(edge);
  });
}

void collect_faces(const TetMesh& mesh, TetComplex& complex) {
  const auto& tets = complex.tets;
  constexpr int kBits = 32;
  const auto uses = sorted_uses(mesh.points.size(), tets, 4, [&](std::size_t t, std::size_t f) {
    const auto& v = mesh.tets[as_size(tets[t])];
    const Index a = v[f == 0 ? 1 : 0], b = v[f < 2 ? 2 : 1], c = v[f == 3 ? 2 : 3];
    const Index least = std::min({a, b, c}), largest = std::max({a, b, c});
    const auto between = as_size(a) + as_size(b) + as_size(c) - as_size(least) - as_size(largest);
    return std::pair{as_size(least), std::uint64_t{between} << kBits | as_size(largest)};
  });
  complex.faces.resize(uses.simplices());
  complex.face_tets.resize(uses.simplices());
  complex.tet_faces.resize(tets.size());
  uses.for_each_use([&](std::size_t least, std::size_t face, const Use& use, bool is_first) {
    if (is_first) {
      complex.faces[face] = {static_cast<Index>(least), static_cast<Index>(use.rest >> kBits),
                             static_cast<Index>(use.rest & 0xffffffffu)};
      complex.face_tets[face] = {use.tet, -1};
    } else {
      complex.face_tets[face][1] = use.tet;
    }
    complex.tet_faces[as_size(use.tet)][as_size(use.place)] = static_cast<Index>(face);
  });
}

}  // namespace

TetComplex tet_complex(const TetMesh& mesh, std::span<const Index> tets) {
  TetComplex complex;
  complex.tets.assign(tets.begin(), tets.end());
  collect_edges(mesh, complex);
  collect_faces(mesh, complex);

  complex.face_edges.resize(complex.faces.size());
  for_each_index(complex.faces.size(), [&](std::size_t f) {
    const auto& face = complex.faces[f];
    const auto t = static_cast<std::size_t>(complex.face_tets[f][0]);
    const auto& v = mesh.tets[static_cast<std::size_t>(tets[t])];
    const auto local = [&](Index vertex) {
      return static_cast<int>(std::find(v.begin(), v.end(), vertex) - v.begin());
    };
    const int a = local(face[0]), b = local(face[1]), c = local(face[2]);
    const auto& edges = complex.tet_edges[t];
    complex.face_edges[f] = {edges[static_cast<std::size_t>(tet_edge(a, b))],
                             edges[static_cast<std::size_t>(tet_edge(a, c))],
                             edges[static_cast<std::size_t>(tet_edge(b, c))]};
  });
  return complex;
}

}  // namespace tensortopo
