// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "exact_level.hpp"
#include "support/generators.hpp"

namespace tensortopo::test {
namespace {

InvariantLevel level_of(Invariant invariant, const char* text) {
  return InvariantLevel::parse(invariant, text);
}

/// |T| is the distance from a centre.
TetMesh distance_field(TetMesh mesh, const Vector3<double>& centre) {
  mesh.tensors.clear();
  for (const auto& p : mesh.points)
    mesh.tensors.push_back({p.x - centre.x, p.y - centre.y, p.z - centre.z, 0, 0, 0});
  return mesh;
}

/// Edges with one triangle that are not in a face of the mesh with one tetrahedron.
int open_edges_inside(const SurfaceMesh& surface, const TetMesh& mesh) {
  std::map<std::set<SurfaceMesh::Index>, int> faces;
  for (const auto& tet : mesh.tets)
    for (const auto left_out : tet) {
      std::set<SurfaceMesh::Index> face(tet.begin(), tet.end());
      face.erase(left_out);
      ++faces[face];
    }
  std::map<std::set<SurfaceMesh::Index>, int> edges;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  int result = 0;
  for (const auto& [edge, count] : edges) {
    if (count != 1) continue;
    std::set<SurfaceMesh::Index> carrier;
    for (const auto v : edge)
      for (const auto id : surface.carrier_vertices[static_cast<std::size_t>(v)])
        if (id >= 0) carrier.insert(id);
    const bool is_on_boundary = std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
      return face.second == 1 &&
             std::includes(face.first.begin(), face.first.end(), carrier.begin(), carrier.end());
    });
    result += !is_on_boundary;
  }
  return result;
}

TEST(InvariantSurface, OfADistanceInsideOneTetrahedronIsASphere) {
  const auto mesh = distance_field(reference_tet_mesh({}), {0.25, 0.2, 0.2});
  const auto level = level_of(Invariant::magnitude, "0.125");
  double last = 2;
  for (const int pieces : {1, 4, 8, 16}) {
    const auto found = extract_invariant_surface(mesh, level, in_pieces(pieces));
    const auto known = surface_invariants(found.surface);
    EXPECT_EQ(topology(found), (std::vector<std::vector<long>>{{2, 0}})) << pieces;
    EXPECT_TRUE(known.manifold && known.closed && known.consistently_oriented);
    const double error = 1 - known.area / (4 * std::numbers::pi * 0.125 * 0.125);
    EXPECT_GT(error, 0);  // inscribed
    EXPECT_LT(error, 0.5 * last);
    last = error;
    for (const double r : found.surface.residual) EXPECT_LT(std::abs(r), 1e-12);
    for (std::size_t v = 0; v < found.surface.points.size(); ++v) {
      const Vector3<double> out = found.surface.points[v] - Vector3<double>{0.25, 0.2, 0.2};
      EXPECT_NEAR(dot(out, found.surface.normal[v]), 0.125, 1e-12);
    }
  }
  EXPECT_LT(last, 0.03);
}

TEST(InvariantSurface, OfADistanceOverManyTetrahedraConvergesToASphere) {
  double last = 1;
  for (const int n : {2, 4, 8}) {
    auto mesh = cube_mesh(n);
    Vector3<double> centre{};
    for (const auto& p : mesh.points) centre += (1.0 / static_cast<double>(mesh.points.size())) * p;
    double radius = 0;
    for (const auto& p : mesh.points) radius = std::max(radius, std::abs(p.x - centre.x));
    mesh = distance_field(std::move(mesh), centre);
    const auto level = level_at(Invariant::magnitude, Rational(radius) * Rational(2, 3));
    const auto found = extract_invariant_surface(mesh, level);
    EXPECT_EQ(topology(found), (std::vector<std::vector<long>>{{2, 0}})) << n;
    const double r = level.approx();
    const double area = surface_invariants(found.surface).area;
    const double error = 1 - area / (4 * std::numbers::pi * r * r);
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 0.35 * last) << n;
    last = error;
  }
}

RC_GTEST_PROP(InvariantSurface, OverRandomMeshesIsSeamless, ()) {
  auto mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, *rc::gen::arbitrary<std::uint64_t>());
  // Integers put vertices, edges and faces on the level and make zero tensors.
  if (*rc::gen::arbitrary<bool>())
    for (auto& t : mesh.tensors) t = rounded(t, 0);
  const int pieces = *rc::gen::inRange(1, 4);
  for (const auto& level :
       {level_of(Invariant::magnitude, "2"), level_of(Invariant::deviator_magnitude, "2"),
        level_of(Invariant::anisotropy, "1/2"), level_of(Invariant::anisotropy, "49/50")}) {
    const auto found = extract_invariant_surface(mesh, level, in_pieces(pieces));
    const auto known = surface_invariants(found.surface);
    RC_ASSERT(known.consistently_oriented);
    RC_ASSERT(known.manifold);
    if (level.invariant() != Invariant::anisotropy) RC_ASSERT(found.zero_tensor.empty());
    for (const double r : found.surface.residual) RC_ASSERT(std::abs(r) < 1e-10);
    if (!found.zero_tensor.empty()) continue;
    RC_ASSERT(open_edges_inside(found.surface, mesh) == 0);
    std::set<std::array<double, 3>> places;
    for (const auto& p : found.surface.points) places.insert({p.x, p.y, p.z});
    RC_ASSERT(places.size() == found.surface.points.size());
  }
}

RC_GTEST_PROP(InvariantSurface, ScalesWithPowersOfTwo, ()) {
  auto mesh = cube_mesh(1);
  fill_with_normal_tensors(mesh, *rc::gen::arbitrary<std::uint64_t>());
  const int exponent = *rc::gen::element(-900, -300, -1, 3, 500, 900);
  auto scaled = mesh;
  for (auto& t : scaled.tensors) t = std::ldexp(1.0, exponent) * t;
  const Rational factor = exponent < 0 ? Rational(1, boost::multiprecision::mpz_int(1) << -exponent)
                                       : Rational(boost::multiprecision::mpz_int(1) << exponent);
  for (const auto invariant :
       {Invariant::magnitude, Invariant::deviator_magnitude, Invariant::anisotropy}) {
    const auto level = level_of(invariant, "2/3");
    const auto other =
        invariant == Invariant::anisotropy ? level : level_at(invariant, Rational(2, 3) * factor);
    const auto a = extract_invariant_surface(mesh, level);
    const auto b = extract_invariant_surface(scaled, other);
    RC_ASSERT(a.surface.points == b.surface.points);
    RC_ASSERT(a.surface.triangles == b.surface.triangles);
  }
}

TEST(InvariantSurface, DoesNotDependOnTheNumberOfThreads) {
  auto mesh = cube_mesh(4);
  fill_with_smooth_tensors(mesh, 7);
  const auto level = level_of(Invariant::anisotropy, "3/4");
  const auto all = extract_invariant_surface(mesh, level);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto alone = extract_invariant_surface(mesh, level);
  ASSERT_FALSE(all.surface.triangles.empty());
  EXPECT_EQ(all.surface.points, alone.surface.points);
  EXPECT_EQ(all.surface.triangles, alone.surface.triangles);
  EXPECT_EQ(all.surface.normal, alone.surface.normal);
  EXPECT_EQ(all.surface.residual, alone.surface.residual);
}

TEST(InvariantSurface, ThatTouchesAnEdgeHasAHandleThere) {
  // |T| is least on the edge 01, with value exactly 1, in its middle: at 1 + 0 a half disc on
  // each of the two faces there, joined across the edge.
  const SymmetricTensor<double> a{1, 1, 0, 0, 0, 0}, b{-1, 1, 0, 0, 0, 0}, c{0, 2, 2, 0, 0, 0},
      d{0, 2, -2, 0, 0, 0};
  const auto found = extract_invariant_surface(reference_tet_mesh({a, b, c, d}),
                                               level_of(Invariant::magnitude, "1"));
  EXPECT_EQ(topology(found), (std::vector<std::vector<long>>{{1, 1}}));
  const auto on_edge =
      std::count(found.surface.carrier.begin(), found.surface.carrier.end(), Carrier::edge);
  EXPECT_EQ(on_edge, 2);
  const auto below = extract_invariant_surface(reference_tet_mesh({a, b, c, d}),
                                               level_of(Invariant::magnitude, "0.999999999999"));
  EXPECT_TRUE(below.surface.triangles.empty());
}

TEST(InvariantSurface, ConstantInACellIsBelowAndItsNeighboursEndThere) {
  auto mesh = cube_mesh(2);
  mesh.tensors.assign(mesh.points.size(), {1, 1, 1, 0, 1, 0});
  mesh.tensors[0] = {2, 2, 2, 0, 0, 0};
  for (const auto& level :
       {level_of(Invariant::deviator_magnitude, "1"), level_of(Invariant::magnitude, "5/2")}) {
    const auto found = extract_invariant_surface(mesh, level);
    EXPECT_TRUE(found.zero_tensor.empty());
    EXPECT_EQ(open_edges_inside(found.surface, mesh), 0);
  }
  mesh.tensors.assign(mesh.points.size(), {3, 0, 0, 0, 2, 2});
  const auto five = level_of(Invariant::magnitude, "5");
  const auto none = extract_invariant_surface(mesh, five);
  EXPECT_TRUE(none.surface.triangles.empty());
  EXPECT_EQ(none.statistics.vertices_on_level, mesh.points.size());
  mesh.tensors[13] = {6, 0, 0, 0, 4, 4};  // the middle vertex alone is above
  const auto around = extract_invariant_surface(mesh, five);
  EXPECT_EQ(topology(around), (std::vector<std::vector<long>>{{2, 0}}));
}

TEST(InvariantSurface, OfAnAnisotropyNamesZeroTensorsThatMatter) {
  auto mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  mesh.tensors[13] = {};
  const auto found = extract_invariant_surface(mesh, level_of(Invariant::anisotropy, "0.9"));
  ASSERT_FALSE(found.zero_tensor.empty());
  for (const auto t : found.zero_tensor) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(t)];
    EXPECT_TRUE(std::find(tet.begin(), tet.end(), 13) != tet.end());
    EXPECT_EQ(std::count(found.surface.tet.begin(), found.surface.tet.end(), t), 0);
  }
  EXPECT_TRUE(
      extract_invariant_surface(mesh, level_of(Invariant::magnitude, "0.9")).zero_tensor.empty());
}

/// Tetrahedra that are left out may cut a surface in two around a vertex: two fans, two vertices.
TEST(InvariantSurface, IsAManifoldBesideZeroTensors) {
  constexpr std::uint64_t kSeed = 20241203;
  Random random(kSeed);
  std::size_t cut = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto mesh = cube_mesh(2);
    fill_with_normal_tensors(mesh, kSeed + static_cast<std::uint64_t>(trial));
    for (int i = 0; i < 6; ++i)
      mesh.tensors[static_cast<std::size_t>(random.integer(0, 26))] = {};
    const auto found = extract_invariant_surface(mesh, level_of(Invariant::anisotropy, "0.9"));
    const auto known = surface_invariants(found.surface);
    EXPECT_TRUE(known.manifold) << "trial " << trial;
    EXPECT_EQ(known.component, found.surface.component);
    std::set<std::array<double, 3>> places;
    for (const auto& p : found.surface.points) places.insert({p.x, p.y, p.z});
    cut += found.surface.points.size() - places.size();
  }
  EXPECT_GT(cut, 0u);
}

TEST(InvariantSurface, RefusesPiecesThatAreNone) {
  const auto mesh = cube_mesh(1);
  EXPECT_THROW(extract_invariant_surface(mesh, level_of(Invariant::magnitude, "1"), in_pieces(0)),
               std::invalid_argument);
  EXPECT_THROW(extract_invariant_surface(mesh, level_of(Invariant::magnitude, "1"), in_pieces(257)),
               std::invalid_argument);
}

}  // namespace
}  // namespace tensortopo::test
