// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// No number in a certificate can be altered unseen.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <random>

#include "certificate_check/check_certificate.hpp"
#include "certificate_writer.hpp"
#include "support/fields/random_fields.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

/// A small certified surface with everything but closed curves.
const CertifiedSurface& honest() {
  static const CertifiedSurface surface = [] {
    TetMesh mesh = cube_mesh(2);
    fill_with_smooth_tensors(mesh, 3);
    return certified_surface(
        mesh, {"1/2", "-1/4"},
        std::filesystem::path(testing::TempDir()) / ("forged_" + std::to_string(getpid())));
  }();
  return surface;
}

std::string verdict(const Json& document) {
  const CertifiedSurface& s = honest();
  try {
    return certificate::check_certificate(s.input(), s.surface(), s.write(document, "f.json"))
        .status();
  } catch (const certificate::Malformed&) {
    return "malformed";
  }
}

void find_numbers(const Json& value, const Json::json_pointer& at,
                  std::vector<Json::json_pointer>& found) {
  if (value.is_number() || value.is_boolean()) found.push_back(at);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) find_numbers(value[i], at / i, found);
  if (value.is_object())
    for (const auto& [key, item] : value.items()) find_numbers(item, at / key, found);
}

TEST(ForgedCertificates, TheHonestOneIsCertified) {
  EXPECT_EQ(verdict(honest().certificate), "certified");
}

/// Each of these changes one number; the width of an interval may be any that does.
TEST(ForgedCertificates, AnAlteredNumberIsNoticed) {
  std::vector<Json::json_pointer> numbers;
  find_numbers(honest().certificate, Json::json_pointer(), numbers);
  ASSERT_GT(numbers.size(), 500u);
  std::mt19937 random(7);
  std::size_t tried = 0;
  for (int n = 0; n < 150; ++n) {
    const Json::json_pointer& place = numbers[random() % numbers.size()];
    Json forged = honest().certificate;
    Json& number = forged[place];
    if (number.is_boolean()) {
      number = !number.get<bool>();
    } else {
      number = number.get<std::int64_t>() + (random() % 2 == 0 ? 1 : -1);
    }
    ++tried;
    EXPECT_NE(verdict(forged), "certified") << place;
  }
  EXPECT_EQ(tried, 150u);
}

/// Claims left out, doubled or exchanged.
TEST(ForgedCertificates, AMissingOrMovedClaimIsNoticed) {
  const Json& truth = honest().certificate;
  for (const char* list : {"edges", "faces", "tets", "components"}) {
    for (const std::size_t level : {0u, 1u}) {
      const std::size_t size = truth["levels"][level][list].size();
      ASSERT_GE(size, 1u);
      for (const std::size_t i : {std::size_t{0}, size / 2, size - 1}) {
        Json without = truth, twice = truth;
        without["levels"][level][list].erase(i);
        twice["levels"][level][list].push_back(truth["levels"][level][list][i]);
        EXPECT_EQ(verdict(without), "refuted") << list << i;
        EXPECT_EQ(verdict(twice), "malformed") << list << i;
      }
    }
  }
}

TEST(ForgedCertificates, OtherKindsOfForgery) {
  const std::vector<std::pair<std::string, std::function<void(Json&)>>> forgeries{
      {"refuted", [](Json& c) { c["levels"][0]["mode"] = "500000000001/1000000000000"; }},
      {"refuted", [](Json& c) { c["levels"][0]["mode"] = "-1/2"; }},
      {"malformed", [](Json& c) { c["levels"][0]["mode"] = "2/4"; }},
      {"malformed", [](Json& c) { c["levels"][0]["mode"] = "1"; }},
      {"refuted", [](Json& c) { c["input"]["sha256"] = std::string(64, '0'); }},
      {"refuted", [](Json& c) { c["surface"]["sha256"] = std::string(64, 'a'); }},
      {"malformed", [](Json& c) { c["input"]["tensor"] = "strain"; }},
      {"malformed",  // the file names them
       [](Json& c) { c["input"]["components"] = "voigt"; }},
      {"malformed", [](Json& c) { c["extra"] = 1; }},
      {"malformed", [](Json& c) { c.erase("version"); }},
      {"refuted", [](Json& c) { std::swap(c["levels"][0], c["levels"][1]); }},
      {"refuted", [](Json& c) { c["levels"].erase(1); }},
      {"malformed", [](Json& c) { c["levels"][0]["edges"][0][2][0] = -1; }},
      {"malformed", [](Json& c) { c["levels"][0]["edges"][0][2][1] = 4000000000; }},
      {"malformed", [](Json& c) {
         c["levels"][0]["distance"] = {{"reach", Json::array()}, {"bound", "0x1p-7"}};
       }}};
  for (std::size_t i = 0; i < forgeries.size(); ++i) {
    Json forged = honest().certificate;
    forgeries[i].second(forged);
    EXPECT_EQ(verdict(forged), forgeries[i].first) << "forgery " << i;
  }
}

/// To leave a tetrahedron undecided is honest, but hides its claims no more than that.
TEST(ForgedCertificates, WhatIsLeftOutIsNotCertified) {
  Json forged = honest().certificate;
  const Json tet = forged["levels"][0]["tets"][0][0];
  forged["levels"][0]["undecided"].push_back({tet, "budget_exhausted"});
  EXPECT_EQ(verdict(forged), "refuted");  // for it still lists its sheets
  forged["levels"][0]["tets"].erase(0);
  EXPECT_NE(verdict(forged), "certified");
}

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Any bytes whatever give a report or one exception.
TEST(HostileFiles, NeitherCrashNorPass) {
  const CertifiedSurface& s = honest();
  const std::string good = s.write(s.certificate, "h.json");
  const std::string binary = s.write(s.certificate, "h.cbor");
  std::mt19937 random(11);
  const std::string target = (s.folder / "hostile").string();
  std::size_t refused = 0;
  for (const std::string& file : {s.input(), s.surface(), good, binary}) {
    const std::string extension = std::filesystem::path(file).extension().string();
    const std::string original = bytes_of(file);
    for (int n = 0; n < 40; ++n) {
      std::string bytes = original;
      if (n % 4 == 0) {
        bytes.resize(random() % bytes.size());
      } else {
        for (int k = 0; k < 1 + n % 3; ++k)
          bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      if (bytes == original) continue;
      std::ofstream(target + extension, std::ios::binary) << bytes;
      try {
        const auto report = certificate::check_certificate(
            file == s.input() ? target + extension : s.input(),
            file == s.surface() ? target + extension : s.surface(),
            file == s.input() || file == s.surface() ? good : target + extension);
        if (report.status() != "certified") ++refused;
      } catch (const certificate::Malformed&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 90u);  // names, comments and unread arrays may change
}

TEST(HostileFiles, DeepAndHugeDocumentsAreRefused) {
  const CertifiedSurface& s = honest();
  const std::string deep(200000, '['), twice = R"({"format": 1, "format": 2})";
  // Indefinite arrays without end; an array and a map that claim 2^63 items.
  const std::vector<std::pair<std::string, std::string>> documents{
      {"d.json", deep},
      {"t.json", twice},
      {"e.json", ""},
      {"n.json", R"({"format": NaN})"},
      {"d.cbor", std::string(200000, '\x9f')},
      {"h.cbor", std::string("\x9b\x7f\xff\xff\xff\xff\xff\xff\xff", 9)},
      {"m.cbor", std::string("\xbb\x7f\xff\xff\xff\xff\xff\xff\xff", 9)}};
  for (const auto& [name, bytes] : documents) {
    const std::string file = (s.folder / name).string();
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_THROW(certificate::check_certificate(s.input(), s.surface(), file),
                 certificate::Malformed)
        << name;
  }
}

}  // namespace
}  // namespace tensortopo::test
