// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "extract/cases/bundled_fields.hpp"
#include "extract/cases/extract_case.hpp"
#include "support/surfaces/measures.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Vector = Vector3<double>;

Vector twice_area(const Vector& a, const Vector& b, const Vector& c) { return cross(b - a, c - a); }

Extraction extract_finely(const TetMesh& mesh, const std::string& mode, double resolution) {
  ExtractOptions options;
  options.sampling.resolution = resolution;
  return extract_mode_surface<double>(mesh, ModeValue::parse(mode), options);
}

/// The tensors at the corners of a lattice over the only tetrahedron, and the area of the level of
/// the modes there, taken as linear between: marching tetrahedra on `n` intervals an edge.
double marched_area(const TetMesh& mesh, double level, int n) {
  const auto at = [&](int i, int j, int k) {
    const std::array<int, 4> weights{n - i - j - k, i, j, k};
    Vector x{0, 0, 0};
    SymmetricTensor<double> t{};
    for (std::size_t v = 0; v < 4; ++v) {
      const double w = static_cast<double>(weights[v]) / n;
      const auto corner = static_cast<std::size_t>(mesh.tets[0][v]);
      x += w * mesh.points[corner];
      t = t + w * mesh.tensors[corner];
    }
    return std::pair{x, tensortopo::mode(deviator(t)) - level};
  };
  using Corner = std::pair<Vector, double>;
  const auto crossing = [](const Corner& a, const Corner& b) {
    return a.first + (a.second / (a.second - b.second)) * (b.first - a.first);
  };
  const auto cell_area = [&](const std::array<Corner, 4>& cell) {
    std::vector<const Corner*> above, below;
    for (const auto& c : cell) (c.second > 0 ? above : below).push_back(&c);
    if (above.size() > below.size()) std::swap(above, below);
    std::vector<Vector> p;
    if (above.size() == 1)
      for (const auto* b : below) p.push_back(crossing(*above[0], *b));
    else if (above.size() == 2)
      for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 0}, {0, 1}, {1, 1}, {1, 0}})
        p.push_back(crossing(*above[a], *below[b]));
    double sum = 0;
    for (std::size_t i = 2; i < p.size(); ++i) sum += length(twice_area(p[0], p[i - 1], p[i])) / 2;
    return sum;
  };
  // Kuhn's tetrahedra of the cells with i >= j >= k in coordinates of their own.
  double sum = 0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b <= a; ++b)
      for (int c = 0; c <= b; ++c)
        for (const auto& path :
             {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
          std::array<int, 3> u{a, b, c};
          std::array<Corner, 4> cell;
          bool inside = true;
          for (std::size_t s = 0; s < 4; ++s) {
            if (s > 0) ++u[static_cast<std::size_t>(path[s - 1])];
            inside = inside && u[0] >= u[1] && u[1] >= u[2];
            if (inside) cell[s] = at(u[0] - u[1], u[1] - u[2], u[2]);
          }
          if (inside) sum += cell_area(cell);
        }
  return sum;
}

TetMesh single(const TetMesh& mesh, std::size_t tet) {
  TetMesh one;
  for (const auto v : mesh.tets[tet]) {
    one.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
    one.tensors.push_back(mesh.tensors[static_cast<std::size_t>(v)]);
  }
  one.tets = {{0, 1, 2, 3}};
  one.cell_ids = {0};
  return one;
}

// Through these a singular line of the neutral surface runs: the strip beside it is joined to the
// right places of the line, or the area is off by up to nine tenths.
TEST(NeutralSheets, BesideASingularLineHaveTheirArea) {
  for (const auto& file : tried_files()) {
    const std::string name = file.filename().string().substr(0, 2);
    std::vector<std::size_t> tets;
    if (name == "s1") tets = {5821, 6475, 6478, 6960, 7025, 7159};
    if (name == "s2") tets = {4532, 5471, 6764, 6766, 6785};
    if (name == "s3") tets = {3959, 4555, 4558, 4693, 5156, 5640};
    if (name == "s4") tets = {3028, 5188, 6166, 6910};
    const TetMesh mesh = read(file);
    for (const auto tet : tets) {
      const TetMesh one = single(mesh, tet);
      const double expected = marched_area(one, 0, 40);
      EXPECT_NEAR(area(extract_finely(one, "0", 16).surface), expected, 0.04 * expected)
          << name << ", tetrahedron " << tet;
    }
  }
}

// Independent tensors at the corners, a singular line in most of them.
TEST(RandomSheets, HaveTheirArea) {
  SCOPED_TRACE(announce(20260501));
  Random random(20260501);
  for (const auto& [mode, level] : {std::pair{"0", 0.0}, {"1/1000", 0.001}, {"1/2", 0.5}}) {
    double sum = 0, off = 0;
    for (int k = 0; k < std::max(20, trials(20)); ++k) {
      const TetMesh mesh = reference_tet_mesh(random.tet_tensors());
      const double expected = marched_area(mesh, level, 32);
      sum += expected;
      off += std::abs(area(extract_finely(mesh, mode, 12).surface) - expected);
    }
    EXPECT_LT(off, 0.01 * sum) << "mode " << mode << ": " << off << " of " << sum;
  }
}

// Triangles have the level's larger modes on the side of their normals.
TEST(NeutralSheets, AreNotFoldedOver) {
  for (const auto& file : tried_files()) {
    const TetMesh mesh = read(file);
    const auto surface = extract_finely(mesh, "0", 10).surface;
    double all = 0, turned = 0;
    for (const auto& t : surface.triangles) {
      const auto at = [&](std::size_t i) { return static_cast<std::size_t>(t[i]); };
      const auto normal =
          twice_area(surface.points[at(0)], surface.points[at(1)], surface.points[at(2)]);
      Vector gradient{0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i) gradient += surface.normal[at(i)];
      all += length(normal);
      if (!(dot(normal, gradient) > 0)) turned += length(normal);
    }
    EXPECT_LT(turned, 5e-4 * all) << file.filename().string();
  }
}

}  // namespace
}  // namespace tensortopo::test
