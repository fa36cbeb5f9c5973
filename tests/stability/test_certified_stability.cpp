// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The checker derives by itself which components are in all fields within a radius.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "certificate_check/check_certificate.hpp"
#include "crossing_counts.hpp"
#include "members.hpp"
#include "slab_with_radii.hpp"
#include "support/compared.hpp"
#include "support/fields/random_fields.hpp"
#include "support/folder.hpp"
#include "support/trials.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/stability/uncertain_field.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

struct Certified {
  std::string input, surface, certificate;
  ExtractReport report;
  Json claims;
};

Certified certified(const Folder& folder, const std::string& uncertainty,
                    const std::string& input = slab_file().string(), const char* mode = "0") {
  Certified result;
  result.input = input;
  result.surface = folder / "surface.vtp";
  result.certificate = folder / "certificate.json";
  ExtractCommand command;
  command.input = result.input;
  command.output = result.surface;
  command.certificate = result.certificate;
  command.modes = {ModeValue::parse(mode)};
  command.uncertainty = uncertainty;
  result.report = run_extract(command);
  std::ifstream(result.certificate) >> result.claims;
  return result;
}

certificate::Report check(const Certified& c, const certificate::Progress& progress = {}) {
  return certificate::check_certificate(c.input, c.surface, c.certificate, progress);
}

/// What the checker says of the claims as they are now.
std::string verdict_on(const Certified& c) {
  std::ofstream(c.certificate) << c.claims;
  try {
    return check(c).status();
  } catch (const certificate::Malformed&) {
    return "malformed";
  }
}

TEST(CertifiedStability, OfAnHonestExtractionIsDerivedByTheChecker) {
  Compared compared("stable components"), crossings("stable crossings", 500);
  const Folder folder;
  for (const char* radius : {"0.01%", "1%", "500"}) {
    const Certified c = certified(folder, radius);
    const certificate::Report report = check(c);
    EXPECT_EQ(report.status(), "certified") << radius;
    const certificate::LevelReport& level = report.levels.at(0);
    EXPECT_TRUE(level.claims_stability);
    EXPECT_EQ(level.radius_of_deviator, std::string(radius).ends_with('%'));
    EXPECT_EQ(level.stable_components.size(),
              c.report.surfaces.at(0).stability->summary.components.size());
    for (std::size_t i = 0; i < level.stable_components.size(); ++i) ++compared;
    EXPECT_EQ(level.stable_crossings,
              c.report.surfaces.at(0).stability->summary.crossed_simplices.size());
    for (std::size_t i = 0; i < level.stable_crossings; ++i) ++crossings;
  }
}

/// Where tensors differ by many orders of magnitude a certificate leaves out more than the
/// extraction does.
TEST(CertifiedStability, ComponentsBesideWhatIsUndecidedAreNotClaimed) {
  Compared checked("certificates"), compared("stable components that are not claimed", 1);
  const Folder folder;
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    TetMesh mesh = cube_mesh(1);
    fill_with_normal_tensors(mesh, seed);
    for (auto& t : mesh.tensors) t = std::ldexp(1, random.integer(-130, 40)) * t;
    const std::string field = folder / "field.vtu";
    write_mesh(mesh, field);
    for (const char* mode : {"0", "-1"}) {
      const Certified c = certified(folder, "0.1%", field, mode);
      EXPECT_NE(check(c).status(), "refuted") << seed << ' ' << mode;
      ++checked;
      const Json& claimed = c.claims.at("levels").at(0).at("stability").at("components");
      const auto& all = std::string(mode) == "0" ? c.report.surfaces.at(0).stability->summary
                                                 : c.report.curves.at(0).stability->summary;
      for (std::size_t i = claimed.size(); i < all.components.size(); ++i) ++compared;
    }
  }
}

/// How many crossings there are in each edge, or of curves face.
std::map<Simplex, std::size_t> crossings_in(const TetMesh& mesh, const char* mode) {
  if (std::string(mode) == "1")
    return crossings_of(extract_degenerate_curves(mesh, Degeneracy::linear).curves, Carrier::face);
  return crossings_of(extract_mode_surface<double>(mesh, ModeValue::parse(mode)).surface,
                      Carrier::edge);
}

/// Of these simplices the places of those that a member of the box crosses otherwise.
std::vector<std::size_t> crossed_otherwise(const Json& simplices, std::size_t vertices,
                                           const TetMesh& mesh, double radius, const char* mode) {
  const auto radii = vertex_radii(mesh, {Uncertainty::Kind::relative, radius, {}});
  const auto own = crossings_in(mesh, mode);
  Random random(1);
  std::vector<std::size_t> found;
  std::vector<char> is_known(simplices.size(), 0);
  for (int k = 0; k < 4; ++k) {
    const auto other = crossings_in(random_member(mesh, radii, random), mode);
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      Simplex simplex{-1, -1, -1, -1};
      for (std::size_t c = 0; c < vertices; ++c) simplex[c] = simplices[i][c].get<TetMesh::Index>();
      const auto a = own.find(simplex), b = other.find(simplex);
      const bool differ = (a == own.end() ? 0 : a->second) != (b == other.end() ? 0 : b->second);
      if (differ && is_known[i]++ == 0) found.push_back(i);
    }
  }
  return found;
}

TEST(CertifiedStability, CrossingsThatAreNotStableAreNotCertified) {
  const auto most = static_cast<std::size_t>(trials(16));
  Compared compared("edges and faces that members cross otherwise", most + most / 4);
  const Folder folder;
  const TetMesh mesh = read_mesh(slab_file(), {}).mesh;
  for (const char* mode : {"1/2", "1"}) {
    Certified c = certified(folder, "1%", slab_file().string(), mode);
    Json& level = c.claims.at("levels").at(0);
    Json& stability = level.at("stability");
    const Json honest = stability;
    const auto verdict = [&] { return verdict_on(c); };
    ASSERT_EQ(verdict(), "certified");
    const bool is_surface = level.contains("edges");
    const Json& simplices = level[is_surface ? "edges" : "faces"];
    auto otherwise = crossed_otherwise(simplices, is_surface ? 2 : 3, mesh, 0.01, mode);
    if (otherwise.size() > most) otherwise.resize(most);
    for (const std::size_t i : otherwise) {
      ++compared;
      stability["crossings"] = Json::array({i});
      EXPECT_NE(verdict(), "certified") << mode << ' ' << i;
    }
    const auto stable = honest["crossings"].get<std::vector<std::size_t>>();
    stability["crossings"] = Json::array({simplices.size()});
    EXPECT_EQ(verdict(), "refuted");
    stability["crossings"] = Json::array({stable[1], stable[0]});
    EXPECT_EQ(verdict(), "malformed");
    stability["crossings"] = Json::array({stable[0]});
    EXPECT_EQ(verdict(), "certified");
  }
}

TEST(CertifiedStability, OfRadiiInAnArrayIsDerivedFromTheSameArray) {
  const Folder folder;
  const std::vector<double> radii = slab_radii();
  Certified c = certified(folder, "array:error", write_slab(folder / "slab.vtk", radii));
  certificate::Report report = check(c);
  EXPECT_EQ(report.status(), "certified");
  EXPECT_EQ(report.levels.at(0).radius_array, "error");
  Compared compared("stable components");
  for (std::size_t i = 0; i < report.levels.at(0).stable_components.size(); ++i) ++compared;
  Json& stability = c.claims.at("levels").at(0).at("stability");
  const Json honest = stability;
  const auto verdict = [&] { return verdict_on(c); };
  stability["array"] = "S";
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["radius"] = "0x1p-3";
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["of"] = "tensor";
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability.erase("sha256");
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["sha256"] = std::string(64, '0');
  EXPECT_EQ(verdict(), "refuted");
  stability = honest;
  std::vector<double> other = radii;
  other[3] = other[3] / 2;
  write_slab(c.input, other);
  EXPECT_EQ(verdict(), "refuted");
  other[3] = -1;
  write_slab(c.input, other);
  EXPECT_EQ(verdict(), "malformed");
  write_slab(c.input, radii);
  EXPECT_EQ(verdict(), "certified");
}

/// The radii, too: who removes a file meanwhile changes nothing.
TEST(CertifiedStability, FilesAreReadOnce) {
  const Folder folder;
  const Certified c =
      certified(folder, "array:error", write_slab(folder / "slab.vtk", slab_radii()));
  int removed = 0;
  const certificate::Report report = check(c, [&](std::string_view, double) {
    for (const std::string& file : {c.input, c.surface, c.certificate})
      removed += std::filesystem::remove(file);
  });
  EXPECT_EQ(report.status(), "certified");
  EXPECT_EQ(removed, 3U);
}

TEST(CertifiedStability, WhatIsAlteredIsNotCertified) {
  const Folder folder;
  Certified c = certified(folder, "1%");
  Json& stability = c.claims.at("levels").at(0).at("stability");
  const Json honest = stability;
  const auto verdict = [&] { return verdict_on(c); };
  ASSERT_EQ(verdict(), "certified");
  const Json& components = c.claims["levels"][0]["components"];
  Compared compared("components that are not stable", 2);
  for (const Json& component : components) {
    const Json& first = component["first_vertex"];
    const auto& list = honest["components"];
    if (std::find(list.begin(), list.end(), first) != list.end()) continue;
    stability["components"] = Json::array({first});
    EXPECT_NE(verdict(), "certified") << first;
    ++compared;
  }
  ASSERT_FALSE(honest["components"].empty());
  stability = honest;
  stability["components"][0] = stability["components"][0].get<int>() + 1;
  EXPECT_NE(verdict(), "certified");
  stability = honest;
  stability["components"].push_back(honest["components"].back());  // twice
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["radius"] = "0x1p-3";
  EXPECT_EQ(verdict(), "refuted");
  stability = honest, stability["radius"] = "1/100";
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["of"] = "stress";
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability.erase("of");
  EXPECT_EQ(verdict(), "malformed");
  stability = honest, stability["more"] = 1;
  EXPECT_EQ(verdict(), "malformed");
  stability = honest;
  EXPECT_EQ(verdict(), "certified");
}

TEST(CertifiedStability, OfDegenerateCurvesIsDerivedByTheChecker) {
  Compared compared("stable components of curves");
  const Folder folder;
  for (const char* mode : {"1", "-1"})
    for (const char* radius : {"0.0001%", "0.1%", "0.5"}) {
      const Certified c = certified(folder, radius, slab_file().string(), mode);
      const certificate::Report report = check(c);
      EXPECT_EQ(report.refuted, 0u) << radius;
      // Special positions are left undecided, stable components are not.
      const certificate::LevelReport& level = report.levels.at(0);
      EXPECT_TRUE(level.claims_stability);
      EXPECT_EQ(level.stable_components.size(),
                c.report.curves.at(0).stability->summary.components.size())
          << radius << " mode " << mode;
      for (std::size_t i = 0; i < level.stable_components.size(); ++i) ++compared;
    }
}

TEST(CertifiedStability, WhatIsAlteredOfDegenerateCurvesIsNotCertified) {
  const Folder folder;
  Certified c = certified(folder, "0.1%", slab_file().string(), "1");
  Json& level = c.claims.at("levels").at(0);
  Json& stability = level.at("stability");
  const Json honest = stability;
  const auto certified_now = [&] {
    std::ofstream(c.certificate) << c.claims;
    try {
      const certificate::Report report = check(c);
      return report.refuted > 0 ? -1
                                : static_cast<int>(report.levels.at(0).stable_components.size());
    } catch (const certificate::Malformed&) {
      return -2;
    }
  };
  const int all = static_cast<int>(honest["components"].size());
  ASSERT_GT(all, 0);
  ASSERT_EQ(certified_now(), all);
  Compared compared("components that are not stable");
  for (const Json& curve : level["curves"]) {
    const auto& list = honest["components"];
    if (std::find(list.begin(), list.end(), curve["first_vertex"]) != list.end()) continue;
    stability["components"] = Json::array({curve["first_vertex"]});
    EXPECT_LE(certified_now(), 0) << curve;
    ++compared;
  }
  stability = honest, stability["radius"] = "0x1p-1";
  EXPECT_LT(certified_now(), all);
  stability = honest;
  stability["components"][0] = stability["components"][0].get<int>() + 1;
  EXPECT_EQ(certified_now(), -1);
  stability = honest, stability["of"] = "mode";
  EXPECT_EQ(certified_now(), -2);
  stability = honest, level["mode"] = "-1";
  EXPECT_EQ(certified_now(), -1);
}

}  // namespace
}  // namespace tensortopo::test
