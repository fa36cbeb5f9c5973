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
  std::optional<TetBoundary> boundary_of(const std::array<Vertex, 4>& vertices) const;
  static std::optional<std::size_t> curve_of(const Loop& loop, const FaceLevel& face);

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
  edge.level = level_in_edge(level_, corners(edge.vertices));
}

void Derivation::settle(FaceTopology& face) const {
  const auto& [a, b, c] = face.vertices;
  face.level = level_in_face(
      level_, corners(face.vertices),
      {&out_.edge({a, b})->level, &out_.edge({a, c})->level, &out_.edge({b, c})->level});
  for (const auto& [from, to] : face.level.arcs) {
    std::array arc{in_mesh(from, face.vertices), in_mesh(to, face.vertices)};
    std::sort(arc.begin(), arc.end());
    face.arcs.push_back(arc);
  }
  std::sort(face.arcs.begin(), face.arcs.end());
}

/// What is known of the edges and faces, or nothing if one of them is not decided.
std::optional<TetBoundary> Derivation::boundary_of(const std::array<Vertex, 4>& vertices) const {
  TetBoundary result;
  bool decided = true;
  std::size_t n = 0;
  for_subsets(4, 2, [&](const auto& m) {
    const EdgeTopology* edge = out_.edge({vertices[m[0]], vertices[m[1]]});
    result.edges[n++] = &edge->level;
    decided = decided && edge->level.decided;
  });
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceTopology* face = out_.face(face_of(vertices, i));
    result.faces[i] = &face->level;
    decided = decided && face->level.decided;
  }
  return decided ? std::optional(result) : std::nullopt;
}

/// Which of a face's closed curves a loop is: that with the same regions beside it.
std::optional<std::size_t> Derivation::curve_of(const Loop& loop, const FaceLevel& face) {
  if (face.loops.size() == 1) return 0;
  if (face.loops.empty()) return std::nullopt;
  FaceRegions regions(*face.refinement);
  std::set<std::size_t> wanted;
  for (const Loop::Sample& sample : loop.beside) {
    std::array<mpz_class, 3> weights;
    for (std::size_t i = 0, n = 0; i < 4; ++i)
      if ((loop.face >> i & 1U) != 0) weights[n++] = sample.weights[i];
    if (const auto region = regions.find(weights, sample.above)) wanted.insert(*region);
  }
  for (std::size_t i = 0; i < face.loops.size(); ++i) {
    const auto& [a, b] = face.loops[i][0];
    if (wanted == std::set{regions.find(a), regions.find(b)}) return i;
  }
  return std::nullopt;
}

void Derivation::settle(TetTopology& tet) const {
  const std::array<Vertex, 4>& vertices = input_.tets[tet.tet];
  const int turn = orientation(input_, vertices);
  const auto boundary = boundary_of(vertices);
  if (turn == 0 || !boundary) return;
  const auto sheets = level_in_tet(level_, corners(vertices), tet.proved, *boundary);
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
      const auto curve = curve_of(loop, face->level);
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
  std::vector<Proved<4>> proofs(input.tets.size(), Proved<4>{Proof::empty, {}});
  parallel_for(proofs.size(), [&](std::size_t t) {
    if (!left_out[t]) proofs[t] = level.prove<4>(derivation.corners(input.tets[t]));
  });
  std::vector<std::array<Vertex, 2>> edges;
  std::vector<std::array<Vertex, 3>> faces;
  for (std::uint32_t t = 0; t < proofs.size(); ++t) {
    if (proofs[t].proof == Proof::empty) continue;
    TetTopology& tet = out.tets.emplace_back();
    tet.tet = t, tet.proved = proofs[t];
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
