// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analyze/curvature/ridges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analyze/curvature/each_corner.hpp"

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;
using Corner = std::optional<LevelExtremality<double>>;

double sign(double x) { return x < 0 ? -1 : 1; }

/// What keeps a triangle from having a segment; `crossed` also if it could have one and has none.
enum class Verdict { crossed, umbilic, flat, undefined };

RidgeEnd end_at(Verdict verdict) {
  return verdict == Verdict::umbilic ? RidgeEnd::umbilic
         : verdict == Verdict::flat  ? RidgeEnd::flat
                                     : RidgeEnd::undefined;
}

/// An edge of the surface, its smaller vertex first.
using Edge = std::pair<Index, Index>;
Edge edge_of(const std::array<Index, 3>& t, std::size_t k) {
  return std::minmax(t[(k + 1) % 3], t[(k + 2) % 3]);
}

/// That of a linear function in a triangle, from its values at the corners; none if it is flat.
std::optional<Vector3<double>> gradient_of(const SurfaceMesh& surface,
                                           const std::array<Index, 3>& t,
                                           const std::array<double, 3>& value) {
  const auto& p = surface.points;
  const Vector3<double> e1 = p[as_size(t[1])] - p[as_size(t[0])],
                        e2 = p[as_size(t[2])] - p[as_size(t[0])];
  const Vector3<double> normal = cross(e1, e2);
  if (!(dot(normal, normal) > 0)) return std::nullopt;
  return (1 / dot(normal, normal)) *
         ((value[1] - value[0]) * cross(e2, normal) + (value[2] - value[0]) * cross(normal, e1));
}

/// Segments of all triangles, joined to lines.
class Tracer {
 public:
  /// @param smooth  the tetrahedra play no part
  Tracer(const SurfaceMesh& surface, const std::vector<Corner>& corners, bool smooth)
      : surface_(surface), corners_(corners), smooth_(smooth), verdicts_(surface.triangles.size()) {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) around_[edge_of(surface.triangles[i], k)].push_back(i);
  }

  RidgeLines run() {
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) trace(i);
    for (const std::size_t kind : {0u, 1u}) bridge(kind);
    join();
    return std::move(lines_);
  }

 private:
  /// A point on an edge, as the field of one tetrahedron has it.
  struct Place {
    std::size_t kind;
    Edge edge;
    Index tet;
    auto operator<=>(const Place&) const = default;
  };
  /// At most two: the segments of the triangles on both sides, or a bridge.
  struct Node {
    Place place;
    std::size_t triangle;  ///< the first that has it
    std::vector<Index> next;
    std::size_t segments = 0;  ///< bridges aside
  };

  Index tet_of(std::size_t triangle) const { return smooth_ ? 0 : surface_.tet[triangle]; }

  void trace(std::size_t triangle) {
    const auto& t = surface_.triangles[triangle];
    std::array<const LevelExtremality<double>*, 3> c;
    auto& verdict = verdicts_[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& corner = corners_[3 * triangle + k];
      if (!corner) {
        verdict.fill(Verdict::undefined);
        ++lines_.undefined_triangles;
        return;
      }
      c[k] = &*corner;
    }
    // Each direction against that of the first corner. The two of a corner are across each other,
    // but corners have tangent planes of their own: either may fail.
    std::array<std::array<double, 3>, 2> turn;
    for (const std::size_t kind : {0u, 1u}) {
      const auto agree = [&](std::size_t i, std::size_t j) {
        return sign(dot(c[i]->curvature.directions[kind], c[j]->curvature.directions[kind]));
      };
      turn[kind] = {1, agree(0, 1), agree(0, 2)};
      if (agree(1, 2) != turn[kind][1] * turn[kind][2]) verdict.fill(Verdict::umbilic);
    }
    if (verdict[0] == Verdict::umbilic) {
      ++lines_.umbilic_triangles;
      return;
    }
    for (const std::size_t kind : {0u, 1u}) {
      if (std::all_of(c.begin(), c.end(), [&](auto* one) { return one->is_flat(kind); })) {
        verdict[kind] = Verdict::flat;
        ++lines_.sums[kind].flat_triangles;
      } else {
        trace(triangle, kind, c, turn[kind], t);
      }
    }
  }

  void trace(std::size_t triangle, std::size_t kind,
             const std::array<const LevelExtremality<double>*, 3>& c,
             const std::array<double, 3>& turn, const std::array<Index, 3>& t) {
    // A zero counts as positive for the direction as it is stored, in all triangles alike.
    std::array<double, 3> value, side;
    Vector3<double> along{};
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = turn[k] * c[k]->extremality[kind];
      side[k] = turn[k] * sign(c[k]->extremality[kind]);
      along += turn[k] * c[k]->curvature.directions[kind];
    }
    std::size_t alone = 3;
    for (std::size_t k = 0; k < 3; ++k)
      if (side[k] != side[(k + 1) % 3] && side[k] != side[(k + 2) % 3]) alone = k;
    if (alone == 3) return;
    const auto gradient = gradient_of(surface_, t, value);
    if (!gradient) return;
    const double slope = dot(*gradient, along) / length(along);
    const double strength = kind == 0 ? -slope : slope;
    if (!(strength > 0)) return;
    const Index a = point_on(triangle, kind, (alone + 1) % 3, c),
                b = point_on(triangle, kind, (alone + 2) % 3, c);
    nodes_[as_size(a)].next.push_back(b);
    nodes_[as_size(b)].next.push_back(a);
    for (const Index v : {a, b}) {
      // The mean of the triangles on both sides.
      Node& node = nodes_[as_size(v)];
      double& mean = lines_.strength[as_size(v)];
      ++node.segments;
      mean += (strength - mean) / static_cast<double>(node.segments);
    }
  }

  /// The zero on the edge across a corner: the same number from the triangles on both sides.
  Index point_on(std::size_t triangle, std::size_t kind, std::size_t across,
                 const std::array<const LevelExtremality<double>*, 3>& c) {
    const auto& t = surface_.triangles[triangle];
    std::size_t i = (across + 1) % 3, j = (across + 2) % 3;
    if (t[i] > t[j]) std::swap(i, j);
    const Place place{kind, {t[i], t[j]}, tet_of(triangle)};
    const auto [found, is_new] = index_.emplace(place, static_cast<Index>(nodes_.size()));
    if (!is_new) return found->second;
    const double u = std::abs(c[i]->extremality[kind]), v = std::abs(c[j]->extremality[kind]);
    const double w = u + v > 0 ? u / (u + v) : 0.5;
    const auto mix = [w](double a, double b) { return (1 - w) * a + w * b; };
    nodes_.push_back({place, triangle, {}});
    lines_.points.push_back((1 - w) * surface_.points[as_size(t[i])] +
                            w * surface_.points[as_size(t[j])]);
    const auto &a = c[i]->curvature.principal, &b = c[j]->curvature.principal;
    lines_.curvature.push_back(mix(a[kind], b[kind]));
    lines_.other_curvature.push_back(mix(a[1 - kind], b[1 - kind]));
    lines_.strength.push_back(0);
    return found->second;
  }

  /// Joins two points of one edge of which each has one segment, in its own tetrahedron.
  void bridge(std::size_t kind) {
    for (auto place = index_.lower_bound({kind, {0, 0}, 0});
         place != index_.end() && place->first.kind == kind; ++place) {
      const auto other = std::next(place);
      if (other == index_.end()) break;
      if (other->first.kind != kind || other->first.edge != place->first.edge) continue;
      Node &a = nodes_[as_size(place->second)], &b = nodes_[as_size(other->second)];
      if (a.next.size() != 1 || b.next.size() != 1) continue;
      a.next.push_back(other->second);
      b.next.push_back(place->second);
    }
  }

  RidgeEnd end_of(const Node& node) const {
    RidgeEnd end = RidgeEnd::boundary;
    for (const std::size_t triangle : around_.at(node.place.edge)) {
      if (triangle == node.triangle) continue;
      const Verdict verdict = verdicts_[triangle][node.place.kind];
      end = verdict != Verdict::crossed          ? end_at(verdict)
            : tet_of(triangle) != node.place.tet ? RidgeEnd::face
                                                 : RidgeEnd::turn;
    }
    return end;
  }

  void join() {
    std::vector<bool> taken(nodes_.size());
    const auto walk = [&](Index start) {
      RidgeLines::Line line{RidgeKind{nodes_[as_size(start)].place.kind}, {start}};
      taken[as_size(start)] = true;
      for (bool more = true; more;) {
        more = false;
        for (const Index next : nodes_[as_size(line.points.back())].next) {
          if (taken[as_size(next)]) continue;
          line.points.push_back(next);
          taken[as_size(next)] = more = true;
          break;
        }
      }
      const auto& last = nodes_[as_size(line.points.back())].next;
      if (line.points.size() > 2 && nodes_[as_size(start)].next.size() > 1 &&
          std::find(last.begin(), last.end(), start) != last.end())
        line.points.push_back(start);
      finish(std::move(line));
    };
    for (const bool open : {true, false})
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (!taken[i] && (nodes_[i].next.size() == 1) == open) walk(static_cast<Index>(i));
  }

  void finish(RidgeLines::Line line) {
    if (line.points.size() < 2) return;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const std::size_t a = as_size(line.points[i - 1]), b = as_size(line.points[i]);
      const double step = length(lines_.points[b] - lines_.points[a]);
      line.length += step;
      line.strength += step * (lines_.strength[a] + lines_.strength[b]) / 2;
      line.strongest = std::max({line.strongest, lines_.strength[a], lines_.strength[b]});
      if (std::abs(lines_.curvature[a] + lines_.curvature[b]) >
          std::abs(lines_.other_curvature[a] + lines_.other_curvature[b]))
        line.crest_length += step;
      if (nodes_[a].place.tet == nodes_[b].place.tet) continue;
      ++line.bridges;
      line.bridge_length += step;
    }
    line.strength = line.length > 0 ? line.strength / line.length : line.strongest;
    if (!line.is_closed())
      line.ends = {end_of(nodes_[as_size(line.points.front())]),
                   end_of(nodes_[as_size(line.points.back())])};
    lines_.sums[static_cast<std::size_t>(line.kind)].add(line);
    lines_.lines.push_back(std::move(line));
  }

  const SurfaceMesh& surface_;
  const std::vector<Corner>& corners_;
  bool smooth_;
  std::vector<std::array<Verdict, 2>> verdicts_;
  std::map<Edge, std::vector<std::size_t>> around_;
  std::map<Place, Index> index_;
  std::vector<Node> nodes_;
  RidgeLines lines_;
};

}  // namespace

void RidgeLines::Sum::add(const Line& line) {
  ++lines;
  length += line.length;
  crest_length += line.crest_length;
  strongest = std::max(strongest, line.strongest);
  bridges += line.bridges;
  bridge_length += line.bridge_length;
  if (line.is_closed()) {
    ++closed;
  } else {
    for (const RidgeEnd end : line.ends) ++ends[static_cast<std::size_t>(end)];
  }
}

RidgeLines filtered(const RidgeLines& ridges, const RidgeFilter& filter) {
  RidgeLines kept;
  kept.umbilic_triangles = ridges.umbilic_triangles;
  kept.undefined_triangles = ridges.undefined_triangles;
  for (const std::size_t kind : {0u, 1u}) {
    kept.sums[kind].flat_triangles = ridges.sums[kind].flat_triangles;
    kept.sums[kind].left_out = ridges.sums[kind].left_out;
    kept.sums[kind].left_out_length = ridges.sums[kind].left_out_length;
  }
  std::vector<Index> place(ridges.points.size(), -1);
  for (RidgeLines::Line line : ridges.lines) {
    RidgeLines::Sum& sum = kept.sums[static_cast<std::size_t>(line.kind)];
    if (!filter.keeps(line)) {
      ++sum.left_out;
      sum.left_out_length += line.length;
      continue;
    }
    for (Index& v : line.points) {
      Index& known = place[as_size(v)];
      if (known < 0) {
        known = static_cast<Index>(kept.points.size());
        kept.points.push_back(ridges.points[as_size(v)]);
        kept.curvature.push_back(ridges.curvature[as_size(v)]);
        kept.other_curvature.push_back(ridges.other_curvature[as_size(v)]);
        kept.strength.push_back(ridges.strength[as_size(v)]);
      }
      v = known;
    }
    sum.add(line);
    kept.lines.push_back(std::move(line));
  }
  return kept;
}

RidgeLines ridges_of(const SurfaceMesh& surface, const std::vector<Corner>& corners) {
  return Tracer(surface, corners, false).run();
}

RidgeLines ridges_of(const SurfaceMesh& surface,
                     const std::vector<std::optional<LevelCurvature<double>>>& vertices) {
  struct Sum {
    std::array<Vector3<double>, 2> gradient{};
    double area = 0, steepest = 0;
  };
  std::vector<Sum> sums(surface.points.size());
  for (const auto& t : surface.triangles) {
    if (!std::all_of(t.begin(), t.end(), [&](Index v) { return vertices[as_size(v)].has_value(); }))
      continue;
    const auto& p = surface.points;
    const double area =
        length(cross(p[as_size(t[1])] - p[as_size(t[0])], p[as_size(t[2])] - p[as_size(t[0])]));
    for (const std::size_t kind : {0u, 1u}) {
      std::array<double, 3> value;
      for (std::size_t k = 0; k < 3; ++k) value[k] = vertices[as_size(t[k])]->principal[kind];
      const auto gradient = gradient_of(surface, t, value);
      if (!gradient) continue;
      for (const Index v : t) {
        sums[as_size(v)].gradient[kind] += area * *gradient;
        sums[as_size(v)].area += area / 2;
        sums[as_size(v)].steepest = std::max(sums[as_size(v)].steepest, length(*gradient));
      }
    }
  }
  std::vector<Corner> corners;
  for (const auto& t : surface.triangles)
    for (const Index v : t) {
      const auto& curvature = vertices[as_size(v)];
      const Sum& sum = sums[as_size(v)];
      corners.emplace_back();
      if (!curvature || !(sum.area > 0)) continue;
      corners.back() = {*curvature, {}, sum.steepest};
      for (const std::size_t kind : {0u, 1u})
        corners.back()->extremality[kind] =
            dot(sum.gradient[kind], curvature->directions[kind]) / sum.area;
    }
  return Tracer(surface, corners, true).run();
}

RidgeLines surface_ridges(const SurfaceMesh& surface, const TetMesh& mesh) {
  return ridges_of(surface, at_each_corner(surface, mesh, level_extremality<double>));
}

}  // namespace tensortopo
