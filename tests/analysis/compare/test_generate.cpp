// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/run_program.hpp"
#include "support/oracles/brute_force.hpp"
#include "support/trials.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

Json generated(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"generate"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.push_back("--json");
  const Outcome outcome = run_program(all);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? Json::parse(outcome.out) : Json();
}

// The numbers of the fields are part of the contract: whoever cites a seed means these.
TEST(Generate, GivesTheSameNumbersEverywhere) {
  const std::map<std::string, std::string> hashes{
      {"linear", "9ebf3b971ae4662cc1b57edb5efb5a3b16ed36c011ae638427b1333b49692cbf"},
      {"complex", "824b34668c0d3bc5f6c9fc8c3bbdef3b77ed4783a907ba7573ff07e62a8d2cb5"},
      {"rough", "47aa9ad9ff18e6b1c6b2494d205987c2bcdc05a449b447772cdb4c5cd0061450"},
      {"bifurcation", "0b52a5bac2fefb7f47def1a92f18a50ac5a973873effc7dc31faae800a09527f"},
      {"planar-extrema", "9c4cd97cf6fc8521aaf02ef99b0d2d65398d48dab4dbde5449013609bd14db9b"},
      {"nongeneric", "f025b51c60ef4ea415f1d8a83298ba69ef559a44404e289e786447df97da3b97"},
      {"boussinesq", "ce15eea7107c759d0803730c4730412f242e6eca531d4c9055f2c41a3b8a775d"},
      {"kelvin", "d12b18c87ce4fa150819fa76ee422c35c57e049abef8cc0e8a93b0bc064e480d"},
      {"helix", "e8cb2a1659fd900400354bcb1e434229c62a6bdb4b8d0b8fc3f087679903aa4b"}};
  const Folder folder;
  for (const auto& [kind, hash] : hashes) {
    std::vector<std::string> words{kind, "-o", folder / (kind + ".vtu"), "--field-only"};
    const bool has_mesh = kind != "linear" && kind != "bifurcation" && kind != "planar-extrema" &&
                          kind != "nongeneric";
    if (has_mesh) words.insert(words.end(), {"--tets", "162"});
    const Json report = generated(words);
    EXPECT_EQ(report["files"][0]["sha256"], hash) << kind;
    EXPECT_EQ(field_sha256(read_mesh(folder / (kind + ".vtu")).mesh), hash) << kind;
  }
  const std::vector<std::string> blocks{
      "17f9ea1e6bcb151180361ed01c676c163a1998ece4214bade6a097c7a0dee4a6",
      "e7f99b1a011abad6cbe39985838909abf66671808928b4569bee959c7fefe82f",
      "b351b329a3d26cf82e02bf1983a493ca66ab300e7fe17c426dba2ad961cc2a67",
      "47c45fa59dd43afaa9881e4d3d270a921e91f6e6db0277832079ecc348a4a029"};
  const Json report =
      generated({"block", "-o", folder / "b.vtu", "--field-only", "--tets", "500", "--count", "4"});
  for (std::size_t i = 0; i < blocks.size(); ++i)
    EXPECT_EQ(report["files"][i]["sha256"], blocks[i]) << i;
}

TEST(Generate, GivesTheSameTruthForAnyNumberOfThreads) {
  const Folder folder;
  generated({"complex", "-o", folder / "a.vtu", "--threads", "1"});
  const std::string truth = contents(folder / "a.truth.json");
  const std::string points = contents(folder / "a.reference.json");
  generated({"complex", "-o", folder / "a.vtu", "--threads", "2"});
  EXPECT_EQ(contents(folder / "a.truth.json"), truth);
  EXPECT_EQ(contents(folder / "a.reference.json"), points);
}

TEST(Generate, RepeatedModesCountOnce) {
  const Folder folder;
  const Json report = generated({"linear", "-o", folder / "a.vtu", "--mode", "0.5", "--mode", "0",
                                 "--mode", "1/2", "--no-reference"});
  ASSERT_EQ(report["files"][0]["levels"].size(), 2u);
  EXPECT_EQ(report["files"][0]["levels"][0]["mode"], "1/2");
  EXPECT_EQ(report["files"][0]["levels"][1]["mode"], "0");
  EXPECT_EQ(Json::parse(contents(folder / "a.truth.json"))["levels"].size(), 2u);
}

TEST(Generate, TellsTheTruth) {
  const Folder folder;
  generated(
      {"linear", "-o", folder / "l.vtu", "--count", "12", "--mode", "1/2", "--mode", "-9/10"});
  int checked = 0;
  for (int i = 0; i < 12; ++i) {
    const std::string stem = std::string("l-00") + (i < 10 ? "0" : "") + std::to_string(i);
    const auto mesh = read_mesh(folder / (stem + ".vtu")).mesh;
    const Json truth = Json::parse(contents(folder / (stem + ".truth.json")));
    EXPECT_EQ(truth["field"]["sha256"], field_sha256(mesh));
    std::array<SymmetricTensor<double>, 4> tensors;
    for (std::size_t v = 0; v < 4; ++v)
      tensors[v] = mesh.tensors[static_cast<std::size_t>(mesh.tets[0][v])];
    ASSERT_EQ(truth["levels"].size(), 2u);
    for (const Json& level : truth["levels"]) {
      EXPECT_TRUE(level["undecided"].empty());
      const double mode = level["mode"] == "1/2" ? 0.5 : -0.9;
      const auto known = brute_force_topology(corners_of(tensors), mode);
      if (!known) continue;
      ++checked;
      std::vector<ComponentTopology> components;
      for (const Json& c : level["components"]) {
        EXPECT_EQ(c["orientable"], true);
        EXPECT_EQ(c["closed"], false);
        components.push_back({c["euler_characteristic"], c["boundary_loops"]});
      }
      EXPECT_EQ(components, known->components) << i;
      std::vector<ComponentTopology> sheets;
      for (const Json& tet : level["tetrahedra"])
        for (const Json& sheet : tet[1]) sheets.push_back({sheet[0], sheet[1]});
      EXPECT_EQ(sheets, known->components) << i;
      int crossings = 0;
      for (const Json& edge : level["edges"]) crossings += edge[2].get<int>();
      EXPECT_EQ(crossings, known->crossings()) << i;
    }
  }
  EXPECT_GE(checked, 18);
}

TEST(Generate, NamesWhatIsUndecided) {
  const Folder folder;
  const Json report = generated({"nongeneric", "-o", folder / "n.vtu", "--count", "20"});
  std::map<std::string, std::string> reasons;
  for (const Json& file : report["files"]) {
    const Json truth = Json::parse(contents(file["truth"].get<std::string>()));
    const Json& undecided = truth["levels"][0]["undecided"];
    reasons[truth["note"]] = undecided.empty() ? "" : undecided[0][1];
  }
  EXPECT_EQ(reasons.size(), 20u);
  EXPECT_EQ(reasons["zero_deviator_vertex"], "");
  EXPECT_EQ(reasons["zero_deviator_inside"], "zero_deviator_inside");
  EXPECT_EQ(reasons["level_constant_in_cell"], "level_constant_in_cell");
  EXPECT_EQ(reasons["plane_strain"], "");
  EXPECT_EQ(reasons["vertex_on_level"], "");
  EXPECT_EQ(reasons["antiplane_shear"], "level_constant_in_cell");
  for (const char* name : {"rank_two", "rank_one", "rank_zero"})
    EXPECT_EQ(reasons.at(name), "") << name;
}

TEST(Generate, WritesTheReferenceBeside) {
  const Folder folder;
  generated({"linear", "-o", folder / "f.vtu", "--mode", "0.5"});
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"f.reference.json", "f.reference.vtp",
                                                      "f.truth.json", "f.vtu"}));
  const Json points = Json::parse(contents(folder / "f.reference.json"));
  const Json truth = Json::parse(contents(folder / "f.truth.json"));
  const Json& reference = truth["levels"][0]["reference"];
  EXPECT_EQ(points[0]["vertices"].size(), reference["vertices"]);
  EXPECT_LT(points[0]["bound"], 1e-31);
  EXPECT_TRUE(points[0]["unproved"].empty());
  for (const Json& vertex : points[0]["vertices"])
    for (const Json& x : vertex) EXPECT_EQ(x.get<std::string>().find("nan"), std::string::npos);
  // Large meshes have no reference and no lists, unless asked for.
  generated({"kelvin", "-o", folder / "k.vtu", "--mode", "0.5", "--tets", "10001"});
  const Json large = Json::parse(contents(folder / "k.truth.json"));
  EXPECT_FALSE(large["levels"][0].contains("edges"));
  EXPECT_FALSE(large["levels"][0].contains("reference"));
  EXPECT_GT(large["levels"][0]["components"].size(), 0u);
}

TEST(Generate, RefusesWhatItCannotDo) {
  const Folder folder;
  EXPECT_EQ(run_program({"generate", "linear", "-o", folder / "a.vtp"}).status, 2);
  EXPECT_EQ(run_program({"generate", "spiral", "-o", folder / "a.vtu"}).status, 2);
  EXPECT_EQ(run_program({"generate", "linear", "-o", folder / "a.vtu", "--mode", "1"}).status, 2);
  EXPECT_EQ(run_program({"generate", "linear", "-o", folder / "none/a.vtu"}).status, 4);
  EXPECT_TRUE(folder.files().empty());
}

// Side by side members are what they are alone.
TEST(Generate, SaysOfEachComponentWhoseItIs) {
  const Folder folder;
  const std::vector<std::string> same{"--seed", "1", "--no-reference", "--mode", "1/2"};
  const auto made = [&](const std::string& kind, const std::string& file, std::string count,
                        bool together) {
    std::vector<std::string> words{kind, "-o", folder / (file + ".vtu"), "--count", count};
    words.insert(words.end(), same.begin(), same.end());
    if (together) words.push_back("--together");
    return generated(words)["files"];
  };
  using Components = std::vector<std::array<int, 2>>;
  const auto shape = [](const Json& c) {
    return std::array<int, 2>{c["euler_characteristic"], c["boundary_loops"]};
  };
  for (const std::string kind : {"nongeneric", "complex"}) {
    const std::string sheet = kind + "-sheet";
    const std::string count = kind == "complex" ? "3" : "16";
    made(kind, sheet, count, true);
    const Json all = Json::parse(contents(folder / (sheet + ".truth.json")));
    std::map<int, Components> of_member;
    for (const Json& c : all["levels"][0]["components"]) {
      const int member = c.at("member");
      of_member[member].push_back(shape(c));
    }
    const Json files = made(kind, kind, count, false);
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < files.size(); ++i) {
      const Json alone = Json::parse(contents(files[i]["truth"].get<std::string>()));
      Components components;
      for (const Json& c : alone["levels"][0]["components"]) {
        EXPECT_FALSE(c.contains("member"));
        components.push_back(shape(c));
      }
      EXPECT_EQ(of_member[static_cast<int>(i)], components) << kind << i;
      notes.push_back(alone["note"]);
    }
    const bool differ = notes.front() != notes.back();
    EXPECT_EQ(all.value("notes", std::vector<std::string>{}),
              differ ? notes : std::vector<std::string>{});
    // A surface can be scored against that file.
    run_program({"extract", folder / (sheet + ".vtu"), "-o", folder / "s.vtp", "--mode", "1/2"});
    const Outcome scored = run_program({"conformance", "--surface", folder / "s.vtp", "--input",
                                        folder / (sheet + ".vtu"), "--mode", "1/2", "--truth",
                                        folder / (sheet + ".truth.json")});
    EXPECT_EQ(scored.status, 0) << scored.out << scored.err;
  }
}

// The tables in the suite's pages are those of its truth files, and every picture is there.
TEST(BundledSuite, PagesSayWhatTheTruthFilesSay) {
  const std::filesystem::path suite(TENSORTOPO_SUITE);
  const Folder folder;
  const std::string command = "TENSORTOPO_SUITE_PAGES='" + (folder / "") + "' bash '" +
                              (suite / "make").string() + "' pages";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::vector<std::string> pages = folder.files();
  EXPECT_EQ(pages.size(), 9u);
  for (const std::string& page : pages) {
    const std::string text = contents(folder / page);
    EXPECT_EQ(text, contents(suite / page)) << "examples/suite/make pages writes it anew";
    std::size_t pictures = 0;
    for (std::size_t at = text.find("](pictures/"); at != std::string::npos;
         at = text.find("](pictures/", at + 1), ++pictures) {
      const std::string name = text.substr(at + 2, text.find(')', at) - at - 2);
      EXPECT_TRUE(std::filesystem::is_regular_file(suite / name)) << name;
    }
    const std::string truth = std::filesystem::path(page).stem().string() + ".truth.json";
    EXPECT_EQ(pictures, Json::parse(contents(suite / truth))["levels"].size()) << page;
  }
}

// The fields in examples/suite are what suite.json lists, and their truths hold. The short suite
// generates every other.
TEST(BundledSuite, IsWhatIsGeneratedAndCertifiedNow) {
  const std::filesystem::path suite(TENSORTOPO_SUITE);
  const Json list = Json::parse(contents(suite / "suite.json"));
  const Folder folder;
  int kinds = 0;
  Share share(2);
  for (const Json& entry : list["suite"]) {
    if (entry.contains("file")) continue;  // not generated
    if (!share.has("kind")) continue;
    const auto kind = entry["kind"].get<std::string>();
    std::vector<std::string> command{kind,
                                     "-o",
                                     folder / (kind + ".vtu"),
                                     "--together",
                                     "--no-reference",
                                     "--seed",
                                     entry["seed"].dump(),
                                     "--count",
                                     entry["count"].dump()};
    if (entry.contains("tetrahedra"))
      command.insert(command.end(), {"--tets", entry["tetrahedra"].dump()});
    const Json bundled = Json::parse(contents(suite / (kind + ".truth.json")));
    for (const Json& level : bundled["levels"])
      command.insert(command.end(), {"--mode", level["mode"].get<std::string>()});
    generated(command);
    EXPECT_EQ(field_sha256(read_mesh(suite / (kind + ".vtu")).mesh), bundled["field"]["sha256"]);
    const Json now = Json::parse(contents(folder / (kind + ".truth.json")));
    ASSERT_EQ(now["levels"].size(), bundled["levels"].size());
    for (std::size_t i = 0; i < now["levels"].size(); ++i) {
      const Json &then = bundled["levels"][i], &level = now["levels"][i];
      // What was undecided may have become known; nothing else may change.
      if (then["undecided"].empty()) {
        EXPECT_EQ(level, then) << kind;
      } else {
        EXPECT_LE(level["undecided"].size(), then["undecided"].size()) << kind;
      }
    }
    ++kinds;
  }
  EXPECT_EQ(kinds, full_or_short(9, 5));
}

}  // namespace
}  // namespace tensortopo::test
