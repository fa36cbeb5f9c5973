// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/component_persistence.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {
namespace {

/// The largest mode in a component of {mode >= m}.
struct Height {
  double at_least = 0;    ///< of its maxima that are known
  bool is_exact = false;  ///< it has no others of a larger mode
};

/// Components of {mode >= m}: the largest mode in each, by one of its maxima.
///
/// What is not proved may join more to a component, so that its largest mode is larger, but not
/// beyond 1.
class Heights {
 public:
  Heights(const MergeTree& tree, const CurveExtraction& curves, double mode)
      : tree_(tree),
        classes_(tree.maxima.size()),
        best_(tree.maxima.size(), -1),
        is_doubtful_(tree.maxima.size(), curves.unresolved.empty() ? 0 : 1) {
    for (const ModeMerge& merge : tree.merges) {
      if (merge.mode.high < mode) break;
      for (const std::size_t i : merge.reached)
        if (merge.is_proved && merge.mode.low > mode)
          classes_.unite(static_cast<std::uint32_t>(merge.reached[0]),
                         static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < tree.maxima.size(); ++i) {
      double& best = best_[class_of(i)];
      best = std::max(best, tree.maxima[i].mode.low);
    }
    for (const ModeMerge& merge : tree.merges)
      if (merge.mode.high >= mode && !(merge.is_proved && merge.mode.low > mode)) doubt(merge);
  }

  /// Of the component with this maximum, if one is known; each reaches to the level at least.
  Height of(const std::optional<std::size_t>& maximum, double level) {
    if (!maximum) return {level, false};
    const std::size_t c = class_of(*maximum);
    return {best_[c], is_doubtful_[c] == 0 || best_[c] >= 1};
  }

 private:
  void doubt(const ModeMerge& merge) {
    if (!merge.is_proved && !merge.possible) {
      std::fill(is_doubtful_.begin(), is_doubtful_.end(), 1);
      return;
    }
    for (const std::size_t i : merge.is_proved ? merge.reached : *merge.possible)
      is_doubtful_[class_of(i)] = 1;
  }
  std::size_t class_of(std::size_t i) { return classes_.find(static_cast<std::uint32_t>(i)); }

  const MergeTree& tree_;
  UnionFind classes_;
  std::vector<double> best_;
  std::vector<char> is_doubtful_;
};

/// For each component the ends of a mesh edge that crosses it and the level nowhere else.
std::vector<std::optional<std::array<SurfaceMesh::Index, 2>>> crossing_edges(
    const SurfaceMesh& surface, std::size_t components) {
  using Edge = std::array<SurfaceMesh::Index, 2>;
  const auto edge_of = [&](std::size_t v) {
    return Edge{surface.carrier_vertices[v][0], surface.carrier_vertices[v][1]};
  };
  std::map<Edge, int> crossings;
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    if (surface.carrier[v] == Carrier::edge) ++crossings[edge_of(v)];
  std::vector<std::optional<Edge>> edges(components);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    auto& edge = edges[as_size(surface.component[t])];
    for (const auto v : surface.triangles[t])
      if (!edge && surface.carrier[as_size(v)] == Carrier::edge &&
          crossings[edge_of(as_size(v))] == 1)
        edge = edge_of(as_size(v));
  }
  return edges;
}

template <class Value>
void keep_rows(std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  std::vector<Value> kept;
  kept.reserve(rows.size());
  for (const std::size_t row : rows) kept.push_back(std::move(values[row]));
  values = std::move(kept);
}

/// Numbers of the components kept, -1 for others.
std::vector<std::int32_t> new_numbers(const std::vector<char>& keep) {
  std::vector<std::int32_t> numbers;
  std::int32_t next = 0;
  for (const char is_kept : keep) numbers.push_back(is_kept != 0 ? next++ : -1);
  return numbers;
}

/// Cells and vertices that stay, and the vertices' new numbers.
template <class Cells>
struct Kept {
  Kept(const Cells& given, const std::vector<std::int32_t>& component,
       const std::vector<char>& keep, std::size_t points)
      : number(points, -1) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (keep[as_size(component[i])] == 0) continue;
      cells.push_back(i);
      for (const auto v : given[i]) number[as_size(v)] = 0;
    }
    for (std::size_t v = 0; v < points; ++v)
      if (number[v] == 0) {
        number[v] = static_cast<std::int32_t>(vertices.size());
        vertices.push_back(v);
      }
  }
  std::vector<std::size_t> cells, vertices;
  std::vector<std::int32_t> number;
};

}  // namespace

std::vector<std::optional<double>> component_persistence(const TetMesh& mesh,
                                                         const PersistenceInput& input,
                                                         const SurfaceMesh& surface, double mode,
                                                         std::span<const TetMesh::Index> numbers) {
  std::size_t components = 0;
  for (const auto c : surface.component) components = std::max(components, as_size(c) + 1);
  const auto edges = crossing_edges(surface, components);
  std::vector<TetMesh::Index> above, below;
  std::vector<std::size_t> known;
  for (std::size_t c = 0; c < components; ++c) {
    if (!edges[c]) continue;
    // One crossing: the ends are on different sides, in the same components as the points beside
    // it.
    const auto mode_at = [&](TetMesh::Index v) {
      const SymmetricTensor<double>& t = mesh.tensors[as_size(v)];
      return mode_range(deviator_box({t, t, t, t}, {1, 0, 0, 0}));
    };
    auto [v, w] = *edges[c];
    if (!numbers.empty()) v = numbers[as_size(v)], w = numbers[as_size(w)];
    if (mode_at(v)[0] < mode_at(w)[0]) std::swap(v, w);
    if (!(mode_at(v)[0] > mode && mode_at(w)[1] < mode)) continue;
    above.push_back(v), below.push_back(w), known.push_back(c);
  }
  const auto maxima =
      maxima_above_vertices(mesh, input.values, input.curves[0], input.trees[0], above);
  const auto minima = maxima_above_vertices(opposite(mesh), opposite(input.values), input.curves[1],
                                            input.trees[1], below);
  Heights heights(input.trees[0], input.curves[0], mode),
      depths(input.trees[1], input.curves[1], -mode);
  const double level = signed_lode_angle(mode);
  std::vector<std::optional<double>> result(components);
  for (std::size_t i = 0; i < known.size(); ++i) {
    const Height highest = heights.of(maxima[i], mode), lowest = depths.of(minima[i], -mode);
    const double rise = signed_lode_angle(highest.at_least) - level,
                 fall = level + signed_lode_angle(lowest.at_least);
    // The smaller of the two, which the other cannot be smaller than.
    if (rise <= fall ? highest.is_exact : lowest.is_exact) result[known[i]] = std::min(rise, fall);
  }
  return result;
}

std::vector<std::optional<double>> curve_persistence(const ModePersistence& persistence, int mode,
                                                     std::size_t components) {
  std::vector<std::optional<double>> result(components);
  for (const CurvePersistence& curve : persistence.curves) {
    const PersistencePair& pair = persistence.pairs[curve.pair];
    if (curve.mode == mode && curve.component < components && pair.has_death && pair.is_certain)
      result[curve.component] = angle_persistence(pair);
  }
  return result;
}

SurfaceMesh kept_components(const SurfaceMesh& surface, const std::vector<char>& keep) {
  SurfaceMesh result = surface;
  const Kept kept(surface.triangles, surface.component, keep, surface.points.size());
  keep_rows(result.points, kept.vertices);
  keep_rows(result.carrier, kept.vertices);
  keep_rows(result.carrier_id, kept.vertices);
  keep_rows(result.carrier_vertices, kept.vertices);
  keep_rows(result.medium_eigenvector, kept.vertices);
  keep_rows(result.dominant_eigenvector, kept.vertices);
  keep_rows(result.normal, kept.vertices);
  keep_rows(result.mode, kept.vertices);
  keep_rows(result.residual, kept.vertices);
  keep_rows(result.value, kept.vertices);
  keep_rows(result.triangles, kept.cells);
  keep_rows(result.tet, kept.cells);
  keep_rows(result.component, kept.cells);
  for (auto& triangle : result.triangles)
    for (auto& v : triangle) v = kept.number[as_size(v)];
  const auto numbers = new_numbers(keep);
  for (auto& c : result.component) c = numbers[as_size(c)];
  return result;
}

CurveMesh kept_components(const CurveMesh& curves, const std::vector<char>& keep) {
  CurveMesh result = curves;
  const Kept kept(curves.lines, curves.component, keep, curves.points.size());
  keep_rows(result.points, kept.vertices);
  keep_rows(result.carrier, kept.vertices);
  keep_rows(result.carrier_vertices, kept.vertices);
  keep_rows(result.dominant_eigenvector, kept.vertices);
  keep_rows(result.mode, kept.vertices);
  keep_rows(result.separation, kept.vertices);
  keep_rows(result.residual, kept.vertices);
  keep_rows(result.lines, kept.cells);
  keep_rows(result.tet, kept.cells);
  keep_rows(result.component, kept.cells);
  for (auto& line : result.lines)
    for (auto& v : line) v = kept.number[as_size(v)];
  const auto numbers = new_numbers(keep);
  for (auto& c : result.component) c = numbers[as_size(c)];
  return result;
}

}  // namespace tensortopo
