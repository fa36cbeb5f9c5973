// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is refused instead of being passed over: files that would be overwritten, files that are
// none.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(Usage, NothingIsWrittenOverWhatIsReadOrWritten) {
  const Folder folder;
  const std::string in = folder / "in.vtu", link = folder / "link.json", s = folder / "s.vtp";
  std::filesystem::copy_file(field("s4_slab"), in);
  std::filesystem::create_symlink(in, link);
  const std::string before = contents(in);
  for (const std::string& certificate : {in, link, folder / "./in.vtu"})
    expect_line(run_program({"extract", in, "-o", s, "--mode", "0.5", "--certify", certificate}), 2,
                "same file");
  expect_line(run_program({"extract", in, "-o", s, "--mode", "0.5", "--certify", s}), 2,
              "same file");
  expect_line(run_program({"analyze", in, "--sweep", "0:0.1:2", "-o", in}), 2, "same file");
  expect_line(run_program({"render", in, "--mode", "0.5", "-o", in}), 2, "same file");
  expect_line(run_program({"bench", "--input", in, "--mode", "0.5", "--curves", in}), 2,
              "same file");
  EXPECT_EQ(contents(in), before);
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"in.vtu", "link.json"}));
}

TEST(Usage, ACertificateIsNamedJsonOrCbor) {
  const Folder folder;
  for (const std::string level : {"--mode", "--invariant"}) {
    std::vector<std::string> words{"extract",   field("s4_slab"), "-o", folder / "s.vtp",
                                   "--certify", folder / "c.txt", level};
    words.push_back(level == "--mode" ? "0.5" : "magnitude");
    if (level != "--mode") words.insert(words.end(), {"--value", "1"});
    expect_line(run_program(words), 2, "c.txt");
  }
  EXPECT_TRUE(folder.files().empty());
}

// VTK, meshing programs and Windows write either; the bytes are those of the usual names.
TEST(Usage, ExtensionsMayBeInCapitals) {
  const Folder folder;
  const std::string in = folder / "in.VTU", surface = folder / "s.VTP";
  ASSERT_EQ(run_program({"generate", "complex", "-o", in, "--field-only"}).status, 0);
  const auto extract = [&](const std::string& output, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"extract", in, "-o", output, "--mode", "0.5"});
    const Outcome run = run_program(more);
    EXPECT_EQ(run.status, 0) << output << ": " << run.err;
    return contents(output);
  };
  for (const auto& [small, large] : {std::pair{".vtp", ".VTP"},
                                     {".ply", ".Ply"},
                                     {".obj", ".OBJ"},
                                     {".off", ".OFF"},
                                     {".stl", ".STL"}})
    EXPECT_EQ(extract((folder / "a") + small), extract((folder / "b") + large));
  for (const auto& [small, large] : {std::pair{".json", ".JSON"}, {".cbor", ".CBOR"}}) {
    const std::string one = (folder / "c") + small, other = (folder / "d") + large;
    extract(folder / "s.vtp", {"--certify", one});
    extract(surface, {"--certify", other});
    EXPECT_EQ(contents(one), contents(other));
    const Outcome check = run_program({"check", in, surface, other});
    EXPECT_EQ(check.status, 0) << check.err;
  }
  const std::vector<std::vector<std::string>> commands{
      {"analyze", surface, "--mesh", in, "-o", folder / "curved.VTP"},
      {"analyze", in, "--sweep", "0.1:0.2:2", "-o", folder / "sweep.PNG"},
      {"render", surface, "--size", "40x30", "-o", folder / "picture.PNG"},
      {"conformance", "--surface", folder / "b.STL", "--input", in, "--mode", "0.5"}};
  for (const auto& words : commands) {
    const Outcome run = run_program(words);
    EXPECT_EQ(run.status, 0) << words[0] << ": " << run.err;
  }
  expect_line(run_program({"extract", in, "-o", folder / "c.OFF", "--mode", "1"}), 2,
              "degenerate curves");
}

// Its arrays have no numbers, so there is nothing in them that a certificate could bind.
TEST(Usage, WhatTheFieldDoesNotHaveIsCertifiedAndHasArraysAllTheSame) {
  const Folder folder;
  const std::string in = folder / "in.vtu", out = folder / "out.vtp", proof = folder / "c.json";
  ASSERT_EQ(run_program({"generate", "linear", "-o", in, "--field-only"}).status, 0);
  const std::vector<std::vector<std::string>> cases{
      {"\"normal\"", "--mode", "0.999"},
      {"\"separation\"", "--mode", "1"},
      {"\"value\"", "--invariant", "magnitude", "--value", "1000"}};
  for (auto words : cases) {
    const std::string array = words[0];
    words.erase(words.begin());
    words.insert(words.begin(), {"extract", in, "-o", out, "--certify", proof});
    const Outcome run = run_program(words);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(contents(out).find("NumberOfPoints=\"0\""), std::string::npos) << array;
    EXPECT_NE(contents(out).find(array), std::string::npos) << array;
    const Outcome check = run_program({"check", in, out, proof});
    EXPECT_EQ(check.status, 0) << check.out << check.err;
  }
}

/// Tensors of another order, or on cells, wherever a mesh is read.
TEST(Usage, AMeshIsReadInTheSameWordsEverywhere) {
  const Folder folder;
  const std::string vtk = folder / "g.vtu", cells = folder / "cells.vtk", s = folder / "s.vtp";
  std::ofstream(cells) << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                          "POINTS 5 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n"
                          "CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10\n10\n"
                          "CELL_DATA 2\nTENSORS stress double\n"
                          "1 0 0 0 0 0 0 0 -1\n\n0 1 0 1 0.5 0 0 0 0\n\n"
                          "TENSORS6 six double\n1 0 -1 0 0 0\n0 0.5 0 1 0 0\n";
  const std::string picture = folder / "p.png";
  const std::vector<std::vector<std::string>> commands{
      {"extract", cells, "-o", s, "--mode", "0.5"},
      {"analyze", cells, "--sweep", "0:0.5:2"},
      {"render", cells, "-o", picture, "--mode", "0.5", "--size", "32x32"},
      {"bench", "--input", cells, "--mode", "0.5", "--only", "none"},
      {"verify", "--input", cells, "--theorem", "mode-range", "--fields", "1"},
      {"conformance", "--surface", s, "--input", cells, "--mode", "0.5"}};
  for (auto words : commands) {
    words.insert(words.end(), {"--cell-to-point", "--tetrahedralize", "--tensor"});
    const auto status = [&](std::vector<std::string> more) {
      more.insert(more.begin(), words.begin(), words.end());
      return run_program(more).status;
    };
    EXPECT_EQ(status({"stress", "--symmetrize"}), 0) << words[0];
    EXPECT_EQ(status({"six", "--components", "vtk"}), 0) << words[0];
    EXPECT_EQ(status({"six", "--components", "bad"}), 2) << words[0];
    words.push_back("stress");
    words.insert(words.end(), {"--components", "voigt"});
    expect_line(run_program(words), 2, "--components");
  }
}

TEST(Usage, WhatIsNoSuiteIsBadInputInOurWords) {
  const Folder folder;
  for (const char* text : {"", "[]", "{}", "{\"suite\": [{}]}", "{\"suite\": [{\"kind\": \"x\"}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"modes\": [\"2\"]}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"modes\": [\"-1\"]}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"count\": -1}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"count\": 1.5}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"tetrahedra\": -5}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"seed\": 18446744073709551615}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"number\": 2}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"modes\": \"0\"}]}",
                           "{\"suite\": [{\"kind\": \"linear\", \"file\": \"l.json\"}]}",
                           "{\"suite\": [{\"file\": \"none.vtu\", \"modes\": [\"0\"]}]}"}) {
    const std::string list = folder / "l.json";
    std::ofstream(list) << text;
    const Outcome run = run_program({"conformance", "--suite", list});
    expect_line(run, 3, list);
    EXPECT_EQ(run.err.find("json.exception"), std::string::npos) << run.err;
  }
}

TEST(Usage, AFolderIsNoFileToCheck) {
  const Folder folder;
  const std::string here = folder / ".";
  expect_line(run_program({"check", here, here, here}), 3, "is no regular file");
}

TEST(Usage, AFileOfAnotherFormatIsNamedAsOneToCheck) {
  const Folder folder;
  const std::string in = field("s4_slab"), cert = folder / "c.json", ply = folder / "s.ply";
  const Outcome run = run_program(
      {"extract", in, "-o", folder / "s.vtp", "--mode", "0.5", "--certify", cert, "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  ASSERT_EQ(run_program({"extract", in, "-o", ply, "--mode", "0.5", "--quiet"}).status, 0);
  expect_line(run_program({"check", in, ply, cert}), 3, "s.ply: no VTK XML file");
}

TEST(Usage, AFolderIsNoFileToWrite) {
  const Folder folder;
  for (const char* name : {"surfaces", "surfaces.vtp"}) {
    std::filesystem::create_directory(folder / name);
    expect_line(run_program({"extract", field("s4_slab"), "-o", folder / name, "--mode", "0"}), 4,
                "is a folder");
  }
}

/// Not after minutes of work.
TEST(Usage, AFolderThatIsNotThereIsFoundOutFirst) {
  const Folder folder;
  const std::string gone = folder / "gone/", in = folder / "no.vtu", s = folder / "no.vtp";
  const std::vector<std::vector<std::string>> commands{
      {"generate", "linear", "-o", gone + "g.vtu"},
      {"render", in, "-o", gone + "p.png", "--mode", "0"},
      {"analyze", in, "--sweep", "0:0.5:2", "-o", gone + "d.png"},
      {"analyze", s, "--mesh", in, "-o", gone + "c.vtp"},
      {"analyze", s, "--mesh", in, "--ridges", gone + "r.vtp"},
      {"bench", "--input", in, "--mode", "0", "--curves", gone + "c.png"},
      {"bench", "--input", in, "--scaling", "mode", "--chart", gone + "c.png"}};
  for (const auto& words : commands) expect_line(run_program(words), 4, "no such folder");
  EXPECT_TRUE(folder.files().empty());
}

TEST(Usage, WhatIsNoSurfaceIsBadInputInOneLine) {
  const Folder folder;
  for (const char* extension : {".vtp", ".ply", ".obj", ".stl"}) {
    const std::string file = folder / (std::string("bad") + extension);
    std::ofstream(file) << "hello";
    expect_line(run_program({"conformance", "--surface", file, "--input", field("s4_slab"),
                             "--mode", "0.5"}),
                3, file);
  }
  const std::string bad = folder / "bad.vtp";
  expect_line(run_program({"analyze", bad}), 3, bad);
  expect_line(run_program({"analyze", bad, "--mesh", field("s4_slab")}), 3, bad);
  expect_line(run_program({"render", bad, "-o", folder / "p.png"}), 3, bad);
}

TEST(Usage, WhatIsNoTruthIsBadInputInOurWords) {
  const Folder folder;
  ASSERT_EQ(run_program({"generate", "linear", "-o", folder / "g.vtu"}).status, 0);
  for (const char* text : {"", "[]", "{\"format\": 1}", "{"}) {
    const std::string truth = folder / "t.json";
    std::ofstream(truth) << text;
    const Outcome run = run_program({"conformance", "--surface", folder / "g.reference.vtp",
                                     "--input", folder / "g.vtu", "--mode", "0", "--truth", truth});
    expect_line(run, 3, truth);
    EXPECT_EQ(run.err.find("json.exception"), std::string::npos) << run.err;
  }
}

TEST(Usage, CoordinatesThatOverflowAreBadInputByName) {
  const Folder folder;
  ASSERT_EQ(run_program({"generate", "linear", "-o", folder / "g.vtu", "--field-only"}).status, 0);
  const std::string file = folder / "huge.vtk";
  std::ofstream(file) << "# vtk DataFile Version 3.0\nhuge\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                         "POINTS 4 double\n0 0 0\n1e300 0 0\n0 1e300 0\n0 0 1e300\n"
                         "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
                         "TENSORS stress double\n1 0 0 0 0 0 0 0 -1\n\n0 1 0 1 0 0 0 0 0\n\n"
                         "1 0 0 0 -2 0 0 0 1\n\n-1 0 0 0 2 1 0 1 0\n";
  expect_line(run_program({"extract", file, "-o", folder / "s.vtp", "--mode", "0"}), 3, "point 1");
}

TEST(Usage, ABaselineHasNoResidual) {
  for (const char* method : {"marching", "vtk-contour-grid", "vtk-contour-3d-linear-grid"}) {
    const Folder folder;
    const Outcome run = run_program(
        {"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode", "0.5", "--method", method});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out.find("nan"), std::string::npos) << run.out;
  }
}

// Four triangles of a subdivided mesh for one of the mesh, about, in the mesh's own tetrahedra.
TEST(Usage, SubdividingMakesMoreTrianglesOfABaseline) {
  const Folder folder;
  std::vector<double> triangles, area;
  for (const char* times : {"0", "1", "2"}) {
    const Outcome run =
        run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode", "0.5",
                     "--method", "vtk-contour-grid", "--subdivide", times, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto surface = nlohmann::json::parse(run.out).at("surfaces").at(0);
    triangles.push_back(surface.at("triangles").get<double>());
    area.push_back(surface.at("area").get<double>());
  }
  EXPECT_GT(triangles[1], 3 * triangles[0]);
  EXPECT_GT(triangles[2], 3 * triangles[1]);
  EXPECT_LT(std::abs(area[2] - area[1]), std::abs(area[1] - area[0]));
  EXPECT_EQ(run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode", "0.5",
                         "--method", "marching", "--subdivide", "6"})
                .status,
            2);
}

/// Tubes around degenerate curves are proved by what the checker has not.
TEST(Usage, WhatTheCheckerMayLeaveOpenIsSaid) {
  const Folder folder;
  for (const bool thin : {false, true}) {
    const Outcome run =
        run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode",
                     thin ? "0.999999" : "0.5", "--certify", folder / "c.json", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const auto beyond = nlohmann::json::parse(run.out).at("certificate").at("beyond_checker");
    EXPECT_EQ(beyond.at("tubes") > 0, thin) << beyond;
    EXPECT_EQ(run.err.find("thin tube") != std::string::npos, thin) << run.err;
  }
  const Outcome pieces = run_program({"extract", field("s4_slab"), "-o", folder / "s.vtp", "--mode",
                                      "0.5", "--certify", folder / "c.json", "--pieces", "2"});
  EXPECT_NE(pieces.err.find("in pieces it is not counted"), std::string::npos) << pieces.err;
}

TEST(Usage, BenchTakesTheBundledField) {
  const Outcome run = run_program({"bench", "--mode", "0", "--only", "none", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_NE(json.at("input").dump().find("examples/data/s3_three"), std::string::npos);
}

}  // namespace
}  // namespace tensortopo::test
