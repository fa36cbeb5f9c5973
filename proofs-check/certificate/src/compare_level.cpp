// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_level.hpp"

#include <algorithm>
#include <cmath>

#include "curve_names.hpp"

namespace certificate {
namespace {

template <std::size_t Count>
bool in_mesh(const std::array<Number, Count>& numbers, const Input& input,
             std::array<Vertex, Count>& vertices) {
  for (std::size_t i = 0; i < Count; ++i) {
    if (numbers[i] >= input.points.size()) return false;
    vertices[i] = static_cast<Vertex>(numbers[i]);
  }
  return true;
}

/// Is the field above at the point i / 2^k of an edge? All weights are of the input's tensors.
bool above_at(const LevelCase& c, const std::array<Vertex, 2>& edge, const mpz_class& i,
              unsigned k) {
  const Tensor<mpz_class> a = c.field.exact(edge[0]), b = c.field.exact(edge[1]);
  const long ea = c.field.exponent(edge[0]), eb = c.field.exponent(edge[1]);
  const long low = std::min(ea, eb);
  Tensor<mpz_class> sum;
  for (std::size_t n = 0; n < 6; ++n) {
    sum[n] = (mpz_class(((mpz_class(1) << k) - i) * a[n]) << static_cast<unsigned long>(ea - low)) +
             (mpz_class(i * b[n]) << static_cast<unsigned long>(eb - low));
  }
  long shift = 0;
  const Tensor<Ball> ball = enclosure(sum, shift);
  return c.level.above(ball, sum);
}

/// What is wrong with the intervals around an edge's crossings, if anything. As many intervals as
/// crossings, without common inner points, and an odd number of crossings in each: so one.
std::string wrong_interval(const LevelCase& c, const EdgeClaim& claim,
                           const std::array<Vertex, 2>& edge) {
  const CrossingClaim* before = nullptr;
  for (const CrossingClaim& x : claim.crossings) {
    if (before != nullptr && mpz_class((before->i + 1) << x.k) > mpz_class(x.i << before->k))
      return "intervals that overlap at " + x.i.get_str();
    if (above_at(c, edge, x.i, x.k) == above_at(c, edge, x.i + 1, x.k))
      return "both ends of interval " + x.i.get_str() + " on one side";
    before = &x;
  }
  return {};
}

/// The claimed loops of a sheet as they are named in the certificate, in its order.
using NamedSheet = std::pair<std::int64_t, std::vector<std::vector<Number>>>;

std::vector<Number> named(const MeshLoop& loop, const CrossingVertices& vertices,
                          const std::vector<Number>& curves) {
  if (loop.steps.empty()) return {curves.at(loop.curve), loop.opposite};
  std::vector<std::array<Number, 2>> steps;
  for (const MeshLoop::Step& step : loop.steps)
    steps.push_back({vertices.vertex.at(step.from), step.opposite});
  std::rotate(steps.begin(), std::min_element(steps.begin(), steps.end()), steps.end());
  std::vector<Number> numbers;
  for (const auto& step : steps) numbers.insert(numbers.end(), step.begin(), step.end());
  return numbers;
}

std::string text_of(const std::vector<NamedSheet>& sheets) {
  std::string result;
  for (const auto& [chi, loops] : sheets)
    result += (result.empty() ? "[" : ", [") + std::to_string(chi) + ", " + text(loops) + "]";
  return result.empty() ? "no sheet" : result;
}

}  // namespace

CrossingVertices compare_edges(const LevelCase& c, Ledger& ledger) {
  CrossingVertices result;
  std::set<std::array<Vertex, 2>> listed;
  for (const EdgeClaim& claim : c.claims.edges) {
    const std::string name = "edge " + text(claim.edge);
    const std::string count = std::to_string(claim.crossings.size()) + " crossings";
    std::array<Vertex, 2> edge;
    const EdgeTopology* truth =
        in_mesh(claim.edge, c.input, edge) ? c.topology.edge(edge) : nullptr;
    if (truth == nullptr) {
      ledger.refute(name, count, "none, or no edge");
      continue;
    }
    listed.insert(edge);
    if (!truth->level.decided) {
      ledger.leave_open(name, "no proof closes");
      continue;
    }
    if (truth->level.crossings != claim.crossings.size()) {
      ledger.refute(name, count, std::to_string(truth->level.crossings));
      continue;
    }
    std::string wrong = wrong_interval(c, claim, edge);
    for (unsigned i = 0; i < claim.crossings.size(); ++i) {
      const Number v = claim.crossings[i].vertex;
      if (v - c.claims.vertices[0] >= c.claims.vertices[1])
        wrong = "vertex " + std::to_string(v) + " is of another level";
      if (!result.crossing.emplace(v, MeshCrossing{edge, i}).second)
        wrong = "vertex " + std::to_string(v) + " is at two crossings";
      result.vertex[{edge, i}] = v;
    }
    ledger.settle(wrong.empty(), name, count, wrong);
  }
  bool complete = true;
  for (const EdgeTopology& edge : c.topology.edges) {
    if ((edge.level.decided && edge.level.crossings == 0) || listed.contains(edge.vertices))
      continue;
    complete = false;
    if (edge.level.decided)
      ledger.refute("edge " + text(edge.vertices), "not listed",
                    std::to_string(edge.level.crossings) + " crossings");
    else
      ledger.leave_open("edge " + text(edge.vertices), "no proof closes");
  }
  if (complete) ledger.certify();  // edges that are not listed have none
  return result;
}

void compare_faces(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  std::set<std::array<Vertex, 3>> listed;
  for (const FaceClaim& claim : c.claims.faces) {
    const std::string name = "face " + text(claim.face);
    std::array<Vertex, 3> face;
    const FaceTopology* truth =
        in_mesh(claim.face, c.input, face) ? c.topology.face(face) : nullptr;
    const std::string claimed =
        text(claim.arcs) + " and " + std::to_string(claim.loops.size()) + " closed";
    if (truth == nullptr) {
      ledger.refute(name, claimed, "no curves, or no face");
      continue;
    }
    listed.insert(face);
    if (!truth->level.decided) {
      ledger.leave_open(name, "no proof closes");
      continue;
    }
    std::vector<std::array<MeshCrossing, 2>> arcs;
    bool known = true;
    for (const auto& [v, w] : claim.arcs) {
      const auto a = vertices.crossing.find(v), b = vertices.crossing.find(w);
      known = known && a != vertices.crossing.end() && b != vertices.crossing.end();
      if (known) arcs.push_back({std::min(a->second, b->second), std::max(a->second, b->second)});
    }
    std::sort(arcs.begin(), arcs.end());
    for (const Number v : claim.loops) known = known && !vertices.crossing.contains(v);
    const std::size_t loops = truth->level.loops.size();
    ledger.settle(known && arcs == truth->arcs && claim.loops.size() == loops, name, claimed,
                  std::to_string(truth->arcs.size()) + " arcs, " + std::to_string(loops) +
                      " closed, or other ends");
  }
  bool complete = true;
  for (const FaceTopology& face : c.topology.faces) {
    const std::size_t loops = face.level.loops.size();
    if ((face.level.decided && face.arcs.empty() && loops == 0) || listed.contains(face.vertices))
      continue;
    complete = false;
    if (face.level.decided)
      ledger.refute("face " + text(face.vertices), "not listed",
                    std::to_string(face.arcs.size()) + " arcs, " + std::to_string(loops) +
                        " closed");
    else
      ledger.leave_open("face " + text(face.vertices), "no proof closes");
  }
  if (complete) ledger.certify();
}

void compare_tets(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  std::map<Number, const TetClaim*> claims;
  for (const TetClaim& claim : c.claims.tets) claims[claim.tet] = &claim;
  bool complete = true;
  for (const TetTopology& tet : c.topology.tets) {
    const Number cell = c.input.cells[tet.tet];
    const std::string name = "tetrahedron " + std::to_string(cell);
    const auto place = claims.find(cell);
    const bool is_listed = place != claims.end();
    std::vector<NamedSheet> claimed, derived;
    if (is_listed)
      for (const SheetClaim& s : place->second->sheets)
        claimed.emplace_back(s.euler_characteristic, s.loops);
    claims.erase(cell);
    bool names_known = tet.decided;
    for (const MeshSheet& sheet : tet.sheets) {
      NamedSheet& out = derived.emplace_back();
      out.first = sheet.euler_characteristic;
      for (const MeshLoop& loop : sheet.loops) {
        std::vector<Number> curves;
        for (const MeshLoop::Step& step : loop.steps)
          names_known = names_known && vertices.vertex.contains(step.from);
        if (loop.steps.empty()) curves = curve_names(c, tet, loop.opposite);
        names_known = names_known && (!loop.steps.empty() || loop.curve < curves.size());
        if (names_known) out.second.push_back(named(loop, vertices, curves));
      }
      std::sort(out.second.begin(), out.second.end());
    }
    if (!names_known) {
      // Its edges or faces are undecided, or refuted already.
      ledger.leave_open(name, tet.decided ? "no names for its loops" : "no proof closes");
      complete = false;
      continue;
    }
    const auto first = [](const NamedSheet& s) {
      return s.second.empty() ? Number{0} : s.second[0][0];
    };
    std::sort(derived.begin(), derived.end(),
              [&](const NamedSheet& a, const NamedSheet& b) { return first(a) < first(b); });
    if (!is_listed && derived.empty()) continue;
    complete = complete && is_listed;
    ledger.settle(claimed == derived, name, text_of(claimed), text_of(derived));
  }
  for (const auto& [cell, claim] : claims) {
    ledger.refute("tetrahedron " + std::to_string(cell), "sheets", "none, or left out");
    complete = false;
  }
  if (complete) ledger.certify();
}

}  // namespace certificate
