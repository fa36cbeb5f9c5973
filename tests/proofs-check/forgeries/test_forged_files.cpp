// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Files of forgers, and of honest people, in tests/proofs-check/cases.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

#include "certificate_check/check_certificate.hpp"

namespace tensortopo::test {
namespace {

struct Case {
  const char *folder, *field, *surface, *certificate, *verdict, *witness;
};

constexpr std::array kCases{
    Case{"further_vertices", "field.vtk", "honest.vtp", "honest.json", "certified",
         "1 component: Euler characteristic -1, 1 boundary loop"},
    // Two more vertices of a crossing, inside a disc, where one fan of tetrahedra is.
    Case{"further_vertices", "field.vtk", "forged.vtp", "forged.json", "refuted",
         "two vertices of a crossing in one tetrahedron"},
    Case{"positions", "o.vtk", "all_at_1e300.vtp", "all_at_1e300.json", "refuted",
         "not in the interval"},
    Case{"positions", "o.vtk", "moved_77_of_78_f.vtp", "moved_77_of_78_f.json", "refuted",
         "place of vertex"},
    Case{"orientation", "d.vtk", "f.vtp", "f.json", "refuted", "the other sign"},
    Case{"two_components", "o.vtk", "f.vtp", "f.json", "refuted", "derived 1 component"},
    Case{"no_level", "b.vtk", "f.vtp", "f.json", "undecided", "claims nothing about any level"},
    // One closed curve around each of two degenerate points that are next to each other.
    Case{"near_curves", "a.vtk", "a.vtp", "a.json", "certified", "tetrahedra without claims: none"},
    Case{"near_curves", "b.vtk", "b.vtp", "b.json", "certified", "tetrahedra without claims: none"},
    // Each point in a box that holds its whole face, and vertices in corners of these.
    Case{"curves_far_away", "field.vtu", "curves.vtp", "curves.json", "certified",
         "residual at most 1.78, at the vertices as written"},
    Case{"two_sections", "b.vtk", "two_polys.vtp", "f.json", "malformed",
         "has two sections 'Polys'"},
    Case{"two_sections", "b.vtk", "f.vtp", "f.json", "malformed", "has two sections 'Points'"},
    Case{"bad_texts", "base.vtk", "base.vtk", "bad_key.cbor", "malformed", "no UTF-8"},
    Case{"bad_texts", "base.vtk", "base.vtk", "bad_utf8.cbor", "malformed", "no UTF-8"},
    Case{"bad_texts", "base.vtk", "base.vtk", "rc70.cbor", "malformed", "no UTF-8"},
    Case{"bad_texts", "base.vtk", "base.vtk", "control_characters.json", "malformed",
         "a text with control characters"},
};

TEST(ForgedFiles, AreAnsweredAsTheyMustBe) {
  for (const Case& c : kCases) {
    const std::string folder = std::string(TENSORTOPO_CASES "/") + c.folder + '/';
    std::string verdict, text;
    try {
      const auto report = certificate::check_certificate(folder + c.field, folder + c.surface,
                                                         folder + c.certificate);
      verdict = report.status(), text = to_text(report);
    } catch (const certificate::Malformed& error) {
      verdict = "malformed", text = error.what();
    }
    EXPECT_EQ(verdict, c.verdict) << c.folder << ' ' << c.certificate << '\n' << text;
    EXPECT_NE(text.find(c.witness), std::string::npos) << c.folder << '\n' << text;
  }
}

TEST(ForgedFiles, VerdictsSayWhatWasCertified) {
  const std::string folder = TENSORTOPO_CASES "/further_vertices/";
  const auto report = certificate::check_certificate(folder + "field.vtk", folder + "honest.vtp",
                                                     folder + "honest.json");
  EXPECT_EQ(report.subject.tensor, "stress");
  EXPECT_EQ(report.subject.listing, "XX XY XZ YX YY YZ ZX ZY ZZ");
  EXPECT_EQ(report.subject.tetrahedra, 1u);
  ASSERT_EQ(report.levels.size(), 1u);
  EXPECT_EQ(report.levels[0].name, "mode 0");
  ASSERT_EQ(report.levels[0].components.size(), 1u);
  EXPECT_EQ(report.levels[0].components[0].euler_characteristic, -1);
  EXPECT_EQ(report.levels[0].components[0].boundary_loops, 1u);
  EXPECT_EQ(report.levels[0].left_out_count(), 0u);
  const std::string json = to_json(report);
  for (const char* part :
       {"\"tensor\":\"stress\"", "\"order\":\"full\"", "\"level\":\"mode 0\"",
        "\"euler_characteristic\":-1", "\"left_out\":{}", "\"unmet_demands\":[]"})
    EXPECT_NE(json.find(part), std::string::npos) << part << '\n' << json;
}

TEST(ForgedFiles, DemandsAreMetOrNot) {
  const std::string folder = TENSORTOPO_CASES "/further_vertices/";
  const auto report = certificate::check_certificate(folder + "field.vtk", folder + "honest.vtp",
                                                     folder + "honest.json");
  const auto unmet = [&](const certificate::Demands& d) { return report.unmet(d).size(); };
  EXPECT_EQ(unmet({}), 0u);
  EXPECT_EQ(unmet({{"0", "0.0", "0/3"}, "stress", true}), 0u);
  EXPECT_EQ(unmet({{"0.5"}, "", false}), 1u);
  EXPECT_EQ(unmet({{}, "strain", false}), 1u);
  EXPECT_THROW(report.unmet({{"half"}, "", false}), std::invalid_argument);
  const auto forged = certificate::check_certificate(folder + "field.vtk", folder + "forged.vtp",
                                                     folder + "forged.json");
  EXPECT_EQ(forged.unmet({{"0"}, "", false}).size(), 1u);
}

/// Where no mode is defined nothing is left out; but a verdict says where that is.
TEST(ForgedFiles, TetrahedraWithoutAModeAreCounted) {
  Court court("isotropic");
  for (std::size_t isotropic = 0; isotropic <= 2; ++isotropic) {
    TetMesh mesh = two_tets_at_an_edge();
    for (std::size_t t = 0; t < isotropic; ++t)
      for (const auto v : mesh.tets[t])
        mesh.tensors[static_cast<std::size_t>(v)] = {3, 3, 3, 0, 0, 0};
    const Exhibit e = exhibit(mesh, {"0"});
    EXPECT_EQ(court.verdict(e), "certified") << court.report();
    EXPECT_EQ(court.report().find("(in " + std::to_string(isotropic) + " all tensors") !=
                  std::string::npos,
              isotropic > 0)
        << court.report();
  }
  certificate::Report report;
  report.levels.emplace_back();
  report.subject.tetrahedra = 2;
  for (std::size_t isotropic = 0; isotropic <= 2; ++isotropic) {
    report.subject.isotropic = isotropic;
    EXPECT_EQ(report.unmet({{}, "", true}).size(), isotropic == 2 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace tensortopo::test
