// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "field_files.hpp"
#include "support/surfaces/measures.hpp"
#include "tensortopo/mesh/validate.hpp"

namespace tensortopo::test {
namespace {

/// Cells given corner by corner over points with zero tensors.
struct Cells {
  std::vector<Vector3<double>> points;
  std::vector<std::pair<int, std::vector<int>>> cells;

  std::filesystem::path write(const std::string& name) const {
    TextVtu text;
    text.points = std::to_string(points.size()), text.cells = std::to_string(cells.size());
    text.coordinates = text.connectivity = text.offsets = text.types = "";
    std::string zeros;
    for (const auto& p : points) {
      text.coordinates +=
          std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + " ";
      zeros += "0 0 0 0 0 0 ";
    }
    std::size_t end = 0;
    for (const auto& [type, corners] : cells) {
      for (const int v : corners) text.connectivity += std::to_string(v) + " ";
      text.offsets += std::to_string(end += corners.size()) + " ";
      text.types += std::to_string(type) + " ";
    }
    text.point_data = TextVtu::array("stress", 6, zeros);
    return put(name, text.str());
  }
};

/// Number of faces with one tetrahedron.
std::size_t outer_faces(const TetMesh& mesh) {
  std::map<std::array<int, 3>, int> count;
  for (const auto& t : mesh.tets)
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<int, 3> face{};
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != skip) face[k++] = t[i];
      std::sort(face.begin(), face.end());
      ++count[face];
    }
  return static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](const auto& f) { return f.second == 1; }));
}

/// Renumbers the points at random.
Cells shuffled(const Cells& cells, unsigned seed) {
  std::vector<int> name(cells.points.size());
  std::iota(name.begin(), name.end(), 0);
  std::mt19937 random(seed);
  std::shuffle(name.begin(), name.end(), random);
  Cells result = cells;
  for (std::size_t i = 0; i < name.size(); ++i)
    result.points[static_cast<std::size_t>(name[i])] = cells.points[i];
  for (auto& [type, corners] : result.cells)
    for (int& v : corners) v = name[static_cast<std::size_t>(v)];
  return result;
}

/// n^3 cubes, hexahedra or voxels.
Cells cubes(int n, bool voxels) {
  Cells result;
  const auto at = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) result.points.push_back({double(i), double(j), double(k)});
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::vector<int> c{at(i, j, k),         at(i + 1, j, k),        at(i, j + 1, k),
                           at(i + 1, j + 1, k), at(i, j, k + 1),        at(i + 1, j, k + 1),
                           at(i, j + 1, k + 1), at(i + 1, j + 1, k + 1)};
        if (!voxels) std::swap(c[2], c[3]), std::swap(c[6], c[7]);
        result.cells.emplace_back(voxels ? 11 : 12, c);
      }
  return result;
}

/// A cube, a wedge and a pyramid beside it, and a tetrahedron on the pyramid.
const Cells mixed{{{0, 0, 0},
                   {1, 0, 0},
                   {1, 1, 0},
                   {0, 1, 0},
                   {0, 0, 1},
                   {1, 0, 1},
                   {1, 1, 1},
                   {0, 1, 1},
                   {0.5, 0, 2},
                   {0.5, 1, 2},
                   {2, 0.5, 0.5},
                   {2, -1, 0.5}},
                  {{12, {0, 1, 2, 3, 4, 5, 6, 7}},
                   {13, {4, 5, 8, 7, 6, 9}},
                   {14, {1, 2, 6, 5, 10}},
                   {10, {1, 10, 5, 11}}}};

ReadOptions split() {
  ReadOptions options;
  options.tetrahedralize = true;
  return options;
}

TEST(ReadCells, OthersAreRefusedByNameAndNumber) {
  expect_error(mixed.write("mixed.vtu"), invalid,
               {"1 hexahedra, 1 wedges, 1 pyramids", "the first is cell 0", "--tetrahedralize"});
  expect_error(cubes(2, true).write("voxels.vtu"), invalid, {"8 voxels", "--tetrahedralize"});
}

/// A cube, and two tetrahedra that cut its side 1 2 6 5 along one diagonal or the other.
Cells beside_a_cube(bool torn) {
  Cells cells = mixed;
  cells.cells.resize(1);
  if (torn) {
    cells.cells.insert(cells.cells.end(), {{10, {1, 2, 5, 10}}, {10, {2, 6, 5, 10}}});
  } else {
    cells.cells.insert(cells.cells.end(), {{10, {1, 2, 6, 10}}, {10, {1, 6, 5, 10}}});
  }
  return cells;
}

TEST(ReadCells, SidesCutAlongBothDiagonalsAreTornFaces) {
  for (const double bulge : {0.0, 0.125, -0.125}) {  // in a plane, a gap, or an overlap
    Cells whole = beside_a_cube(false), torn = beside_a_cube(true);
    whole.points[6].x = torn.points[6].x = 1 + bulge;
    EXPECT_EQ(read_mesh(whole.write("whole.vtu"), split()).report.torn_faces.count, 0u);
    const ReadReport report = read_mesh(torn.write("torn.vtu"), split()).report;
    EXPECT_EQ(report.torn_faces.count, 4u);
    EXPECT_EQ(report.torn_faces.vertices[0], (std::array<std::int64_t, 3>{1, 2, 5}));
    EXPECT_EQ(report.torn_faces.vertices[1], (std::array<std::int64_t, 3>{1, 2, 6}));
    EXPECT_EQ(report.torn_faces.cells, (std::array<std::int64_t, 2>{1, 0}));
    EXPECT_NE(report.notes.back().find("1 2 5 of cell 1, on 1 2 6 of cell 0"), std::string::npos);
  }
  EXPECT_EQ(read_mesh(mixed.write("mixed.vtu"), split()).report.torn_faces.count, 0u);
  EXPECT_EQ(read_mesh(cubes(3, true).write("c.vtu"), split()).report.torn_faces.count, 0u);
}

/// A hole in the form of a tetrahedron has both, and none lie on others.
TEST(ReadCells, AHoleIsNotTorn) {
  Cells cells{
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-4, 0, 0}, {0, -4, 0}, {0, 0, -4}, {4, 4, 4}},
      {{10, {0, 1, 2, 6}}, {10, {0, 1, 3, 5}}, {10, {0, 2, 3, 4}}, {10, {1, 2, 3, 7}}}};
  const ReadResult result = read_mesh(cells.write("hole.vtu"));
  EXPECT_EQ(outer_faces(result.mesh), 16u);
  EXPECT_EQ(result.report.torn_faces.count, 0u);
}

TEST(ReadCells, CurvedAndPolyhedralOnesAreRefusedEvenThen) {
  for (const auto& [type, name] :
       {std::pair{31, "quadratic linear wedges"}, std::pair{33, "biquadratic quadratic hexahedra"},
        std::pair{42, "polyhedra"}, std::pair{71, "Lagrange tetrahedra"},
        std::pair{200, "unknown type 200"}}) {
    Cells cells = mixed;
    cells.cells = {{10, {0, 1, 2, 4}}, {type, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
    const auto file = cells.write("curved.vtu");
    expect_error(file, invalid, {std::string(name), "the first is cell 1"}, split());
    EXPECT_EQ(std::string(error_of(file, split()).what()).find("--tetra"), std::string::npos);
  }
}

TEST(ReadCells, OfLowDimensionAreSkippedAndCounted) {
  Cells cells = mixed;
  cells.cells = {{1, {0}},
                 {3, {0, 1}},
                 {5, {0, 1, 2}},
                 {9, {0, 1, 2, 3}},
                 {10, {0, 1, 2, 4}},
                 {22, {0, 1, 2, 3, 4, 5}},
                 {0, {}}};
  const ReadResult result = read_mesh(cells.write("low.vtu"));
  EXPECT_EQ(result.report.skipped_cells_2d_1d, 6u);
  EXPECT_EQ(result.mesh.cell_ids, std::vector<std::int64_t>{4});
  EXPECT_FALSE(result.report.notes.empty());
  cells.cells.erase(cells.cells.begin() + 4);
  expect_error(cells.write("none.vtu"), invalid, {"no tetrahedra"});
  cells.cells.clear();
  expect_error(cells.write("empty.vtu"), invalid, {"no tetrahedra"});
}

TEST(ReadCells, SplitCellsConformWhateverTheNumbering) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const ReadResult result = read_mesh(shuffled(mixed, seed).write("mixed.vtu"), split());
    EXPECT_TRUE(validate(result.mesh).empty());
    EXPECT_NEAR(volume(result.mesh), 1 + 0.5 + 1.0 / 3 + 0.25, 1e-12);
    // Triangles outside: 4 x 2 of the cube, 2 + 4 of the wedge, 3 of the pyramid, 3 less the one
    // face that the last two share.
    EXPECT_EQ(outer_faces(result.mesh), 8u + 6u + 3u + 3u);
    EXPECT_EQ(result.report.split_cells, 3u);
    EXPECT_EQ(result.report.reoriented_cells,
              result.mesh.cell_ids.back() == 3 ? result.report.reoriented_cells : 0u);
    EXPECT_EQ(std::count(result.mesh.cell_ids.begin(), result.mesh.cell_ids.end(), 0), 6);
    EXPECT_EQ(std::count(result.mesh.cell_ids.begin(), result.mesh.cell_ids.end(), 1), 3);
    EXPECT_EQ(std::count(result.mesh.cell_ids.begin(), result.mesh.cell_ids.end(), 2), 2);
  }
}

TEST(ReadCells, ABlockOfCubesConforms) {
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const bool voxels : {false, true}) {
      const auto mesh =
          read_mesh(shuffled(cubes(3, voxels), seed).write("cubes.vtu"), split()).mesh;
      EXPECT_EQ(mesh.tets.size(), 6u * 27u);
      EXPECT_NEAR(volume(mesh), 27, 1e-12);
      EXPECT_EQ(outer_faces(mesh), 6u * 9u * 2u);
    }
}

TEST(ReadCells, PrismsOfFiveAndSixSidesAreSplit) {
  for (const int sides : {5, 6}) {
    Cells cells;
    std::vector<int> corners;
    for (int layer = 0; layer < 2; ++layer)
      for (int i = 0; i < sides; ++i) {
        corners.push_back(static_cast<int>(cells.points.size()));
        const double angle = 2 * 3.14159265358979 * i / sides;
        cells.points.push_back({std::cos(angle), std::sin(angle), double(layer)});
      }
    cells.cells = {{sides == 5 ? 15 : 16, corners}};
    for (unsigned seed = 0; seed < 10; ++seed) {
      const auto mesh = read_mesh(shuffled(cells, seed).write("prism.vtu"), split()).mesh;
      EXPECT_NEAR(volume(mesh), sides / 2.0 * std::sin(2 * 3.14159265358979 / sides), 1e-5);
      EXPECT_EQ(outer_faces(mesh), static_cast<std::size_t>(2 * (sides - 2) + 2 * sides));
    }
  }
}

TEST(ReadCells, ACollapsedHexahedronIsAWedge) {
  Cells cells = cubes(1, false);
  auto& corners = cells.cells[0].second;
  corners[3] = corners[2], corners[7] = corners[6];
  const ReadResult result = read_mesh(cells.write("collapsed.vtu"), split());
  EXPECT_NEAR(volume(result.mesh), 0.5, 1e-12);
  EXPECT_EQ(result.mesh.tets.size(), 3u);
  EXPECT_EQ(result.report.unreferenced_points, 2u);
}

TEST(ReadCells, InvertedTetrahedraAreTurnedAndCounted) {
  TextVtu text;
  text.connectivity = "0 2 1 3";
  const ReadResult result = read_mesh(put("inverted.vtu", text.str()));
  EXPECT_EQ(result.report.reoriented_cells, 1u);
  EXPECT_EQ(result.mesh.tets[0], (std::array<int, 4>{0, 2, 3, 1}));
  EXPECT_EQ(result.report.notes.size(), 1u);
}

TEST(ReadCells, UnreferencedPointsAreKeptAndCounted) {
  TextVtu text;
  text.points = "5", text.coordinates += " 7 7 7";
  text.point_data =
      TextVtu::array("stress", 6, "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6");
  const ReadResult result = read_mesh(put("loose.vtu", text.str()));
  EXPECT_EQ(result.mesh.points.size(), 5u);
  EXPECT_EQ(result.report.unreferenced_points, 1u);
}

TEST(ReadCells, GhostsAreSkipped) {
  TextVtu text;
  text.cells = "2", text.connectivity = "0 1 2 3 0 1 2 3", text.offsets = "4 8",
  text.types = "10 10";
  text.cell_data = TextVtu::array("vtkGhostType", 1, "0 1", "UInt8");
  const ReadResult result = read_mesh(put("ghost.vtu", text.str()));
  EXPECT_EQ(result.mesh.tets.size(), 1u);
  EXPECT_EQ(result.report.skipped_ghost_cells, 1u);
}

}  // namespace
}  // namespace tensortopo::test
