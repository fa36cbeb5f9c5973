// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

namespace fs = std::filesystem;

std::string one_tetrahedron(const Folder& folder) {
  const std::string path = folder / "m.vtk";
  std::ofstream(path) << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                         "POINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                         "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
                         "TENSORS6 stress double\n3 -1 -2 0.5 0 0.25\n1 -1 0.5 2 3 0\n"
                         "0 1 -2 1 2 4\n5 -3 -2 0 2 1\n";
  return path;
}

/// A result, or an error of one line and nothing written.
void expect_answer(const Outcome& run, const std::string& what, const std::string& written) {
  EXPECT_TRUE(run.status == 0 || run.status == 1 || run.status == 3)
      << what << ": " << run.status << ' ' << run.err;
  if (run.status != 3) return;
  EXPECT_EQ(run.err.rfind("tensortopo: ", 0), 0u) << what << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << what << run.err;
  EXPECT_EQ(run.out, "") << what;
  EXPECT_FALSE(fs::exists(written)) << what;
}

TEST(HostileSurfaces, AreAnsweredByAllThatReadSurfaces) {
  const Folder folder;
  const std::string mesh = one_tetrahedron(folder), picture = folder / "p.png";
  std::size_t asked = 0, refused = 0;
  const auto ask = [&](const std::vector<std::string>& words) {
    const Outcome run = run_program(words);
    expect_answer(run, words[0] + ' ' + words[1] + ' ' + words[2], picture);
    fs::remove(picture);
    ++asked, refused += run.status == 3;
  };
  for (const char* kind : {"ply", "vtp", "obj", "off", "stl"})
    for (const auto& entry : fs::directory_iterator(fs::path(TENSORTOPO_CORPUS) / kind)) {
      // Named as its format is.
      const std::string file = folder / (entry.path().stem().string() + "." + kind);
      fs::copy_file(entry.path(), file, fs::copy_options::overwrite_existing);
      ask({"conformance", "--surface", file, "--input", mesh, "--mode", "0.2"});
      if (std::string(kind) != "vtp") continue;
      ask({"analyze", file, "--mesh", mesh});
      ask({"render", file, "--size", "16x16", "-o", picture});
    }
  EXPECT_GT(asked, 30u);
  EXPECT_GT(refused, 10u);
}

TEST(HostileSurfaces, PipesAndDevicesAreRefused) {
  const Folder folder;
  const std::string mesh = one_tetrahedron(folder), picture = folder / "p.png";
  for (const char* extension : {".vtp", ".vtu", ".vtk", ".json", ".ply"}) {
    const std::string pipe = folder / ("pipe" + std::string(extension)),
                      device = folder / ("device" + std::string(extension));
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", device);
    for (const std::string& file : {pipe, device}) {
      const std::string suffix = extension;
      std::vector<std::string> words{"conformance", "--surface", file, "--input",
                                     mesh,          "--mode",    "0.2"};
      if (suffix == ".vtu" || suffix == ".vtk")
        words = {"render", file, "--mode", "0.2", "--size", "16x16", "-o", picture};
      if (suffix == ".json") words = {"conformance", "--suite", file};
      const Outcome run = run_program(words);
      EXPECT_EQ(run.status, 3) << file << run.err;
      expect_answer(run, file, picture);
    }
  }
}

}  // namespace
}  // namespace tensortopo::test
