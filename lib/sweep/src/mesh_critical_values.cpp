// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/sweep/mesh_critical_values.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/field/exact_critical_points.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/tet_complex.hpp"
#include "tensortopo/tensor/deviator.hpp"

namespace tensortopo {
namespace {

using Index = TetMesh::Index;
using Tensor = SymmetricTensor<double>;

Verdict sign_of_rise(bool rises) { return rises ? Verdict::positive : Verdict::negative; }

/// The edges opposite an edge in the tetrahedra around it, and the like for vertices.
template <std::size_t Count>
struct Around {
  std::vector<std::array<Index, Count>> simplices;
  std::vector<std::size_t> begin;  ///< of each edge or vertex; one more at the end

  template <class Visit>
  Around(std::size_t count, const Visit& visit) : begin(count + 1, 0) {
    visit([&](std::size_t i, const std::array<Index, Count>&) { ++begin[i + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    simplices.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    visit([&](std::size_t i, const std::array<Index, Count>& s) { simplices[next[i]++] = s; });
  }
  std::span<const std::array<Index, Count>> of(std::size_t i) const {
    return std::span(simplices).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

template <std::size_t Count>
std::vector<Index> vertices_of(std::span<const std::array<Index, Count>> simplices) {
  std::vector<Index> vertices;
  for (const auto& s : simplices) vertices.insert(vertices.end(), s.begin(), s.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

int place_of(const std::vector<Index>& vertices, Index v) {
  return static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
}

class Collecting {
 public:
  Collecting(const TetMesh& mesh, double low, double high)
      : mesh_(mesh), low_(low), high_(high), complex_(tet_complex(mesh, all_tets(mesh))) {}

  MeshCriticalValues run() {
    vertices();
    edges();
    faces();
    tets();
    std::stable_sort(result_.points.begin(), result_.points.end(),
                     [](const auto& a, const auto& b) {
                       return std::tie(a.low, a.high) < std::tie(b.low, b.high);
                     });
    return std::move(result_);
  }

 private:
  using Points = std::vector<MeshCriticalPoint>;

  static std::vector<Index> all_tets(const TetMesh& mesh) {
    std::vector<Index> all(mesh.tets.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  std::vector<Tensor> tensors_of(const std::vector<Index>& vertices) const {
    std::vector<Tensor> tensors;
    for (const Index v : vertices) tensors.push_back(mesh_.tensors[as_size(v)]);
    return tensors;
  }

  /// Looks at all simplices of a dimension, in parallel, and keeps their points in order.
  template <class Look>
  void for_each(std::size_t count, int dimension, const Look& look) {
    constexpr std::size_t kBlock = 128;
    std::vector<Points> kept((count + kBlock - 1) / kBlock);
    std::vector<std::size_t> looked_at(kept.size(), 0);
    tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t block) {
      const auto keep = [&](const CriticalPoint& found, std::span<const Index> simplex,
                            const SignedLink& link, const std::vector<Index>& around) {
        if (!is_in_range(found)) return;
        ++looked_at[block];
        MeshCriticalPoint point;
        point.effect = local_effect(link);
        if (point.effect.change == LocalChange::regular) return;
        point.low = found.low;
        point.high = found.high;
        point.gap_low = found.gap_low;
        point.gap_high = found.gap_high;
        point.dimension = dimension;
        point.weights = found.weights;
        point.is_certain = found.is_certain;
        point.deviator = found.deviator;
        point.index = found.index;
        point.link = link;
        point.around = around;
        point.vertices.fill(-1);
        std::copy(simplex.begin(), simplex.end(), point.vertices.begin());
        for (std::size_t i = 0; i < simplex.size(); ++i)
          point.point += found.weights[i] * mesh_.points[as_size(simplex[i])];
        kept[block].push_back(point);
      };
      for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i)
        look(i, keep);
    });
    for (std::size_t block = 0; block < kept.size(); ++block) {
      result_.looked_at[static_cast<std::size_t>(dimension)] += looked_at[block];
      result_.points.insert(result_.points.end(), kept[block].begin(), kept[block].end());
    }
  }

  bool is_in_range(const CriticalPoint& point) const {
    return point.high > low_ && point.low <= high_;
  }

  /// Whether intervals of doubles leave something open.
  bool is_open(const CriticalPoint& point) const {
    return is_in_range(point) &&
           (!point.is_certain || std::find(point.towards.begin(), point.towards.end(),
                                           Verdict::unknown) != point.towards.end());
  }

  /// The points of a simplex, in intervals or where those do not tell in rational arithmetic.
  template <class Exact>
  std::vector<CriticalPoint> decided(std::vector<CriticalPoint> points, const Exact& exact) const {
    const auto open = [&](const CriticalPoint& point) { return is_open(point); };
    return std::any_of(points.begin(), points.end(), open) ? exact() : std::move(points);
  }

  void vertices() {
    const Around<3> around(mesh_.points.size(), [&](const auto& tell) {
      for (const auto& t : mesh_.tets) {
        tell(as_size(t[0]), std::array{t[1], t[2], t[3]});
        tell(as_size(t[1]), std::array{t[0], t[2], t[3]});
        tell(as_size(t[2]), std::array{t[0], t[1], t[3]});
        tell(as_size(t[3]), std::array{t[0], t[1], t[2]});
      }
    });
    for_each(mesh_.points.size(), 0, [&](std::size_t v, const auto& keep) {
      const auto faces = around.of(v);
      const Tensor& tensor = mesh_.tensors[v];
      const auto d = deviator(tensor);
      // Without a mode there is none at which something could change.
      if (faces.empty() || d == Deviator<double>{}) return;
      const auto neighbours = vertices_of(faces);
      const auto around_it = tensors_of(neighbours);
      CriticalPoint point = critical_vertex(tensor, around_it);
      if (is_open(point)) point = exact_critical_vertex(tensor, around_it);
      SignedLink link{point.towards, {}};
      for (const auto& f : faces)
        link.triangles.push_back(
            {place_of(neighbours, f[0]), place_of(neighbours, f[1]), place_of(neighbours, f[2])});
      keep(point, std::array{static_cast<Index>(v)}, link, neighbours);
    });
  }

  void edges() {
    const Around<2> around(complex_.edges.size(), [&](const auto& tell) {
      for (std::size_t t = 0; t < complex_.tets.size(); ++t)
        for (std::size_t e = 0; e < 6; ++e) {
          const auto& opposite = kTetEdges[5 - e];
          const auto& tet = mesh_.tets[t];
          tell(as_size(complex_.tet_edges[t][e]),
               std::array{tet[as_size(opposite[0])], tet[as_size(opposite[1])]});
        }
    });
    for_each(complex_.edges.size(), 1, [&](std::size_t e, const auto& keep) {
      const auto& ends = complex_.edges[e];
      const auto ring = vertices_of(around.of(e));
      const std::array tensors{mesh_.tensors[as_size(ends[0])], mesh_.tensors[as_size(ends[1])]};
      const auto around_it = tensors_of(ring);
      for (const auto& point : decided(critical_points_on_edge(tensors, around_it), [&] {
             return exact_critical_points_on_edge(tensors, around_it);
           })) {
        SignedLink link{point.towards, {}};
        const int n = static_cast<int>(ring.size());
        const Verdict along = point.is_certain ? sign_of_rise(point.index == 0) : Verdict::unknown;
        link.signs.insert(link.signs.end(), 2, along);
        for (const auto& s : around.of(e)) {
          const int i = place_of(ring, s[0]), j = place_of(ring, s[1]);
          link.triangles.push_back({i, j, n});
          link.triangles.push_back({i, j, n + 1});
        }
        keep(point, ends, link, ring);
      }
    });
  }

  void faces() {
    for_each(complex_.faces.size(), 2, [&](std::size_t f, const auto& keep) {
      const auto& corners = complex_.faces[f];
      std::vector<Index> apices;
      for (const Index t : complex_.face_tets[f]) {
        if (t < 0) continue;
        for (const Index v : mesh_.tets[as_size(complex_.tets[as_size(t)])])
          if (std::find(corners.begin(), corners.end(), v) == corners.end()) apices.push_back(v);
      }
      const std::array tensors{mesh_.tensors[as_size(corners[0])],
                               mesh_.tensors[as_size(corners[1])],
                               mesh_.tensors[as_size(corners[2])]};
      const auto around_it = tensors_of(apices);
      for (const auto& point : decided(critical_points_on_face(tensors, around_it), [&] {
             return exact_critical_points_on_face(tensors, around_it);
           })) {
        SignedLink link{point.towards, {}};
        // Around an extremum one sign, around a saddle four times the other.
        const int n = static_cast<int>(apices.size());
        for (int i = 0; i < 4; ++i)
          link.signs.push_back(!point.is_certain ? Verdict::unknown
                                                 : sign_of_rise(point.index == 0 ||
                                                                (point.index == 1 && i % 2 == 0)));
        for (int apex = 0; apex < n; ++apex)
          for (int i = 0; i < 4; ++i) link.triangles.push_back({apex, n + i, n + (i + 1) % 4});
        keep(point, corners, link, apices);
      }
    });
  }

  void tets() {
    for_each(mesh_.tets.size(), 3, [&](std::size_t t, const auto& keep) {
      const auto& v = mesh_.tets[t];
      const std::array tensors{mesh_.tensors[as_size(v[0])], mesh_.tensors[as_size(v[1])],
                               mesh_.tensors[as_size(v[2])], mesh_.tensors[as_size(v[3])]};
      for (const auto& point : decided(critical_points_in_tet(tensors),
                                       [&] { return exact_critical_points_in_tet(tensors); })) {
        // An octahedron, two opposite vertices for each direction.
        SignedLink link;
        for (int i = 0; i < 6; ++i)
          link.signs.push_back(point.is_certain ? sign_of_rise(i / 2 >= point.index)
                                                : Verdict::unknown);
        for (int x = 0; x < 2; ++x)
          for (int y = 2; y < 4; ++y)
            for (int z = 4; z < 6; ++z) link.triangles.push_back({x, y, z});
        keep(point, v, link, {});
      }
    });
  }

  const TetMesh& mesh_;
  double low_, high_;
  TetComplex complex_;
  MeshCriticalValues result_;
};

}  // namespace

MeshCriticalValues mesh_critical_values(const TetMesh& mesh, double low, double high) {
  const CanonicalMesh canonical = canonical_mesh(mesh);
  MeshCriticalValues result = Collecting(canonical.mesh, low, high).run();
  for (MeshCriticalPoint& point : result.points) {
    for (Index& v : point.vertices)
      if (v >= 0) v = canonical.vertices[as_size(v)];
    for (Index& v : point.around) v = canonical.vertices[as_size(v)];
  }
  return result;
}

}  // namespace tensortopo
