// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/curve_assembly.hpp"

#include <algorithm>

#include "extract/curves/curve_graph.hpp"
#include "extract/curves/curve_vertex.hpp"
#include "extract/level/position.hpp"
#include "extract/run/parallel_stage.hpp"
#include "tensortopo/scalar/extended.hpp"

namespace tensortopo {

namespace {

using Index = CurveMesh::Index;

std::size_t count_of(const SimplexVertices& vertices) {
  return as_size(std::find(vertices.begin(), vertices.end(), -1) - vertices.begin());
}

SimplexVertices in_order(SimplexVertices vertices) {
  const auto before = [](Index u, Index v) { return u >= 0 && (v < 0 || u < v); };
  std::sort(vertices.begin(), vertices.end(), before);
  return vertices;
}

class CurveAssembler {
 public:
  CurveAssembler(const TetMesh& mesh, const ScaledField<double>& field,
                 const std::vector<CurvePlace>& places, const std::vector<CurveLink>& links)
      : mesh_(mesh), field_(field), places_(places), links_(links), graph_(links, places.size()) {}

  AssembledCurves run(Degeneracy kind, const ExtractOptions& options) {
    add_places();
    add_inner_points();
    const auto components = graph_.components();
    for (std::size_t c = 0; c < components.size(); ++c)
      for (const CurveStep& step : components[c]) add_line(step, static_cast<Index>(c));
    describe(kind, options);
    return {std::move(curves_), std::move(used_), std::move(inner_link_), std::move(steps_)};
  }

 private:
  template <std::size_t Count>
  Vector3<double> position(const std::array<Extended, 4>& weights,
                           const SimplexVertices& vertices) const {
    std::array<Extended, Count> w;
    std::array<int, Count> exponents;
    std::array<Vector3<double>, Count> points;
    for (std::size_t i = 0; i < Count; ++i) {
      w[i] = weights[i];
      exponents[i] = field_.exponents[as_size(vertices[i])];
      points[i] = mesh_.points[as_size(vertices[i])];
    }
    return position_at(w, exponents, points);
  }

  void add_point(const std::array<Extended, 4>& weights, const Vector3<Extended>& dominant,
                 const SimplexVertices& vertices) {
    constexpr std::array<Carrier, 4> carriers{Carrier::vertex, Carrier::edge, Carrier::face,
                                              Carrier::tet};
    const std::size_t count = count_of(vertices);
    curves_.points.push_back(count == 1   ? mesh_.points[as_size(vertices[0])]
                             : count == 2 ? position<2>(weights, vertices)
                             : count == 3 ? position<3>(weights, vertices)
                                          : position<4>(weights, vertices));
    curves_.dominant_eigenvector.push_back(unit_or_zero(vector_cast<double>(dominant)));
    curves_.carrier_vertices.push_back(in_order(vertices));
    curves_.carrier.push_back(carriers[count - 1]);
  }

  void add_places() {
    vertex_.assign(places_.size(), -1);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      if (graph_.at(p).empty()) continue;
      vertex_[p] = static_cast<Index>(curves_.points.size());
      used_.push_back(p);
      add_point(places_[p].weights, places_[p].dominant, places_[p].vertices);
    }
  }

  void add_inner_points() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      first_inner_.push_back(static_cast<Index>(curves_.points.size()));
      for (const auto& sample : links_[i].inner) {
        add_point(sample.weights, sample.dominant, links_[i].vertices);
        inner_link_.push_back(i);
      }
    }
  }

  void add_line(const CurveStep& step, Index component) {
    const auto& link = links_[step.link];
    std::vector<Index> line{vertex_[link.ends[0]]};
    for (std::size_t k = 0; k < link.inner.size(); ++k)
      line.push_back(first_inner_[step.link] + static_cast<Index>(k));
    line.push_back(vertex_[link.ends[1]]);
    if (step.from == 1) std::reverse(line.begin(), line.end());
    curves_.lines.push_back(std::move(line));
    curves_.tet.push_back(link.tet);
    curves_.component.push_back(component);
    steps_.push_back(step);
  }

  /// What the field says at each vertex; where lines meet, the mean over their tetrahedra.
  void describe(Degeneracy kind, const ExtractOptions& options) {
    const std::size_t count = curves_.points.size();
    curves_.mode.assign(count, kind == Degeneracy::linear ? 1 : -1);
    curves_.separation.assign(count, 0);
    curves_.residual.assign(count, 0);
    parallel_stage(options, "stitch", count, 256, [&](std::size_t v) {
      const auto& e = curves_.dominant_eigenvector[v];
      if (dot(e, e) == 0) return;
      std::span<const std::size_t> at;
      if (v < used_.size())
        at = graph_.at(used_[v]);
      else
        at = std::span(inner_link_).subspan(v - used_.size(), 1);
      double sum = 0;
      int tets = 0;
      for (const std::size_t link : at) {
        const FieldInSpace space(field_, as_size(links_[link].tet));
        sum += space.separation(curves_.points[v], e);
        if (tets == 0) curves_.residual[v] = space.distance_from_degenerate(curves_.points[v]);
        ++tets;
      }
      curves_.separation[v] = sum / tets;
    });
  }

  const TetMesh& mesh_;
  const ScaledField<double>& field_;
  const std::vector<CurvePlace>& places_;
  const std::vector<CurveLink>& links_;
  CurveGraph graph_;
  CurveMesh curves_;
  std::vector<Index> vertex_;            ///< of each place
  std::vector<std::size_t> used_;        ///< the places that are vertices, in order
  std::vector<Index> first_inner_;       ///< of each link
  std::vector<std::size_t> inner_link_;  ///< of each vertex between places
  std::vector<CurveStep> steps_;         ///< of each line
};

}  // namespace

AssembledCurves assemble_curves(const TetMesh& mesh, const ScaledField<double>& field,
                                Degeneracy kind, const std::vector<CurvePlace>& places,
                                const std::vector<CurveLink>& links,
                                const ExtractOptions& options) {
  return CurveAssembler(mesh, field, places, links).run(kind, options);
}

}  // namespace tensortopo
