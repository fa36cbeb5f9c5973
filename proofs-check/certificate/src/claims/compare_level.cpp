// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/compare_level.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "claims/compare_list.hpp"
#include "claims/curve_names.hpp"
#include "claims/sides.hpp"

namespace certificate {
namespace {

/// The tensor at a point of an edge.
class OnEdge : public ExactTensors {
 public:
  /// @param weights  of the tensors at the ends, up to a common factor
  OnEdge(const Field& field, const std::array<Vertex, 2>& edge, std::array<mpz_class, 2> weights)
      : field_(field), edge_(edge), weights_(std::move(weights)) {}

  Tensor<mpz_class> exact(std::uint32_t) const override {
    const long low = std::min(field_.exponent(edge_[0]), field_.exponent(edge_[1]));
    Tensor<mpz_class> sum;
    for (std::size_t e = 0; e < 2; ++e) {
      const Tensor<mpz_class> end = field_.exact(edge_[e]);
      const mpz_class weight = weights_[e]
                               << static_cast<unsigned long>(field_.exponent(edge_[e]) - low);
      for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += weight * end[n];
    }
    return sum;
  }
  /// Encloses a multiple of it.
  Tensor<Ball> ball() const {
    const long scale = std::max(field_.scale(edge_[0]), field_.scale(edge_[1]));
    const auto bits = mpz_sizeinbase(mpz_class(weights_[0] + weights_[1]).get_mpz_t(), 2);
    Tensor<Ball> sum{};
    for (std::size_t e = 0; e < 2; ++e) {
      const Ball weight =
          ball_of(weights_[e], static_cast<long>(bits) + scale - field_.scale(edge_[e]));
      const Tensor<Ball>& end = *field_.corner(edge_[e], false).ball;
      for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += weight * end[n];
    }
    scale_to_one(sum);
    return sum;
  }

 private:
  const Field& field_;
  const std::array<Vertex, 2>& edge_;
  std::array<mpz_class, 2> weights_;
};

/// Is the field above at an end of an interval of an edge?
bool above_at(const LevelCase& c, const std::array<Vertex, 2>& edge, const mpz_class& i,
              unsigned k) {
  const OnEdge place(c.field, edge, {(mpz_class(1) << k) - i, i});
  const Tensor<Ball> ball = place.ball();
  return c.level.above({&ball, 0, &place, 0});
}

/// What is claimed of an edge; null if nothing is.
const Json* claimed_edge(const LevelCase& c, const std::array<Vertex, 2>& vertices) {
  const Json& edges = c.claims["edges"];
  const auto key = [](const Json& edge) {
    return std::array{edge[0].get<Number>(), edge[1].get<Number>()};
  };
  const std::array<Number, 2> numbers{vertices[0], vertices[1]};
  const auto place = std::lower_bound(edges.begin(), edges.end(), numbers,
                                      [&](const Json& e, const auto& n) { return key(e) < n; });
  return place == edges.end() || key(*place) != numbers ? nullptr : &*place;
}

/// As many intervals as crossings, which follow each other, with an odd number of crossings in
/// each.
bool has_crossings(const LevelCase& c, const EdgeTopology& edge, const Json& claim) try {
  if (claim.size() - 2 != edge.level.crossings) return false;
  mpq_class free_from;
  for (std::size_t n = 2; n < claim.size(); ++n) {
    const Interval interval = interval_of(claim[n]);
    if (interval.end(0) < free_from || above_at(c, edge.vertices, interval.i, interval.k) ==
                                           above_at(c, edge.vertices, interval.i + 1, interval.k))
      return false;
    free_from = interval.end(1);
  }
  return true;
} catch (const Malformed&) {
  return false;
}

/// The names of a loop in the certificate, or nothing if something on it has none.
std::vector<Number> named(const LevelCase& c, const CrossingVertices& vertices,
                          const TetTopology& tet, const MeshLoop& loop) {
  if (loop.steps.empty()) {
    const std::vector<Number> curves = curve_names(c, face_opposite(c, tet.tet, loop.opposite));
    if (loop.curve >= curves.size()) return {};
    return {curves[loop.curve], loop.opposite};
  }
  std::vector<std::array<Number, 2>> steps;
  for (const MeshLoop::Step& step : loop.steps) {
    const auto place = vertices.vertex.find(step.from);
    if (place == vertices.vertex.end()) return {};
    steps.push_back({place->second, step.opposite});
  }
  std::rotate(steps.begin(), std::min_element(steps.begin(), steps.end()), steps.end());
  std::vector<Number> numbers;
  for (const auto& step : steps) numbers.insert(numbers.end(), step.begin(), step.end());
  return numbers;
}

/// A sheet as the certificate names it.
struct NamedSheet {
  long euler_characteristic;
  std::vector<std::vector<Number>> loops;  ///< ascending
};

/// The sheets of a tetrahedron in the certificate's order, or nothing if a loop has no name.
std::optional<std::vector<NamedSheet>> named(const LevelCase& c, const CrossingVertices& vertices,
                                             const TetTopology& tet) {
  std::vector<NamedSheet> result;
  for (const MeshSheet& sheet : tet.sheets) {
    NamedSheet& out = result.emplace_back(NamedSheet{sheet.euler_characteristic, {}});
    for (const MeshLoop& loop : sheet.loops)
      if (out.loops.push_back(named(c, vertices, tet, loop)); out.loops.back().empty()) return {};
    std::sort(out.loops.begin(), out.loops.end());
  }
  std::sort(result.begin(), result.end(), [](const NamedSheet& a, const NamedSheet& b) {
    return !b.loops.empty() &&  // first one without boundary
           (a.loops.empty() || a.loops[0][0] < b.loops[0][0]);
  });
  return result;
}

bool are_equal(const Json& list, std::span<const Number> numbers) {
  return list.size() == numbers.size() &&
         std::equal(numbers.begin(), numbers.end(), list.begin(), [](Number n, const Json& j) {
           return j.is_number_unsigned() && j.get<Number>() == n;
         });
}

bool has_sheets(const Json& claim, const std::vector<NamedSheet>& sheets) {
  if (claim.size() != sheets.size() + 1) return false;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const auto& [euler_characteristic, loops] = sheets[s];
    const Json& own = claim[s + 1];
    if (own.size() != loops.size() + 1 || own[0].get<long>() != euler_characteristic) return false;
    for (std::size_t l = 0; l < loops.size(); ++l)
      if (!are_equal(own[l + 1], loops[l])) return false;
  }
  return true;
}

/// Are there closed curves on the boundary that their places do not separate?
bool has_uncertain_curves(const LevelCase& c, std::size_t tet) {
  for (std::size_t i = 0; i < 4; ++i)
    if (c.curves.uncertain.contains(without(c.input.tets[tet], i))) return true;
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
            c.curves.uncertain.contains(without(c.input.tets[tet], i)))
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
  result.vertex.reserve(c.topology.edges.size());
  result.crossing.reserve(c.topology.edges.size());
  const auto is_of_level = [&](Number v) { return v - c.vertices.first < c.vertices.count; };
  const auto note = [&](const EdgeTopology& edge, unsigned n, const Json& crossing) {
    const Number first = crossing[2].get<Number>();
    for (std::size_t i = 2; i < crossing.size(); ++i) {
      const Number v = crossing[i].get<Number>();
      if (!is_of_level(v)) return "vertex " + std::to_string(v) + " of another level";
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
  const auto agrees = [&](const EdgeTopology& edge, const Json& claim) {
    return has_crossings(c, edge, claim);
  };
  const auto accept = [&](const EdgeTopology& edge, const Json& claim) {
    std::vector<Number> vertices;
    for (std::size_t n = 2; n < claim.size(); ++n)
      for (std::size_t i = 2; i < claim[n].size(); ++i)
        vertices.push_back(claim[n][i].get<Number>());
    std::sort(vertices.begin(), vertices.end());
    if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end() ||
        std::any_of(vertices.begin(), vertices.end(),
                    [&](Number v) { return !is_of_level(v) || result.crossing.contains(v); }))
      return false;
    for (unsigned n = 0; n + 2 < claim.size(); ++n) note(edge, n, claim[n + 2]);
    return true;
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
  compare_list<2>("edge ", c.claims["edges"], c.topology.edges, numbers_of<EdgeTopology>, agrees,
                  accept, settle, [&](const auto& vertices) { return sides_in(c, vertices); },
                  ledger);
  // What is claimed of an edge that stays open names its crossings all the same.
  for (const EdgeTopology& edge : c.topology.edges) {
    if (edge.is_decided()) continue;
    const Json* const claim = claimed_edge(c, edge.vertices);
    for (unsigned n = 0; claim != nullptr && n + 2 < claim->size(); ++n) {
      interval_of((*claim)[n + 2]);  // throws if it is none
      if (const std::string unfit = note(edge, n, (*claim)[n + 2]); !unfit.empty())
        ledger.refute("edge " + claim->dump(), claim->dump(), unfit);
    }
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
  using Arcs = std::vector<std::array<Number, 2>>;
  // Those with names; false if some have none, or a closed curve has the name of a crossing.
  const auto name_arcs = [&](const FaceTopology& face, const Json& claim, Arcs& arcs) {
    bool known = true;
    for (const auto& [from, to] : face.arcs) {
      const auto a = vertices.vertex.find(from), b = vertices.vertex.find(to);
      known = known && a != vertices.vertex.end() && b != vertices.vertex.end();
      if (!known) continue;
      arcs.push_back({std::min(a->second, b->second), std::max(a->second, b->second)});
    }
    std::sort(arcs.begin(), arcs.end());
    for (const Json& v : claim[4]) known = known && !vertices.crossing.contains(v.get<Number>());
    return known;
  };
  const auto agrees = [&](const FaceTopology& face, const Json& claim) {
    Arcs arcs;
    return name_arcs(face, claim, arcs) && claim[3].size() == arcs.size() &&
           std::equal(arcs.begin(), arcs.end(), claim[3].begin(),
                      [](const auto& arc, const Json& j) { return are_equal(j, arc); }) &&
           claim[4].size() == face.level.loops.size();
  };
  const auto accept = [](const FaceTopology&, const Json&) { return true; };
  const auto settle = [&](const FaceTopology& face, const Json& claim, const std::string& name) {
    Arcs arcs;
    name_arcs(face, claim, arcs);
    ledger.refute(name, claim.dump(),
                  std::to_string(face.arcs.size()) + " arcs, those with names are " +
                      Json(arcs).dump() + ", and " + std::to_string(face.level.loops.size()) +
                      " closed",
                  [&] { return sides_in_face(numbers_of(face)); });
  };
  compare_list<3>("face ", c.claims["faces"], c.topology.faces, numbers_of<FaceTopology>, agrees,
                  accept, settle, sides_in_face, ledger);
}

void compare_tets(const LevelCase& c, const CrossingVertices& vertices, Ledger& ledger) {
  const auto agrees = [&](const TetTopology& tet, const Json& claim) {
    const auto sheets = named(c, vertices, tet);
    return sheets && has_sheets(claim, *sheets);
  };
  const auto accept = [](const TetTopology&, const Json&) { return true; };
  const auto settle = [&](const TetTopology& tet, const Json& claim, const std::string& name) {
    const auto sheets = named(c, vertices, tet);
    // Its edges or faces are undecided, or refuted already.
    if (!sheets) return ledger.leave_open(name, "no names for its loops");
    Json derived = Json::array({claim[0]});
    for (const auto& [euler_characteristic, loops] : *sheets) {
      Json& out = derived.emplace_back(Json::array({euler_characteristic}));
      for (const auto& loop : loops) out.push_back(loop);
    }
    if (has_uncertain_curves(c, tet.tet) &&
        without_curves(c, claim) == without_curves(c, derived))
      return ledger.leave_open(name, "which closed curve of a face is which");
    ledger.refute(name, claim.dump(), derived.dump(),
                  [&] { return sides_in_cell(c, {c.input.cells[tet.tet]}); });
  };
  const auto key = [&](const TetTopology& tet) {
    return std::array<Number, 1>{c.input.cells[tet.tet]};
  };
  compare_list<1>("tetrahedron ", c.claims["tets"], c.topology.tets, key, agrees, accept, settle,
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
