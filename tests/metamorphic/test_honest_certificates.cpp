// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Nothing true is refuted: whatever the extractor claims, the independent checker certifies or
// leaves undecided.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "extract/extract_case.hpp"
#include "honest_verdict.hpp"

namespace tensortopo::test {
namespace {

/// An integer from the environment.
int setting(const char* name, int usual) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : usual;
}

class HonestCertificates : public testing::TestWithParam<Family> {};

/// The cases from TENSORTOPO_FIRST_CASE on. With TENSORTOPO_REFUTED_FOLDER the files of those that
/// are refuted are left there.
TEST_P(HonestCertificates, AreNotRefuted) {
  // Special meshes have up to 48 tetrahedra, and take as much longer.
  const int usual = GetParam() == Family::special_meshes ? 1 : 8;
  const int first = setting("TENSORTOPO_FIRST_CASE", 0), count = trials(usual);
  const char* folder = std::getenv("TENSORTOPO_REFUTED_FOLDER");
  const std::string family = name_of(GetParam());
  HonestCourt court(family);
  std::map<std::string, int> statuses, open;
  std::size_t triangles = 0, claims = 0;
  for (int number = first; number < first + count; ++number) {
    const FieldCase c = field_case(GetParam(), number);
    const Exhibit e = exhibit(c.mesh, {c.mode});
    const HonestVerdict verdict = court.judge(e);
    ++statuses[verdict.status];
    triangles += verdict.triangles;
    claims += verdict.claims;
    for (const auto& [reason, times] : verdict.open) open[reason] += times;
    if (verdict.status == "certified" || verdict.status == "undecided") continue;
    ADD_FAILURE() << family << " case " << number << ", mode " << c.mode << ": " << verdict.report;
    if (folder == nullptr) continue;
    const std::filesystem::path stem =
        std::filesystem::path(folder) / (family + '_' + std::to_string(number));
    std::ofstream(stem.string() + ".vtu") << e.field_text();
    std::ofstream(stem.string() + ".vtp") << e.surface_text();
    std::ofstream(stem.string() + ".json") << e.certificate.dump();
    std::ofstream(stem.string() + ".txt") << "mode " << c.mode << '\n' << verdict.report;
  }
  std::cout << "| " << family << " | " << count << " | " << statuses["certified"] << " | "
            << statuses["undecided"] << " | " << statuses["refuted"] + statuses["malformed"]
            << " | " << claims << " |";
  for (const auto& [reason, times] : open) std::cout << ' ' << reason << ' ' << times << ';';
  std::cout << '\n';
  // Most cases have a surface, and most certificates are certified as a whole.
  EXPECT_GT(triangles, static_cast<std::size_t>(count));
  EXPECT_GE(4 * statuses["certified"] + 3, count);
}

/// Two closed curves of a face, around degenerate points 1e-6 apart, which the checker has to tell
/// apart exactly.
TEST(HonestCertificatesOnceRefuted, AreCertified) {
  HonestCourt court("once_refuted");
  for (const int number : {2207, 3684, 3930, 5276, 5685, 5839, 7843, 9143, 9570, 10679}) {
    const HonestVerdict verdict = court.judge(field_case(Family::nearly_rank_one, number));
    EXPECT_EQ(verdict.status, "certified") << number << ": " << verdict.report;
  }
}

/// An edge that the level nearly touches: the vertex is as far from the crossing as 1e-8.
TEST(HonestCertificatesOnceRefuted, OfALevelThatNearlyTouchesAnEdgeAreNot) {
  HonestCourt court("touching");
  const HonestVerdict verdict = court.judge(field_case(Family::nearly_special, 48));
  EXPECT_TRUE(verdict.status == "certified" || verdict.status == "undecided") << verdict.report;
}

INSTANTIATE_TEST_SUITE_P(Families, HonestCertificates, testing::ValuesIn(all_families()),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace tensortopo::test
