// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/scene/fine_surface.hpp"
#include "render/scene/line_field.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

using Index = SurfaceMesh::Index;

// The unit square at some height, cut in 2 n^2 triangles along diagonals of either kind.
SurfaceMesh square(int n, bool other_diagonal = false, double fold = 0) {
  SurfaceMesh sheet;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      sheet.points.push_back({x, y, 0.37 + fold * std::abs(x - 0.5)});
    }
  }
  const auto number = [n](int i, int j) { return static_cast<Index>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Index a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                  d = number(i, j + 1);
      if (other_diagonal) {
        sheet.triangles.insert(sheet.triangles.end(), {{a, b, d}, {b, c, d}});
      } else {
        sheet.triangles.insert(sheet.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  return sheet;
}

SurfacePlace place_in(const SurfaceMesh& sheet, double x, double y) {
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    const auto& t = sheet.triangles[i];
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &p = sheet.points[as_size(t[k])], &q = sheet.points[as_size(t[(k + 1) % 3])];
      inside = inside && (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x) >= 0;
    }
    if (inside) return {static_cast<Index>(i), {x, y, 0.37}};
  }
  return {-1, {x, y, 0.37}};
}

LineField uniform(const SurfaceMesh& sheet, const Vector3<double>& d) {
  return LineField(sheet.points.size(), dyad(d));
}

double deviation(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

TEST(LineIntegralConvolution, OfAUniformDirectionIsConstantAlongIt) {
  const SurfaceMesh sheet = square(7);
  LicOptions options;
  options.cell = 0.01;
  options.half_length = 200;
  std::vector<SurfacePlace> along, across;
  for (int i = 1; i < 40; ++i) {
    along.push_back(place_in(sheet, i / 40.0, 0.433));
    across.push_back(place_in(sheet, 0.433, i / 40.0));
  }
  const LineField lines = uniform(sheet, {1, 0, 0});
  const double on_a_line = deviation(line_integral_convolution(sheet, lines, along, options));
  const double on_many = deviation(line_integral_convolution(sheet, lines, across, options));
  EXPECT_LT(on_a_line, 0.1 * on_many);
  EXPECT_GT(on_many, 0.01);
}

TEST(LineIntegralConvolution, DoesNotSeeHowTrianglesLie) {
  const SurfaceMesh one = square(5), other = square(8, true);
  LicOptions options;
  options.cell = 0.02;
  std::vector<SurfacePlace> in_one, in_other;
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(), y = random.uniform();
    in_one.push_back(place_in(one, x, y));
    in_other.push_back(place_in(other, x, y));
  }
  const Vector3<double> d{0.6, 0.8, 0};
  const auto a = line_integral_convolution(one, uniform(one, d), in_one, options);
  const auto b = line_integral_convolution(other, uniform(other, d), in_other, options);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-6);
}

// On a roof, lines that run over the ridge are as long as on the flat sheet; stopped there, the
// mean over half of the grains would differ.
TEST(LineIntegralConvolution, GoesOnOverARidge) {
  const SurfaceMesh roof = square(6, false, 1);
  LicOptions options;
  options.cell = 0.01;
  options.half_length = 400;
  const LineField lines(roof.points.size(), SymmetricTensor<double>{1, 0, 1, 0, 0, 0});
  std::vector<SurfacePlace> left, right;
  for (int i = 1; i < 40; ++i) {
    SurfacePlace a = place_in(roof, 0.2, i / 40.0), b = place_in(roof, 0.8, i / 40.0);
    a.point.z = b.point.z = 0.37 + 0.3;
    left.push_back(a), right.push_back(b);
  }
  const auto a = line_integral_convolution(roof, lines, left, options);
  const auto b = line_integral_convolution(roof, lines, right, options);
  std::vector<double> difference;
  for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(a[i] - b[i]);
  EXPECT_LT(deviation(difference), 0.2 * deviation(a));
}

RC_GTEST_PROP(LineIntegralConvolution, HasNoSignOfDirections, ()) {
  const SurfaceMesh sheet = square(3);
  Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 20)));
  LineField lines, turned;
  for (std::size_t i = 0; i < sheet.points.size(); ++i) {
    const Vector3<double> d{random.normal(), random.normal(), random.normal()};
    lines.push_back(dyad(d));
    turned.push_back(dyad(random.integer(0, 1) ? d : -d));
  }
  std::vector<SurfacePlace> places;
  for (int i = 0; i < 20; ++i)
    places.push_back(place_in(sheet, random.uniform(), random.uniform()));
  LicOptions options;
  options.cell = 0.03;
  RC_ASSERT(line_integral_convolution(sheet, lines, places, options) ==
            line_integral_convolution(sheet, turned, places, options));
}

TEST(LineIntegralConvolution, IsTheSameWithOneThread) {
  const SurfaceMesh sheet = square(4);
  Random random(9);
  LineField lines;
  for (std::size_t i = 0; i < sheet.points.size(); ++i) lines.push_back(random.tensor());
  std::vector<SurfacePlace> places;
  for (int i = 0; i < 500; ++i)
    places.push_back(place_in(sheet, random.uniform(), random.uniform()));
  LicOptions options;
  options.cell = 0.02;
  const auto many = line_integral_convolution(sheet, lines, places, options);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(many, line_integral_convolution(sheet, lines, places, options));
  EXPECT_GE(*std::min_element(many.begin(), many.end()), 0);
  EXPECT_LE(*std::max_element(many.begin(), many.end()), 1);
}

RC_GTEST_PROP(FineSurface, CoversTheSurfaceAndConforms, ()) {
  const double longest = *rc::gen::inRange(2, 40) / 40.0;
  const SurfaceMesh sheet = square(*rc::gen::inRange(1, 4), *rc::gen::arbitrary<bool>(), 0.5);
  const FineSurface fine = fine_surface(sheet, longest, 100000);
  double area = 0;
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& t : fine.triangles) {
    const auto &p = fine.vertices[as_size(t[0])].point, &q = fine.vertices[as_size(t[1])].point,
               &r = fine.vertices[as_size(t[2])].point;
    const Vector3<double> normal = cross(q - p, r - p);
    RC_ASSERT(normal.z > 0);
    area += std::sqrt(dot(normal, normal)) / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index u = t[k], v = t[(k + 1) % 3];
      ++edges[{std::min(u, v), std::max(u, v)}];
    }
  }
  RC_ASSERT(std::abs(area - [&] {
              double sum = 0;
              for (const auto& t : sheet.triangles) {
                const auto &p = sheet.points[as_size(t[0])], &q = sheet.points[as_size(t[1])],
                           &r = sheet.points[as_size(t[2])];
                const Vector3<double> normal = cross(q - p, r - p);
                sum += std::sqrt(dot(normal, normal)) / 2;
              }
              return sum;
            }()) < 1e-9);
  for (const auto& [edge, count] : edges) {
    const auto &p = fine.vertices[as_size(edge.first)].point,
               &q = fine.vertices[as_size(edge.second)].point;
    RC_ASSERT(dot(p - q, p - q) <= longest * longest);
    const auto on_rim = [](double a, double b) { return a == b && (a == 0 || a == 1); };
    RC_ASSERT(count == (on_rim(p.x, q.x) || on_rim(p.y, q.y) ? 1 : 2));
  }
  for (std::size_t i = 0; i < fine.vertices.size(); ++i) {
    Vector3<double> sum{};
    for (std::size_t k = 0; k < 3; ++k)
      sum += fine.weights[i][k] *
             sheet.points[as_size(sheet.triangles[as_size(fine.vertices[i].triangle)][k])];
    const Vector3<double> off = sum - fine.vertices[i].point;
    RC_ASSERT(dot(off, off) < 1e-20);
  }
}

}  // namespace
}  // namespace tensortopo::test
