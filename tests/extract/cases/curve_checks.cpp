// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "curve_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "support/oracles/high_precision_mode.hpp"
#include "tensortopo/scalar/real.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;
using Face = std::array<Index, 3>;

struct PreciseTensor {
  double residual = 0;   ///< sqrt(1 - mode^2)
  double rounding = 0;   ///< what one unit in the last place of each coordinate explains
  bool positive = true;  ///< the determinant
};

double last_place(double x) {
  const double size = std::abs(x);
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

PreciseTensor precise_tensor(const TetMesh& mesh, Index tet, const Vector3<double>& x) {
  using Vector = Vector3<Real50>;
  const auto wide = [](const Vector3<double>& v) {
    return Vector{Real50(v.x), Real50(v.y), Real50(v.z)};
  };
  const auto& corners = mesh.tets[as_size(tet)];
  std::array<Vector, 4> p;
  std::array<Deviator<Real50>, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    p[i] = wide(mesh.points[as_size(corners[i])]);
    const auto& t = mesh.tensors[as_size(corners[i])];
    tensors[i] = deviator(tensor_cast<Real50>(t));
  }
  const Vector u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
  const Real50 scale = Real50(1) / dot(cross(u, v), w);
  const std::array<Vector, 3> gradient{scale * cross(v, w), scale * cross(w, u),
                                       scale * cross(u, v)};
  const auto along = [&](const Vector& direction) {
    Deviator<Real50> d{};
    for (std::size_t i = 0; i < 3; ++i)
      d = d + dot(gradient[i], direction) * (tensors[i + 1] - tensors[0]);
    return d;
  };
  const auto t = tensors[0] + along(wide(x) - p[0]);
  const Real50 size = norm_form(t);
  PreciseTensor result;
  result.residual =
      static_cast<double>(Real50(sqrt(Real50(54 * discriminant_form(t) / (size * size * size)))));
  result.positive = determinant_form(t) > 0;
  const std::array<Vector3<double>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<double, 3> steps{last_place(x.x), last_place(x.y), last_place(x.z)};
  for (std::size_t k = 0; k < 3; ++k)
    result.rounding +=
        3 * std::acos(-1.0) / 2 * steps[k] *
        static_cast<double>(Real50(sqrt(Real50(norm_form(along(wide(axes[k]))) / size))));
  return result;
}

class Checker {
 public:
  Checker(const CurveExtraction& extraction, const TetMesh& mesh, double mode, CurveEnds ends)
      : extraction_(extraction),
        curves_(extraction.curves),
        mesh_(mesh),
        mode_(mode),
        ends_(ends) {}

  std::string run() {
    check_lengths();
    if (!complaints_.str().empty()) return complaints_.str();
    check_lines();
    check_components();
    check_ends();
    for (std::size_t l = 0; l < curves_.lines.size(); ++l)
      for (const Index v : curves_.lines[l]) check_place(v, curves_.tet[l]);
    return complaints_.str();
  }

 private:
  template <class First, class... Rest>
  void complain(const First& first, const Rest&... rest) {
    if (++count_ > 5) return;
    complaints_ << first;
    (complaints_ << ... << rest) << '\n';
  }

  void check_lengths() {
    const std::size_t points = curves_.points.size(), lines = curves_.lines.size();
    for (const std::size_t size : {curves_.carrier.size(), curves_.carrier_vertices.size(),
                                   curves_.dominant_eigenvector.size(), curves_.mode.size(),
                                   curves_.separation.size(), curves_.residual.size()})
      if (size != points) complain("an array has ", size, " entries for ", points, " points");
    for (const std::size_t size : {curves_.tet.size(), curves_.component.size()})
      if (size != lines) complain("an array has ", size, " entries for ", lines, " lines");
    const std::set<Index> held(curves_.tet.begin(), curves_.tet.end());
    if (extraction_.statistics.tets_crossed != held.size())
      complain(extraction_.statistics.tets_crossed, " tetrahedra crossed, lines in ", held.size());
    for (const double m : curves_.mode)
      if (m != mode_) complain("mode ", m);
    for (const double s : curves_.separation)
      if (!std::isfinite(s)) complain("separation ", s);
    for (const auto& e : curves_.dominant_eigenvector)
      if (dot(e, e) != 0 && !(std::abs(dot(e, e) - 1) < 1e-14))
        complain("an eigenvector of length ", dot(e, e));
  }

  std::array<Index, 4> corners(Index tet) const {
    auto result = mesh_.tets[as_size(tet)];
    std::sort(result.begin(), result.end());
    return result;
  }

  static std::set<Index> vertices_of(const std::array<Index, 4>& key) {
    std::set<Index> result(key.begin(), key.end());
    result.erase(-1);
    return result;
  }

  static bool is_part(const std::array<Index, 4>& key, const std::array<Index, 4>& of) {
    const auto part = vertices_of(key), whole = vertices_of(of);
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
  }

  void check_lines() {
    std::set<Index> used;
    std::set<std::pair<Index, Index>> straight;
    for (std::size_t v = 0; v < curves_.points.size(); ++v) {
      const auto count = vertices_of(curves_.carrier_vertices[v]).size();
      constexpr std::array<Carrier, 5> carriers{Carrier::vertex, Carrier::vertex, Carrier::edge,
                                                Carrier::face, Carrier::tet};
      if (count == 0 || curves_.carrier[v] != carriers[count]) complain("wrong carrier at ", v);
    }
    for (std::size_t l = 0; l < curves_.lines.size(); ++l) {
      const auto& line = curves_.lines[l];
      const auto tet = corners(curves_.tet[l]);
      used.insert(line.begin(), line.end());
      const auto key = [&](std::size_t i) { return curves_.carrier_vertices[as_size(line[i])]; };
      for (std::size_t i = 0; i < line.size(); ++i)
        if (!is_part(key(i), tet)) complain("line ", l, " is not in its tetrahedron");
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        if (key(i) != key(1)) complain("line ", l, " leaves its cell");
      if (line.size() > 2 && !(is_part(key(0), key(1)) && is_part(key(line.size() - 1), key(1))))
        complain("line ", l, " ends away from its cell");
      // A curve inside one cell may close up.
      const bool closed = line.front() == line.back();
      if (std::set<Index>(line.begin(), line.end()).size() + closed != line.size() ||
          (closed && line.size() < 4))
        complain("line ", l, " repeats a vertex");
      // Along an edge.
      const auto to = vertices_of(key(line.size() - 1));
      auto both = vertices_of(key(0));
      both.insert(to.begin(), to.end());
      if (both.size() == 2 && line.size() == 2 &&
          !straight.insert(std::minmax(line[0], line[1])).second)
        complain("line ", l, " is there already");
    }
    if (used.size() != curves_.points.size()) complain("vertices that no line uses");
  }

  void check_components() {
    std::map<Index, int> ends;
    for (const auto& line : curves_.lines) ++ends[line.front()], ++ends[line.back()];
    for (std::size_t l = 1; l < curves_.lines.size(); ++l) {
      const Index last = curves_.component[l - 1], next = curves_.component[l];
      if (next != last && next != last + 1) complain("component ", next, " after ", last);
      if (next == last && curves_.lines[l].front() != curves_.lines[l - 1].back() &&
          (ends[curves_.lines[l].front()] == 2 || ends[curves_.lines[l - 1].back()] == 2))
        complain("line ", l, " does not follow the one before");
    }
    const auto invariants = curve_invariants(curves_);
    const std::size_t counted =
        curves_.component.empty() ? 0 : as_size(curves_.component.back()) + 1;
    if (invariants.components != counted)
      complain(counted, " components for ", invariants.components);
  }

  void check_ends() {
    std::set<Index> unresolved;
    for (const auto& cell : extraction_.unresolved) {
      unresolved.insert(cell.tet);
      if (cell.obstacle == CurveObstacle::degenerate_on_a_surface) surfaces_.insert(cell.tet);
    }
    for (std::size_t l = 0; l < curves_.lines.size(); ++l)
      if (unresolved.contains(curves_.tet[l]) && !surfaces_.contains(curves_.tet[l]))
        complain("a line in an unresolved tetrahedron");
    if (ends_ == CurveEnds::free) return;
    std::map<Face, int> tets_at;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const auto tet = corners(static_cast<Index>(t));
      for (std::size_t i = 0; i < 4; ++i) {
        Face face;
        for (std::size_t k = 0, n = 0; k < 4; ++k)
          if (k != i) face[n++] = tet[k];
        ++tets_at[face];
      }
    }
    std::vector<std::array<Index, 4>> borders;
    for (const auto& [face, count] : tets_at)
      if (count == 1) borders.push_back({face[0], face[1], face[2], -1});
    for (const Index t : unresolved) borders.push_back(corners(t));
    std::map<Index, int> ends;
    for (const auto& line : curves_.lines) ++ends[line.front()], ++ends[line.back()];
    for (const auto& [v, count] : ends) {
      const auto& e = curves_.dominant_eigenvector[as_size(v)];
      if (dot(e, e) == 0 || count % 2 == 0) continue;
      const auto& key = curves_.carrier_vertices[as_size(v)];
      if (std::none_of(borders.begin(), borders.end(),
                       [&](const auto& border) { return is_part(key, border); }))
        complain("vertex ", v, " inside ends ", count, " lines");
    }
  }

  void check_place(Index v, Index tet) {
    const auto& x = curves_.points[as_size(v)];
    const auto& e = curves_.dominant_eigenvector[as_size(v)];
    if (dot(e, e) == 0) return;  // no deviator, no mode
    const auto t = precise_tensor(mesh_, tet, x);
    if (!(t.residual <= t.rounding))
      complain("vertex ", v, ": residual ", t.residual, ", rounding explains ", t.rounding);
    if (t.positive != (mode_ > 0)) complain("vertex ", v, " is of the other kind");
    const auto place = precise_mode(mesh_, tet, x, mode_);
    for (std::size_t i = 0; i < 4; ++i)
      if (place.barycentric[i] < -2 * place.barycentric_rounding[i])
        complain("vertex ", v, " is outside by ", place.barycentric[i]);
  }

  const CurveExtraction& extraction_;
  const CurveMesh& curves_;
  const TetMesh& mesh_;
  const double mode_;
  const CurveEnds ends_;
  std::set<Index> surfaces_;  ///< tetrahedra with degenerate surfaces
  std::ostringstream complaints_;
  int count_ = 0;
};

}  // namespace

std::string flaws(const CurveExtraction& extraction, const TetMesh& mesh, double mode,
                  CurveEnds ends) {
  return Checker(extraction, mesh, mode, ends).run();
}

double distance(const Vector3<double>& x, const CurveMesh& curves) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& line : curves.lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const auto& a = curves.points[as_size(line[i])];
      const auto d = curves.points[as_size(line[i + 1])] - a;
      const double size = dot(d, d);
      const double t = size > 0 ? std::clamp(dot(x - a, d) / size, 0.0, 1.0) : 0;
      const auto away = a + t * d - x;
      least = std::min(least, dot(away, away));
    }
  return std::sqrt(least);
}

std::map<std::int64_t, Away> away_from(const CurveMesh& other, const CurveMesh& curves,
                                       std::size_t each) {
  std::map<std::int64_t, Away> result;
  for (std::size_t l = 0; l < curves.lines.size(); ++l) {
    Away& away = result[curves.component[l]];
    for (std::size_t i = 0; i < curves.lines[l].size(); ++i) {
      const auto point = [&](std::size_t k) {
        return curves.points[static_cast<std::size_t>(curves.lines[l][k])];
      };
      if (i % each == 0) away.distance = std::max(away.distance, distance(point(i), other));
      const auto step = point(i) - point(i > 0 ? i - 1 : 0);
      away.length += std::sqrt(dot(step, step));
    }
  }
  return result;
}

}  // namespace tensortopo::test
