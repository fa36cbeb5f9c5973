// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "field_files.hpp"
#include "support/surfaces/measures.hpp"

namespace tensortopo::test {
namespace {

using Point = Vector3<double>;
using Tensor = SymmetricTensor<double>;

/// A quadratic field.
Tensor value_at(const Point& p) {
  return {p.x * p.x + p.y, p.y * p.z - 1, 2 - p.z * p.z, p.x * p.y, p.z + p.x * p.z, 1 + p.x};
}

struct Cell {
  int type;  ///< VTK's, quadratic
  std::vector<int> corners;
};

const std::map<int, std::vector<std::array<std::size_t, 2>>> kEdges{
    {24, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
    {25,
     {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6},
      {3, 7}}},
    {26, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
    {27, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}}};

std::string text(double x) {
  char bytes[40];
  std::snprintf(bytes, sizeof bytes, "%.17g ", x);
  return bytes;
}

/// A .vtu of quadratic cells with straight edges; `shift` moves the first middle of an edge.
TextVtu quadratic_vtu(std::vector<Point> points, const std::vector<Cell>& cells, double shift = 0) {
  std::map<std::array<int, 2>, int> middles;
  TextVtu file;
  file.connectivity = file.offsets = file.types = file.coordinates = "";
  std::size_t end = 0;
  for (const Cell& cell : cells) {
    std::vector<int> nodes = cell.corners;
    for (const auto& [a, b] : kEdges.at(cell.type)) {
      const int p = std::min(nodes[a], nodes[b]), q = std::max(nodes[a], nodes[b]);
      const auto [at, is_new] = middles.try_emplace({p, q}, static_cast<int>(points.size()));
      if (is_new) {
        const Point &u = points[static_cast<std::size_t>(p)], &v = points[static_cast<std::size_t>(q)];
        points.push_back({u.x / 2 + v.x / 2 + (middles.size() == 1 ? shift : 0), u.y / 2 + v.y / 2,
                          u.z / 2 + v.z / 2});
      }
      nodes.push_back(at->second);
    }
    for (const int v : nodes) file.connectivity += std::to_string(v) + " ";
    end += nodes.size();
    file.offsets += std::to_string(end) + " ";
    file.types += std::to_string(cell.type) + " ";
  }
  std::string tensors;
  for (const Point& p : points) {
    for (const double x : {p.x, p.y, p.z}) file.coordinates += text(x);
    const Tensor t = value_at(p);
    for (const double x : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) tensors += text(x);
  }
  file.points = std::to_string(points.size());
  file.cells = std::to_string(cells.size());
  file.point_data = TextVtu::array("stress", 6, tensors);
  return file;
}

/// Every vertex has the value of the quadratic field: so have the centres that were added.
void expect_quadratic(const TetMesh& mesh) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Tensor is = mesh.tensors[v], should = value_at(mesh.points[v]);
    for (const auto& [a, b] : {std::array{is.xx, should.xx}, {is.yy, should.yy}, {is.zz, should.zz},
                               {is.xy, should.xy}, {is.yz, should.yz}, {is.xz, should.xz}})
      EXPECT_NEAR(a, b, 1e-13);
  }
}

const std::vector<Point> kCubes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
                                {1, 1, 1}, {0, 1, 1}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}, {2, 1, 1}};

TEST(QuadraticCells, TetrahedraAreCutInEight) {
  // Corners in all orders, so that all diagonals come about.
  std::array<int, 4> order{0, 1, 2, 3};
  int tried = 0;
  do {
    const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0.3, 0.3, -1}};
    const std::vector<Cell> cells{{24, {order.begin(), order.end()}},
                                  {24, {order[3], 1, 2, order[3] == 0 ? 5 : 4}}};
    if (order[3] == 1 || order[3] == 2) continue;
    const ReadResult read = read_mesh(put("t.vtu", quadratic_vtu(corners, cells).str()));
    EXPECT_EQ(read.mesh.tets.size(), 16u);
    EXPECT_EQ(read.report.quadratic_cells, 2u);
    EXPECT_EQ(read.report.added_vertices, 0u);
    EXPECT_EQ(read.report.curved_edges, 0u);
    EXPECT_EQ(read.mesh.cell_ids[7], 0);
    EXPECT_EQ(read.mesh.cell_ids[8], 1);
    expect_quadratic(read.mesh);
    ++tried;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(tried, 12);
}

TEST(QuadraticCells, HexahedraAreCutAroundCentresThatNeighboursShare) {
  const std::vector<Cell> cells{{25, {0, 1, 2, 3, 4, 5, 6, 7}}, {25, {1, 8, 9, 2, 5, 10, 11, 6}}};
  const ReadResult read = read_mesh(put("h.vtu", quadratic_vtu(kCubes, cells).str()));
  EXPECT_EQ(read.report.added_vertices, 13u);  // 11 faces, 2 cells
  EXPECT_EQ(read.report.torn_faces.count, 0u);
  EXPECT_EQ(read.report.unreferenced_points, 0u);
  EXPECT_NEAR(volume(read.mesh), 2, 1e-14);
  expect_quadratic(read.mesh);
}

TEST(QuadraticCells, OfDifferentKindsMatch) {
  std::vector<Point> points = kCubes;
  points.push_back({0.5, 0.5, 2});   // above the first cube
  points.push_back({1.5, 0.5, 2});   // above the second
  points.push_back({3, 0, 0}), points.push_back({3, 0, 1});
  const std::vector<Cell> cells{{25, {0, 1, 2, 3, 4, 5, 6, 7}},
                                {27, {4, 5, 6, 7, 12}},
                                {25, {1, 8, 9, 2, 5, 10, 11, 6}},
                                {27, {5, 10, 11, 6, 13}},
                                {24, {5, 6, 13, 12}},
                                {26, {8, 14, 9, 10, 15, 11}}};
  const ReadResult read = read_mesh(put("m.vtu", quadratic_vtu(points, cells).str()));
  EXPECT_EQ(read.report.torn_faces.count, 0u) << read.report.torn_faces.text();
  EXPECT_EQ(read.report.quadratic_cells, 6u);
  EXPECT_EQ(read.report.reoriented_cells, 0u);
  EXPECT_NEAR(volume(read.mesh), 1 + 1. / 3 + 1 + 1. / 3 + 1. / 6 + 0.5, 1e-14);
  expect_quadratic(read.mesh);
}

TEST(QuadraticCells, CanBeTakenByTheirCorners) {
  const std::vector<Cell> cells{{25, {0, 1, 2, 3, 4, 5, 6, 7}}, {25, {1, 8, 9, 2, 5, 10, 11, 6}}};
  ReadOptions options;
  options.quadratic = QuadraticCells::corners;
  const auto file = put("h.vtu", quadratic_vtu(kCubes, cells, 0.1).str());
  const ReadResult read = read_mesh(file, options);
  EXPECT_EQ(read.report.added_vertices, 0u);
  EXPECT_EQ(read.report.curved_edges, 1u);
  EXPECT_EQ(read.report.unreferenced_points, 20u);
  EXPECT_NEAR(volume(read.mesh), 2, 1e-14);
  EXPECT_EQ(read_mesh(file).report.curved_edges, 1u);
}

TEST(QuadraticCells, OfOtherNumbersOfNodesAreRefused) {
  TextVtu file = quadratic_vtu({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{24, {0, 1, 2, 3}}});
  file.connectivity = "0 1 2 3", file.offsets = "4";
  expect_error(put("t.vtu", file.str()), invalid, {"4 nodes where 10 belong", "cell 0"});
  file.connectivity = "0 1 2 3 4 5 6 7 8 9 0", file.offsets = "11";
  expect_error(put("t.vtu", file.str()), invalid, {"11 nodes where 10 belong"});
}

TEST(NamedScalars, AreJoinedByAPattern) {
  TextVtu file;
  file.point_data = "";
  for (const auto& [name, value] : std::map<std::string, std::string>{
           {"S_xx", "1"}, {"S_yy", "2"}, {"S_zz", "3"}, {"S_xy", "4"}, {"S_yz", "5"},
           {"S_xz", "6"}})
    file.point_data +=
        TextVtu::array(name, 1, value + " " + value + " " + value + " " + value + "0");
  const auto path = put("s.vtu", file.str());
  for (const char* pattern : {"S_{xx,yy,zz,xy,yz,xz}", "S_{xx,yy,zz,xy,xz,yz}",
                              "S_{xx,yy,zz,yz,xz,xy}", "S_{xx,xy,xz,xy,yy,yz,xz,yz,zz}"}) {
    ReadOptions options;
    options.tensor = pattern;
    if (std::string(pattern).size() > 25) {  // nine names, of which some are the same
      expect_error(path, invalid, {"alike"}, options);
      continue;
    }
    const ReadResult read = read_mesh(path, options);
    EXPECT_EQ(read.mesh.tensors[0], (Tensor{1, 2, 3, 4, 5, 6})) << pattern;
    EXPECT_EQ(read.mesh.tensors[3], (Tensor{10, 20, 30, 40, 50, 60})) << pattern;
    EXPECT_EQ(read.report.components.source, ComponentSource::named);
  }
  ReadOptions options;
  options.tensor = "S_{xx,yy,zz,xy,yz}";
  expect_error(path, invalid, {"names 5 arrays"}, options);
  options.tensor = "S_{xx,yy,zz,xy,yz,zx}";
  expect_error(path, invalid, {"has no array `S_{xx,yy,zz,xy,yz,zx}`", "S_xx"}, options);
  options.tensor = "{S_xx,S_yy,S_zz,S_xy,S_yz,S_xz}";
  EXPECT_EQ(read_mesh(path, options).mesh.tensors[0], (Tensor{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace tensortopo::test
