// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "extract/cases/curve_checks.hpp"
#include "extract/cases/extract_case.hpp"

// Degenerate curves in special position of which the answer is known.

namespace tensortopo::test {
namespace {

using Index = TetMesh::Index;
using Point = Vector3<double>;

TetMesh sampled(TetMesh mesh, const std::function<SymmetricTensor<double>(const Point&)>& field) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.tensors[v] = field(mesh.points[v]);
  return mesh;
}

/// The cube [-size, size]^3 in 48 tetrahedra, moved.
TetMesh cube_around(const Point& centre, double size) {
  TetMesh mesh = cube_mesh(2);
  for (auto& p : mesh.points) p = centre + size * (p - Point{1, 1, 1});
  return mesh;
}

/// A tetrahedron cut in four at a point of it.
TetMesh split_at(const std::array<Point, 4>& corners, const Point& p) {
  TetMesh mesh;
  mesh.points.assign(corners.begin(), corners.end());
  mesh.points.push_back(p);
  for (Index i = 0; i < 4; ++i) {
    std::array<Index, 4> tet{0, 1, 2, 3};
    tet[static_cast<std::size_t>(i)] = 4;
    mesh.cell_ids.push_back(i);
    mesh.tets.push_back(tet);
  }
  mesh.tensors.resize(5);
  return mesh;
}

const std::array<Point, 4> kCorners{{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, {0, 0, 16}}};

/// What holds the vertex at a place; none if there is no vertex.
std::set<Carrier> carriers_at(const CurveMesh& curves, const Point& p) {
  std::set<Carrier> result;
  for (std::size_t v = 0; v < curves.points.size(); ++v) {
    const auto d = curves.points[v] - p;
    if (dot(d, d) < 1e-20) result.insert(curves.carrier[v]);
  }
  return result;
}

// A linear field has one curve, however its domain is cut, also where the cuts run through a point
// of the curve: there a vertex, an edge or a face of the mesh.
TEST(SpecialCurves, OfALinearFieldDoNotDependOnTheMesh) {
  const std::uint64_t seed = 20250115;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  ExtractOptions options;
  options.sampling.resolution = 100;
  const Point p{4, 3, 5};
  const struct {
    Point cut;
    Carrier carrier;
  } cases[]{{p, Carrier::vertex},
            {p + 0.25 * (p - kCorners[1]), Carrier::edge},
            {p + 0.25 * (p - 0.5 * (kCorners[1] + kCorners[2])), Carrier::face},
            {{3, 4, 2}, Carrier::tet}};
  for (int trial = 0; trial < trials(20); ++trial) {
    SymmetricTensor<double> dx, dy, dz;
    for (auto* t : {&dx, &dy, &dz})
      for (double* entry : {&t->xx, &t->yy, &t->zz, &t->xy, &t->yz, &t->xz})
        *entry = random.integer(-3, 3);
    const Point e{double(random.integer(1, 4)), double(random.integer(-4, 4)),
                  double(random.integer(-4, 4))};
    const double size = trial % 2 == 0 ? 1 : -1;
    const SymmetricTensor<double> degenerate{e.x * e.x, e.y * e.y, e.z * e.z,
                                             e.x * e.y, e.y * e.z, e.x * e.z};
    const auto field = [&](const Point& x) {
      return size * degenerate + (x.x - p.x) * dx + (x.y - p.y) * dy + (x.z - p.z) * dz;
    };
    const Degeneracy kind = kKinds[trial % 2 == 0 ? 0 : 1];
    TetMesh whole = single_tet_mesh(kCorners, {});
    whole = sampled(whole, field);
    const auto expected = extract_degenerate_curves(whole, kind, options);
    ASSERT_EQ(flaws(expected, whole, mode_of(kind)), "");
    for (const auto& [cut, carrier] : cases) {
      TetMesh mesh = split_at(kCorners, cut);
      mesh = sampled(mesh, field);
      const auto found = extract_degenerate_curves(mesh, kind, options);
      ASSERT_TRUE(found.unresolved.empty());
      EXPECT_EQ(flaws(found, mesh, mode_of(kind)), "") << "trial " << trial;
      const auto one = curve_invariants(expected.curves), two = curve_invariants(found.curves);
      EXPECT_EQ(one.components, two.components) << "trial " << trial;
      EXPECT_EQ(one.closed_components, two.closed_components);
      EXPECT_NEAR(one.length, two.length, 1e-3 * one.length) << "trial " << trial;
      for (const Point& x : found.curves.points)
        EXPECT_LT(distance(x, expected.curves), 1e-2) << "trial " << trial;
      if (carrier != Carrier::tet) {
        EXPECT_EQ(carriers_at(found.curves, p), std::set{carrier}) << "trial " << trial;
      }
    }
  }
}

// Interpolated, u u^T + (3 + z) e_z e_z^T with u across the z axis is degenerate on the axis only:
// u turns by about 60 degrees from each vertex around the axis to the next.
TEST(SpecialCurves, OfAnAxisOfSymmetryRunAlongEdgesOnce) {
  const TetMesh mesh = sampled(cube_around({0, 0, 0}, 1), [](const Point& p) {
    const double x = p.x - p.y / 2, y = 7 * p.y / 8;
    return SymmetricTensor<double>{x * x, y * y, 3 + p.z, x * y, 0, 0};
  });
  const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear);
  EXPECT_TRUE(extraction.unresolved.empty());
  EXPECT_EQ(flaws(extraction, mesh, 1), "");
  const auto& curves = extraction.curves;
  ASSERT_EQ(curves.lines.size(), 2u);
  EXPECT_EQ(curve_invariants(curves).length, 2);
  EXPECT_EQ(curve_invariants(curves).components, 1u);
  EXPECT_EQ(curves.points.size(), 3u);
  for (const Carrier carrier : curves.carrier) EXPECT_EQ(carrier, Carrier::vertex);
}

// In plane strain the in-plane isotropic points fill a line along the normal: through cells, faces
// or edges.
TEST(SpecialCurves, OfPlaneStrainAreLinesAlongTheNormal) {
  for (const Point& axis :
       {Point{0, 0, 0}, Point{0.25, 0.25, 0}, Point{0.5, 0, 0}, Point{0.25, 0.125, 0}}) {
    const auto field = [&](double normal) {
      return sampled(cube_around({0, 0, 0}, 1), [&](const Point& p) {
        return SymmetricTensor<double>{p.x - axis.x, axis.x - p.x, normal, p.y - axis.y, 0, 0};
      });
    };
    const TetMesh far = field(16), near = field(0.5);
    const auto lines = extract_degenerate_curves(far, Degeneracy::linear);
    EXPECT_EQ(flaws(lines, far, 1), "");
    EXPECT_TRUE(lines.unresolved.empty());
    EXPECT_EQ(curve_invariants(lines.curves).components, 1u);
    EXPECT_DOUBLE_EQ(curve_invariants(lines.curves).length, 2);
    EXPECT_TRUE(extract_degenerate_curves(far, Degeneracy::planar).curves.lines.empty());
    // The cylinder on which an in-plane eigenvalue is that of the normal is a surface of mode -1.
    const auto beside = extract_degenerate_curves(near, Degeneracy::linear);
    EXPECT_TRUE(beside.unresolved.empty());
    EXPECT_DOUBLE_EQ(curve_invariants(beside.curves).length, 2);
    const auto surface = extract_degenerate_curves(near, Degeneracy::planar);
    EXPECT_TRUE(surface.curves.lines.empty());
    EXPECT_FALSE(surface.unresolved.empty());
    for (const auto& cell : surface.unresolved)
      EXPECT_EQ(cell.obstacle, CurveObstacle::degenerate_on_a_surface);
  }
}

// [[1+x, y, z], [y, 1-x, 0], [z, 0, -2]]: mode 1 on the circle of radius 3 in the plane z = 0, and
// on the branch x >= 3 of 2 x (x - 3) = z^2 in the plane y = 0; they cross at (3, 0, 0).
TEST(SpecialCurves, OfANeutralCharacteristicTensorCrossThemselves) {
  const auto field = [](const Point& p) {
    return SymmetricTensor<double>{1 + p.x, 1 - p.x, -2, p.y, 0, p.z};
  };
  const TetMesh meshes[]{
      sampled(cube_around({0, 0, 0}, 4), field), sampled(cube_around({0, 0, 0.5}, 4), field),
      sampled(cube_around({0.25, 0.5, 0.125}, 4.5), field),
      sampled(cube_around({3, 0, 0}, 8), field),
      sampled(single_tet_mesh({{{-32, -32, -32}, {32, 32, -32}, {-32, 32, 32}, {32, -32, 32}}}, {}),
              field)};
  ExtractOptions options;
  options.sampling.resolution = 100;
  for (const TetMesh& mesh : meshes) {
    const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear, options);
    EXPECT_TRUE(extraction.unresolved.empty());
    EXPECT_EQ(flaws(extraction, mesh, 1), "");
    const auto& curves = extraction.curves;
    EXPECT_EQ(curve_invariants(curves).components, 1u);
    double circle = 0;
    std::map<Index, int> ends;
    for (const auto& line : curves.lines) {
      ++ends[line.front()], ++ends[line.back()];
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto& a = curves.points[static_cast<std::size_t>(line[i])];
        const auto& b = curves.points[static_cast<std::size_t>(line[i + 1])];
        if (std::abs(a.z) + std::abs(b.z) > 1e-9) continue;
        circle += std::sqrt(dot(b - a, b - a));
      }
    }
    EXPECT_NEAR(circle, 6 * std::acos(-1.0), 1e-3);
    int junctions = 0, loose = 0;
    for (const auto& [v, count] : ends) {
      const auto d = curves.points[static_cast<std::size_t>(v)] - Point{3, 0, 0};
      if (count == 4) {
        ++junctions;
        EXPECT_LT(dot(d, d), 1e-20);
      }
      loose += count == 1;
    }
    EXPECT_EQ(junctions, 1);
    EXPECT_EQ(loose, 2);
  }
}

// A closed curve inside one face: it has no point on the face's boundary.
TEST(SpecialCurves, InAPlaneOfSymmetryMayCloseInOneFace) {
  TetMesh mesh;
  mesh.points = {{-16, -8, 0}, {16, -8, 0}, {0, 16, 0}, {0, 0, 16}, {0, 0, -16}};
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.cell_ids = {0, 1};
  mesh.tensors.resize(5);
  mesh = sampled(mesh, [](const Point& p) {
    return SymmetricTensor<double>{1 + p.x, 1 - p.x, -2 - p.z, p.y, p.z, std::abs(p.z)};
  });
  const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear);
  EXPECT_TRUE(extraction.unresolved.empty());
  EXPECT_EQ(flaws(extraction, mesh, 1, CurveEnds::free), "");
  std::size_t in_face = 0;
  for (const Carrier carrier : extraction.curves.carrier) in_face += carrier == Carrier::face;
  EXPECT_GT(in_face, 10u);
  for (const Point& p : extraction.curves.points) {
    if (std::abs(p.z) < 1e-9) {
      EXPECT_NEAR(p.x * p.x + p.y * p.y, 9, 1e-12);
    }
  }
}

// Around an isotropic vertex there is one ray for each degenerate point of the faces
// opposite.
TEST(SpecialCurves, AroundAVertexWithoutDeviatorAreRays) {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20250110);
  constexpr Index centre = 13;
  mesh.tensors[centre] = {7, 7, 7, 0, 0, 0};
  for (const Degeneracy kind : kKinds) {
    const auto extraction = extract_degenerate_curves(mesh, kind);
    EXPECT_TRUE(extraction.unresolved.empty());
    EXPECT_EQ(flaws(extraction, mesh, mode_of(kind)), "");
    const auto& curves = extraction.curves;
    std::size_t rays = 0, opposite = 0;
    for (std::size_t l = 0; l < curves.lines.size(); ++l) {
      const auto& tet = mesh.tets[static_cast<std::size_t>(curves.tet[l])];
      const bool around = std::find(tet.begin(), tet.end(), centre) != tet.end();
      for (const Index v : {curves.lines[l].front(), curves.lines[l].back()}) {
        const auto& key = curves.carrier_vertices[static_cast<std::size_t>(v)];
        rays += key[0] == centre && key[1] == -1;
        opposite += around && std::find(key.begin(), key.end(), centre) == key.end();
      }
      if (around) {
        EXPECT_EQ(curves.lines[l].size(), 2u);
      }
    }
    EXPECT_GT(rays, 0u);
    EXPECT_EQ(rays, opposite);
  }
}

TEST(SpecialCurves, OfConstantFieldsAreNamed) {
  for (const double sign : {1.0, -1.0}) {
    const TetMesh mesh = sampled(cube_mesh(1), [&](const Point& p) {
      return (sign * (1 + p.x)) * SymmetricTensor<double>{2, -1, -1, 0, 0, 0};
    });
    for (const Degeneracy kind : kKinds) {
      const auto extraction = extract_degenerate_curves(mesh, kind);
      EXPECT_TRUE(extraction.curves.lines.empty());
      EXPECT_EQ(extraction.unresolved.size(), mode_of(kind) == sign ? mesh.tets.size() : 0);
      for (const auto& cell : extraction.unresolved)
        EXPECT_EQ(cell.obstacle, CurveObstacle::degenerate_throughout);
    }
  }
}

/// e e^T - I / 3 with e = (1, 2, 2) / 3, times 9: oblique to the axes.
constexpr SymmetricTensor<double> kOblique{-2, 1, 1, 2, 4, 2};

TEST(SpecialCurves, OfUniaxialFieldsAreNamedWithoutCountingFaces) {
  const TetMesh mesh =
      sampled(cube_mesh(3), [](const Point& p) { return (1 + p.x + p.y * p.z) * kOblique; });
  const auto linear = extract_degenerate_curves(mesh, Degeneracy::linear);
  EXPECT_EQ(linear.unresolved.size(), mesh.tets.size());
  EXPECT_EQ(linear.statistics.faces, 0u);
  EXPECT_TRUE(linear.curves.lines.empty());
  EXPECT_TRUE(extract_degenerate_curves(mesh, Degeneracy::planar).unresolved.empty());
}

// Rounded to a few digits such a field has curves of its rounding, which doubles find.
TEST(SpecialCurves, OfRoundedUniaxialFieldsNeedNoMoreDigits) {
  const Point e{0.32145, 0.54723, 0.77279};
  for (const double size : {1e-6, 1e-9}) {
    const TetMesh mesh = sampled(cube_mesh(3), [&](const Point& p) {
      const double s = 1 + 0.3 * p.x + 0.2 * std::sin(3 * p.y) + 0.1 * p.z * p.z;
      SymmetricTensor<double> t =
          s * SymmetricTensor<double>{e.x * e.x, e.y * e.y, e.z * e.z,
                                      e.x * e.y, e.y * e.z, e.x * e.z};
      for (double* x : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz}) *x = size * std::round(*x / size);
      return t;
    });
    const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear);
    EXPECT_TRUE(extraction.unresolved.empty());
    EXPECT_EQ(flaws(extraction, mesh, mode_of(Degeneracy::linear), CurveEnds::free), "");
    EXPECT_GT(extraction.statistics.face_points, 20u);
    EXPECT_LT(extraction.statistics.faces_exact * 20, extraction.statistics.faces);
  }
}

// Beside a uniaxial part the curves of the other part are found as before.
TEST(SpecialCurves, BesideAUniaxialPartOnlyItsOwnCellsAreThroughout) {
  const TetMesh mesh = sampled(cube_mesh(4), [](const Point& p) {
    SymmetricTensor<double> t = (1 + p.y) * kOblique;
    if (p.x > 2) t = t + (p.x - 2) * SymmetricTensor<double>{1, p.z, -1, p.y, 0.5, 1 - p.z};
    return t;
  });
  const auto extraction = extract_degenerate_curves(mesh, Degeneracy::linear);
  std::size_t throughout = 0, others = 0;
  for (const auto& cell : extraction.unresolved) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(cell.tet)];
    const bool is_uniaxial = std::all_of(tet.begin(), tet.end(), [&](TetMesh::Index v) {
      return mesh.points[static_cast<std::size_t>(v)].x <= 2;
    });
    EXPECT_EQ(cell.obstacle == CurveObstacle::degenerate_throughout, is_uniaxial);
    throughout += is_uniaxial;
    others += !is_uniaxial;
  }
  EXPECT_EQ(throughout, mesh.tets.size() / 2);
  EXPECT_LT(others, mesh.tets.size() / 2);
}

}  // namespace
}  // namespace tensortopo::test
