// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "analysis/render/pixels.hpp"
#include "analysis/run_program.hpp"
#include "support/trials.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo::test {
namespace {

// A field whose complex domain is large.
std::string bifurcation(const Folder& folder) {
  const std::string file = folder / "bifurcation.vtu";
  run_program({"generate", "bifurcation", "-o", file, "--count", "1", "--field-only"});
  return file;
}

// The share of the sphere that the complex domain covers, by places evenly spread.
double share_of_complex_domain(const std::string& file, const std::string& mode) {
  const TetMesh mesh = read_mesh(file).mesh;
  TetrahedronField<double> field;
  for (std::size_t k = 0; k < 4; ++k)
    field.vertex[k] = deviator(mesh.tensors[static_cast<std::size_t>(mesh.tets[0][k])]);
  const MediumEigenvectorManifold<double> manifold(*characteristic_tensor(field),
                                                   mode_parameter<double>(ModeValue::parse(mode)));
  constexpr int count = 200000;
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z), turn = i * 2.399963229728653;
    if (!manifold.in_real_domain({r * std::cos(turn), r * std::sin(turn), z})) ++inside;
  }
  return static_cast<double>(inside) / count;
}

// The sphere, seen with parallel rays, fills nine tenths of the panel's width. A pixel stands for a
// part of the sphere that is larger where this is seen at an angle.
TEST(RenderTet, GreyIsTheShareOfTheComplexDomain) {
  const Folder folder;
  const std::string field = bifurcation(folder);
  for (const std::string& mode : full_or_short<std::vector<std::string>>({"1/5", "9/10"}, {"1/5"})) {
    const Outcome run =
        run_program({"render", field, "--tet", "0", "--mode", mode, "--panels", "manifold",
                     "--beyond", "2", "--size", "300x360", "-o", folder / "m.png"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Pixels picture = pixels_of(folder / "m.png");
    ASSERT_EQ(picture.width, 300);
    const double radius = 0.84 * 150;
    // The disc's middle, from its highest coloured pixel.
    int top = 0;
    const auto coloured = [&](int x, int y) {
      const auto c = picture.at(x, y);
      return *std::min_element(c.begin(), c.end()) < 200;
    };
    while (top < 150 && !coloured(150, top)) ++top;
    const double middle = top + radius;
    double grey = 0, all = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const double u = (x + 0.5 - 150) / radius, v = (y + 0.5 - middle) / radius;
        // Near the rim a pixel stands for too much.
        const double square = u * u + v * v;
        if (square > 0.99) continue;
        const auto [r, g, b] = picture.at(x, y);
        const double weight = 1 / std::sqrt(1 - square);
        all += weight;
        if (std::abs(r - g) < 14 && std::abs(g - b) < 14) grey += weight;
      }
    }
    // Of the visible half without its rim, in which there is no complex domain.
    const double whole = 1 / (1 - std::sqrt(1 - 0.99));
    EXPECT_NEAR(grey / all / whole, share_of_complex_domain(field, mode), 0.02) << mode;
  }
}

TEST(RenderTet, DrawsSheetsAndRegionsInTheSameColours) {
  const Folder folder;
  run_program({"generate", "linear", "-o", folder / "l.vtu", "--count", "1", "--field-only"});
  const Outcome run = run_program({"render", folder / "l.vtu", "--tet", "0", "--mode", "1/2",
                                   "--size", "640x360", "-o", folder / "l.png", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_GT(report["bifurcation_mode"].get<double>(), 0);
  const Pixels picture = pixels_of(folder / "l.png");
  std::array<std::array<int, 2>, 2> count{};
  for (int y = 0; y < 270; ++y) {
    for (int x = 0; x < 640; ++x) {
      const auto [r, g, b] = picture.at(x, y);
      if (g > r + 80 && b > r + 80 && g > b - 20) ++count[0][x < 320 ? 0 : 1];
      if (r > b + 100 && g > b + 60) ++count[1][x < 320 ? 0 : 1];
    }
  }
  // What is on the visible half of the sphere is in space. (The other half is not seen.)
  for (const auto& [sphere, space] : count)
    EXPECT_TRUE(sphere <= 100 || space > 50) << sphere << " " << space;
  EXPECT_GT(count[0][0] + count[1][0], 500);
}

TEST(RenderTet, WritesTheSameBytesWhateverTheThreads) {
  const Folder folder;
  const std::string field = bifurcation(folder);
  for (const std::string threads : {"1", "2"}) {
    const Outcome run =
        run_program({"render", field, "--tet", "0", "--mode", "0.6", "--mode", "0.1", "--beyond",
                     "9", "--texture", "major", "--size", "96x96", "--threads", threads, "-o",
                     folder / (threads + ".png")});
    ASSERT_EQ(run.status, 0) << run.err;
  }
  EXPECT_EQ(contents(folder / "1.png"), contents(folder / "2.png"));
}

TEST(RenderTet, SaysWhereTheMarkedDirectionIs) {
  const Folder folder;
  const std::string field = bifurcation(folder);
  const Outcome run =
      run_program({"render", field, "--tet", "0", "--mode", "0.3", "--direction", "1,-2,0.5",
                   "--size", "200x200", "--panels", "surface", "-o", folder / "d.png", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  ASSERT_EQ(report["direction"].size(), 2u);
  for (const auto& point : report["direction"])
    EXPECT_NEAR(std::abs(point["mode"].get<double>()), 0.3, 1e-9);
}

TEST(RenderTet, RefusesWhatItCannotDraw) {
  const Folder folder;
  const std::string field = bifurcation(folder), png = folder / "x.png";
  const auto tet = [&](std::vector<std::string> words) {
    std::vector<std::string> all{"render", field, "-o", png};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(all);
  };
  const Outcome far = tet({"--tet", "7", "--mode", "1/2"});
  EXPECT_EQ(far.status, 2);
  EXPECT_NE(far.err.find("--tet 7: no such tetrahedron; the mesh has 1, numbered from 0 to 0"),
            std::string::npos)
      << far.err;
  EXPECT_EQ(tet({"--tet", "0"}).status, 2);
  EXPECT_EQ(tet({"--tet", "0", "--mode", "2"}).status, 2);
  EXPECT_EQ(tet({"--tet", "0", "--mode", "1/2", "--panels", "manifold,,surface"}).status, 2);
  EXPECT_EQ(tet({"--tet", "0", "--mode", "1/2", "--beyond", "0.5"}).status, 2);
  EXPECT_EQ(tet({"--tet", "0", "--mode", "1/2", "--direction", "0,0,0"}).status, 2);
  EXPECT_EQ(tet({"--tet", "0", "--mode", "1/2", "--texture", "wood"}).status, 2);
  EXPECT_EQ(tet({"--panels", "surface"}).status, 2);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"bifurcation.vtu"});
}

TEST(RenderTet, NamesATetrahedronWithoutManifold) {
  const Folder folder;
  // Plane strain: every deviator is in a space of three dimensions.
  std::ofstream(folder / "plane.vtu") << R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1">
<PointData><DataArray type="Float64" Name="t" NumberOfComponents="6" format="ascii">
1 0 0 0 0 0  0 1 0 0 0 0  0 0 1 0 0 0  0 0 0 1 0 0</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";
  const Outcome run = run_program(
      {"render", folder / "plane.vtu", "--tet", "0", "--mode", "1/2", "-o", folder / "x.png"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("dependent (tetrahedron 0)"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace tensortopo::test
