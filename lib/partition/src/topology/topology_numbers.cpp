// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/partition/topology_numbers.hpp"

#include <array>
#include <utility>

#include "number_lists.hpp"

namespace tensortopo {

namespace {

using Index = std::int32_t;

class Reader : public ListReader<Index> {
 public:
  Reader(const TopologyNumbers& numbers, const TopologyCounts& counts)
      : ListReader(numbers.integers, "proofs"), numbers_(numbers), counts_(counts) {}

  Index mesh_vertex() { return below(counts_.mesh_vertices); }
  Index tet() { return below(counts_.tets); }
  Index surface_vertex() { return below(counts_.surface_vertices); }
  double weight() {
    if (at_weight_ == numbers_.weights.size()) refuse();
    return numbers_.weights[at_weight_++];
  }
  void require_end() const {
    ListReader::require_end();
    if (at_weight_ != numbers_.weights.size()) refuse();
  }

 private:
  const TopologyNumbers& numbers_;
  const TopologyCounts& counts_;
  std::size_t at_weight_ = 0;
};

}  // namespace

TopologyNumbers numbers_of(const LevelTopology& topology) {
  ListWriter<Index> to;
  std::vector<double> weights;
  const auto number = [&](Index n) { to.number(n); };
  to.list(topology.edges, [&](const LevelTopology::Edge& edge) {
    for (const Index v : edge.vertices) number(v);
    to.list(edge.crossings, [&](const LevelTopology::Crossing& crossing) {
      number(crossing.rising ? 1 : 0), number(crossing.vertex);
      for (const double w : crossing.weights) weights.push_back(w);
    });
  });
  to.list(topology.faces, [&](const LevelTopology::Face& face) {
    for (const Index v : face.vertices) number(v);
    to.list(face.arcs, [&](const auto& arc) { number(arc[0]), number(arc[1]); });
    to.list(face.loops, number);
  });
  to.list(topology.tets, [&](const LevelTopology::Tet& tet) {
    number(tet.tet);
    to.list(tet.sheets, [&](const LevelTopology::Sheet& sheet) {
      number(sheet.euler_characteristic);
      to.list(sheet.loops, [&](const auto& loop) {
        to.list(loop, [&](const auto& arc) { number(arc.from), number(arc.opposite); });
      });
    });
  });
  to.list(topology.cones, [&](const LevelTopology::Cone& cone) {
    number(cone.tet);
    to.list(cone.sheets, [&](const auto& sheet) { to.list(sheet, number); });
  });
  return {std::move(to.made), std::move(weights)};
}

LevelTopology topology_of(const TopologyNumbers& numbers, const TopologyCounts& counts) {
  Reader from(numbers, counts);
  LevelTopology topology;
  const auto surface_vertex = [&] { return from.surface_vertex(); };
  from.list(topology.edges, [&] {
    LevelTopology::Edge edge;
    for (Index& v : edge.vertices) v = from.mesh_vertex();
    from.list(edge.crossings, [&] {
      LevelTopology::Crossing crossing;
      crossing.rising = from.below(2) == 1;
      crossing.vertex = from.surface_vertex();
      for (double& w : crossing.weights) w = from.weight();
      return crossing;
    });
    return edge;
  });
  from.list(topology.faces, [&] {
    LevelTopology::Face face;
    for (Index& v : face.vertices) v = from.mesh_vertex();
    from.list(face.arcs, [&] {
      std::array<Index, 2> arc{};
      for (Index& v : arc) v = from.surface_vertex();
      return arc;
    });
    from.list(face.loops, surface_vertex);
    return face;
  });
  from.list(topology.tets, [&] {
    LevelTopology::Tet tet;
    tet.tet = from.tet();
    from.list(tet.sheets, [&] {
      LevelTopology::Sheet sheet;
      sheet.euler_characteristic = from.number();
      from.list(sheet.loops, [&] {
        std::vector<LevelTopology::BoundaryArc> loop;
        from.list(loop, [&] {
          LevelTopology::BoundaryArc arc;
          arc.from = from.surface_vertex();
          arc.opposite = from.mesh_vertex();
          return arc;
        });
        if (loop.empty()) from.refuse();
        return loop;
      });
      return sheet;
    });
    return tet;
  });
  from.list(topology.cones, [&] {
    LevelTopology::Cone cone;
    cone.tet = from.tet();
    from.list(cone.sheets, [&] {
      LevelTopology::ConeSheet sheet;
      from.list(sheet, surface_vertex);
      if (sheet.size() < 2 || sheet.size() > 4) from.refuse();
      return sheet;
    });
    return cone;
  });
  from.require_end();
  return topology;
}

}  // namespace tensortopo
