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

#include "analysis/render/pixels.hpp"
#include "analysis/run_program.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/manifold/medium_eigenvector_manifold.hpp"

namespace tensortopo::test {
namespace {

// How dark the darkest pixel is around the middle.
int darkest_in_the_middle(const Pixels& picture) {
  int least = 255;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      const auto [r, g, b] = picture.at(picture.width / 2 + x, picture.height / 2 + y);
      least = std::min(least, std::max({r, g, b}));
    }
  return least;
}

std::string generated(const Folder& folder, const std::string& kind) {
  const std::string file = folder / (kind + ".vtu");
  run_program({"generate", kind, "-o", file, "--field-only", "--quiet"});
  return file;
}

// The dark edges of a cube from -1 to 1 meet in its corners, and in the middles of its faces there
// are none.
TEST(RenderView, TheFocusIsInTheMiddle) {
  const Folder folder;
  const std::string cube = generated(folder, "complex"), png = folder / "c.png";
  const auto middle = [&](const std::string& focus, const std::string& zoom) {
    const Outcome run = run_program(
        {"render", cube, "--focus=" + focus, "--zoom", zoom, "--size", "160x120", "-o", png});
    EXPECT_EQ(run.status, 0) << run.err;
    return darkest_in_the_middle(pixels_of(png));
  };
  for (const std::string zoom : {"1", "200"})
    for (const std::string corner : {"1,1,1", "-1,-1,1", "1,-1,-1"})
      EXPECT_LT(middle(corner, zoom), 120) << corner << " at zoom " << zoom;
  for (const std::string place : {"0.1,0.2,1", "0,-1,0.2", "1,0.1,0"})
    EXPECT_GT(middle(place, "8"), 180) << place;
}

TEST(RenderView, TheFocusIsInTheMiddleOfATetrahedronsPanel) {
  const Folder folder;
  const std::string file = folder / "f.vtu";
  run_program({"generate", "bifurcation", "-o", file, "--count", "1", "--field-only"});
  const TetMesh mesh = read_mesh(file).mesh;
  for (const auto v : mesh.tets[0]) {
    const auto& p = mesh.points[static_cast<std::size_t>(v)];
    const std::string focus =
        "--focus=" + std::to_string(p.x) + ',' + std::to_string(p.y) + ',' + std::to_string(p.z);
    const Outcome run =
        run_program({"render", file, "--tet", "0", "--mode", "1/5", "--panels", "curves", focus,
                     "--zoom", "5", "--size", "160x160", "-o", folder / "t.png"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_LT(darkest_in_the_middle(pixels_of(folder / "t.png")), 150) << focus;
  }
}

TEST(RenderView, ZoomEnlargesBothWays) {
  const Folder folder;
  const std::string surface = folder / "s.vtp", png = folder / "z.png";
  ASSERT_EQ(run_program({"extract", field("s4_slab"), "-o", surface, "--mode", "1/2"}).status, 0);
  std::vector<double> teal;
  for (const std::string zoom : {"0.25", "0.5", "1"}) {
    const Outcome run =
        run_program({"render", surface, "--zoom", zoom, "--size", "500x400", "-o", png});
    ASSERT_EQ(run.status, 0) << run.err;
    const Pixels picture = pixels_of(png);
    double count = 0;
    // Above the legend.
    for (int y = 0; y < 360; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const auto [r, g, b] = picture.at(x, y);
        if (g > r + 60 && b > r + 60) ++count;
      }
    teal.push_back(count);
  }
  EXPECT_GT(teal[0], 300);
  EXPECT_NEAR(teal[1] / teal[0], 4, 0.8);
  EXPECT_NEAR(teal[2] / teal[1], 4, 0.3);
}

TEST(RenderView, RefusesViewsThatAreNone) {
  const Folder folder;
  const auto status = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"render", field("s4_slab"), "-o", folder / "x.png"};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(all).status;
  };
  EXPECT_EQ(status({"--focus", "1,2"}), 2);
  EXPECT_EQ(status({"--focus", "1,2,inf"}), 2);
  EXPECT_EQ(status({"--focus", "1,2,3,4"}), 2);
  EXPECT_EQ(status({"--zoom", "0"}), 2);
  EXPECT_EQ(status({"--zoom", "nan"}), 2);
  EXPECT_TRUE(folder.files().empty());
}

// Uniaxial tensors, next to mode 1.
std::string nearly_uniaxial(const Folder& folder) {
  std::ofstream(folder / "u.vtu") << R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1">
<PointData><DataArray type="Float64" Name="t" NumberOfComponents="6" format="ascii">
2 -1 -1 0 0 0.01  2 -1 -1 0.1 0 0  2 -1 -1 0 0.1 0  2 -1 -1 0 0 0.1</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";
  return folder / "u.vtu";
}

TEST(RenderView, SaysWhereThereIsNoSurface) {
  const Folder folder;
  const std::string mesh = nearly_uniaxial(folder), png = folder / "x.png";
  const auto said = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all{"render", mesh, "--size", "90x90", "-o", png};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome run = run_program(all);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.err;
  };
  const std::string tet = said({"--tet", "0", "--mode", "1/5"});
  EXPECT_NE(tet.find("the surface misses tetrahedron 0"), std::string::npos) << tet;
  EXPECT_NE(tet.find("cell data 'tet' of an extracted .vtp"), std::string::npos) << tet;
  const std::string all = said({"--mode", "1/5"});
  EXPECT_NE(all.find("mode 1/5: the field has no such surface"), std::string::npos) << all;
  const std::string value = said({"--invariant", "magnitude", "--value", "100"});
  EXPECT_NE(value.find("magnitude 100: the field has no such surface"), std::string::npos) << value;
  const std::string drawn = said({"--invariant", "deviator-magnitude", "--value", "2.45"});
  EXPECT_EQ(drawn.find("no such surface"), std::string::npos) << drawn;
}

TEST(RenderView, DrawsOtherInvariantsAsAnExtractedFileHoldsThem) {
  const Folder folder;
  const std::string mesh = field("s4_slab");
  const std::vector<std::string> what{
      "--invariant", "deviator-magnitude", "--value", "1/2", "--value", "1/4", "--quiet"};
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.end(), what.begin(), what.end());
    return run_program(words);
  };
  const Outcome direct =
      run({"render", mesh, "--size", "150x100", "-o", folder / "direct.png", "--json"});
  ASSERT_EQ(direct.status, 0) << direct.err;
  EXPECT_EQ(nlohmann::json::parse(direct.out).at("values").size(), 2u);
  ASSERT_EQ(run({"extract", mesh, "-o", folder / "v.vtp"}).status, 0);
  ASSERT_EQ(run_program({"render", folder / "v.vtp", "--mesh", mesh, "--size", "150x100", "-o",
                         folder / "file.png"})
                .status,
            0);
  EXPECT_EQ(contents(folder / "direct.png"), contents(folder / "file.png"));
  EXPECT_EQ(run({"render", mesh, "--tet", "0", "-o", folder / "x.png"}).status, 2);
  EXPECT_EQ(run({"render", mesh, "--mode", "0", "-o", folder / "x.png"}).status, 2);
  EXPECT_EQ(
      run_program({"render", mesh, "--invariant", "magnitude", "-o", folder / "x.png"}).status, 2);
}

// The neutral surface has one colour, in a field and in a tetrahedron.
TEST(RenderView, TheNeutralSurfaceIsChartreuse) {
  const Folder folder;
  const std::string mesh = generated(folder, "complex"), png = folder / "n.png";
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{}, {"--tet", "7", "--panels", "surface"}}) {
    std::vector<std::string> all{"render", mesh, "--mode", "0", "--size", "200x200", "-o", png};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome run = run_program(all);
    ASSERT_EQ(run.status, 0) << run.err;
    const Pixels picture = pixels_of(png);
    int chartreuse = 0;
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 200; ++x) {
        const auto [r, g, b] = picture.at(x, y);
        if (g > r + 15 && r > b + 50) ++chartreuse;
      }
    EXPECT_GT(chartreuse, 500);
  }
}

// The triangle of squares: grey is the complex domain's share of it.
TEST(RenderView, TheOctantIsGreyWhereTheComplexDomainIs) {
  const Folder folder;
  const std::string file = folder / "b.vtu";
  run_program({"generate", "bifurcation", "-o", file, "--count", "1", "--field-only"});
  const TetMesh mesh = read_mesh(file).mesh;
  TetrahedronField<double> field;
  for (std::size_t k = 0; k < 4; ++k)
    field.vertex[k] = deviator(mesh.tensors[static_cast<std::size_t>(mesh.tets[0][k])]);
  for (const std::string mode : {"1/5", "9/10"}) {
    const MediumEigenvectorManifold<double> manifold(
        *characteristic_tensor(field), mode_parameter<double>(ModeValue::parse(mode)));
    const auto& e = manifold.characteristic().eigenvectors;
    constexpr int rows = 400;
    double inside = 0, all = 0;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; i + j < rows; ++j) {
        const double a = (i + 1 / 3.0) / rows, b = (j + 1 / 3.0) / rows;
        ++all;
        inside += !manifold.in_real_domain(std::sqrt(a) * e[0] + std::sqrt(b) * e[1] +
                                           std::sqrt(1 - a - b) * e[2]);
      }
    const Outcome run = run_program({"render", file, "--tet", "0", "--mode", mode, "--panels",
                                     "octant", "--size", "500x700", "-o", folder / "o.png"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Pixels picture = pixels_of(folder / "o.png");
    double grey = 0, pale = 0;
    for (int y = 0; y < 500; ++y)
      for (int x = 0; x < 500; ++x) {
        const auto [r, g, b] = picture.at(x, y);
        grey += std::abs(r - 153) < 4 && std::abs(g - 153) < 4 && std::abs(b - 153) < 4;
        pale += std::abs(r - 238) < 4 && std::abs(g - 240) < 4 && std::abs(b - 242) < 4;
      }
    // Some pixels are lines and dots.
    EXPECT_NEAR(grey / (grey + pale), inside / all, 0.02) << mode;
    EXPECT_GT(grey + pale, 70000);
  }
}

TEST(RenderView, LooksForFfmpegFirst) {
  const Folder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder / ".").c_str(), 1);
  // Nothing of this is there: no mesh, no X server.
  const Outcome run =
      run_program({"render", "nowhere.vtu", "--animate", "0:0.5:9", "-o", folder / "f.gif"});
  // A name without the right to run is no program.
  std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n";
  const Outcome named =
      run_program({"render", "nowhere.vtu", "--animate", "0:0.5:9", "-o", folder / "f.gif"});
  setenv("PATH", path.c_str(), 1);
  for (const Outcome& one : {run, named}) {
    EXPECT_EQ(one.status, 4);
    EXPECT_NE(one.err.find("films need the program ffmpeg"), std::string::npos) << one.err;
  }
}

}  // namespace
}  // namespace tensortopo::test
