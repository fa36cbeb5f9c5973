// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/fill/subdivision_patch.hpp"

#include <algorithm>
#include <cmath>

#include "extract/level/position.hpp"
#include "extract/level/segment_root.hpp"
#include "extract/patch/fill/polygon.hpp"
#include "extract/patch/patch_check.hpp"
#include "extract/patch/patch_defects.hpp"
#include "extract/run/extractor_scalars.hpp"
#include "extract/patch/patch.hpp"

namespace tensortopo {

namespace {

/// A corner of a leaf polygon on its way to triangles.
struct Corner {
  std::int32_t id;  ///< as in `Patch`
  PolygonCorner corner;
};

template <class Scalar>
class SubdivisionTriangles {
 public:
  SubdivisionTriangles(const CellTopology<Scalar>& proved,
                       std::span<const SampleRequest<Scalar>> requests,
                       const TetWithCurves<Scalar>& tet, const FaceArcVertices& vertices,
                       const Level<Scalar>& level, Patch<Scalar>& out)
      : proved_(proved),
        mesh_(proved.subdivision->mesh),
        requests_(requests),
        tet_(tet),
        vertices_(vertices),
        level_(level),
        out_(out),
        crossings_(crossings_of_subdivision(tet, proved)),
        inner_(mesh_.nodes.size(), 0),
        first_inner_(out.inner.size()),
        first_triangle_(out.triangles.size()),
        test_(tet) {}

  bool add(const SubdivisionMesh::Polygon& polygon) {
    std::vector<Corner> corners;
    for (int i = 0; i < polygon.size; ++i) {
      const auto p = polygon.nodes[static_cast<std::size_t>(i)];
      const auto q = polygon.nodes[static_cast<std::size_t>((i + 1) % polygon.size)];
      const auto common = static_cast<unsigned>(mesh_.nodes[p].faces & mesh_.nodes[q].faces);
      if (common != 0) {
        int face = 0;
        while (!(common >> face & 1)) ++face;
        if (!append_loop(face, p, q, corners)) return false;
      } else if (!append_side(p, q, corners)) {
        return false;
      }
    }
    corners.erase(std::unique(corners.begin(), corners.end(),
                              [](const auto& a, const auto& b) { return a.id == b.id; }),
                  corners.end());
    while (corners.size() > 1 && corners.front().id == corners.back().id) corners.pop_back();
    if (corners.size() >= 3) cut(polygon, corners);  // else two boundary loop samples were one
    return true;
  }

  /// Polygons of which samples of the boundary loop fell together leave vertices without triangles.
  void drop_unused() { drop_unused_inner(out_, first_inner_, first_triangle_); }

 private:
  Corner inner_corner(std::uint32_t n) {
    if (inner_[n] == 0) {
      out_.inner.push_back(node_point(proved_.subdivision->refinement, mesh_.nodes[n], level_));
      inner_[n] = -static_cast<std::int32_t>(out_.inner.size());
    }
    const auto& point = out_.inner[static_cast<std::size_t>(-1 - inner_[n])];
    return {inner_[n], {position_at(point.weights, tet_.simplex.exponents, tet_.points), 0}};
  }

  static Corner boundary_corner(const BoundaryVertex& v) { return {v.id, {v.position, v.faces}}; }

  struct OnArc {
    int arc = -1;
    std::size_t index = 0;
  };

  /// The arc of the face, and the vertex on it, that a node is. For a crossing of an edge the arc
  /// is the one that has it as an end.
  OnArc on_arc(int face, std::uint32_t n) const {
    const auto f = static_cast<std::size_t>(face);
    const auto crossing = crossings_.find(n);
    if (crossing != crossings_.end()) {
      for (std::size_t a = 0; a < tet_.arcs[f].size(); ++a) {
        const auto& arc = tet_.arcs[f][a];
        if (arc.closed) continue;
        if (crossing_of(tet_, face, arc.begin) == crossing->second) return {static_cast<int>(a), 0};
        if (crossing_of(tet_, face, arc.end) == crossing->second)
          return {static_cast<int>(a), vertices_[f][a].vertices.size() - 1};
      }
      return {};
    }
    const auto& request = requests_[n];
    if (request.arc < 0 || request.face != face) return {};
    const auto& places = vertices_[f][static_cast<std::size_t>(request.arc)].places;
    const double wanted = static_cast<double>(request.place);
    std::size_t best = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
      if (std::abs(places[i] - wanted) < std::abs(places[best] - wanted)) best = i;
    return {request.arc, best};
  }

  /// The boundary loop from node p up to, not including, node q.
  bool append_loop(int face, std::uint32_t p, std::uint32_t q, std::vector<Corner>& corners) {
    const auto from = on_arc(face, p), to = on_arc(face, q);
    if (from.arc < 0 || from.arc != to.arc) return false;
    const auto f = static_cast<std::size_t>(face);
    const auto& arc = vertices_[f][static_cast<std::size_t>(from.arc)];
    const bool closed = tet_.arcs[f][static_cast<std::size_t>(from.arc)].closed;
    const std::size_t n = arc.vertices.size();
    const bool forward = tet_.outward[f];
    if (!closed && (forward ? from.index > to.index : from.index < to.index)) return false;
    if (from.index == to.index) {
      corners.push_back(boundary_corner(arc.vertices[from.index]));
      return true;
    }
    for (std::size_t i = from.index; i != to.index; i = forward ? (i + 1) % n : (i + n - 1) % n)
      corners.push_back(boundary_corner(arc.vertices[i]));
    return true;
  }

  /// The vertex of the boundary loop that a node on a face or an edge has become.
  const BoundaryVertex* boundary_vertex(std::uint32_t n) const {
    const auto faces = static_cast<unsigned>(mesh_.nodes[n].faces);
    int face = 0;
    while (!(faces >> face & 1)) ++face;
    const auto at = on_arc(face, n);
    if (at.arc < 0) return nullptr;
    return &vertices_[static_cast<std::size_t>(face)][static_cast<std::size_t>(at.arc)]
                .vertices[at.index];
  }

  /// Node p, and what is between it and q on a side inside the tetrahedron.
  bool append_side(std::uint32_t p, std::uint32_t q, std::vector<Corner>& corners) {
    if (mesh_.nodes[p].faces == 0) {
      corners.push_back(inner_corner(p));
      return true;
    }
    const auto* from = boundary_vertex(p);
    if (!from) return false;
    corners.push_back(boundary_corner(*from));
    if (mesh_.nodes[q].faces == 0) return true;
    const auto* to = boundary_vertex(q);
    if (!to) return false;
    // Samples of a boundary loop that fell together can put both ends on one face, where the
    // neighbour might mesh the same side: a vertex on it tells them apart.
    if (from->id != to->id && (from->faces & to->faces) != 0) corners.push_back(side_corner(p, q));
    return true;
  }

  /// A vertex inside the triangle of the cell that holds the side between two nodes.
  Corner side_corner(std::uint32_t p, std::uint32_t q) {
    auto& known = sides_[std::minmax(p, q)];
    if (known == 0) {
      const auto& vertices = proved_.subdivision->refinement.vertices();
      const auto &m = mesh_.nodes[p], &n = mesh_.nodes[q];
      const auto tip = m.first == n.first || m.first == n.second ? m.first : m.second;
      const auto &u = vertices[m.first + m.second - tip], &v = vertices[n.first + n.second - tip];
      const auto& w = vertices[tip];
      const auto base = u.tensor + v.tensor;
      const Scalar f = segment_root(base, w.tensor, w.above, level_);
      InnerVertex<Scalar> point;
      point.tensor = base + f * (w.tensor - base);
      for (std::size_t i = 0; i < 4; ++i) {
        const Scalar below = Scalar(u.weights[i]) + Scalar(v.weights[i]);
        point.weights[i] = below + f * (Scalar(w.weights[i]) - below);
      }
      out_.inner.push_back(point);
      known = -static_cast<std::int32_t>(out_.inner.size());
    }
    const auto& point = out_.inner[static_cast<std::size_t>(-1 - known)];
    return {known, {position_at(point.weights, tet_.simplex.exponents, tet_.points), 0}};
  }

  void cut(const SubdivisionMesh::Polygon& polygon, const std::vector<Corner>& corners) {
    std::vector<PolygonCorner> outline;
    for (const auto& c : corners) outline.push_back(c.corner);
    auto triangles = cut_polygon(outline);
    const auto is_upward = [&](const Vector3<double>& a, const Vector3<double>& b,
                               const Vector3<double>& c) { return test_.facing(a, b, c).is_upward; };
    const auto at = [&](int i) { return outline[static_cast<std::size_t>(i)].position; };
    // The other diagonal, or a vertex amid the polygon, where a triangle would be against the
    // gradient.
    const auto are_upward = [&](const std::vector<std::array<int, 3>>& list) {
      return std::all_of(list.begin(), list.end(), [&](const auto& t) {
        return is_upward(at(t[0]), at(t[1]), at(t[2]));
      });
    };
    if (!triangles.empty() && !are_upward(triangles)) {
      if (outline.size() == 4 && !((outline[0].faces & outline[2].faces) != 0 ||
                                   (outline[1].faces & outline[3].faces) != 0)) {
        const bool is_first = triangles[0][0] == 0 && triangles[0][1] == 1 && triangles[0][2] == 2;
        std::vector<std::array<int, 3>> other{{0, 1, 2}, {0, 2, 3}};
        if (is_first || !are_upward(other)) other = {{0, 1, 3}, {1, 2, 3}};
        if (are_upward(other)) triangles = other;
      }
      if (!are_upward(triangles)) {
        const auto middle = middle_of(polygon);
        const auto centre = position_at(middle.weights, tet_.simplex.exponents, tet_.points);
        bool all = true;
        for (std::size_t i = 0; i < outline.size(); ++i)
          all &= is_upward(outline[i].position, outline[(i + 1) % outline.size()].position, centre);
        if (all) triangles.clear();
        if (!all) out_.cells_against.push_back(polygon.cell);
      }
    }
    for (const auto& t : triangles)
      out_.triangles.push_back({corners[static_cast<std::size_t>(t[0])].id,
                                corners[static_cast<std::size_t>(t[1])].id,
                                corners[static_cast<std::size_t>(t[2])].id});
    if (!triangles.empty()) return;
    out_.inner.push_back(middle_of(polygon));
    const auto centre = -static_cast<std::int32_t>(out_.inner.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      out_.triangles.push_back({corners[i].id, corners[(i + 1) % corners.size()].id, centre});
  }

  using Local = std::array<Scalar, 4>;  // homogeneous in a cell

  /// A point of the sheet amid the polygon: on the line of the cell's direction through the
  /// middle of its corners or, should the shadow of the sheet not hold that, between the middle of
  /// the cell's corners above the level and that of those below.
  InnerVertex<Scalar> middle_of(const SubdivisionMesh::Polygon& polygon) const {
    const auto& refinement = proved_.subdivision->refinement;
    const auto& cell = refinement.cells()[polygon.cell];
    Local centre{}, above{}, below{};
    for (std::size_t c = 0; c < 4; ++c) centre[c] = above[c] = below[c] = Scalar(0);
    for (int i = 0; i < polygon.size; ++i) {
      const auto& node = mesh_.nodes[polygon.nodes[static_cast<std::size_t>(i)]];
      const auto &u = refinement.vertices()[node.first], &v = refinement.vertices()[node.second];
      const Scalar f = segment_root(u.tensor, v.tensor, v.above, level_);
      for (std::size_t c = 0; c < 4; ++c) {
        if (cell.vertices[c] == node.first) centre[c] = centre[c] + (Scalar(1) - f);
        if (cell.vertices[c] == node.second) centre[c] = centre[c] + f;
      }
    }
    for (std::size_t c = 0; c < 4; ++c)
      (refinement.vertices()[cell.vertices[c]].above ? above : below)[c] = Scalar(1);
    const auto& d = cell.proof.direction;
    Scalar down(0), up(0);
    bool has_down = false, has_up = false;
    for (std::size_t c = 0; c < 4; ++c) {
      if (d[c] == Scalar(0)) continue;
      const Scalar k = -centre[c] / d[c];
      if (d[c] > Scalar(0) && (!has_down || k > down)) down = k, has_down = true;
      if (d[c] < Scalar(0) && (!has_up || k < up)) up = k, has_up = true;
    }
    if (has_down && has_up) {
      Local lower, upper;
      for (std::size_t c = 0; c < 4; ++c) {
        lower[c] = centre[c] + down * d[c];
        upper[c] = centre[c] + up * d[c];
      }
      if (is_below(cell, lower) && is_above(cell, upper)) return point_between(cell, lower, upper);
    }
    // Each middle lies on the side of its corners: it is a corner, or in a simple edge or face with
    // all corners on one side, which the level does not meet.
    return point_between(cell, below, above);
  }

  using Cell = typename Refinement<Scalar, 4>::Cell;

  Deviator<Scalar> field_at(const Cell& cell, const Local& place) const {
    const auto& vertices = proved_.subdivision->refinement.vertices();
    std::array<Deviator<Scalar>, 4> tensors;
    for (std::size_t c = 0; c < 4; ++c) tensors[c] = vertices[cell.vertices[c]].tensor;
    return tensor_at(tensors, place);
  }
  bool is_below(const Cell& cell, const Local& place) const {
    return level_function(field_at(cell, place), level_) < Scalar(0);
  }
  bool is_above(const Cell& cell, const Local& place) const {
    return level_function(field_at(cell, place), level_) > Scalar(0);
  }

  /// A point of the level between two places in the cell, below and above it.
  InnerVertex<Scalar> point_between(const Cell& cell, const Local& below,
                                    const Local& above) const {
    const auto& vertices = proved_.subdivision->refinement.vertices();
    const auto lower = field_at(cell, below), upper = field_at(cell, above);
    const Scalar f = segment_root(lower, upper, level_);
    InnerVertex<Scalar> point;
    point.tensor = lower + f * (upper - lower);
    for (std::size_t i = 0; i < 4; ++i) {
      point.weights[i] = Scalar(0);
      for (std::size_t c = 0; c < 4; ++c)
        point.weights[i] = point.weights[i] + (below[c] + f * (above[c] - below[c])) *
                                                  Scalar(vertices[cell.vertices[c]].weights[i]);
    }
    return point;
  }

  const CellTopology<Scalar>& proved_;
  const SubdivisionMesh& mesh_;
  std::span<const SampleRequest<Scalar>> requests_;
  const TetWithCurves<Scalar>& tet_;
  const FaceArcVertices& vertices_;
  const Level<Scalar>& level_;
  Patch<Scalar>& out_;
  std::map<std::uint32_t, CrossingKey> crossings_;
  std::vector<std::int32_t> inner_;  ///< corner of a node inside, 0 if not made yet
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int32_t> sides_;  ///< corner on a side
  std::size_t first_inner_, first_triangle_;  ///< how many there were of other sheets
  UpwardTest test_;
};

}  // namespace

template <class Scalar>
bool mesh_from_subdivision(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                           std::span<const SampleRequest<Scalar>> requests,
                           const TetWithCurves<Scalar>& tet, const FaceArcVertices& vertices,
                           const Level<Scalar>& level, Patch<Scalar>& out) {
  SubdivisionTriangles<Scalar> triangles(proved, requests, tet, vertices, level, out);
  for (const auto& polygon : proved.subdivision->mesh.polygons)
    if (polygon.component == sheet.component && !triangles.add(polygon)) return false;
  triangles.drop_unused();
  return true;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                                           \
  template bool mesh_from_subdivision(                                                           \
      const CellTopology<Scalar>&, const SheetTopology&, std::span<const SampleRequest<Scalar>>, \
      const TetWithCurves<Scalar>&, const FaceArcVertices&, const Level<Scalar>&, Patch<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
