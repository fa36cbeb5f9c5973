// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology.hpp"

#include <algorithm>
#include <bit>

#include "parallel.hpp"
#include "regions.hpp"

namespace certificate {
namespace {

template <class Simplices, class Vertices>
auto* find_in(Simplices& simplices, const Vertices& vertices) {
  const auto place =
      std::lower_bound(simplices.begin(), simplices.end(), vertices,
                       [](const auto& s, const Vertices& v) { return s.vertices < v; });
  return place != simplices.end() && place->vertices == vertices ? &*place : nullptr;
}

/// One entry for each of these simplices, in ascending order.
template <class Simplex, class Vertices>
std::vector<Simplex> listed(std::vector<Vertices> all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<Simplex> result(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) result[i].vertices = all[i];
  return result;
}

class Derivation {
 public:
  Derivation(const Input& input, const Field& field, const Level& level, Topology& out)
      : input_(input), field_(field), level_(level), out_(out) {}

  template <std::size_t Count>
  std::array<Corner, Count> corners(const std::array<Vertex, Count>& vertices) const {
    std::array<Corner, Count> result;
    for (std::size_t i = 0; i < Count; ++i)
      result[i] = field_.corner(vertices[i], out_.above[vertices[i]]);
    return result;
  }
  void settle(EdgeTopology& edge) const;
  void settle(FaceTopology& face) const;
  void settle(TetTopology& tet) const;

 private:
  bool know_faces_and_edges(Refinement& refinement, std::span<const Vertex> vertices) const;
  bool same_counts(const Refinement& refinement, std::span<const Vertex> vertices) const;
  std::optional<std::size_t> curve_of(const Refinement& refinement, const CrossedEdge& sample,
                                      unsigned bits, const FaceTopology& face) const;

  const Input& input_;
  const Field& field_;
  const Level& level_;
  Topology& out_;
};

MeshCrossing in_mesh(const Crossing& c, std::span<const Vertex> vertices) {
  return {{vertices[static_cast<std::size_t>(std::countr_zero(c.edge))],
           vertices[static_cast<std::size_t>(std::bit_width(c.edge) - 1)]},
          c.ordinal};
}

void Derivation::settle(EdgeTopology& edge) const {
  edge.proof = level_.prove<2>(corners(edge.vertices));
  Refinement refinement(level_, corners(edge.vertices));
  refinement.assume(std::array<Refinement::Id, 2>{0, 1}, edge.proof);
  edge.decided = refinement.run();
  if (edge.decided) edge.crossings = Crossings(refinement).count(3);
}

/// Tells the refinement what is proved of edges and faces of the mesh as a whole. False if one of
/// them is not decided.
bool Derivation::know_faces_and_edges(Refinement& refinement,
                                      std::span<const Vertex> vertices) const {
  bool decided = true;
  const auto know = [&](const auto* simplex, std::span<const Refinement::Id> ids) {
    decided = decided && simplex != nullptr && simplex->decided;
    if (decided) refinement.assume(ids, simplex->proof);
  };
  for_subsets(vertices.size(), 2, [&](const auto& m) {
    const std::array ids{static_cast<Refinement::Id>(m[0]), static_cast<Refinement::Id>(m[1])};
    know(out_.edge({vertices[m[0]], vertices[m[1]]}), ids);
  });
  if (vertices.size() < 4) return decided;
  for_subsets(4, 3, [&](const auto& m) {
    const std::array ids{static_cast<Refinement::Id>(m[0]), static_cast<Refinement::Id>(m[1]),
                         static_cast<Refinement::Id>(m[2])};
    know(out_.face({vertices[m[0]], vertices[m[1]], vertices[m[2]]}), ids);
  });
  return decided;
}

/// Each refinement proves the crossings of the edges for itself; a difference is a mistake here.
bool Derivation::same_counts(const Refinement& refinement,
                             std::span<const Vertex> vertices) const {
  const Crossings crossings(refinement);
  bool same = true;
  for_subsets(vertices.size(), 2, [&](const auto& m) {
    same = same && crossings.count(1U << m[0] | 1U << m[1]) ==
                       out_.edge({vertices[m[0]], vertices[m[1]]})->crossings;
  });
  return same;
}

void Derivation::settle(FaceTopology& face) const {
  face.proof = level_.prove<3>(corners(face.vertices));
  auto refinement = std::make_unique<Refinement>(level_, corners(face.vertices));
  if (!know_faces_and_edges(*refinement, face.vertices)) return;
  refinement->assume(std::array<Refinement::Id, 3>{0, 1, 2}, face.proof);
  if (!refinement->run() || !same_counts(*refinement, face.vertices)) return;
  FaceCurves curves = trace_face(*refinement);
  for (const auto& [a, b] : curves.arcs) {
    std::array arc{in_mesh(a, face.vertices), in_mesh(b, face.vertices)};
    std::sort(arc.begin(), arc.end());
    face.arcs.push_back(arc);
  }
  std::sort(face.arcs.begin(), face.arcs.end());
  face.loops = curves.loops.size();
  face.loop_points = std::move(curves.loops);
  if (face.loops > 1) face.refinement = std::move(refinement);
  face.decided = true;
}

/// Which of a face's closed curves goes through a point: that with the same regions beside it.
std::optional<std::size_t> Derivation::curve_of(const Refinement& refinement,
                                                const CrossedEdge& sample, unsigned bits,
                                                const FaceTopology& face) const {
  if (face.loops == 1) return 0;
  FaceRegions regions(refinement, bits);
  std::set<std::size_t> wanted{regions.find(sample[0]), regions.find(sample[1])};
  for (std::size_t i = 0; i < face.loops; ++i) {
    std::set<std::size_t> beside;
    for (const Refinement::Id id : face.loop_points[i][0]) {
      const Refinement::Point& point = face.refinement->points()[id];
      if (const auto region = regions.find(weights_in(point, 7), point.above))
        beside.insert(*region);
    }
    if (beside == wanted) return i;
  }
  return std::nullopt;
}

void Derivation::settle(TetTopology& tet) const {
  const std::array<Vertex, 4>& vertices = input_.tets[tet.tet];
  Refinement refinement(level_, corners(vertices));
  const int turn = orientation(input_, vertices);
  if (turn == 0 || !know_faces_and_edges(refinement, vertices)) return;
  refinement.assume(std::array<Refinement::Id, 4>{0, 1, 2, 3}, tet.proof);
  if (!refinement.run() || !same_counts(refinement, vertices)) return;
  const auto sheets = trace_tet(refinement);
  if (!sheets) return;
  const auto opposite = [&](unsigned face) {
    return static_cast<std::size_t>(std::countr_zero(15U & ~face));
  };
  for (const Sheet& sheet : *sheets) {
    MeshSheet& found = tet.sheets.emplace_back();
    found.euler_characteristic = sheet.euler_characteristic;
    for (const Loop& loop : sheet.loops) {
      MeshLoop& in_tet = found.loops.emplace_back();
      in_tet.opposite = vertices[opposite(loop.face)];
      for (const Loop::Step& step : loop.steps)
        in_tet.steps.push_back({in_mesh(step.from, vertices), vertices[opposite(step.face)]});
      if (turn < 0) {  // backwards: the face before a crossing is then the one after it
        auto& steps = in_tet.steps;
        std::reverse(steps.begin(), steps.end());
        for (std::size_t i = 0; i + 1 < steps.size(); ++i)
          std::swap(steps[i].opposite, steps[i + 1].opposite);
      }
      if (!in_tet.steps.empty()) continue;
      const FaceTopology* face = out_.face(face_of(vertices, opposite(loop.face)));
      const auto curve = curve_of(refinement, loop.sample, loop.face, *face);
      if (!curve) return;
      in_tet.curve = *curve;
    }
  }
  tet.decided = true;
}

}  // namespace

const EdgeTopology* Topology::edge(const std::array<Vertex, 2>& vertices) const {
  return find_in(edges, vertices);
}
const FaceTopology* Topology::face(const std::array<Vertex, 3>& vertices) const {
  return find_in(faces, vertices);
}

int orientation(const Input& input, const std::array<Vertex, 4>& tet) {
  const auto determinant = [&]<class N>(const auto& number) {
    std::array<std::array<N, 3>, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        d[i][k] = number(input.points[tet[i + 1]][k]) - number(input.points[tet[0]][k]);
    const auto minor = [&](std::size_t a, std::size_t b) {
      return N(d[1][a] * d[2][b] - d[1][b] * d[2][a]);
    };
    return N(d[0][0] * minor(1, 2) - d[0][1] * minor(0, 2) + d[0][2] * minor(0, 1));
  };
  const Ball ball = determinant.operator()<Ball>([](double x) { return Ball(x, 0); });
  if (std::abs(ball.value) > ball.error) return ball.value > 0 ? 1 : -1;
  return sgn(determinant.operator()<mpq_class>([](double x) { return mpq_class(x); }));
}

Topology derive_topology(const Input& input, const Field& field, const Level& level,
                         const std::vector<bool>& left_out) {
  Topology out;
  std::vector<char> above(input.points.size());
  std::atomic<std::size_t> on_level{0};
  parallel_for(above.size(), [&](std::size_t v) {
    const Corner corner = field.corner(static_cast<Vertex>(v), false);
    above[v] = level.above(corner);
    if (level.on_level(corner)) ++on_level;
  });
  out.above.assign(above.begin(), above.end());
  out.on_level = on_level;

  const Derivation derivation(input, field, level, out);
  std::vector<Proof> proofs(input.tets.size(), Proof::empty);
  parallel_for(proofs.size(), [&](std::size_t t) {
    if (!left_out[t]) proofs[t] = level.prove<4>(derivation.corners(input.tets[t]));
  });
  std::vector<std::array<Vertex, 2>> edges;
  std::vector<std::array<Vertex, 3>> faces;
  for (std::uint32_t t = 0; t < proofs.size(); ++t) {
    if (proofs[t] == Proof::empty) continue;
    TetTopology& tet = out.tets.emplace_back();
    tet.tet = t, tet.proof = proofs[t];
    const std::array<Vertex, 4>& v = input.tets[t];
    for_subsets(4, 2, [&](const auto& m) { edges.push_back({v[m[0]], v[m[1]]}); });
    for (std::size_t i = 0; i < 4; ++i) faces.push_back(face_of(v, i));
  }
  out.edges = listed<EdgeTopology>(std::move(edges));
  out.faces = listed<FaceTopology>(std::move(faces));
  const auto settle_all = [&](auto& items) {
    parallel_for(items.size(), [&](std::size_t i) { derivation.settle(items[i]); });
  };
  settle_all(out.edges);
  settle_all(out.faces);
  settle_all(out.tets);
  return out;
}

}  // namespace certificate
