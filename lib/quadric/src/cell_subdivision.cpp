// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "cell_subdivision.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "level_place.hpp"
#include "tensortopo/mesh/tet_complex.hpp"

namespace tensortopo {
namespace {

using Tet = std::array<std::uint8_t, 4>;

// Vertices of a small tetrahedron: 0-3 its corners, then a place in each edge, face, and inside.
constexpr std::uint8_t kEdgePlace = 4, kFacePlace = 10, kInnerPlace = 14;
constexpr std::size_t kPlaces = 15;

/// Face f is opposite corner f.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kFaces{
    {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};

/// Even permutations that bring each corner to the front.
constexpr std::array<Tet, 4> kFront{{{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
/// Even permutations that bring each edge to the front.
constexpr std::array<Tet, 6> kEdgeFront{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

class Marching {
 public:
  Marching(const ConvexLevel& level, Invariant invariant, const TetMesh& mesh,
           const std::array<TetMesh::Index, 4>& nodes, bool is_even, int pieces)
      : level_(level),
        invariant_(invariant),
        nodes_(nodes),
        is_even_(is_even),
        pieces_(pieces),
        tensors_(tensors_of(mesh, nodes)),
        form_(level, tensors_),
        geometry_(level, tensors_, points_of(mesh, nodes), is_even) {}

  CellLevel run() {
    const GridPoint whole[4]{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    if (is_empty(whole)) return finish();
    if (level_.nappe != 0 && form_.holds_zero()) {
      result_.meets_zero = true;
      return finish();
    }
    // A lattice point x1 >= x2 >= x3 has the coordinates n - x1, x1 - x2, x2 - x3, x3: the cubes'
    // Kuhn tetrahedra are the edgewise subdivision, and agree in shared faces.
    std::array<int, 3> axes{0, 1, 2};
    const int n = pieces_;
    do {
      const bool even_axes = (axes[0] < axes[1]) ^ (axes[1] < axes[2]) ^ (axes[0] < axes[2]);
      for (int x1 = 0; x1 < n; ++x1)
        for (int x2 = 0; x2 <= x1; ++x2)
          for (int x3 = 0; x3 <= x2; ++x3) {
            std::array<GridPoint, 4> corners;
            std::array<int, 3> x{x1, x2, x3};
            bool within = true;
            for (std::size_t k = 0; k < 4; ++k) {
              if (k > 0) ++x[static_cast<std::size_t>(axes[k - 1])];
              within &= n >= x[0] && x[0] >= x[1] && x[1] >= x[2];
              corners[k] = {n - x[0], x[0] - x[1], x[1] - x[2], x[2]};
            }
            if (within) march(corners, even_axes == is_even_);
          }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return finish();
  }

 private:
  static std::array<const SymmetricTensor<double>*, 4> tensors_of(
      const TetMesh& mesh, const std::array<TetMesh::Index, 4>& nodes) {
    std::array<const SymmetricTensor<double>*, 4> result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = &mesh.tensors[static_cast<std::size_t>(nodes[i])];
    return result;
  }
  static std::array<Vector3<double>, 4> points_of(const TetMesh& mesh,
                                                  const std::array<TetMesh::Index, 4>& nodes) {
    std::array<Vector3<double>, 4> result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = mesh.points[static_cast<std::size_t>(nodes[i])];
    return result;
  }

  CellLevel finish() {
    result_.exact_answers = form_.exact_answers();
    return std::move(result_);
  }

  /// What the body is to the edges, faces and inside of a small tetrahedron.
  struct Met {
    std::array<Side, 4> corner;
    std::array<bool, kPlaces> place{};  ///< holds a place of the body, from kEdgePlace on
    bool any = false;
  };

  /// Whether the level misses the tetrahedron: then a zero tensor in it does not matter.
  bool is_empty(std::span<const GridPoint, 4> whole) {
    if (form_.is_clearly_outside()) return true;
    std::array<Side, 4> side;
    for (std::size_t i = 0; i < 4; ++i) side[i] = form_.side(whole[i]);
    const auto count = [&](Side s) { return std::count(side.begin(), side.end(), s); };
    const auto zero = count(Side::zero);
    // In a cone with its tip at a vertex everything is decided on the opposite simplex.
    if (count(Side::inside) + zero == 4 || count(Side::opposite) + zero == 4) return true;
    if (count(Side::outside) + zero < 4) return false;
    std::array<GridPoint, 4> others;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (side[i] == Side::outside) others[k++] = whole[i];
    return !is_met({others.data(), k});
  }

  /// Whether the body or its other nappe meets a simplex whose corners are all outside.
  bool is_met(std::span<const GridPoint> corners) {
    for (std::size_t order = 2; order <= corners.size(); ++order)
      for (unsigned mask = 1; mask < 1u << corners.size(); ++mask) {
        std::array<GridPoint, 4> part;
        std::size_t k = 0;
        for (std::size_t i = 0; i < corners.size(); ++i)
          if (mask >> i & 1) part[k++] = corners[i];
        if (k != order) continue;
        if (form_.meeting({part.data(), k}) != Side::outside) return true;
      }
    return false;
  }

  bool note(Met& met, std::size_t place, Side side) {
    if (side == Side::inside) met.place[place] = met.any = result_.met_inside = true;
    return side != Side::outside;
  }

  Met ask(const std::array<GridPoint, 4>& c) {
    Met met;
    for (std::size_t i = 0; i < 4; ++i) met.corner[i] = side_at(c[i]);
    const auto is_outside = [&](std::size_t i) { return met.corner[i] == Side::outside; };
    std::array<bool, 6> edge_met{};
    for (std::size_t e = 0; e < 6; ++e) {
      const auto i = static_cast<std::size_t>(kTetEdges[e][0]);
      const auto j = static_cast<std::size_t>(kTetEdges[e][1]);
      if (!is_outside(i) || !is_outside(j)) continue;
      const GridPoint ends[2]{c[i], c[j]};
      edge_met[e] = note(met, kEdgePlace + e, form_.meeting(ends));
    }
    bool any = false, all_outside = true;
    for (std::size_t f = 0; f < 4; ++f) {
      const auto& v = kFaces[f];
      all_outside &= is_outside(f);
      if (!is_outside(v[0]) || !is_outside(v[1]) || !is_outside(v[2])) continue;
      if (edge_met[static_cast<std::size_t>(tet_edge(v[0], v[1]))] ||
          edge_met[static_cast<std::size_t>(tet_edge(v[0], v[2]))] ||
          edge_met[static_cast<std::size_t>(tet_edge(v[1], v[2]))]) {
        any = true;
        continue;
      }
      const GridPoint corners[3]{c[v[0]], c[v[1]], c[v[2]]};
      any |= note(met, kFacePlace + f, form_.meeting(corners));
    }
    if (all_outside && !any) note(met, kInnerPlace, form_.meeting(c));
    return met;
  }

  Side side_at(const GridPoint& p) {
    const auto [it, is_new] = sides_.try_emplace(p, Side::outside);
    if (is_new) it->second = form_.side(p);
    return it->second;
  }

  /// Replaces each tetrahedron with these corners by one for each of them, the new place in its
  /// stead.
  static void split(std::vector<Tet>& tets, std::span<const std::uint8_t> corners,
                    std::uint8_t place) {
    std::vector<Tet> result;
    for (const Tet& tet : tets) {
      const auto has = [&](std::uint8_t v) {
        return std::find(tet.begin(), tet.end(), v) != tet.end();
      };
      if (!std::all_of(corners.begin(), corners.end(), has)) {
        result.push_back(tet);
        continue;
      }
      for (const auto v : corners) {
        result.push_back(tet);
        std::replace(result.back().begin(), result.back().end(), v, place);
      }
    }
    tets = std::move(result);
  }

  void march(const std::array<GridPoint, 4>& corners, bool is_positive) {
    const Met met = ask(corners);
    const bool mixed = std::any_of(met.corner.begin(), met.corner.end(), [&](Side s) {
      return (s == Side::inside) != (met.corner[0] == Side::inside);
    });
    if (!mixed && !met.any) return;
    tets_.assign(1, {0, 1, 2, 3});
    if (met.any) {
      for (std::size_t e = 0; e < 6; ++e) {
        const std::uint8_t ends[2]{static_cast<std::uint8_t>(kTetEdges[e][0]),
                                   static_cast<std::uint8_t>(kTetEdges[e][1])};
        if (met.place[kEdgePlace + e])
          split(tets_, ends, static_cast<std::uint8_t>(kEdgePlace + e));
      }
      for (std::size_t f = 0; f < 4; ++f)
        if (met.place[kFacePlace + f])
          split(tets_, kFaces[f], static_cast<std::uint8_t>(kFacePlace + f));
      constexpr Tet all{0, 1, 2, 3};
      if (met.place[kInnerPlace]) split(tets_, all, kInnerPlace);
    }
    for (const Tet& tet : tets_) polygon(corners, met, tet, is_positive);
  }

  void polygon(const std::array<GridPoint, 4>& corners, const Met& met, const Tet& tet,
               bool is_positive) {
    std::array<bool, 4> inside;
    for (std::size_t i = 0; i < 4; ++i)
      inside[i] = tet[i] >= kEdgePlace || met.corner[tet[i]] == Side::inside;
    const auto count = std::count(inside.begin(), inside.end(), true);
    if (count == 0 || count == 4) return;
    const auto vertex = [&](std::size_t i, std::size_t j) {
      return inside[i] ? vertex_between(corners, tet[i], tet[j])
                       : vertex_between(corners, tet[j], tet[i]);
    };
    if (count != 2) {
      std::size_t alone = 0;
      while (inside[alone] != (count == 1)) ++alone;
      const Tet& p = kFront[alone];
      triangle(vertex(p[0], p[1]), vertex(p[0], p[2]), vertex(p[0], p[3]),
               is_positive == (count == 1));
      return;
    }
    std::size_t e = 0;
    while (!inside[kEdgeFront[e][0]] || !inside[kEdgeFront[e][1]]) ++e;
    const Tet& p = kEdgeFront[e];
    const auto a = vertex(p[0], p[2]), b = vertex(p[0], p[3]);
    const auto c = vertex(p[1], p[3]), d = vertex(p[1], p[2]);
    if (squared_distance(a, c) <= squared_distance(b, d)) {
      triangle(a, b, c, is_positive);
      triangle(a, c, d, is_positive);
    } else {
      triangle(a, b, d, is_positive);
      triangle(b, c, d, is_positive);
    }
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool is_positive) {
    result_.triangles.push_back({a, is_positive ? b : c, is_positive ? c : b});
  }

  double squared_distance(std::uint32_t a, std::uint32_t b) const {
    const auto d = result_.vertices[a].position - result_.vertices[b].position;
    return dot(d, d);
  }

  /// The corners, of the small tetrahedron, of the simplex that holds a place.
  static std::span<const std::uint8_t> simplex_of(std::uint8_t place) {
    static constexpr std::array<std::uint8_t, 4> own{0, 1, 2, 3};
    static constexpr std::array<std::array<std::uint8_t, 2>, 6> edges{
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    if (place < kEdgePlace) return {own.data() + place, 1};
    if (place < kFacePlace) return edges[static_cast<std::size_t>(place - kEdgePlace)];
    if (place < kInnerPlace) return kFaces[static_cast<std::size_t>(place - kFacePlace)];
    return own;
  }

  Weights weights(const GridPoint& p) const {
    Weights result;
    for (std::size_t i = 0; i < 4; ++i)
      result[i] = static_cast<double>(p[i]) / static_cast<double>(pieces_);
    return result;
  }

  std::uint32_t vertex_between(const std::array<GridPoint, 4>& corners, std::uint8_t in,
                               std::uint8_t out) {
    VertexKey key{{-1, -1, -1, -1}, {}, {}, static_cast<std::int8_t>(level_.nappe)};
    const auto simplex = simplex_of(in);
    std::array<int, 4> sum{};
    for (const auto v : simplex)
      for (std::size_t i = 0; i < 4; ++i) sum[i] += corners[v][i];
    std::size_t k = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (sum[i] == 0 && corners[out][i] == 0) continue;
      key.ids[k] = nodes_[i];
      key.inside[k] = static_cast<std::uint16_t>(sum[i]);
      key.outside[k++] = static_cast<std::uint16_t>(corners[out][i]);
    }
    const auto next = static_cast<std::uint32_t>(result_.vertices.size());
    const auto [it, is_new] = numbers_.try_emplace(key, next);
    if (!is_new) return it->second;
    std::array<Weights, 4> ends;
    for (std::size_t i = 0; i < simplex.size(); ++i) ends[i] = weights(corners[simplex[i]]);
    const Weights inside =
        simplex.size() == 1 ? ends[0] : geometry_.inner_place({ends.data(), simplex.size()});
    const Weights w = geometry_.crossing(inside, weights(corners[out]));
    SymmetricTensor<double> t{};
    for (std::size_t i = 0; i < 4; ++i) t = t + w[i] * *tensors_[i];
    result_.vertices.push_back(
        {key, geometry_.position(w), geometry_.normal(w), invariant_of(invariant_, t)});
    return next;
  }

  const ConvexLevel& level_;
  Invariant invariant_;
  std::array<TetMesh::Index, 4> nodes_;
  bool is_even_;
  int pieces_;
  std::array<const SymmetricTensor<double>*, 4> tensors_;
  CellForm form_;
  CellGeometry geometry_;
  CellLevel result_;
  std::map<GridPoint, Side> sides_;
  std::map<VertexKey, std::uint32_t> numbers_;
  std::vector<Tet> tets_;
};

}  // namespace

CellLevel level_in_cell(const ConvexLevel& level, Invariant invariant, const TetMesh& mesh,
                        const std::array<TetMesh::Index, 4>& nodes, bool is_even, int pieces) {
  return Marching(level, invariant, mesh, nodes, is_even, pieces).run();
}

}  // namespace tensortopo
