// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numbers>

#include "persistence/linked_mesh.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/trials.hpp"
#include "tensortopo/persistence/certified_linking.hpp"
#include "tensortopo/persistence/linking_number.hpp"
#include "tensortopo/persistence/mode_regions.hpp"

namespace tensortopo::test {
namespace {

std::vector<PlaceBox> boxes_around(const std::vector<Vector3<double>>& points, double radius) {
  std::vector<PlaceBox> boxes;
  for (const auto& p : points)
    boxes.push_back(
        {{p.x - radius, p.y - radius, p.z - radius}, {p.x + radius, p.y + radius, p.z + radius}});
  return boxes;
}

std::vector<Vector3<double>> random_polygon(Random& random) {
  std::vector<Vector3<double>> points;
  for (int i = 0; i < 12; ++i)
    points.push_back({random.normal(), random.normal(), random.normal()});
  return points;
}

// Any polygons in the boxes have the number that is proved for the boxes.
TEST(EnclosedLinkingNumber, IsThatOfPolygonsInside) {
  Random random(20261110);
  Compared polygons("polygons inside boxes", 500), linked("linked ones", 100);
  std::map<int, int> numbers;
  for (int trial = 0; trial < trials(300, 150); ++trial) {
    const auto a = random_polygon(random), b = random_polygon(random);
    const double radius = trial % 2 == 0 ? 1e-9 : 1e-3;
    const auto number = enclosed_linking_number(boxes_around(a, radius), boxes_around(b, radius));
    if (!number) continue;
    ++numbers[*number];
    for (int k = 0; k < 4; ++k) {
      auto p = a, q = b;
      for (auto* points : {&p, &q})
        for (auto& x : *points) {
          const auto shift = [&] { return k == 0 ? 0 : radius * (2 * random.uniform() - 1); };
          x += Vector3<double>{shift(), shift(), shift()};
        }
      EXPECT_EQ(linking_number(p, q), number);
      ++polygons;
      linked.count(*number != 0);
    }
  }
  EXPECT_GT(numbers.size(), 3u);
}

TEST(EnclosedLinkingNumber, IsNotKnownWhereBoxesMeet) {
  Random random(20261111);
  const auto a = random_polygon(random);
  EXPECT_EQ(enclosed_linking_number(boxes_around(a, 1e-9), boxes_around(a, 1e-9)), std::nullopt);
}

// The numbers of the curves are those of the polygons extracted, which are found by another method
// and are isotopic to them where all goes well.
TEST(CertifiedLinks, AreThoseOfExtractedPolygons) {
  Compared pairs("pairs of closed curves", 200), near("pairs with a tetrahedron in common", 1);
  Compared linked("linked pairs", 2);
  std::map<LinkObstacle, int> obstacles;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    TetMesh mesh = cube_mesh(5);
    fill_with_normal_tensors(mesh, 20261112 + seed);
    if (seed > 6) mesh = linked_mesh(seed);
    std::array<CurveExtraction, 2> extractions{extract_degenerate_curves(mesh, Degeneracy::linear),
                                               extract_degenerate_curves(mesh, Degeneracy::planar)};
    const CurveArcs linear(mesh, Degeneracy::linear, extractions[0].curves),
        planar(mesh, Degeneracy::planar, extractions[1].curves);
    CertifiedLinks links(mesh);
    std::vector<std::vector<Vector3<double>>> polygons;
    std::vector<std::vector<TetMesh::Index>> tets;
    for (const CurveArcs* arcs : {&linear, &planar}) {
      const CurveMesh& curves = arcs->curves();
      for (std::size_t c = 0; c < curve_invariants(curves).components; ++c) {
        const auto lines = lines_of_closed(curves, c);
        const auto closed = closed_line(curves, c);
        // Two lines between the same two points are no polygon, but a curve.
        ASSERT_GE(lines.has_value(), closed.has_value());
        if (!lines) continue;
        EXPECT_EQ(links.add(*arcs, *lines), polygons.size());
        polygons.emplace_back();
        for (const auto v : closed.value_or(std::vector<CurveMesh::Index>{}))
          polygons.back().push_back(curves.points[as_size(v)]);
        tets.emplace_back();
        for (const std::size_t line : *lines) tets.back().push_back(curves.tet[line]);
      }
    }
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (std::size_t j = i + 1; j < polygons.size(); ++j) {
        const CertifiedLink link = links.link(i, j);
        ASSERT_NE(link.number.has_value(), link.obstacle.has_value());
        if (link.obstacle) {
          ++obstacles[*link.obstacle];
          continue;
        }
        if (polygons[i].empty() || polygons[j].empty()) continue;
        EXPECT_EQ(linking_number(polygons[i], polygons[j]), link.number) << seed << ' ' << i;
        ++pairs;
        linked.count(*link.number != 0);
        near.count(std::any_of(tets[i].begin(), tets[i].end(), [&](TetMesh::Index t) {
          return std::find(tets[j].begin(), tets[j].end(), t) != tets[j].end();
        }));
      }
  }
  std::cout << pairs.so_far() << " pairs, " << near.so_far() << " with a tetrahedron in common, "
            << linked.so_far() << " linked";
  for (const auto& [obstacle, count] : obstacles)
    std::cout << ", " << name_of(obstacle) << ' ' << count;
  std::cout << '\n';
}

}  // namespace
}  // namespace tensortopo::test
