// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "analysis/run_program.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;
using Index = SurfaceMesh::Index;

// A small field with three components of mode 1/2, and a right surface to spoil.
class Conformance : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_program({"generate", "complex", "-o", mesh_file, "--mode", "1/2"}).status, 0);
    mesh = read_mesh(mesh_file).mesh;
    const auto extraction = extract_mode_surface<double>(mesh, ModeValue::parse("1/2"));
    right.points = extraction.surface.points;
    right.triangles = extraction.surface.triangles;
    known = surface_invariants(right);
    ASSERT_GE(known.parts.size(), 2u);
    std::map<std::array<Index, 2>, int> uses;
    for (const auto& t : right.triangles)
      for (std::size_t i = 0; i < 3; ++i) ++uses[edge(t[i], t[(i + 1) % 3])];
    std::set<Index> rim;
    for (const auto& [e, count] : uses)
      if (count == 1) rim.insert(e.begin(), e.end());
    for (inner = 0; inner < right.triangles.size(); ++inner) {
      const auto& t = right.triangles[inner];
      if (std::none_of(t.begin(), t.end(), [&](Index v) { return rim.contains(v); })) break;
    }
    ASSERT_LT(inner, right.triangles.size());
  }

  static std::array<Index, 2> edge(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  Outcome run(const SurfaceMesh& surface, const std::string& extension = ".ply",
              const std::vector<std::string>& more = {}) const {
    const std::string file = folder / ("s" + extension);
    write_surface(surface, mesh, file);
    std::vector<std::string> all{"conformance", "--surface", file,  "--input",
                                 mesh_file,     "--mode",    "1/2", "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all);
  }
  Json score(const SurfaceMesh& surface, const std::string& extension = ".ply") const {
    const Outcome outcome = run(surface, extension);
    EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["conforms"], false);
    return json;
  }

  Folder folder;
  std::string mesh_file = folder / "field.vtu";
  TetMesh mesh;
  SurfaceMesh right;
  SurfaceInvariants known;
  std::size_t inner = 0;  ///< a triangle away from the boundary
};

TEST_F(Conformance, FindsNothingWrongWithOurOwnSurface) {
  for (const char* extension :
       {".vtp", ".ply", ".obj", ".off", ".stl"}) {  // .stl rounds to float32
    const Outcome outcome = run(right, extension, {"--truth", folder / "field.truth.json"});
    EXPECT_EQ(outcome.status, 0) << extension << ": " << outcome.out << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["conforms"], true);
    EXPECT_EQ(json["components"]["matched"], known.parts.size());
    EXPECT_EQ(json["seam_edges"], 0);
    EXPECT_GT(json["crossings"]["truth"], 20);
    EXPECT_LT(json["distance"]["sampled_to_truth"], 0.1);
    EXPECT_LT(json["distance"]["sampled_from_truth"], 0.1);
  }
}

// An .off keeps all that counts: doubles and shared vertices.
TEST_F(Conformance, ScoresAnOffFileAsTheSameInAVtp) {
  SurfaceMesh spoilt = right;
  spoilt.triangles.erase(spoilt.triangles.begin() + static_cast<std::ptrdiff_t>(inner));
  const auto score_of = [&](const char* extension) {
    Json json = score(spoilt, extension);
    json.erase("surface");
    json.erase("options");
    return json;
  };
  EXPECT_EQ(score_of(".off"), score_of(".vtp"));
}

TEST_F(Conformance, ReadsOffFilesOfOthersAndRefusesWhatIsNone) {
  const auto outcome_of = [&](const std::string& text) {
    std::ofstream(folder / "o.off") << text;
    return run_program({"conformance", "--surface", folder / "o.off", "--input", mesh_file,
                        "--mode", "1/2", "--json"});
  };
  // Comments, counts on the first line, Windows' ends of lines, colours, a polygon, a line.
  const Outcome read = outcome_of(
      "COFF 4 2 0 # by hand\r\n\r\n0 0 0 9 9 9\r\n.1 0 0 9 9 9\r\n.1 1e-1 0 9 9 9\r\n"
      "0 .1 0 9 9 9 # the last\r\n4 0 1 2 3 1 0 0\r\n2 0 2\r\n");
  EXPECT_EQ(read.status, 1) << read.err;
  const Json matches = Json::parse(read.out).at("matches");
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].at("given").at("triangles"), 2);
  for (const std::string text :
       {"", "# OFF\n", "0 0 0\n", "4OFF\n0 0 0\n", "OFF BINARY\n", "OFF\n1\n", "OFF\n-1 0 0\n",
        "OFF\n1 0 0\n", "OFF\n1 0 0\n0 0\n", "OFF\n1 0 0\n0 0 x\n", "OFF\n1 0 0\n0 0 1e999\n",
        "OFF\n1 0 0\n0 0 nan\n", "OFF\n99999999999999 1 0\n0 0 0\n", "OFF\n1e3 0 0\n",
        "OFF\n1 1 0\n0 0 0\n", "OFF\n1 1 0\n0 0 0\n3 0 0\n", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n",
        "OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "OFF\n1 1 0\n0 0 0\n0\n"}) {
    const Outcome run = outcome_of(text);
    EXPECT_EQ(run.status, 3) << text;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

// Rounded to float32, a triangle that is nearly along an edge of the mesh meets it elsewhere.
TEST(ConformanceOfAField, FindsNothingWrongWithOurOwnSurfaceInFloat32) {
  const Folder folder;
  const std::string surface = folder / "s.stl", mesh = field("s4_slab");
  ASSERT_EQ(run_program({"extract", mesh, "-o", surface, "--mode", "-9/10"}).status, 0);
  const Outcome outcome = run_program(
      {"conformance", "--surface", surface, "--input", mesh, "--mode", "-9/10", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json crossings = Json::parse(outcome.out)["crossings"];
  EXPECT_EQ(crossings["extra"], 0);
  EXPECT_EQ(crossings["missed"], 0);
  EXPECT_LE(crossings["unclear_edges"], 1);
}

// A file of several modes is as right for each as files of their own.
TEST_F(Conformance, TakesTheModeAskedForFromAFileOfSeveral) {
  const std::string file = folder / "several.vtp";
  const Outcome extracted = run_program({"extract", mesh_file, "-o", file, "--mode", "1/2",
                                         "--mode", "-3/10", "--mode", "1", "--json"});
  ASSERT_EQ(extracted.status, 0) << extracted.err;
  const Json surfaces = Json::parse(extracted.out)["surfaces"];
  ASSERT_EQ(surfaces.size(), 2u);
  for (const auto& [of, other] : {std::pair{0u, 1u}, std::pair{1u, 0u}}) {
    const Outcome outcome = run_program({"conformance", "--surface", file, "--input", mesh_file,
                                         "--mode", surfaces[of]["mode_exact"], "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["triangles"], surfaces[of]["triangles"]);
    EXPECT_EQ(json["other_modes"], surfaces[other]["triangles"]);
    EXPECT_EQ(json["components"]["matched"], surfaces[of]["components"]);
  }
  // A mode that the file does not have is missing from it.
  const Outcome none = run_program(
      {"conformance", "--surface", file, "--input", mesh_file, "--mode", "1/4", "--json"});
  EXPECT_EQ(none.status, 1) << none.err;
  EXPECT_EQ(Json::parse(none.out)["triangles"], 0);
  const Outcome text =
      run_program({"conformance", "--surface", file, "--input", mesh_file, "--mode", "1/4"});
  EXPECT_NE(text.out.find("has no triangles of this mode"), std::string::npos) << text.out;
}

// The level through a vertex exactly is a component of mu + 0 that no coordinates show.
TEST(ConformanceOfAField, LeavesOutComponentsWithoutExtent) {
  const Folder folder;
  const std::string surface = folder / "s.vtp", mesh = folder / "f.vtu";
  ASSERT_EQ(run_program({"generate", "nongeneric", "-o", mesh, "--mode", "4/5"}).status, 0);
  ASSERT_EQ(run_program({"extract", mesh, "-o", surface, "--mode", "4/5"}).status, 0);
  const Outcome outcome =
      run_program({"conformance", "--surface", surface, "--input", mesh, "--mode", "4/5", "--truth",
                   folder / "f.truth.json", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["components"]["without_extent"], 1);
  EXPECT_EQ(json["components"]["missed"].size(), 0u);
  EXPECT_EQ(json["seam_edges"], 0);
}

// Fans that meet in an isotropic vertex are no pinch, and the surface may end beside
// tetrahedra about which nothing is certified.
TEST(ConformanceOfAField, FindsNothingWrongWithOurOwnSurfaceAroundZeroDeviators) {
  const Folder folder;
  const std::string surface = folder / "s.vtp", file = folder / "f.vtu";
  std::size_t cones = 0, undecided = 0;
  for (int seed = 0; seed < 6; ++seed) {
    // Small integers on a cube of six tetrahedra, none of which has two of the vertices 3, 5, 6.
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    const auto digit = [&] { return static_cast<double>(static_cast<int>(random() % 3) - 1); };
    TetMesh mesh;
    for (int i = 0; i < 8; ++i) {
      mesh.points.push_back({double(i & 1), double((i >> 1) & 1), double(i >> 2)});
      const double xx = digit(), yy = digit(), zz = digit(), xy = random() % 2 == 0 ? 1 : -1;
      mesh.tensors.push_back(i == 3 || i == 5 || i == 6
                                 ? SymmetricTensor<double>{1, 1, 1, 0, 0, 0}
                                 : SymmetricTensor<double>{xx, yy, zz, xy, 0, 0});
    }
    // With this the deviator vanishes on an edge, and two tetrahedra stay undecided.
    if (seed % 2 == 1) mesh.tensors[1] = -1.0 * mesh.tensors[0];
    for (const auto& [a, b] : {std::pair{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}})
      mesh.tets.push_back({0, a, b, 7});
    mesh.cell_ids = {0, 1, 2, 3, 4, 5};
    write_mesh(mesh, file);
    for (const char* mode : {"0", "1/2"}) {
      const Outcome extracted =
          run_program({"extract", file, "-o", surface, "--mode", mode, "--json"});
      ASSERT_EQ(extracted.status, 0) << extracted.err;
      cones += Json::parse(extracted.out)["statistics"]["sheets_cones"].get<std::size_t>();
      const Outcome outcome = run_program(
          {"conformance", "--surface", surface, "--input", file, "--mode", mode, "--json"});
      EXPECT_EQ(outcome.status, 0) << seed << ' ' << mode << ": " << outcome.out << outcome.err;
      undecided += Json::parse(outcome.out)["undecided_tetrahedra"].get<std::size_t>();
    }
  }
  EXPECT_GT(cones, 10u);
  EXPECT_GT(undecided, 0u);
}

TEST_F(Conformance, FindsAMissingComponent) {
  SurfaceMesh surface = right;
  surface.triangles.clear();
  for (std::size_t i = 0; i < right.triangles.size(); ++i)
    if (known.component[i] != 0) surface.triangles.push_back(right.triangles[i]);
  const Json json = score(surface);
  ASSERT_EQ(json["components"]["missed"].size(), 1u);
  EXPECT_EQ(json["components"]["missed"][0]["euler_characteristic"],
            known.parts[0].euler_characteristic);
  EXPECT_EQ(json["components"]["matched"], known.parts.size() - 1);
  EXPECT_EQ(json["components"]["extra"].size(), 0u);
  EXPECT_EQ(json["crossings"]["extra"], 0);
}

TEST_F(Conformance, FindsEverythingMissing) {
  SurfaceMesh surface = right;
  surface.triangles.clear();
  surface.points.clear();
  for (const char* extension : {".vtp", ".ply", ".obj", ".off", ".stl"}) {
    const Json json = score(surface, extension);
    EXPECT_EQ(json["components"]["missed"].size(), known.parts.size()) << extension;
    EXPECT_EQ(json["crossings"]["missed"], json["crossings"]["truth"]) << extension;
    EXPECT_TRUE(json["distance"]["sampled_from_truth"].is_null()) << extension;
  }
}

TEST_F(Conformance, FindsAHole) {
  SurfaceMesh surface = right;
  surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(inner));
  const Json json = score(surface);
  EXPECT_EQ(json["holes"]["count"], 1);
  EXPECT_EQ(json["holes"]["edges"], 3);
  EXPECT_EQ(json["components"]["wrong_topology"], 1);
  EXPECT_EQ(json["components"]["missed"].size(), 0u);
}

TEST_F(Conformance, FindsASeam) {
  SurfaceMesh surface = right;
  for (Index& v : surface.triangles[inner]) {
    surface.points.push_back(surface.points[as_size(v)]);
    v = static_cast<Index>(surface.points.size()) - 1;
  }
  const Json exact = score(surface);
  EXPECT_EQ(exact["seam_edges"], 3);
  EXPECT_EQ(exact["merged_points"], 3);
  EXPECT_EQ(exact["components"]["wrong_topology"], 0);  // merged, it is right
  // Not even the coordinates agree: nothing is merged, and there is a crack. (VTK reads a .ply as
  // float32, in which they would.)
  for (std::size_t i = surface.points.size() - 3; i < surface.points.size(); ++i)
    surface.points[i].x += 1e-9;
  const Json near = score(surface, ".vtp");
  EXPECT_EQ(near["seam_edges"], 3);
  EXPECT_EQ(near["holes"]["edges"], 6);
}

TEST_F(Conformance, FindsAnAddedSphere) {
  SurfaceMesh surface = right;
  const auto first = static_cast<Index>(surface.points.size());
  const Vector3<double> c{0.21, 0.17, 0.33};
  for (const Vector3<double>& d : std::vector<Vector3<double>>{
           {0.01, 0, 0}, {-0.01, 0, 0}, {0, 0.01, 0}, {0, -0.01, 0}, {0, 0, 0.01}, {0, 0, -0.01}})
    surface.points.push_back(c + d);
  for (const Index z : {4, 5})
    for (const auto& [a, b] :
         std::vector<std::pair<Index, Index>>{{0, 2}, {2, 1}, {1, 3}, {3, 0}}) {
      std::array<Index, 3> t{first + a, first + b, first + z};
      if (z == 5) std::swap(t[0], t[1]);
      surface.triangles.push_back(t);
    }
  const Json json = score(surface);
  ASSERT_EQ(json["components"]["extra"].size(), 1u);
  EXPECT_EQ(json["components"]["extra"][0]["euler_characteristic"], 2);
  EXPECT_EQ(json["components"]["extra"][0]["boundary_loops"], 0);
  EXPECT_EQ(json["components"]["missed"].size(), 0u);
  EXPECT_EQ(json["holes"]["edges"], 0);
}

TEST_F(Conformance, FindsADisplacement) {
  SurfaceMesh surface = right;
  for (auto& p : surface.points) p = p + Vector3<double>{0.15, 0.1, -0.12};
  const Json json = score(surface);
  EXPECT_GT(json["distance"]["sampled_to_truth"], 0.1);
  EXPECT_GT(json["distance"]["sampled_from_truth"], 0.1);
  EXPECT_GT(json["holes"]["edges"], 10);  // its boundary is not the domain's
}

TEST_F(Conformance, FindsNonManifoldEdgesAndVertices) {
  SurfaceMesh surface = right;
  const auto t = surface.triangles[inner];
  const auto& p = surface.points;
  const auto n = cross(p[as_size(t[1])] - p[as_size(t[0])], p[as_size(t[2])] - p[as_size(t[0])]);
  surface.points.push_back(p[as_size(t[0])] + (0.05 / std::sqrt(dot(n, n))) * n);
  surface.triangles.push_back({t[0], t[1], static_cast<Index>(surface.points.size()) - 1});
  const Json json = score(surface);
  EXPECT_EQ(json["non_manifold"]["edges"], 1);
  // A triangle that hangs on one vertex.
  surface = right;
  const auto tip = surface.points[as_size(t[0])];
  const Vector3<double> up = (0.05 / std::sqrt(dot(n, n))) * n;
  surface.points.push_back(tip + up);
  surface.points.push_back(tip + up + 0.1 * (p[as_size(t[1])] - tip));
  const auto last = static_cast<Index>(surface.points.size()) - 1;
  surface.triangles.push_back({t[0], last - 1, last});
  EXPECT_EQ(score(surface)["non_manifold"]["vertices"], 1);
}

TEST_F(Conformance, FindsWrongCrossings) {
  const auto other = extract_mode_surface<double>(mesh, ModeValue::parse("-9/10"));
  SurfaceMesh surface;
  surface.points = other.surface.points;
  surface.triangles = other.surface.triangles;
  const Json json = score(surface);
  EXPECT_GT(json["crossings"]["missed"].get<int>() + json["crossings"]["extra"].get<int>(), 0);
  for (const Json& e : json["crossings"]["edges"]) EXPECT_NE(e["truth"], e["given"]);
}

TEST_F(Conformance, RefusesATruthThatIsNone) {
  EXPECT_EQ(run_program({"generate", "complex", "-o", folder / "other.vtu", "--seed", "2"}).status,
            0);
  EXPECT_EQ(run(right, ".ply", {"--truth", folder / "other.truth.json"}).status, 3);
  // A number changed by hand.
  std::string text = contents(folder / "field.truth.json");
  const auto at = text.find("\"mode\":\"1/2\"");
  ASSERT_NE(at, std::string::npos);
  const auto fact = text.find("\"boundary_loops\":", at);
  ++text[fact + std::string("\"boundary_loops\":").size()];
  std::ofstream(folder / "forged.truth.json") << text;
  const Outcome forged = run(right, ".ply", {"--truth", folder / "forged.truth.json"});
  EXPECT_EQ(forged.status, 3);
  EXPECT_NE(forged.err.find("contradicts"), std::string::npos) << forged.err;
  std::ofstream(folder / "broken.truth.json") << "{\"format\": \"tensortopo truth\"";
  EXPECT_EQ(run(right, ".ply", {"--truth", folder / "broken.truth.json"}).status, 3);
}

TEST_F(Conformance, SuiteScoresLinearContoursAgainstTruth) {
  std::ofstream(folder / "suite.json") << R"({"suite": [{"kind": "linear", "count": 4,
      "modes": ["1/2"]}, {"kind": "nongeneric", "count": 3}]})";
  const Outcome outcome = run_program({"conformance", "--suite", folder / "suite.json", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["cases"], 7);
  EXPECT_EQ(json["undecided"], 1);  // no deviator at a point of an edge
  ASSERT_EQ(json["results"].size(), 6u * 5);
  double first = 0, last = 0;
  bool has_first = false;
  for (const Json& result : json["results"]) {
    if (result["method"] == "tensortopo") {
      EXPECT_EQ(result["conforms"], true) << result;
    }
    // Linear contours have nothing at all where the mode changes next to an isotropic point.
    if (result["method"] == "linear contour") {
      has_first = !result["distance_from_truth"].is_null();
      if (has_first) first += result["distance_from_truth"].get<double>();
    }
    if (result["method"] == "subdivided 3x" && has_first)
      last += result["distance_from_truth"].get<double>();
  }
  EXPECT_LT(last, first / 4);
}

}  // namespace
}  // namespace tensortopo::test
