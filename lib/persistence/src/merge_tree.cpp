// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/merge_tree.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "ascent.hpp"
#include "tensortopo/scalar/elementary.hpp"
#include "tensortopo/scalar/rational.hpp"
#include "tensortopo/tensor/mode.hpp"
#include "touched_maxima.hpp"

namespace tensortopo {
namespace {

using namespace persistence;
using Index = TetMesh::Index;

double distance(const Vector3<double>& a, const Vector3<double>& b) {
  return elementary::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// One maximum for each component, in order.
std::vector<ModeMaximum> maxima_of(const TetMesh& mesh, const CurveMesh& curves) {
  std::vector<ModeMaximum> maxima;
  for (std::size_t line = 0; line < curves.lines.size(); ++line) {
    const auto component = as_size(curves.component[line]);
    if (component >= maxima.size()) maxima.resize(component + 1);
    ModeMaximum& maximum = maxima[component];
    const auto& row = curves.lines[line];
    if (maximum.tet < 0) {
      maximum.mode = {1, 1};
      maximum.curve = component;
      maximum.tet = static_cast<Index>(curves.tet[line]);
      maximum.vertices = mesh.tets[as_size(maximum.tet)];
      maximum.point = curves.points[as_size(row[0])];
    }
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      maximum.length +=
          distance(curves.points[as_size(row[i])], curves.points[as_size(row[i + 1])]);
  }
  // Closed if each vertex has lines on two sides.
  std::vector<int> ends(curves.points.size(), 0);
  for (const auto& row : curves.lines) ++ends[as_size(row.front())], ++ends[as_size(row.back())];
  for (ModeMaximum& maximum : maxima) maximum.is_closed = true;
  for (std::size_t line = 0; line < curves.lines.size(); ++line)
    for (const auto v : {curves.lines[line].front(), curves.lines[line].back()})
      if (ends[as_size(v)] == 1) maxima[as_size(curves.component[line])].is_closed = false;
  return maxima;
}

bool is_exactly_linear(const SymmetricTensor<double>& tensor) {
  const auto t = deviator(tensor_cast<Rational>(tensor));
  return discriminant_form(t) == 0 && determinant_form(t) > 0;
}

/// What paths may end at: components of curves, and points.
class Ends {
 public:
  Ends(const TetMesh& mesh, const CurveMesh& curves)
      : mesh_(mesh),
        stars_(mesh),
        along_(mesh),
        ascent_(mesh, stars_, landmarks_, along_),
        touched_(mesh, stars_, ascent_, along_, curves) {
    landmarks_.add_curves(mesh, curves);
    for (std::size_t line = 0; line < curves.lines.size(); ++line)
      for (const auto v : curves.lines[line])
        if (curves.carrier[as_size(v)] == Carrier::vertex)
          on_curves_[static_cast<Index>(curves.carrier_vertices[as_size(v)][0])] =
              as_size(curves.component[line]);
    for (const auto& [vertex, component] : on_curves_) ascent_.set_maximum(vertex, component);
  }

  void add(const MeshCriticalPoint& point, std::size_t maximum) {
    if (point.dimension == 0) ascent_.set_maximum(point.vertices[0], maximum);
    landmarks_.add_point(mesh_, stars_, point.vertices, point.weights, point.deviator, maximum);
    touched_.add(point, maximum);
  }

  bool is_on_curve(Index vertex) const { return on_curves_.contains(vertex); }
  const VertexStars& stars() const { return stars_; }
  Ascent& ascent() { return ascent_; }
  TouchedMaxima& touched() { return touched_; }

  /// Where paths lead to from one of the parts of a link.
  std::optional<std::size_t> above(const std::vector<TetDeparture>& part, double level) {
    for (const TetDeparture& way : part)
      if (const auto maximum = ascent_.leave(way, level)) return maximum;
    return std::nullopt;
  }

 private:
  const TetMesh& mesh_;
  VertexStars stars_;
  Landmarks landmarks_;
  SimplexMaxima along_;
  Ascent ascent_;
  TouchedMaxima touched_;
  std::unordered_map<Index, std::size_t> on_curves_;
};

class Building {
 public:
  Building(const TetMesh& mesh, const MeshCriticalValues& values, const CurveExtraction& curves)
      : mesh_(mesh), values_(values), curves_(curves.curves), ends_(mesh, curves.curves) {
    knows_all_maxima_ =
        curves.unresolved.empty() &&
        std::none_of(values.points.begin(), values.points.end(), [](const auto& point) {
          return point.effect.change == LocalChange::undecided;
        });
  }

  MergeTree run() {
    tree_.maxima = maxima_of(mesh_, curves_);
    std::vector<std::size_t> merges;
    for (std::size_t i = 0; i < values_.points.size(); ++i)
      if (!is_maximum(i)) merges.push_back(i);
    for (const std::size_t i : merges) add_merge(i);
    for (auto* list : {&tree_.merges, &tree_.others})
      std::stable_sort(list->begin(), list->end(), [](const ModeMerge& a, const ModeMerge& b) {
        return a.mode.low + a.mode.high > b.mode.low + b.mode.high;
      });
    return std::move(tree_);
  }

 private:
  Index tet_of(const MeshCriticalPoint& point) const {
    const auto tets = ends_.stars().around(point.vertices);
    return tets.empty() ? -1 : tets.front();
  }

  /// Takes the point as a maximum, if it is one.
  bool is_maximum(std::size_t index) {
    const MeshCriticalPoint& point = values_.points[index];
    ModeRange mode{point.low, point.high};
    const auto& signs = point.link.signs;
    const bool is_peak =
        point.effect.change != LocalChange::undecided &&
        std::all_of(signs.begin(), signs.end(), [](Verdict s) { return s == Verdict::negative; });
    if (!is_peak) {
      // At a vertex of mode 1 the derivatives vanish; no other mode is larger.
      if (point.dimension != 0 || point.high < 1 ||
          !is_exactly_linear(mesh_.tensors[as_size(point.vertices[0])]))
        return false;
      if (ends_.is_on_curve(point.vertices[0])) return true;
      mode = {1, 1};
    }
    ModeMaximum maximum;
    maximum.mode = mode;
    maximum.vertices = point.vertices;
    maximum.point = point.point;
    maximum.tet = tet_of(point);
    maximum.critical_point = index;
    ends_.add(point, tree_.maxima.size());
    tree_.maxima.push_back(maximum);
    return true;
  }

  void add_merge(std::size_t index) {
    const MeshCriticalPoint& point = values_.points[index];
    // Of the least mode: nothing is below.
    if (point.dimension == 0 && point.low <= -1 &&
        is_exactly_linear(-1.0 * mesh_.tensors[as_size(point.vertices[0])]))
      return;
    ModeMerge merge;
    merge.point = index;
    merge.mode = {point.low, point.high};
    bool meets = true;
    if (point.effect.change != LocalChange::undecided) {
      const auto ways = departures(mesh_, ends_.stars(), point);
      const auto outer =
          parts_on_boundary(point.link, parts_of_sign(point.link, Verdict::positive));
      if (ways.empty() || (ways.size() == 1 && !changes_more_than_components(point, outer))) return;
      merge.is_proved = merge.is_proved_inside = true;
      for (std::size_t i = 0; i < ways.size(); ++i) {
        if (const auto maximum = above(ways[i], point)) {
          merge.reached.push_back(*maximum);
          merge.touches_boundary.push_back(outer[i]);
        } else {
          merge.is_proved = false;
          merge.is_proved_inside &= outer[i] != 0;
        }
      }
      meets = ways.size() > 1;
    }
    const auto& signs = point.link.signs;
    merge.may_be_maximum = point.effect.change == LocalChange::undecided &&
                           std::count(signs.begin(), signs.end(), Verdict::positive) == 0;
    if (!merge.is_proved) merge.possible = ends_.touched().at(point);
    merge.tet = tet_of(point);
    (meets ? tree_.merges : tree_.others).push_back(std::move(merge));
  }

  /// A maximum of the component into which one part of the link leads: by a path, or because there
  /// is no other.
  std::optional<std::size_t> above(const std::vector<TetDeparture>& part,
                                   const MeshCriticalPoint& point) {
    if (const auto maximum = ends_.above(part, point.high)) return maximum;
    if (!knows_all_maxima_) return std::nullopt;
    for (const TetDeparture& way : part)
      if (const auto maximum = ends_.touched().only_one_from(way.tet, point)) return maximum;
    return std::nullopt;
  }

  /// The component comes to touch the boundary there, or its loops or voids change: the mode falls
  /// in several parts of the link, what is outside of the mesh counting as one.
  static bool changes_more_than_components(const MeshCriticalPoint& point,
                                           const std::vector<char>& outer_rises) {
    const bool is_outer = point.effect.on_boundary;
    const auto falls = parts_on_boundary(point.link, parts_of_sign(point.link, Verdict::negative));
    return (is_outer && outer_rises[0] == 0) ||
           std::count(falls.begin(), falls.end(), 0) + (is_outer ? 1 : 0) > 1;
  }

  const TetMesh& mesh_;
  const MeshCriticalValues& values_;
  const CurveMesh& curves_;
  Ends ends_;
  bool knows_all_maxima_ = false;
  MergeTree tree_;
};

/// Adds the points of a finished tree.
void add_points(Ends& ends, const MeshCriticalValues& values, const MergeTree& tree) {
  for (std::size_t i = 0; i < tree.maxima.size(); ++i)
    if (const auto& point = tree.maxima[i].critical_point) ends.add(values.points[*point], i);
}

}  // namespace

MergeTree merge_tree(const TetMesh& mesh, const MeshCriticalValues& values,
                     const CurveExtraction& curves) {
  return Building(mesh, values, curves).run();
}

std::vector<std::optional<std::size_t>> maxima_above_points(const TetMesh& mesh,
                                                            const MeshCriticalValues& values,
                                                            const CurveExtraction& curves,
                                                            const MergeTree& tree,
                                                            std::span<const std::size_t> points) {
  Ends ends(mesh, curves.curves);
  add_points(ends, values, tree);
  std::vector<std::optional<std::size_t>> reached;
  for (const std::size_t i : points) {
    const MeshCriticalPoint& point = values.points[i];
    std::optional<std::size_t> maximum;
    if (point.is_certain)
      for (const auto& part : departures(mesh, ends.stars(), point))
        if (!maximum) maximum = ends.above(part, point.high);
    reached.push_back(maximum);
  }
  return reached;
}

std::vector<std::optional<std::size_t>> maxima_above_vertices(
    const TetMesh& mesh, const MeshCriticalValues& values, const CurveExtraction& curves,
    const MergeTree& tree, std::span<const TetMesh::Index> vertices) {
  Ends ends(mesh, curves.curves);
  add_points(ends, values, tree);
  std::vector<std::optional<std::size_t>> reached;
  for (const Index v : vertices) {
    const bool has_mode = deviator(mesh.tensors[as_size(v)]) != Deviator<double>{};
    reached.push_back(has_mode ? ends.ascent().from_vertex(v) : std::nullopt);
  }
  return reached;
}

}  // namespace tensortopo
