// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/compare_curves.hpp"

#include <algorithm>
#include <set>

#include "claims/containment.hpp"
#include "claims/point_boxes.hpp"
#include "mesh/power_of_two.hpp"
#include "union_find.hpp"

namespace certificate {
namespace {

/// Has the vertex, as far as rounding goes, coordinates that points of the box have?
bool is_near(const CurveCase& c, const PointBox& box, const std::array<Vertex, 3>& face) {
  const auto& place = c.curves.points[box.vertex];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<mpq_class, 3> p;
    double largest = 0;
    for (std::size_t n = 0; n < 3; ++n) {
      p[n] = c.input.points[face[n]][axis];
      largest = std::max(largest, std::abs(c.input.points[face[n]][axis]));
    }
    const mpq_class u = p[1] - p[0], v = p[2] - p[0], one(box.one());
    const mpq_class middle = p[0] + (box.middle(0) * u + box.middle(1) * v) / one;
    const mpq_class reach = (abs(u) + abs(v)) / one + rounding_of(largest);
    if (abs(mpq_class(place[axis]) - middle) > reach) return false;
  }
  return true;
}

/// Does it lie in the tetrahedron?
bool is_near(const CurveCase& c, Number vertex, std::size_t tet) {
  std::array<Point3, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = c.input.points[c.input.tets[tet][i]];
  return lies_in(c.curves.points[vertex], corners);
}

/// The points of a face, about: weights of its vertices at both ends of an arc that holds each.
std::string places_in(const CurveCase& c, const std::array<Number, 3>& numbers) {
  std::array<Vertex, 3> vertices{};
  std::transform(numbers.begin(), numbers.end(), vertices.begin(),
                 [](Number v) { return static_cast<Vertex>(v); });
  const CurveFace* const face = c.topology.face(vertices);
  const std::size_t count = face == nullptr ? 0 : face->level.points.size();
  std::string text = std::to_string(count) + " points in face " + Json(numbers).dump();
  for (std::size_t n = 0; n < count; ++n) {
    FacePoint point = face->level.points[n];
    point.sharpen();
    for (const std::size_t end : {0U, 4U}) {
      std::array<mpq_class, 3> w;
      mpq_class sum;
      for (std::size_t l = 0; l < 3; ++l) {
        w[l] = times_power_of_two(point.weight(l, end), -c.field.exponent(vertices[l]));
        sum += w[l];
      }
      Json shown = Json::array();
      for (const mpq_class& x : w) shown.push_back(mpq_class(x / sum).get_d());
      text += (end == 0 ? (n == 0 ? ", at weights between " : ", between ") : " and ") +
              shown.dump();
    }
  }
  return text;
}

bool is_of(const Range& range, Number i) { return i - range.first < range.count; }

std::array<Number, 2> ascending(Number v, Number w) { return {std::min(v, w), std::max(v, w)}; }

}  // namespace

PointVertices compare_face_points(const CurveCase& c, Ledger& ledger) {
  PointVertices result;
  std::set<Number> taken;
  const auto settle = [&](const CurveFace& face, const Json& claim, const std::string& name) {
    const std::size_t count = face.level.points.size();
    std::string wrong;
    if (claim.size() != 3 + count) wrong = std::to_string(count) + " points";
    std::vector<std::size_t> met(count, 0);
    bool is_open = false;
    for (std::size_t n = 3; n < claim.size() && wrong.empty(); ++n) {
      const PointBox box(claim[n]);
      if (!is_of(c.vertices, box.vertex)) {
        wrong = "vertex " + std::to_string(box.vertex) + " of other curves";
      } else if (!taken.insert(box.vertex).second) {
        wrong = "vertex " + std::to_string(box.vertex) + " at two points";
      } else if (!is_near(c, box, face.vertices)) {
        wrong = "vertex " + std::to_string(box.vertex) + " is not in its box, but at " +
                Json(c.curves.points[box.vertex]).dump();
      }
      std::size_t inside = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Answer answer = holds(c, box, face.vertices, {0, 1, 2}, face.level.points[i]);
        is_open = is_open || answer == Answer::unsure;
        if (answer != Answer::yes) continue;
        ++inside, ++met[i];
        result[{face.vertices, i}] = box.vertex;
      }
      if (inside != 1 && wrong.empty())
        wrong = std::to_string(inside) + " points in the box of vertex " +
                std::to_string(box.vertex);
    }
    if (is_open) return ledger.leave_open(name, "a point on the edge of its box");
    if (wrong.empty() && std::any_of(met.begin(), met.end(), [](std::size_t n) { return n != 1; }))
      wrong = "a point in two boxes";
    ledger.settle(wrong.empty(), name, claim.dump(), wrong,
                  [&] { return places_in(c, numbers_of(face)); });
  };
  compare_list<3>("face ", c.claims["faces"], c.topology.faces, numbers_of<CurveFace>, settle,
                  [&](const auto& vertices) { return places_in(c, vertices); }, ledger);
  return result;
}

void compare_pieces(const CurveCase& c, const PointVertices& vertices, Ledger& ledger) {
  const auto settle = [&](const CurveTet& tet, const Json& claim, const std::string& name) {
    std::vector<std::array<Number, 2>> pieces;
    for (const auto& [from, to] : tet.pieces) {
      const auto v = vertices.find(from), w = vertices.find(to);
      // Its faces are undecided, or refuted already.
      if (v == vertices.end() || w == vertices.end())
        return ledger.leave_open(name, "no names for its points");
      pieces.push_back(ascending(v->second, w->second));
    }
    std::sort(pieces.begin(), pieces.end());
    Json derived = Json::array({claim[0]});
    for (const auto& piece : pieces) derived.push_back(piece);
    ledger.settle(claim == derived, name, claim.dump(), derived.dump());
  };
  const auto key = [&](const CurveTet& tet) {
    return std::array<Number, 1>{c.input.cells[tet.tet]};
  };
  const auto witness = [&](const std::array<Number, 1>& cell) {
    const std::size_t t = c.input.tet_at(cell[0]);
    std::string text;
    for (std::size_t i = 0; t != Input::kNone && i < 4; ++i) {
      std::array<Number, 3> face{};
      const auto corners = without(c.input.tets[t], i);
      std::copy(corners.begin(), corners.end(), face.begin());
      text += (i == 0 ? "" : "; ") + places_in(c, face);
    }
    return t == Input::kNone ? std::string("no tetrahedron of the input is that cell") : text;
  };
  compare_list<1>("tetrahedron ", c.claims["tets"], c.topology.tets, key, settle, witness, ledger);
}

namespace {

/// In each tetrahedron that is not left out the lines join what the claimed pieces join.
void compare_lines(const CurveCase& c, Ledger& ledger) {
  std::map<Number, std::vector<std::array<Number, 2>>> found, claimed;
  std::map<Number, std::size_t> used;  // how often, at ends and elsewhere
  std::set<Number> inner;
  std::string wrong;
  const Number end = c.lines.first + c.lines.count;
  for (Number l = c.lines.first; l < end && wrong.empty(); ++l) {
    const auto& line = c.curves.lines[l];
    const std::string name = "line " + std::to_string(l);
    const std::size_t tet = c.input.tet_at(c.curves.cells[l]);
    if (tet == Input::kNone) {
      wrong = name + " in no tetrahedron";
      break;
    }
    if (!c.left_out[tet]) found[c.curves.cells[l]].push_back(ascending(line.front(), line.back()));
    for (std::size_t n = 0; n < line.size(); ++n) {
      if (!is_of(c.vertices, line[n]))
        wrong = name + " with a vertex of other curves";
      else if (!is_near(c, line[n], tet))
        wrong = name + " leaves its tetrahedron";
      ++used[line[n]];
      if (n > 0 && n + 1 < line.size()) inner.insert(line[n]);
    }
  }
  for (const Number v : inner)
    if (used[v] != 1 && wrong.empty()) wrong = "lines meet at vertex " + std::to_string(v);
  if (used.size() != c.vertices.count && wrong.empty())
    wrong = std::to_string(used.size()) + " vertices on lines, of " +
            std::to_string(c.vertices.count);
  for (auto& [cell, lines] : found) std::sort(lines.begin(), lines.end());
  for (const Json& claim : c.claims["tets"])
    for (std::size_t n = 1; n < claim.size(); ++n)
      claimed[claim[0]].push_back({claim[n][0].get<Number>(), claim[n][1].get<Number>()});
  if (wrong.empty() && found != claimed) {
    const auto differs = std::mismatch(found.begin(), found.end(), claimed.begin(), claimed.end());
    const Number cell = differs.first != found.end() ? differs.first->first : differs.second->first;
    wrong = "lines in tetrahedron " + std::to_string(cell) + " between " +
            Json(found[cell]).dump() + ", claimed " + Json(claimed[cell]).dump();
  }
  ledger.settle(wrong.empty(), "lines", "the pieces claimed", wrong);
}

/// The components of the polylines, whatever the field.
Json components_of(const CurveCase& c) {
  UnionFind joined;
  std::map<std::size_t, std::size_t> ends;  // how many lines end at a vertex
  std::map<std::size_t, std::size_t> lines;
  const Number first = c.lines.first, end = first + c.lines.count;
  for (Number l = first; l < end; ++l) {
    const auto& line = c.curves.lines[l];
    for (const std::uint32_t v : line) joined.join(line[0], v);
    ++ends[line.front()], ++ends[line.back()];
  }
  std::set<std::size_t> open;
  for (const auto& [v, count] : ends)
    if (count == 1) open.insert(joined.find(v));
  for (Number l = first; l < end; ++l) ++lines[joined.find(c.curves.lines[l][0])];
  Json result = Json::array();
  for (const auto& [v, count] : lines)
    result.push_back({{"closed", !open.contains(v)}, {"lines", count}, {"first_vertex", v}});
  return result;
}

}  // namespace

void compare_polylines(const CurveCase& c, Ledger& ledger) {
  compare_lines(c, ledger);
  const Json derived = components_of(c), &claimed = c.claims["curves"];
  for (std::size_t i = 0; i < std::max(derived.size(), claimed.size()); ++i) {
    const Json none, &truth = i < derived.size() ? derived[i] : none,
                     &claim = i < claimed.size() ? claimed[i] : none;
    ledger.settle(claim == truth, "curve " + std::to_string(i), claim.dump(), truth.dump());
    if (!truth.is_null())
      ledger.of_level().components.push_back({0, 0, truth["closed"], truth["lines"]});
  }
}

}  // namespace certificate
