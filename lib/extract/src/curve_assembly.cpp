// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curve_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "curve_vertex.hpp"
#include "narrow.hpp"
#include "parallel_stage.hpp"
#include "tensortopo/extract/position.hpp"

namespace tensortopo {

namespace {

using Index = CurveMesh::Index;

std::size_t as_size(std::int64_t i) { return static_cast<std::size_t>(i); }

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A piece of a curve in a tetrahedron; its ends are numbers of face points.
struct Link {
  std::size_t tet;    ///< of the complex
  std::size_t piece;  ///< of the tetrahedron
  std::array<std::size_t, 2> ends;
};

/// A link in a component, run from its end `from` to the other one.
struct Step {
  std::size_t link;
  std::size_t from;
};

/// The links at the face points: at most two each, as a face has at most two tetrahedra.
class CurveGraph {
 public:
  CurveGraph(const std::vector<Link>& links, std::size_t points)
      : links_(links), at_(points, {kNone, kNone}) {
    for (std::size_t i = 0; i < links.size(); ++i)
      for (const std::size_t end : links[i].ends) at_[end][at_[end][0] == kNone ? 0 : 1] = i;
  }

  const std::array<std::size_t, 2>& at(std::size_t point) const { return at_[point]; }

  /// The connected components, each in order and direction.
  std::vector<std::vector<Step>> components() const {
    std::vector<std::vector<Step>> result;
    std::vector<char> used(links_.size(), 0);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (used[i]) continue;
      auto steps = walk(first_step(i));
      for (const Step& step : steps) used[step.link] = 1;
      result.push_back(std::move(steps));
    }
    return result;
  }

 private:
  /// All steps from this one to an end, or around.
  std::vector<Step> walk(const Step& first) const {
    std::vector<Step> steps{first};
    while (true) {
      const Step last = steps.back();
      const std::size_t point = links_[last.link].ends[1 - last.from];
      const auto& two = at_[point];
      const std::size_t next = two[0] == last.link ? two[1] : two[0];
      if (next == kNone || next == first.link) return steps;
      steps.push_back({next, links_[next].ends[0] == point ? 0u : 1u});
    }
  }

  /// Where the component of a link begins: at the end with the lower number, or if closed at the
  /// lowest of all, towards the lower link.
  Step first_step(std::size_t link) const {
    const auto forward = walk({link, 0}), backward = walk({link, 1});
    const auto reversed = [&](const Step& s) { return Step{s.link, 1 - s.from}; };
    const auto start = [&](const Step& s) { return links_[s.link].ends[s.from]; };
    const Step one = reversed(forward.back()), other = reversed(backward.back());
    const bool closed =
        start(one) == links_[link].ends[0] && forward.size() > 1 && at_[start(one)][1] != kNone;
    if (!closed) return start(one) < start(other) ? one : other;
    Step best = forward[0];
    for (const Step& s : forward)
      if (start(s) < start(best)) best = s;
    const auto& two = at_[start(best)];
    const std::size_t lower = std::min(two[0], two[1]);
    return {lower, links_[lower].ends[0] == start(best) ? 0u : 1u};
  }

  const std::vector<Link>& links_;
  std::vector<std::array<std::size_t, 2>> at_;
};

class CurveAssembler {
 public:
  CurveAssembler(const TetMesh& mesh, const ScaledField<double>& field, const CurveParts& parts)
      : mesh_(mesh), field_(field), parts_(parts), first_point_(parts.faces.size() + 1, 0) {
    for (std::size_t f = 0; f < parts.faces.size(); ++f)
      first_point_[f + 1] = first_point_[f] + parts.faces[f].points.size();
    for (std::size_t t = 0; t < parts.tets.size(); ++t) {
      const auto number = [&](std::size_t i) {
        const auto& key = parts.rims[t][i];
        return first_point_[as_size(key.face)] + key.point;
      };
      const auto& pieces = parts.tets[t].pieces;
      for (std::size_t k = 0; k < pieces.size(); ++k)
        links_.push_back({t, k, {number(pieces[k].begin), number(pieces[k].end)}});
    }
  }

  CurveMesh run(Degeneracy kind, const ExtractOptions& options) {
    const CurveGraph graph(links_, first_point_.back());
    add_face_points(graph);
    add_inner_points();
    const auto components = graph.components();
    for (std::size_t c = 0; c < components.size(); ++c)
      for (const Step& step : components[c]) add_line(step, static_cast<Index>(c));
    describe(graph, kind, options);
    return std::move(curves_);
  }

 private:
  template <class Weights>
  void add_point(const Weights& weights, const Vector3<long double>& dominant,
                 std::span<const Index> vertices, Carrier carrier) {
    constexpr std::size_t count = std::tuple_size_v<Weights>;
    std::array<int, count> exponents;
    std::array<Vector3<double>, count> points;
    for (std::size_t i = 0; i < count; ++i) {
      exponents[i] = field_.exponents[as_size(vertices[i])];
      points[i] = mesh_.points[as_size(vertices[i])];
    }
    curves_.points.push_back(position_at(weights, exponents, points));
    const auto e = narrow(dominant);
    curves_.dominant_eigenvector.push_back((1 / std::sqrt(dot(e, e))) * e);
    std::array<Index, 4> key{-1, -1, -1, -1};
    std::copy(vertices.begin(), vertices.end(), key.begin());
    std::sort(key.begin(), key.begin() + count);
    curves_.carrier_vertices.push_back(key);
    curves_.carrier.push_back(carrier);
  }

  void add_face_points(const CurveGraph& graph) {
    vertex_.assign(first_point_.back(), -1);
    for (std::size_t f = 0; f < parts_.faces.size(); ++f)
      for (std::size_t k = 0; k < parts_.faces[f].points.size(); ++k) {
        const std::size_t number = first_point_[f] + k;
        if (graph.at(number)[0] == kNone) continue;
        vertex_[number] = static_cast<Index>(curves_.points.size());
        used_.push_back(number);
        const auto& point = parts_.faces[f].points[k];
        add_point(point.weights, point.dominant, parts_.complex.faces[f], Carrier::face);
      }
  }

  void add_inner_points() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      first_inner_.push_back(static_cast<Index>(curves_.points.size()));
      const auto& link = links_[i];
      for (const auto& sample : parts_.tets[link.tet].pieces[link.piece].inner) {
        add_point(sample.weights, sample.dominant,
                  mesh_.tets[as_size(parts_.complex.tets[link.tet])], Carrier::tet);
        inner_link_.push_back(i);
      }
    }
  }

  void add_line(const Step& step, Index component) {
    const auto& link = links_[step.link];
    const std::size_t inner = parts_.tets[link.tet].pieces[link.piece].inner.size();
    std::vector<Index> line{vertex_[link.ends[0]]};
    for (std::size_t k = 0; k < inner; ++k)
      line.push_back(first_inner_[step.link] + static_cast<Index>(k));
    line.push_back(vertex_[link.ends[1]]);
    if (step.from == 1) std::reverse(line.begin(), line.end());
    curves_.lines.push_back(std::move(line));
    curves_.tet.push_back(parts_.complex.tets[link.tet]);
    curves_.component.push_back(component);
  }

  /// What the field says at each vertex; in a face, the mean over the tetrahedra whose lines end
  /// there.
  void describe(const CurveGraph& graph, Degeneracy kind, const ExtractOptions& options) {
    const std::size_t count = curves_.points.size();
    curves_.mode.assign(count, kind == Degeneracy::linear ? 1 : -1);
    curves_.separation.assign(count, 0);
    curves_.residual.assign(count, 0);
    parallel_stage(options, "stitch", count, 256, [&](std::size_t v) {
      std::array<std::size_t, 2> at{kNone, kNone};
      if (v < used_.size())
        at = graph.at(used_[v]);
      else
        at[0] = inner_link_[v - used_.size()];
      double sum = 0;
      int tets = 0;
      for (const std::size_t link : at) {
        if (link == kNone) continue;
        const FieldInSpace space(field_, as_size(parts_.complex.tets[links_[link].tet]));
        sum += space.separation(curves_.points[v], curves_.dominant_eigenvector[v]);
        if (tets == 0) curves_.residual[v] = space.distance_from_degenerate(curves_.points[v]);
        ++tets;
      }
      curves_.separation[v] = sum / tets;
    });
  }

  const TetMesh& mesh_;
  const ScaledField<double>& field_;
  const CurveParts& parts_;
  std::vector<std::size_t> first_point_;  ///< number of the first point of each face
  std::vector<Link> links_;
  CurveMesh curves_;
  std::vector<Index> vertex_;            ///< of each face point
  std::vector<std::size_t> used_;        ///< the face points that are vertices, in order
  std::vector<Index> first_inner_;       ///< of each link
  std::vector<std::size_t> inner_link_;  ///< of each vertex inside a tetrahedron
};

}  // namespace

CurveMesh assemble_curves(const TetMesh& mesh, const ScaledField<double>& field, Degeneracy kind,
                          const CurveParts& parts, const ExtractOptions& options) {
  return CurveAssembler(mesh, field, parts).run(kind, options);
}

}  // namespace tensortopo
