// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/tet_complex.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

struct FaceUse {
  std::array<Index, 3> vertices;
  Index tet;
  int opposite;
  friend bool operator<(const FaceUse& p, const FaceUse& q) {
    return std::tie(p.vertices, p.tet) < std::tie(q.vertices, q.tet);
  }
};

struct EdgeUse {
  std::array<Index, 2> vertices;
  Index tet;
  int edge;
  friend bool operator<(const EdgeUse& p, const EdgeUse& q) {
    return std::tie(p.vertices, p.tet) < std::tie(q.vertices, q.tet);
  }
};

template <class Body>
void for_each_index(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// How many simplices there are in a sorted list of their uses.
template <class Use>
std::size_t count_simplices(const std::vector<Use>& uses) {
  std::size_t count = 0;
  for (std::size_t u = 0; u < uses.size(); ++u)
    count += u == 0 || uses[u].vertices != uses[u - 1].vertices;
  return count;
}

// Edges come before faces, not beside them: the lists of uses are larger than what becomes of them.
void collect_edges(const TetMesh& mesh, TetComplex& complex) {
  const auto& tets = complex.tets;
  std::vector<EdgeUse> uses(6 * tets.size());
  for_each_index(tets.size(), [&](std::size_t t) {
    const auto& v = mesh.tets[static_cast<std::size_t>(tets[t])];
    for (std::size_t e = 0; e < 6; ++e) {
      const Index a = v[static_cast<std::size_t>(kTetEdges[e][0])];
      const Index b = v[static_cast<std::size_t>(kTetEdges[e][1])];
      uses[6 * t + e] = {
          {std::min(a, b), std::max(a, b)}, static_cast<Index>(t), static_cast<int>(e)};
    }
  });
  tbb::parallel_sort(uses.begin(), uses.end());
  complex.edges.reserve(count_simplices(uses));
  complex.tet_edges.resize(tets.size());
  for (std::size_t u = 0; u < uses.size(); ++u) {
    const auto& use = uses[u];
    if (u == 0 || use.vertices != uses[u - 1].vertices) complex.edges.push_back(use.vertices);
    complex.tet_edges[static_cast<std::size_t>(use.tet)][static_cast<std::size_t>(use.edge)] =
        static_cast<Index>(complex.edges.size() - 1);
  }
}

void collect_faces(const TetMesh& mesh, TetComplex& complex) {
  const auto& tets = complex.tets;
  std::vector<FaceUse> uses(4 * tets.size());
  for_each_index(tets.size(), [&](std::size_t t) {
    const auto& v = mesh.tets[static_cast<std::size_t>(tets[t])];
    for (std::size_t f = 0; f < 4; ++f) {
      std::array<Index, 3> face;
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != f) face[k++] = v[i];
      std::sort(face.begin(), face.end());
      uses[4 * t + f] = {face, static_cast<Index>(t), static_cast<int>(f)};
    }
  });
  tbb::parallel_sort(uses.begin(), uses.end());
  const std::size_t faces = count_simplices(uses);
  complex.faces.reserve(faces);
  complex.face_tets.reserve(faces);
  complex.tet_faces.resize(tets.size());
  for (std::size_t u = 0; u < uses.size(); ++u) {
    const auto& use = uses[u];
    if (u == 0 || use.vertices != uses[u - 1].vertices) {
      complex.faces.push_back(use.vertices);
      complex.face_tets.push_back({use.tet, -1});
    } else {
      complex.face_tets.back()[1] = use.tet;
    }
    complex.tet_faces[static_cast<std::size_t>(use.tet)][static_cast<std::size_t>(use.opposite)] =
        static_cast<Index>(complex.faces.size() - 1);
  }
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
