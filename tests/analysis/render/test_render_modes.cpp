// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(RenderModes, DrawsWhatAnExtractedFileHolds) {
  const Folder folder;
  const std::string mesh = field("s4_slab");
  const Outcome extract = run_program(
      {"extract", mesh, "-o", folder / "s.vtp", "--mode", "1/2", "--generalized", "--quiet"});
  ASSERT_EQ(extract.status, 0) << extract.err;
  for (const std::string texture : {"minor", "dominant"}) {
    const Outcome file = run_program({"render", folder / "s.vtp", "--mesh", mesh, "--texture",
                                      texture, "--size", "150x100", "-o", folder / "file.png"});
    ASSERT_EQ(file.status, 0) << file.err;
    const Outcome direct =
        run_program({"render", mesh, "--mode", "1/2", "--generalized", "--texture", texture,
                     "--size", "150x100", "-o", folder / (texture + ".png")});
    ASSERT_EQ(direct.status, 0) << direct.err;
    EXPECT_EQ(contents(folder / "file.png"), contents(folder / (texture + ".png")));
  }
  EXPECT_NE(contents(folder / "minor.png"), contents(folder / "dominant.png"));
  const Outcome smooth =
      run_program({"render", folder / "s.vtp", "--mesh", mesh, "--texture", "minor", "--recover",
                   "--size", "150x100", "-o", folder / "smooth.png"});
  ASSERT_EQ(smooth.status, 0) << smooth.err;
  EXPECT_NE(contents(folder / "smooth.png"), contents(folder / "minor.png"));
}

TEST(RenderModes, RepeatedModesAreDrawnOnce) {
  const Folder folder;
  const std::string mesh = std::string(TENSORTOPO_SUITE) + "/linear.vtu";
  const auto draw = [&](const std::string& name, std::vector<std::string> modes) {
    std::vector<std::string> words{"render", mesh,          "--size", "150x100",
                                   "-o",     folder / name, "--json"};
    words.insert(words.end(), modes.begin(), modes.end());
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["modes"], nlohmann::json({0.5}));
  };
  draw("one.png", {"--mode", "1/2"});
  draw("two.png", {"--mode", "0.5", "--mode", "1/2"});
  EXPECT_TRUE(contents(folder / "one.png") == contents(folder / "two.png"));
}

TEST(RenderModes, DrawsCurvesBesideATexture) {
  const Folder folder;
  const std::string mesh = field("s4_slab");
  for (const std::string mode : {"1", "3/4"}) {
    const Outcome extract = run_program(
        {"extract", mesh, "-o", folder / (mode.substr(0, 1) + ".vtp"), "--mode", mode, "--quiet"});
    ASSERT_EQ(extract.status, 0) << extract.err;
  }
  const Outcome run =
      run_program({"render", folder / "3.vtp", "--surface", folder / "1.vtp", "--mesh", mesh,
                   "--texture", "major", "--size", "150x100", "-o", folder / "both.png", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["modes"], nlohmann::json({0.75, 1}));
}

// Of the same triangles: all stable, some, none.
TEST(RenderModes, TrianglesThatAreNotStableAreFaded) {
  const Folder folder;
  const std::string mesh = field("s4_slab");
  const auto picture = [&](const std::string& radius) {
    std::vector<std::string> words{"extract", mesh,      "-o", folder / "s.vtp", "--mode",
                                   "1/2",     "--quiet"};
    if (!radius.empty()) words.insert(words.end(), {"--uncertainty", radius});
    const Outcome extract = run_program(words);
    EXPECT_EQ(extract.status, 0) << extract.err;
    const Outcome run = run_program({"render", folder / "s.vtp", "--mesh", mesh, "--size",
                                     "150x100", "-o", folder / "picture.png", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    return contents(folder / "picture.png");
  };
  const std::string plain = picture(""), some = picture("1%"), none = picture("200%");
  EXPECT_NE(plain, some);
  EXPECT_NE(some, none);
  EXPECT_NE(plain, none);
}

// A program of this name that only keeps what it reads.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const Folder& folder) : path_(std::getenv("PATH")) {
    std::filesystem::create_directory(folder / "bin");
    std::ofstream(folder / "bin/ffmpeg")
        << "#!/bin/sh\nfor last; do :; done\ncat > \"${last#file:}\"\n";
    std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
    setenv("PATH", (folder / "bin:" + path_).c_str(), 1);
  }
  ~FakeFfmpeg() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

TEST(RenderModes, AnAnimationIsAFrameForEachMode) {
  const Folder folder;
  const FakeFfmpeg ffmpeg(folder);
  const Outcome run = run_program({"render", field("s1_compress_off"), "--animate", "-1:0.8:4",
                                   "--size", "120x90", "-o", folder / "film.gif", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["modes"], nlohmann::json({-1, -0.4, 0.2, 0.8}));
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"bin", "film-000.png", "film-001.png",
                                                      "film-002.png", "film-003.png", "film.gif"}));
  std::string all;
  for (const auto& frame : report["frames"]) {
    const std::string bytes = contents(frame.get<std::string>());
    EXPECT_EQ(all.find(bytes), std::string::npos) << "two frames are the same";
    all += bytes;
  }
  EXPECT_EQ(contents(folder / "film.gif"), all) << "not all frames went to ffmpeg, in order";
  EXPECT_EQ(report["output"]["path"], folder / "film.gif");
  const auto frames =
      nlohmann::json::parse(run_program({"render", field("s1_compress_off"), "--animate", "0:0.8:2",
                                         "--size", "60x60", "-o", folder / "frame.png", "--json"})
                                .out);
  EXPECT_FALSE(frames.contains("output")) << frames;
  EXPECT_EQ(frames["frames"].size(), 2u);
  const Outcome one = run_program({"render", field("s1_compress_off"), "--mode", "-2/5", "--size",
                                   "120x90", "-o", folder / "one.png"});
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(contents(folder / "one.png"), contents(folder / "film-001.png"));
}

TEST(RenderModes, WithoutFfmpegNothingIsDrawn) {
  const Folder folder;
  const std::string path = std::getenv("PATH");
  // A folder with the X server and nothing else.
  std::filesystem::create_directory(folder / "bin");
  for (const std::string place : {"/usr/bin/Xvfb", "/usr/bin/xkbcomp"})
    if (std::filesystem::exists(place))
      std::filesystem::create_symlink(place, folder / "bin" + place.substr(8));
  setenv("PATH", (folder / "bin").c_str(), 1);
  const Outcome run = run_program({"render", field("s4_slab"), "--animate", "0.2:0.4:2", "--size",
                                   "60x60", "-o", folder / "f.mp4"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(run.status, 4);
  EXPECT_NE(run.err.find("films need the program ffmpeg"), std::string::npos) << run.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"bin"});
}

TEST(RenderModes, TheReportNamesTheFilesThatAreThere) {
  const Folder folder;
  const std::string mesh = folder / "g.vtu";
  run_program({"generate", "linear", "-o", mesh, "--field-only"});
  const Outcome run = run_program(
      {"render", mesh, "--animate", "0.2:0.4:2", "--size", "32x32", "-o", folder / "f.png"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with((folder / "f-000.png") + " to f-001.png: ")) << run.out;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"f-000.png", "f-001.png", "g.vtu"}));
}

TEST(RenderModes, TheReportHasTheNotesThatAreSaid) {
  const Folder folder;
  const Outcome run = run_program({"render", field("s4_slab"), "--mode", "1/2", "--tet", "any",
                                   "--size", "64x64", "-o", folder / "t.png", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto notes = nlohmann::json::parse(run.out)["notes"];
  ASSERT_FALSE(notes.empty());
  for (const auto& note : notes)
    EXPECT_NE(run.err.find(note.get<std::string>()), std::string::npos) << note << run.err;
  EXPECT_NE(notes.dump().find("--tet any: tetrahedron"), std::string::npos) << notes;
}

TEST(RenderModes, RefusesWhatContradicts) {
  const Folder folder;
  const std::string mesh = field("s4_slab"), png = folder / "x.png";
  const auto status = [&](std::vector<std::string> words) {
    std::vector<std::string> all{"render", mesh};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(all).status;
  };
  EXPECT_EQ(status({"-o", png, "--animate", "0:1"}), 2);
  EXPECT_EQ(status({"-o", png, "--animate", "0:1:1"}), 2);
  EXPECT_EQ(status({"-o", png, "--animate", "0:1.5:3"}), 2);
  EXPECT_EQ(status({"-o", png, "--animate", "0:1:3", "--mode", "0"}), 2);
  EXPECT_EQ(status({"-o", folder / "x.gif", "--mode", "0"}), 2);
  EXPECT_EQ(status({"-o", png, "--texture", "major"}), 2);
  EXPECT_EQ(status({"-o", png, "--mode", "0", "--texture", "dominant", "--recover"}), 2);
  EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace tensortopo::test
