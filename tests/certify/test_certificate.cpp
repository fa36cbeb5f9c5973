// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "certify_case.hpp"
#include "tensortopo/certify/certificate.hpp"

namespace tensortopo::test {
namespace {

std::string bytes_of(const TetMesh& mesh, const std::vector<CertifiedLevel>& levels,
                     CertificateEncoding encoding) {
  CertificateSubject subject;
  subject.tensor = "stress";
  subject.components = "vtk";
  subject.points = mesh.points.size();
  subject.tetrahedra = mesh.tets.size();
  return certificate_bytes(subject, levels, mesh, encoding);
}

TetMesh mesh_with_ids() {
  TetMesh mesh = cube_mesh(2);
  fill_with_normal_tensors(mesh, 20241115);
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(1000 + 3 * t));
  return mesh;
}

TEST(Certificate, SaysTheSameInJsonAndCbor) {
  const TetMesh mesh = mesh_with_ids();
  const std::vector<CertifiedLevel> levels{certified(mesh, "1/2").level,
                                           certified(mesh, "-1/2").level};
  const auto json = nlohmann::json::parse(bytes_of(mesh, levels, CertificateEncoding::json));
  const auto cbor = nlohmann::json::from_cbor(bytes_of(mesh, levels, CertificateEncoding::cbor));
  EXPECT_EQ(json, cbor);
  EXPECT_GT(json.at("levels").at(0).at("tets").size(), 0u);
}

TEST(Certificate, IsInTheShortestFormOfItsDocument) {
  using Json = nlohmann::ordered_json;
  const TetMesh mesh = mesh_with_ids();
  const std::vector<CertifiedLevel> both{certified(mesh, "1/2").level,
                                         certified(mesh, "-1/2").level};
  for (const auto& levels : {both, std::vector<CertifiedLevel>()}) {
    const auto text = bytes_of(mesh, levels, CertificateEncoding::json);
    EXPECT_EQ(text, Json::parse(text).dump() + '\n');
    const auto cbor = bytes_of(mesh, levels, CertificateEncoding::cbor);
    std::string again;
    Json::to_cbor(Json::from_cbor(cbor), again);
    EXPECT_EQ(cbor, again);
    EXPECT_EQ(Json::parse(text).at("levels").size(), levels.size());
  }
}

TEST(Certificate, IsTheSameFromTheFieldOfTheExtraction) {
  const TetMesh mesh = mesh_with_ids();
  const PreparedField<double> field(mesh);
  const ModeValue mode = ModeValue::parse("1/2");
  ExtractOptions options;
  options.keep_topology = true;
  Extraction extraction = extract_mode_surface(field, mode, options);
  const auto bytes = bytes_of(mesh, {certify(field, mode, extraction)}, CertificateEncoding::json);
  EXPECT_EQ(bytes, bytes_of(mesh, {certified(mesh, "1/2").level}, CertificateEncoding::json));
  EXPECT_FALSE(nlohmann::json::parse(bytes).at("levels").at(0).at("tets").empty());
}

TEST(Certificate, NumbersTheVerticesOfAllLevelsThroughAndCallsTetrahedraByTheirIds) {
  const TetMesh mesh = mesh_with_ids();
  const std::vector<CertifiedLevel> levels{certified(mesh, "1/2").level,
                                           certified(mesh, "-1/2").level};
  const auto json = nlohmann::json::parse(bytes_of(mesh, levels, CertificateEncoding::json));
  std::size_t first_vertex = 0, first_triangle = 0;
  for (std::size_t l = 0; l < 2; ++l) {
    const auto& level = json.at("levels").at(l);
    EXPECT_EQ(level.at("vertices"), nlohmann::json::array({first_vertex, levels[l].vertices}));
    EXPECT_EQ(level.at("triangles"), nlohmann::json::array({first_triangle, levels[l].triangles}));
    std::set<std::size_t> crossings;
    for (const auto& edge : level.at("edges"))
      for (std::size_t k = 2; k < edge.size(); ++k)
        EXPECT_TRUE(crossings.insert(edge[k].at(2).get<std::size_t>()).second);
    ASSERT_FALSE(crossings.empty());
    EXPECT_GE(*crossings.begin(), first_vertex);
    EXPECT_LT(*crossings.rbegin(), first_vertex + levels[l].vertices);
    for (const auto& tet : level.at("tets")) EXPECT_EQ((tet.at(0).get<int>() - 1000) % 3, 0);
    first_vertex += levels[l].vertices;
    first_triangle += levels[l].triangles;
  }
}

TEST(Certificate, HoldsNoNumberThatWasRounded) {
  const TetMesh mesh = mesh_with_ids();
  const std::vector<CertifiedLevel> levels{certified(mesh, "1/3").level};
  const auto json = nlohmann::json::parse(bytes_of(mesh, levels, CertificateEncoding::json));
  std::function<void(const nlohmann::json&)> check = [&](const nlohmann::json& j) {
    EXPECT_FALSE(j.is_number_float());
    if (j.is_structured())
      for (const auto& child : j) check(child);
  };
  check(json);
  EXPECT_EQ(json.at("levels").at(0).at("mode"), "1/3");
  const std::string bound = json.at("levels").at(0).at("distance").at("bound");
  EXPECT_EQ(std::strtod(bound.c_str(), nullptr), levels[0].distance.bound);
}

}  // namespace
}  // namespace tensortopo::test
