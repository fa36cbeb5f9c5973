// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/curve_names.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "claims/half_edges.hpp"
#include "mesh/power_of_two.hpp"
#include "places.hpp"

namespace certificate {
namespace {

using Face = std::array<Vertex, 3>;
/// The closed polygons along which the triangles of a tetrahedron end, by their smallest vertices.
using Polygons = std::map<Number, std::vector<Number>>;

/// Weights of the refinement's roots at about the point of the face that is nearest to a vertex:
/// its projection along an axis, exactly, with negative weights set to zero. Nothing if the face
/// has no area.
std::optional<Place<3>> place_in_face(const LevelCase& c, const FaceTopology& face, Number vertex) {
  std::array<std::array<mpq_class, 3>, 3> corners;
  std::array<mpq_class, 3> x;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = c.surface.points[vertex][k];
    for (std::size_t i = 0; i < 3; ++i) corners[i][k] = c.input.points[face.vertices[i]][k];
  }
  const auto area = [](const auto& p, const auto& q, const auto& r, std::size_t axis) -> mpq_class {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
  };
  std::size_t axis = 0;
  mpq_class total;
  for (std::size_t k = 0; k < 3; ++k)
    if (const mpq_class a = area(corners[0], corners[1], corners[2], k); abs(a) > abs(total))
      total = a, axis = k;
  if (total == 0) return std::nullopt;
  std::array<mpq_class, 3> weights;
  mpz_class common = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    // The tensors are multiples of the exact ones.
    const mpq_class w = times_power_of_two(
        mpq_class(area(x, corners[(i + 1) % 3], corners[(i + 2) % 3], axis) / total),
        c.field.exponent(face.vertices[i]));
    weights[i] = w > 0 ? w : mpq_class(0);
    common = lcm(common, weights[i].get_den());
  }
  Place<3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = weights[i].get_num() * (common / weights[i].get_den());
  return result;
}

/// The closed curves of a face, by the parts of its refinement that they pass.
class Passed {
 public:
  explicit Passed(const FaceLevel& level) : level_(level) {
    for (std::size_t n = 0; n < level.loops.size(); ++n)
      for (const CrossedEdge& edge : level.loops[n]) curve_[edge] = n;
  }
  /// The curve in the part at that place, if one passes it.
  std::optional<std::size_t> at(const Place<3>& place) const {
    const auto& points = level_.refinement->points();
    for (const Refinement::Cell& cell : level_.refinement->cells()) {
      if (cell.cut || cell.proof == Proof::empty) continue;
      std::optional<std::size_t> found;
      for_subsets(3, 2, [&](const auto& m) {
        const auto [a, b] = std::minmax(cell.points[m[0]], cell.points[m[1]]);
        if (const auto curve = curve_.find({a, b}); curve != curve_.end()) found = curve->second;
      });
      if (!found) continue;
      std::array<Place<3>, 3> tile;
      for (std::size_t i = 0; i < 3; ++i) tile[i] = without(points[cell.points[i]].weights, 3);
      const Place<3> inside = weights_at(tile, place);
      if (inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0) return found;
    }
    return std::nullopt;
  }

 private:
  const FaceLevel& level_;
  std::map<CrossedEdge, std::size_t> curve_;
};

/// The polygons of all triangles in these tetrahedra; none if they are no manifold.
Polygons polygons_in(const LevelCase& c, const std::set<std::size_t>& tets) {
  std::vector<HalfEdges::Triangle> triangles;
  std::map<std::size_t, std::vector<std::size_t>> by_tet;
  std::vector<std::size_t> tet_of;
  for (std::size_t t = c.triangles.first; t < c.triangles.first + c.triangles.count; ++t) {
    const std::size_t tet = c.input.tet_at(c.surface.cells[t]);
    if (!tets.contains(tet)) continue;
    by_tet[tet].push_back(triangles.size());
    triangles.push_back(c.surface.triangles[t]);
    tet_of.push_back(tet);
  }
  Polygons result;
  const HalfEdges mesh(triangles);
  for (const auto& [tet, some] : by_tet) {
    try {
      const auto pieces = mesh.pieces(some, [&](std::size_t t, std::size_t, std::size_t other) {
        return tet_of[t] == tet_of[other];
      });
      for (const Piece& piece : pieces) {
        for (const auto& loop : piece.loops) {
          std::vector<Number> polygon;
          for (const BoundaryEdge& edge : loop) polygon.push_back(edge.from);
          result[*std::min_element(polygon.begin(), polygon.end())] = std::move(polygon);
        }
      }
    } catch (const Wrong&) {
      continue;  // compare_surface says so
    }
  }
  return result;
}

/// The loops that the certificate lists of a face.
const Json* claimed_loops(const LevelCase& c, const FaceTopology& face) {
  const Json numbers = face.vertices, &faces = c.claims["faces"];
  const auto claim = std::lower_bound(faces.begin(), faces.end(), numbers,
                                      [](const Json& f, const Json& n) {
                                        return std::array{f[0], f[1], f[2]} <
                                               std::array{n[0], n[1], n[2]};
                                      });
  if (claim == faces.end() || (*claim)[4].size() != face.level.loops.size() ||
      Json::array({(*claim)[0], (*claim)[1], (*claim)[2]}) != numbers)
    return nullptr;
  return &(*claim)[4];
}

/// Some vertices of a polygon, the same whatever their numbers are: all if there are few, else every
/// so many-th in the order of places.
std::vector<Number> some_of(const LevelCase& c, const std::vector<Number>& polygon) {
  constexpr std::size_t kMost = 32;
  std::vector<Number> all = polygon, some;
  std::sort(all.begin(), all.end(), [&](Number v, Number w) {
    return c.surface.points[v] < c.surface.points[w];
  });
  const std::size_t step = (all.size() + kMost - 1) / kMost;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

/// Names by curve; each polygon votes with its vertices. Curves with votes come first, names that
/// are left over go to curves that are, in any order.
/// @param certain  whether each polygon had votes for its curve, and for no other
std::vector<Number> names_of(const LevelCase& c, const FaceTopology& face, const Json& loops,
                             const Polygons& polygons, bool& certain) {
  const std::size_t count = loops.size();
  const Passed passed(face.level);
  std::vector<std::array<std::size_t, 3>> votes;  // how many, of which name, for which curve
  certain = true;
  for (std::size_t n = 0; n < count; ++n) {
    std::vector<std::size_t> own(count);
    if (const auto polygon = polygons.find(loops[n].get<Number>()); polygon != polygons.end())
      for (const Number v : some_of(c, polygon->second))
        if (const auto place = place_in_face(c, face, v))
          if (const auto curve = passed.at(*place)) ++own[*curve];
    certain = certain && std::count(own.begin(), own.end(), 0U) + 1 ==
                             static_cast<std::ptrdiff_t>(count);
    for (std::size_t curve = 0; curve < count; ++curve) votes.push_back({own[curve], n, curve});
  }
  std::stable_sort(votes.begin(), votes.end(),
                   [](const auto& a, const auto& b) { return a[0] > b[0]; });
  constexpr Number kNone = static_cast<Number>(-1);
  std::vector<Number> result(count, kNone);
  std::vector<bool> is_named(count);
  for (const auto& [many, n, curve] : votes) {
    if (is_named[n] || result[curve] != kNone) continue;
    is_named[n] = true;
    result[curve] = loops[n].get<Number>();
    certain = certain && many > 0;
  }
  return result;
}

}  // namespace

const FaceTopology& face_opposite(const LevelCase& c, std::size_t tet, Vertex opposite) {
  std::array<Vertex, 3> face{};
  std::size_t n = 0;
  for (const Vertex v : c.input.tets[tet])
    if (v != opposite && n < 3) face[n++] = v;
  return *c.topology.face(face);
}

std::vector<Number> curve_names(const LevelCase& c, const FaceTopology& face) {
  const Json* const loops = claimed_loops(c, face);
  if (loops == nullptr || loops->empty()) return {};
  if (loops->size() == 1) return {(*loops)[0].get<Number>()};
  const auto found = c.curves.names.find(face.vertices);
  return found == c.curves.names.end() ? std::vector<Number>{} : found->second;
}

CurveNames name_curves(const LevelCase& c) {
  std::set<Face> several;
  for (const FaceTopology& face : c.topology.faces)
    if (face.level.loops.size() > 1) several.insert(face.vertices);
  if (several.empty()) return {};
  std::set<std::size_t> tets;
  const auto add = [&](std::size_t tet) {
    for (std::size_t i = 0; i < 4; ++i)
      if (several.contains(without(c.input.tets[tet], i))) tets.insert(tet);
  };
  for (const TetTopology& tet : c.topology.tets) add(tet.tet);
  for (const ConeTopology& cone : c.topology.cones) add(cone.tet);
  const Polygons polygons = polygons_in(c, tets);
  CurveNames result;
  for (const Face& vertices : several) {
    const FaceTopology& face = *c.topology.face(vertices);
    const Json* const loops = claimed_loops(c, face);
    bool certain = false;
    if (loops != nullptr) result.names[vertices] = names_of(c, face, *loops, polygons, certain);
    if (!certain) result.uncertain.insert(vertices);
  }
  return result;
}

}  // namespace certificate
