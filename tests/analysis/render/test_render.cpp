// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

struct Picture {
  std::size_t width = 0, height = 0, teal = 0, gold = 0, white = 0, dark = 0, green = 0, plum = 0,
              red = 0, blue = 0;
};

Picture look_at(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return {};
  image.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) return {};
  Picture picture{image.width, image.height};
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3) {
    const int r = pixels[i], g = pixels[i + 1], b = pixels[i + 2];
    if (g > r + 60 && b > r + 60) ++picture.teal;
    if (r > b + 80 && g > b + 40) ++picture.gold;
    if (g > r + 60 && g > b + 40) ++picture.green;
    if (r > g + 30 && b > g + 30) ++picture.plum;
    if (r > g + 60 && r > b + 60) ++picture.red;
    if (b > r + 60 && b > g + 40) ++picture.blue;
    if (r == 255 && g == 255 && b == 255) ++picture.white;
    if (std::max({r, g, b}) < 100) ++picture.dark;
  }
  return picture;
}

TEST(Render, DrawsPositiveModesTealAndNegativeModesGold) {
  const Folder folder;
  const Outcome extract = run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp",
                                       "--mode", "0.5", "--generalized", "--quiet"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  const Outcome run = run_program({"render", folder / "s.vtp", "--mesh", field("s4_slab"), "-o",
                                   folder / "s.png", "--size", "400x300"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Picture picture = look_at(folder / "s.png");
  EXPECT_EQ(picture.width, 400u);
  EXPECT_EQ(picture.height, 300u);
  EXPECT_GT(picture.teal, 1000u);
  EXPECT_GT(picture.gold, 1000u);
  EXPECT_GT(picture.white, 20000u);
  EXPECT_GT(picture.dark, 100u);
}

TEST(Render, DrawsDegenerateCurvesGreenAndYellow) {
  const Folder folder;
  const Outcome extract = run_program({"extract", field("s1_compress_off"), "-o", folder / "c.vtp",
                                       "--mode", "1", "--generalized", "--quiet"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  const Outcome run = run_program(
      {"render", folder / "c.vtp", "-o", folder / "c.png", "--size", "400x300", "--view", "30,70"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Picture picture = look_at(folder / "c.png");
  EXPECT_GT(picture.green, 500u);
  EXPECT_GT(picture.gold, 1000u);
}

TEST(Render, DrawsOtherInvariantsPlumAndSaysTheirValues) {
  const Folder folder;
  const Outcome extract =
      run_program({"extract", field("s4_slab"), "-o", folder / "v.vtp", "--invariant",
                   "deviator-magnitude", "--value", "1/4", "--value", "1/2", "--quiet"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  const Outcome run = run_program(
      {"render", folder / "v.vtp", "-o", folder / "v.png", "--size", "400x300", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out).at("values"), (std::vector<double>{0.25, 0.5}));
  const Picture picture = look_at(folder / "v.png");
  EXPECT_GT(picture.plum, 1000u);
  EXPECT_EQ(picture.teal + picture.gold, 0u);
  EXPECT_EQ(run_program({"render", folder / "v.vtp", "--mesh", field("s4_slab"), "--texture",
                         "major", "-o", folder / "t.png"})
                .status,
            3);
}

// Only three of its points are in a triangle: what is drawn costs what there is, not its square.
TEST(Render, DrawsASurfaceOfMillionsOfPoints) {
  constexpr std::uint32_t count = 3000000;
  std::vector<float> points(std::size_t{3} * count);
  points[3] = points[7] = 1;
  const std::uint32_t bytes = 12 * count;
  std::string file = R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian")"
                     R"( header_type="UInt32"><PolyData><Piece NumberOfPoints=")" +
                     std::to_string(count) +
                     R"(" NumberOfPolys="1"><Points>)"
                     R"(<DataArray type="Float32" NumberOfComponents="3" format="appended")"
                     R"( offset="0"/></Points><Polys>)"
                     R"(<DataArray type="Int64" Name="connectivity">0 1 2</DataArray>)"
                     R"(<DataArray type="Int64" Name="offsets">3</DataArray></Polys></Piece>)"
                     R"(</PolyData><AppendedData encoding="raw">_)";
  file.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  file.append(reinterpret_cast<const char*>(points.data()), bytes);
  file += "</AppendedData></VTKFile>";
  const Folder folder;
  std::ofstream(folder / "s.vtp", std::ios::binary) << file;
  const Outcome run =
      run_program({"render", folder / "s.vtp", "-o", folder / "s.png", "--size", "200x150"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
}

TEST(Render, DrawsRidgesRedAndValleysBlue) {
  const Folder folder;
  const std::string surface = folder / "s.vtp", ridges = folder / "r.vtp";
  ASSERT_EQ(run_program({"extract", field("s4_slab"), "-o", surface, "--mode", "0.5"}).status, 0);
  ASSERT_EQ(
      run_program({"analyze", surface, "--mesh", field("s4_slab"), "--ridges", ridges, "--recover"})
          .status,
      0);
  const Outcome run = run_program(
      {"render", surface, "--surface", ridges, "-o", folder / "r.png", "--size", "400x300"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Picture picture = look_at(folder / "r.png");
  EXPECT_GT(picture.teal, 1000u);
  EXPECT_GT(picture.red, 100u);
  EXPECT_GT(picture.blue, 100u);
}

TEST(Render, DrawsAMeshAlone) {
  const Folder folder;
  const Outcome run = run_program({"render", field("s1_compress_off"), "-o", folder / "m.png",
                                   "--size", "200x160", "--view", "-40,30"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Picture picture = look_at(folder / "m.png");
  EXPECT_EQ(picture.width, 200u);
  EXPECT_EQ(picture.teal + picture.gold, 0u);
  EXPECT_GT(picture.dark, 50u);
}

TEST(Render, NamesThePackageWhereThereIsNoXServer) {
  const Folder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const Outcome run = run_program({"render", field("s4_slab"), "-o", folder / "x.png"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(run.status, 4);
  EXPECT_NE(run.err.find("xvfb"), std::string::npos) << run.err;
  EXPECT_TRUE(folder.files().empty());
}

// A script over many modes goes on where the field has no such surface.
TEST(Render, DrawsWhatIsBesidesAFileThatHoldsNothing) {
  const Folder folder;
  const std::string mesh = folder / "g.vtu";
  ASSERT_EQ(run_program({"generate", "linear", "-o", mesh, "--field-only"}).status, 0);
  for (const std::string mode : {"0.999", "1"}) {  // a surface, a curve
    const std::string none = folder / mode + ".vtp", png = folder / mode + ".png";
    ASSERT_EQ(run_program({"extract", mesh, "-o", none, "--mode", mode, "--quiet"}).status, 0);
    const auto render = [&](std::vector<std::string> more) {
      more.insert(more.begin(), {"render", none, "-o", png, "--size", "200x150"});
      const Outcome run = run_program(more);
      EXPECT_EQ(run.status, 0) << run.err;
      EXPECT_EQ(run.err, "tensortopo: " + none +
                             ": holds no triangles and no lines, so nothing is drawn of it\n");
      return look_at(png);
    };
    EXPECT_EQ(render({}).white, 200u * 150u);
    for (const auto& more : std::vector<std::vector<std::string>>{{}, {"--texture", "major"}}) {
      std::vector<std::string> words{"--mesh", mesh};
      words.insert(words.end(), more.begin(), more.end());
      const Picture outline = render(words);
      EXPECT_GT(outline.dark, 100u);
      EXPECT_EQ(outline.teal + outline.gold + outline.green, 0u);
    }
  }
  // Nor does it change the picture of another surface.
  const std::string some = folder / "some.vtp";
  ASSERT_EQ(run_program({"extract", mesh, "-o", some, "--mode", "-1", "--quiet"}).status, 0);
  const std::vector<std::string> view{"--size", "200x150", "-o"};
  std::vector<std::string> alone{"render", some},
      both{"render", some, "--surface", folder / "1.vtp"};
  for (auto* words : {&alone, &both}) words->insert(words->end(), view.begin(), view.end());
  alone.push_back(folder / "alone.png"), both.push_back(folder / "both.png");
  EXPECT_EQ(run_program(alone).status, 0);
  EXPECT_EQ(run_program(both).status, 0);
  EXPECT_EQ(contents(folder / "alone.png"), contents(folder / "both.png"));
  EXPECT_GT(look_at(folder / "alone.png").gold, 50u);
}

TEST(Render, DrawsCurvesBesideAModeThatTheFieldDoesNotHave) {
  const Folder folder;
  const std::string mesh = folder / "g.vtu", png = folder / "g.png";
  ASSERT_EQ(run_program({"generate", "linear", "-o", mesh, "--field-only"}).status, 0);
  const Outcome run = run_program(
      {"render", mesh, "--mode", "-1", "--mode", "0.999", "-o", png, "--size", "400x300"});
  EXPECT_EQ(run.status, 0) << run.err;
  const Picture picture = look_at(png);
  EXPECT_GT(picture.gold, 200u);  // of which less than 100 are the legend's
}

TEST(Render, RefusesWhatItCannotDraw) {
  const Folder folder;
  std::ofstream(folder / "bad.vtp") << "no surface\n";
  const std::string png = folder / "x.png";
  EXPECT_EQ(run_program({"render", folder / "bad.vtp", "-o", png}).status, 3);
  EXPECT_EQ(run_program({"render", folder / "missing.vtp", "-o", png}).status, 3);
  EXPECT_EQ(run_program({"render", field("s4_slab"), "-o", folder / "x.jpg"}).status, 2);
  EXPECT_EQ(run_program({"render", field("s4_slab"), "-o", png, "--size", "0x9"}).status, 2);
  EXPECT_EQ(run_program({"render", field("s4_slab"), "-o", png, "--view", "1,2,3"}).status, 2);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"bad.vtp"});
}

}  // namespace
}  // namespace tensortopo::test
