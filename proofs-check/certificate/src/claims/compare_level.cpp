// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/compare_level.hpp"

#include <algorithm>

#include "claims/compare_list.hpp"
#include "claims/curve_names.hpp"
#include "claims/sides.hpp"
#include "files/given_tensor.hpp"

namespace certificate {
namespace {

/// Is the field above at an end of an interval of an edge?
bool above_at(const LevelCase& c, const std::array<Vertex, 2>& edge, const mpz_class& i,
              unsigned k) {
  const Tensor<mpz_class> a = c.field.exact(edge[0]), b = c.field.exact(edge[1]);
  const long ea = c.field.exponent(edge[0]), eb = c.field.exponent(edge[1]);
  const long low = std::min(ea, eb);
  Tensor<mpz_class> sum;
  for (std::size_t n = 0; n < sum.size(); ++n) {
    sum[n] = (mpz_class(((mpz_class(1) << k) - i) * a[n]) << static_cast<unsigned long>(ea - low)) +
             (mpz_class(i * b[n]) << static_cast<unsigned long>(eb - low));
  }
  long shift = 0;
  const Tensor<Ball> ball = enclosure(sum, shift);
  return is_above(c.level, ball, sum);
}

/// The names of a loop in the certificate, or nothing if something on it has none.
Json named(const LevelCase& c, const CrossingVertices& vertices, const TetTopology& tet,
           const MeshLoop& loop) {
  if (loop.steps.empty()) {
    const std::vector<Number> curves = curve_names(c, face_opposite(c, tet.tet, loop.opposite));
    return loop.curve < curves.size() ? Json::array({curves[loop.curve], loop.opposite}) : Json();
  }
  std::vector<std::array<Number, 2>> steps;
  for (const MeshLoop::Step& step : loop.steps) {
    const auto place = vertices.vertex.find(step.from);
    if (place == vertices.vertex.end()) return {};
    steps.push_back({place->second, step.opposite});
  }
  std::rotate(steps.begin(), std::min_element(steps.begin(), steps.end()), steps.end());
  Json numbers = Json::array();
  for (const auto& step : steps)
    for (const Number number : step) numbers.push_back(number);
  return numbers;
}

/// Are there closed curves on the boundary that their places do not separate?
bool has_uncertain_curves(const LevelCase& c, std::size_t tet) {
  for (std::size_t i = 0; i < 4; ++i)
    if (c.curves.uncertain.contains(face_of(c.input.tets[tet], i))) return true;
  return false;
}

/// The sheets of a tetrahedron where all closed curves of a face have one name.
Json without_curves(const LevelCase& c, const Json& sheets) {
  const std::size_t tet = c.input.tet_at(sheets[0].get<Number>());
  Json result = sheets;
  for (std::size_t s = 1; s < result.size(); ++s) {
    for (std::size_t l = 1; l < result[s].size(); ++l) {
      Json& loop = result[s][l];
      for (std::size_t i = 0; i < 4 && loop.size() == 2; ++i)
        if (loop[1] == c.input.tets[tet][i] &&
            c.curves.uncertain.contains(face_of(c.input.tets[tet], i)))
          loop[0] = 0;
    }
    std::sort(result[s].begin() + 1, result[s].end());
  }
  std::sort(result.begin() + 1, result.end());
  return result;
}

/// What names a cone's sheet in the certificate but its tips; or nothing.
std::vector<Number> named(const LevelCase& c, const CrossingVertices& vertices,
                          const ConeTopology& cone, const ConeSheet& sheet) {
  std::vector<Number> names;
  if (sheet.crossings.empty()) {
    const auto curves =
        curve_names(c, *c.topology.face({cone.base[0], cone.base[1], cone.base[2]}));
    if (sheet.curve < curves.size()) names.push_back(curves[sheet.curve]);
    return names;
  }
  for (const MeshCrossing& crossing : sheet.crossings) {
    const auto place = vertices.vertex.find(crossing);
    if (place == vertices.vertex.end()) return {};
    names.push_back(place->second);
  }
  return names;
}

std::string sides_in_cell(const LevelCase& c, const std::array<Number, 1>& cell) {
  const std::size_t tet = c.input.tet_at(cell[0]);
  if (tet == Input::kNone) return "no tetrahedron of the input is that cell";
  const auto& vertices = c.input.tets[tet];
  return sides_in(c, std::vector<Number>(vertices.begin(), vertices.end()));
}

}  // namespace

bool is_at(const LevelCase& c, const Json& vertex, Vertex place) {
  const Number v = vertex.get<Number>();
  return v - c.vertices.first < c.vertices.count && c.surface.points[v] == c.input.points[place];
}

/// As many intervals as crossings, without common inner points, and an odd number of crossings in
/// each: so one.
CrossingVertices compare_edges(const LevelCase& c, Ledger& ledger) {
  CrossingVertices result;
  const auto note = [&](const EdgeTopology& edge, unsigned n, const Json& crossing) {
    const Number first = crossing[2].get<Number>();
    for (std::size_t i = 2; i < crossing.size(); ++i) {
      const Number v = crossing[i].get<Number>();
      if (v - c.vertices.first >= c.vertices.count)
        return "vertex " + std::to_string(v) + " of another level";
      if (const auto [other, is_new] =
              result.crossing.emplace(v, MeshCrossing{edge.vertices, n});
          !is_new)
        return "vertex " + std::to_string(v) + " at two crossings, also on edge " +
               Json(other->second.edge).dump();
      if (i > 2) result.original[v] = first;
    }
    result.vertex[{edge.vertices, n}] = first;
    return std::string();
  };
  const auto settle = [&](const EdgeTopology& edge, const Json& claim, const std::string& name) {
    const std::size_t count = claim.size() - 2;
    std::string wrong;
    if (count != edge.level.crossings) wrong = std::to_string(edge.level.crossings) + " crossings";
    mpq_class free_from;
    for (unsigned n = 0; n < count && wrong.empty(); ++n) {
      const Json& crossing = claim[n + 2];
      const Interval interval = interval_of(crossing);
      if (interval.end(0) < free_from)
        wrong = "intervals that overlap: one ends at " + free_from.get_str() +
                ", the next begins at " + interval.end(0).get_str();
      if (above_at(c, edge.vertices, interval.i, interval.k) ==
          above_at(c, edge.vertices, interval.i + 1, interval.k))
        wrong = std::string("the field is ") +
                (above_at(c, edge.vertices, interval.i, interval.k) ? "above" : "below") +
                " at both ends of an interval, at " + interval.end(0).get_str() + " and " +
                interval.end(1).get_str() + " of the way";
      if (const std::string unfit = note(edge, n, crossing); !unfit.empty()) wrong = unfit;
      free_from = interval.end(1);
    }
    ledger.settle(wrong.empty(), name, claim.dump(), wrong,
                  [&] { return sides_in(c, numbers_of(edge)); });
  };
  compare_list<2>("edge ", c.claims["edges"], c.topology.edges, numbers_of<EdgeTopology>, settle,
                  [&](const auto& vertices) { return sides_in(c, vertices); }, ledger);
  // What is claimed of an edge that stays open names its crossings all the same.
  for (const Json& claim : c.claims["edges"]) {
    const EdgeTopology* edge = c.topology.edge({claim[0].get<Vertex>(), claim[1].get<Vertex>()});
    for (unsigned n = 0; edge != nullptr && !edge->is_decided() && n + 2 < claim.size(); ++n)
      if (const std::string unfit = note(*edge, n, claim[n + 2]); !unfit.empty())
        ledger.refute("edge " + claim.dump(), claim.dump(), unfit);
  }
  return result;
}

void compare_faces(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  const auto sides_in_face = [&](const std::array<Number, 3>& numbers) {
    std::string text = sides_in(c, numbers);
    std::array<Vertex, 3> corners{};
    std::transform(numbers.begin(), numbers.end(), corners.begin(),
                   [](Number v) { return static_cast<Vertex>(v); });
    if (const FaceTopology* face = c.topology.face(corners); face != nullptr && face->is_decided())
      if (const std::string curves = sides_of_curves(c, *face); !curves.empty())
        text += "; " + curves;
    return text;
  };
  const auto settle = [&](const FaceTopology& face, const Json& claim, const std::string& name) {
    std::vector<std::array<Number, 2>> arcs;
    bool known = true;
    for (const auto& [from, to] : face.arcs) {
      const auto a = vertices.vertex.find(from), b = vertices.vertex.find(to);
      known = known && a != vertices.vertex.end() && b != vertices.vertex.end();
      if (!known) continue;
      arcs.push_back({std::min(a->second, b->second), std::max(a->second, b->second)});
    }
    std::sort(arcs.begin(), arcs.end());
    for (const Json& v : claim[4]) known = known && !vertices.crossing.contains(v.get<Number>());
    ledger.settle(known && claim[3] == Json(arcs) && claim[4].size() == face.level.loops.size(),
                  name, claim.dump(),
                  std::to_string(face.arcs.size()) + " arcs, those with names are " +
                      Json(arcs).dump() + ", and " + std::to_string(face.level.loops.size()) +
                      " closed",
                  [&] { return sides_in_face(numbers_of(face)); });
  };
  compare_list<3>("face ", c.claims["faces"], c.topology.faces, numbers_of<FaceTopology>, settle,
                  sides_in_face, ledger);
}

void compare_tets(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  const auto settle = [&](const TetTopology& tet, const Json& claim, const std::string& name) {
    Json derived = Json::array();
    for (const MeshSheet& sheet : tet.sheets) {
      Json& out = derived.emplace_back(Json::array({sheet.euler_characteristic}));
      for (const MeshLoop& loop : sheet.loops) out.push_back(named(c, vertices, tet, loop));
      // Its edges or faces are undecided, or refuted already.
      if (std::count(out.begin(), out.end(), nullptr) > 0)
        return ledger.leave_open(name, "no names for its loops");
      std::sort(out.begin() + 1, out.end());
    }
    std::sort(derived.begin(), derived.end(), [](const Json& a, const Json& b) {
      return b.size() > 1 && (a.size() == 1 || a[1][0] < b[1][0]);  // first one without boundary
    });
    derived.insert(derived.begin(), claim[0]);
    if (claim != derived && has_uncertain_curves(c, tet.tet) &&
        without_curves(c, claim) == without_curves(c, derived))
      return ledger.leave_open(name, "which closed curve of a face is which");
    ledger.settle(claim == derived, name, claim.dump(), derived.dump(),
                  [&] { return sides_in_cell(c, {c.input.cells[tet.tet]}); });
  };
  const auto key = [&](const TetTopology& tet) {
    return std::array<Number, 1>{c.input.cells[tet.tet]};
  };
  compare_list<1>("tetrahedron ", c.claims["tets"], c.topology.tets, key, settle,
                  [&](const auto& cell) { return sides_in_cell(c, cell); }, ledger);
}

void compare_cones(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  const auto sides_in_base = [&](const ConeTopology& cone) {
    return sides_in(c, std::vector<Number>(cone.base.begin(), cone.base.end()));
  };
  const auto settle = [&](const ConeTopology& cone, const Json& claim, const std::string& name) {
    std::map<std::vector<Number>, const ConeSheet*> derived;
    for (const ConeSheet& sheet : cone.sheets)
      derived[named(c, vertices, cone, sheet)] = &sheet;
    if (derived.contains({})) return ledger.leave_open(name, "no names for its sheets");
    bool same = derived.size() == cone.sheets.size() && claim.size() == derived.size() + 1;
    std::string text;
    std::size_t i = 1;
    for (const auto& [names, sheet] : derived) {
      text += Json(names).dump() + " with tips at " + Json(sheet->tips).dump() + ' ';
      if (!same) continue;
      const Json& s = claim[i++];
      const std::size_t first = names.size();
      same = s.size() == (sheet->tips.size() == 2 ? 4 : first + 1) &&
             std::equal(names.begin(), names.end(), s.begin()) &&
             is_at(c, s[first], sheet->tips[0]) && is_at(c, s.back(), sheet->tips.back());
    }
    ledger.settle(same, name, claim.dump(), text, [&] { return sides_in_base(cone); });
  };
  const auto key = [&](const ConeTopology& cone) {
    return std::array<Number, 1>{c.input.cells[cone.tet]};
  };
  const auto witness = [&](const std::array<Number, 1>& cell) {
    const ConeTopology* const cone = c.topology.cone(c.input.tet_at(cell[0]));
    return cone == nullptr ? sides_in_cell(c, cell) : sides_in_base(*cone);
  };
  compare_list<1>("cone ", c.claims["cones"], c.topology.cones, key, settle, witness, ledger);
}

}  // namespace certificate
