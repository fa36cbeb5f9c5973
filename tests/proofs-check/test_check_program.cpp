// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The two programs: exit status, and what goes where.
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"
#include "proofs-check/forgeries/certificate_writer.hpp"
#include "support/fields/random_fields.hpp"
#include "tensortopo/io/write_mesh.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

CertifiedSurface small_surface(const Folder& folder) {
  TetMesh mesh = cube_mesh(1);
  fill_with_smooth_tensors(mesh, 3);
  return certified_surface(mesh, {"0"}, folder / "files");
}

TEST(CheckProgram, SaysWhatItFoundByStatusAndJson) {
  const Folder folder;
  const CertifiedSurface s = small_surface(folder);
  const auto run = [&](const Json& document) {
    return run_program({"check", s.input(), s.surface(), s.write(document), "--json"});
  };
  const Outcome good = run(s.certificate);
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_EQ(good.err, "");
  const Json report = Json::parse(good.out);
  EXPECT_EQ(report.at("status"), "certified");
  EXPECT_EQ(report.at("claims"), report.at("certified"));
  EXPECT_EQ(report.at("refuted"), 0);
  EXPECT_EQ(report.at("undecided"), 0);

  Json forged = s.certificate;
  forged["levels"][0]["on_level"] = 1;
  const Outcome bad = run(forged);
  EXPECT_EQ(bad.status, 1);
  const Json witness = Json::parse(bad.out).at("witnesses").at(0);
  EXPECT_EQ(witness.at("claimed"), "1");
  EXPECT_EQ(witness.at("derived"), "0");

  forged = s.certificate;  // it claims nothing of any tetrahedron
  auto& level = forged["levels"][0];
  for (int t = 0; t < 6; ++t) level["undecided"].push_back({t, "budget_exhausted"});
  for (const char* list : {"edges", "faces", "tets"}) level[list] = Json::array();
  const Outcome open = run(forged);
  EXPECT_EQ(open.status, 1);
  EXPECT_EQ(Json::parse(open.out).at("status"), "undecided");
}

TEST(CheckProgram, RefusesFilesInOneLine) {
  const Folder folder;
  const CertifiedSurface s = small_surface(folder);
  const std::string file = folder / "broken.json";
  std::ofstream(file) << "{";
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"check", s.input(), s.surface(), file},
           {"check", s.input(), s.surface(), folder / "missing.json"},
           {"check", s.surface(), s.surface(), s.write(s.certificate)}}) {
    expect_line(run_program(arguments), 3, "");
  }
  EXPECT_EQ(run_program({"check", s.input()}).status, 2);
}

TEST(CheckProgram, WritesNoCharactersThatATerminalObeys) {
  const Folder folder;
  const CertifiedSurface s = small_surface(folder);
  const std::string field = folder / "field.vtk";
  // A control sequence, and text from right to left, in the place of a keyword.
  std::ofstream(field) << "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                       << "POINTS 0 double\nCELLS 0 0\nCELL_TYPES 0\nPOINT_DATA 0\n\xc2\x9b"
                       << "31m\xe2\x80\xae x T double\n";
  const Outcome run = run_program({"check", field, s.surface(), s.write(s.certificate)});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find('?'), std::string::npos) << run.err;
  for (const char c : run.err)
    EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << static_cast<int>(c);
}

TEST(CheckProgram, SaysInWordsWhatIsNoCertificate) {
  const Folder folder;
  const CertifiedSurface s = small_surface(folder);
  for (const char* text : {"[]", "3", "{}", "hello", ""}) {
    const std::string file = folder / "c.json";
    std::ofstream(file) << text;
    const Outcome run = run_program({"check", s.input(), s.surface(), file});
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(run.err.starts_with("tensortopo: " + file + ": ")) << run.err;
    EXPECT_EQ(run.err.find(": : "), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("json.exception"), std::string::npos) << run.err;
  }
}

TEST(CheckProgram, NamesTheFileThatIsWrong) {
  const Folder folder;
  const CertifiedSurface s = small_surface(folder);
  Json forged = s.certificate;
  forged["input"]["components"] = "nye";
  const std::string file = s.write(forged);
  const Outcome run = run_program({"check", s.input(), s.surface(), file});
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(run.err.starts_with("tensortopo: " + file + ": /input/components: ")) << run.err;
}

TEST(CheckProgram, CertifiesSheetsDrawnAsGraphs) {
  const Folder folder;
  const std::vector<std::string> files{field("s4_slab"), folder / "s.vtp", folder / "c.json"};
  const Outcome made = run_program({"extract", files[0], "-o", files[1], "--mode", "0.5",
                                    "--method", "manifold", "--certify", files[2]});
  EXPECT_EQ(made.status, 0) << made.err;
  const Outcome checked = run_program({"check", files[0], files[1], files[2]});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
}

TEST(CheckProgram, CertifiesWhatExtractClaimsOfInvariants) {
  const Folder folder;
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 3);
  for (const bool has_zero : {false, true}) {
    if (has_zero) mesh.tensors[13] = {};
    write_mesh(mesh, folder / "m.vtu");
    const Outcome made = run_program({"extract", folder / "m.vtu", "-o", folder / "s.vtp",
                                      "--invariant", "anisotropy", "--value", "0.9", "--value",
                                      "4/5", "--certify", folder / "c.cbor", "--json"});
    EXPECT_EQ(made.status, has_zero ? 1 : 0) << made.err;
    const Json said = Json::parse(made.out).at("certificate");
    EXPECT_EQ(said.at("status"), has_zero ? "undecided" : "certified");
    EXPECT_EQ(said.at("undecided").contains("zero_tensor"), has_zero);
    const Outcome checked =
        run_program({"check", folder / "m.vtu", folder / "s.vtp", folder / "c.cbor", "--json"});
    EXPECT_EQ(checked.status, has_zero ? 1 : 0) << checked.err;
    const Json report = Json::parse(checked.out);
    EXPECT_EQ(report.at("refuted"), 0);
    EXPECT_EQ(report.at("undecided"), has_zero ? said.at("undecided").at("zero_tensor") : Json(0));
  }
}

TEST(CheckProgram, CertifiesWhatExtractClaimsOfDegenerateCurves) {
  const Folder folder;
  for (const std::string name : {"c.json", "c.cbor"}) {
    const std::vector<std::string> files{field("s4_slab"), folder / "s.vtp", folder / name};
    const Outcome made = run_program({"extract", files[0], "-o", files[1], "--mode", "1",
                                      "--generalized", "--certify", files[2], "--json"});
    EXPECT_EQ(made.status, 0) << made.err;
    const Json said = Json::parse(made.out).at("certificate");
    EXPECT_EQ(said.at("status"), "certified");
    std::size_t sum = 0;
    for (const auto& [kind, count] : said.at("kinds").items()) sum += count.get<std::size_t>();
    EXPECT_EQ(said.at("certified"), sum);
    const Outcome checked = run_program({"check", files[0], files[1], files[2], "--json"});
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    const Json kinds = Json::parse(checked.out).at("kinds");
    // Each list has a claim that it is complete, and lines one that they are the pieces.
    EXPECT_EQ(kinds.at("faces").at("certified"), said.at("kinds").at("faces").get<int>() + 2);
    EXPECT_EQ(kinds.at("curves").at("certified"), said.at("kinds").at("curves").get<int>() + 2);
    // A certificate is of curves or of surfaces, as its file is.
    const Outcome other = run_program({"extract", files[0], "-o", files[1], "--mode", "0.5"});
    EXPECT_EQ(other.status, 0);
    EXPECT_EQ(run_program({"check", files[0], files[1], files[2]}).status, 3);
  }
}

/// Plane strain: what is special is named, and asked-for certainty is missing.
TEST(CheckProgram, LeavesSpecialPositionsOfCurvesUndecided) {
  const Folder folder;
  TetMesh mesh = cube_mesh(2);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& p = mesh.points[v];
    mesh.tensors[v] = {p.x - 0.75, 0.75 - p.x, 4, p.y - 0.625, 0, 0};
  }
  write_mesh(mesh, folder / "m.vtu");
  const Outcome made = run_program({"extract", folder / "m.vtu", "-o", folder / "s.vtp", "--mode",
                                    "1", "--certify", folder / "c.json", "--json"});
  EXPECT_EQ(made.status, 1);
  const Json said = Json::parse(made.out).at("certificate");
  EXPECT_EQ(said.at("status"), "undecided");
  std::size_t sum = 0;
  for (const auto& [reason, count] : said.at("undecided").items()) sum += count.get<std::size_t>();
  const Outcome checked =
      run_program({"check", folder / "m.vtu", folder / "s.vtp", folder / "c.json", "--json"});
  EXPECT_EQ(checked.status, 1);
  const Json report = Json::parse(checked.out);
  EXPECT_EQ(report.at("refuted"), 0);
  EXPECT_EQ(report.at("undecided"), sum);
}

}  // namespace
}  // namespace tensortopo::test
