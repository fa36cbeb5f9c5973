// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "extract/level/level_in_tet.hpp"
#include "extract/patch/quality/edge_flips.hpp"
#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

using Id = std::int32_t;
using Triangles = std::vector<std::array<Id, 3>>;
using Edges = std::set<std::pair<Id, Id>>;

/// What is meshed in a mesh of one tetrahedron, as a meshing has it.
struct Drawn {
  TetWithCurves<double> tet;
  std::vector<std::vector<BoundaryVertex>> boundaries{{}};
  Patch<double> triangles;
  std::map<Id, Vector3<double>> points;
  std::map<Id, unsigned> faces;

  Drawn(const TetMesh& mesh, const ScaledField<double>& field, const SurfaceMesh& surface) {
    const auto& corners = mesh.tets[0];
    tet.simplex = field.simplex<4>(corners, std::vector<char>(mesh.points.size(), 0));
    for (std::size_t i = 0; i < 4; ++i) tet.points[i] = mesh.points[as_size(corners[i])];
    const TetGeometry geometry(tet.points, tet.simplex.exponents);
    std::vector<Id> id(surface.points.size());
    for (std::size_t v = 0; v < id.size(); ++v) {
      const auto& x = surface.points[v];
      if (surface.carrier[v] == Carrier::tet) {
        InnerVertex<double> inner;
        for (std::size_t i = 0; i < 4; ++i)
          inner.weights[i] = std::ldexp(geometry.weight(i, x), -tet.simplex.exponents[i]);
        triangles.inner.push_back(inner);
        id[v] = -static_cast<Id>(triangles.inner.size());
      } else {
        BoundaryVertex vertex;
        vertex.id = id[v] = static_cast<Id>(v);
        vertex.position = x;
        const auto& carrier = surface.carrier_vertices[v];
        for (unsigned f = 0; f < 4; ++f)
          if (std::find(carrier.begin(), carrier.end(), corners[f]) == carrier.end())
            vertex.faces = static_cast<std::uint8_t>(vertex.faces | 1u << f);
        boundaries[0].push_back(vertex);
        faces[id[v]] = vertex.faces;
      }
      points[id[v]] = x;
    }
    for (const auto& t : surface.triangles)
      triangles.triangles.push_back({id[as_size(t[0])], id[as_size(t[1])], id[as_size(t[2])]});
  }

  /// The sum over all triangles of a quadratic form in the offsets of their edges' middles.
  double squares(const LevelInTet& level) const {
    return sum([&](const auto& p, const auto& q, const auto& r) {
      const auto offset = [&](const Vector3<double>& u, const Vector3<double>& v) {
        const auto x = 0.5 * (u + v);
        return std::copysign(level.distance(x), level.residual(x));
      };
      const double a = offset(p, q), b = offset(q, r), c = offset(r, p);
      return a * a + b * b + c * c + a * b + b * c + c * a;
    });
  }

  /// Squared distances at places that flips do not look at.
  double squares_inside(const LevelInTet& level) const {
    return sum([&](const auto& p, const auto& q, const auto& r) {
      double result = 0;
      for (const double w : {0.1, 0.3, 0.6, 0.8}) {
        const double d = level.distance(w * p + (0.7 * (1 - w)) * q + (0.3 * (1 - w)) * r);
        result += d * d;
      }
      return result;
    });
  }

  template <class Square>
  double sum(const Square& square) const {
    double result = 0;
    for (const auto& t : triangles.triangles) {
      const auto &p = points.at(t[0]), &q = points.at(t[1]), &r = points.at(t[2]);
      const auto n = cross(q - p, r - p);
      result += std::sqrt(dot(n, n)) * square(p, q, r);
    }
    return result;
  }

  bool on_one_face(Id a, Id b) const {
    const auto p = faces.find(a), q = faces.find(b);
    return p != faces.end() && q != faces.end() && (p->second & q->second) != 0;
  }
};

Edges edges_of(const Triangles& triangles) {
  Edges edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.emplace(t[k], t[(k + 1) % 3]);
  return edges;
}

Edges boundary_of(const Edges& edges) {
  Edges boundary;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) boundary.emplace(a, b);
  return boundary;
}

/// Exchanges the diagonal of triangle i after its corner k, if that leaves a complex.
void exchange(Drawn& patch, std::size_t i, std::size_t k) {
  auto& all = patch.triangles.triangles;
  const Id a = all[i][k], b = all[i][(k + 1) % 3], c = all[i][(k + 2) % 3];
  for (auto& other : all)
    for (std::size_t l = 0; l < 3; ++l) {
      if (other[l] != b || other[(l + 1) % 3] != a) continue;
      const Id d = other[(l + 2) % 3];
      const auto edges = edges_of(all);
      if (c == d || patch.on_one_face(c, d) || edges.contains({c, d}) || edges.contains({d, c}))
        return;
      all[i] = {a, d, c};
      other = {d, b, c};
      return;
    }
}

TEST(EdgeFlips, KeepTheComplexAndBringTheTrianglesCloserToTheLevel) {
  const std::uint64_t seed = 20261122;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  double before = 0, after = 0;
  std::size_t flipped = 0;
  for (int trial = 0; trial < trials(60); ++trial) {
    const auto tensors = random.tet_tensors();
    const TetMesh mesh = reference_tet_mesh(tensors);
    const auto mode = ModeValue::parse(kLevels[static_cast<std::size_t>(trial) % kLevels.size()]);
    const auto extraction = extract_mode_surface<double>(mesh, mode);
    const std::size_t count = extraction.surface.triangles.size();
    if (count < 8 || count > 300) continue;
    const ScaledField<double> field(mesh);
    const auto level = make_level<double>(mode);
    const LevelInTet in_tet(mesh, field, 0, level);
    Drawn patch(mesh, field, extraction.surface);
    for (std::size_t i = 0; i < patch.triangles.triangles.size(); ++i)
      exchange(patch, i, static_cast<std::size_t>(random.integer(0, 2)));
    const auto old_edges = edges_of(patch.triangles.triangles);
    const double squares = patch.squares(in_tet), inside = patch.squares_inside(in_tet);
    flipped += flip_edges<double>(patch.tet, level, patch.boundaries, patch.triangles);

    const auto& now = patch.triangles.triangles;
    const auto edges = edges_of(now);
    EXPECT_EQ(edges.size(), 3 * now.size()) << exact_text(tensors);  // each direction once
    EXPECT_EQ(boundary_of(edges), boundary_of(old_edges)) << exact_text(tensors);
    for (const auto& [a, b] : edges) {
      if (edges.contains({b, a})) {
        EXPECT_FALSE(patch.on_one_face(a, b)) << exact_text(tensors);
      }
    }
    constexpr double kRounding = 1e-9;
    EXPECT_LE(patch.squares(in_tet), (1 + kRounding) * squares) << exact_text(tensors);
    // Of one size each: what a tetrahedron counts does not depend on its surface's area.
    if (inside > 0) before += 1, after += patch.squares_inside(in_tet) / inside;
  }
  EXPECT_GT(flipped, 0u);
  EXPECT_LT(after, 0.9 * before);
}

}  // namespace
}  // namespace tensortopo::test
