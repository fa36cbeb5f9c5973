// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "topology.hpp"

#include <algorithm>
#include <atomic>
#include <map>

namespace certificate {
namespace {

/// The item of an ascending list of which a member has this value; or null.
auto* find_in(auto& items, const auto& value, auto member) {
  const auto place = std::lower_bound(items.begin(), items.end(), value,
                                      [&](const auto& x, const auto& v) { return x.*member < v; });
  return place != items.end() && (*place).*member == value ? &*place : nullptr;
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
      : reaches(input.points.size()), input_(input), field_(field), level_(level), out_(out) {}

  template <std::size_t Count>
  std::array<Corner, Count> corners(const std::array<Vertex, Count>& vertices) const {
    std::array<Corner, Count> result;
    for (std::size_t i = 0; i < Count; ++i) {
      result[i] = field_.corner(vertices[i], out_.above[vertices[i]] != 0);
      result[i].reach = reaches[vertices[i]];
    }
    return result;
  }
  std::vector<double> reaches;  ///< of the vertices
  void settle(EdgeTopology& edge) const;
  void settle(FaceTopology& face) const;
  void settle(TetTopology& tet) const;
  void settle(ConeTopology& cone) const;

 private:
  bool trace_rim(const std::array<Vertex, 4>& tet, int turn, std::vector<MeshLoop>& loops,
                 std::vector<RimCurve>& curves) const;

  const Input& input_;
  const Field& field_;
  const Level& level_;
  Topology& out_;
};

void Derivation::settle(EdgeTopology& edge) const {
  edge.level = level_in_edge(level_, corners(edge.vertices));
}

void Derivation::settle(FaceTopology& face) const {
  const auto& [a, b, c] = face.vertices;
  face.level = level_in_face(
      level_, corners(face.vertices),
      {&out_.edge({a, b})->level, &out_.edge({a, c})->level, &out_.edge({b, c})->level});
  if (face.level.loops.empty()) face.level.refinement.reset();
  const auto in_mesh = [&](const Crossing& x) {
    return MeshCrossing{{face.vertices[x.edge[0]], face.vertices[x.edge[1]]}, x.ordinal};
  };
  for (const auto& [from, to] : face.level.arcs) face.arcs.push_back({in_mesh(from), in_mesh(to)});
}

/// The closed curves on the boundary of a tetrahedron: from outside larger modes are to the left.
bool Derivation::trace_rim(const std::array<Vertex, 4>& tet, int turn,
                           std::vector<MeshLoop>& loops, std::vector<RimCurve>& curves) const {
  std::map<MeshCrossing, std::pair<MeshCrossing, Vertex>> next;
  for (std::size_t i = 0; i < 4; ++i) {
    const FaceTopology& face = *out_.face(without(tet, i));
    for (auto [from, to] : face.arcs) {
      if ((i % 2 == 1) != (turn < 0)) std::swap(from, to);
      if (!next.try_emplace(from, to, tet[i]).second) return false;
    }
    for (std::size_t n = 0; n < face.level.loops.size(); ++n) {
      loops.push_back({{}, tet[i], n});
      curves.push_back({15U & ~(1U << i), n});
    }
  }
  while (!next.empty()) {
    const MeshCrossing first = next.begin()->first;
    MeshLoop& loop = loops.emplace_back();
    MeshCrossing at = first;
    while (const auto step = next.extract(at)) {
      loop.steps.push_back({at, step.mapped().second});
      at = step.mapped().first;
    }
    if (at != first) return false;
    unsigned edge = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (tet[i] == first.edge[0] || tet[i] == first.edge[1]) edge |= 1U << i;
    curves.push_back({edge, first.ordinal});
  }
  return true;
}

void Derivation::settle(TetTopology& tet) const {
  const std::array<Vertex, 4>& vertices = input_.tets[tet.tet];
  const int turn = orientation(input_, vertices);
  TetBoundary boundary;
  bool decided = turn != 0;
  std::size_t n = 0;
  for_subsets(4, 2, [&](const auto& m) {
    boundary.edges[n++] = &out_.edge({vertices[m[0]], vertices[m[1]]})->level;
  });
  for (std::size_t i = 0; i < 4; ++i) boundary.faces[i] = &out_.face(without(vertices, i))->level;
  for (const EdgeLevel* edge : boundary.edges) decided = decided && edge->decided;
  for (const FaceLevel* face : boundary.faces) decided = decided && face->decided;
  std::vector<MeshLoop> loops;
  std::vector<RimCurve> curves;
  if (!decided || !trace_rim(vertices, turn, loops, curves)) return;
  const auto sheets = level_in_tet(level_, corners(vertices), tet.proved, boundary, curves);
  if (!sheets) return;
  for (const Sheet& sheet : *sheets) {
    MeshSheet& found = tet.sheets.emplace_back(
        MeshSheet{sheet.euler_characteristic, {}, sheet.above_inside});
    for (const std::size_t i : sheet.loops) found.loops.push_back(loops[i]);
  }
  tet.decided = true;
}

/// On each ray from a tip the mode is that of the face or edge opposite.
void Derivation::settle(ConeTopology& cone) const {
  const std::array<Vertex, 4>& vertices = input_.tets[cone.tet];
  const int turn = orientation(input_, vertices);
  if (cone.tips.size() == 1) {
    const FaceTopology& face = *out_.face({cone.base[0], cone.base[1], cone.base[2]});
    const auto place = std::find(vertices.begin(), vertices.end(), cone.tips[0]) - vertices.begin();
    cone.decided = turn != 0 && face.is_decided();
    for (auto [from, to] : face.arcs) {
      if ((place % 2 == 1) != (turn < 0)) std::swap(from, to);
      cone.sheets.push_back({{from, to}, cone.tips, 0});
    }
    for (std::size_t n = 0; n < face.level.loops.size(); ++n)
      cone.sheets.push_back({{}, cone.tips, n});
    return;
  }
  const EdgeTopology& edge = *out_.edge({cone.base[0], cone.base[1]});
  cone.decided = turn != 0 && edge.is_decided();
  // Tips and then the edge's second end turn like the mesh's vertices, or not.
  const std::array order{cone.base[0], cone.tips[0], cone.tips[1], cone.base[1]};
  int side = turn;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (order[i] > order[j]) side = -side;
  for (unsigned k = 0; k < edge.level.crossings; ++k) {
    ConeSheet& sheet = cone.sheets.emplace_back(ConeSheet{{{edge.vertices, k}}, cone.tips, 0});
    const bool rises = out_.above[cone.base[0]] != (k % 2 == 0);
    if (rises != (side > 0)) std::swap(sheet.tips[0], sheet.tips[1]);
  }
}

}  // namespace

const TetTopology* Topology::tet(std::size_t t) const { return find_in(tets, t, &TetTopology::tet); }
const ConeTopology* Topology::cone(std::size_t t) const {
  return find_in(cones, t, &ConeTopology::tet);
}
const EdgeTopology* Topology::edge(const std::array<Vertex, 2>& vertices) const {
  return find_in(edges, vertices, &EdgeTopology::vertices);
}
const FaceTopology* Topology::face(const std::array<Vertex, 3>& vertices) const {
  return find_in(faces, vertices, &FaceTopology::vertices);
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
                         const std::vector<bool>& left_out, const ForAll& for_all,
                         const ForAll& for_some) {
  Topology out;
  out.above.resize(input.points.size());
  Derivation derivation(input, field, level, out);
  std::atomic<std::size_t> on_level{0};
  for_all(out.above.size(), [&](std::size_t v) {
    const Corner corner = field.corner(static_cast<Vertex>(v), false);
    out.above[v] = level.above(corner) ? 1 : 0;
    derivation.reaches[v] = level.reach(corner);
    if (!field.is_zero(static_cast<Vertex>(v)) && level.on_level(corner)) ++on_level;
  }, "sides of vertices");
  out.on_level = on_level;

  std::vector<Proved<4>> proofs(input.tets.size(), Proved<4>{Proof::empty, {}});
  const auto is_tip = [&](Vertex i) { return field.is_zero(i); };
  for_all(proofs.size(), [&](std::size_t t) {
    const auto& v = input.tets[t];
    if (!left_out[t] && std::none_of(v.begin(), v.end(), is_tip))
      proofs[t] = level.prove<4>(derivation.corners(v));
  }, "where the level is");
  std::vector<std::array<Vertex, 2>> edges;
  std::vector<std::array<Vertex, 3>> faces;
  for (std::uint32_t t = 0; t < proofs.size(); ++t) {
    const auto& corners = input.tets[t];
    const auto tips = std::count_if(corners.begin(), corners.end(), is_tip);
    if (!left_out[t] && (tips == 1 || tips == 2)) {
      ConeTopology cone{t, false, {}, {}, {}};
      for (const Vertex v : corners) (is_tip(v) ? cone.tips : cone.base).push_back(v);
      const std::vector<Vertex>& b = cone.base;
      for_subsets(b.size(), 2, [&](const auto& m) { edges.push_back({b[m[0]], b[m[1]]}); });
      if (b.size() == 3) faces.push_back({b[0], b[1], b[2]});
      out.cones.push_back(std::move(cone));
    }
    if (proofs[t].proof == Proof::empty) continue;
    out.tets.push_back({t, false, proofs[t], {}});
    for_subsets(4, 2, [&](const auto& m) { edges.push_back({corners[m[0]], corners[m[1]]}); });
    for (std::size_t i = 0; i < 4; ++i) faces.push_back(without(corners, i));
  }
  out.edges = listed<EdgeTopology>(std::move(edges));
  out.faces = listed<FaceTopology>(std::move(faces));
  const auto settle_all = [&](auto& items, const char* what) {
    for_some(items.size(), [&](std::size_t i) { derivation.settle(items[i]); }, what);
  };
  settle_all(out.edges, "edges");
  settle_all(out.faces, "faces");
  settle_all(out.tets, "tetrahedra");
  settle_all(out.cones, "cones");
  return out;
}

}  // namespace certificate
