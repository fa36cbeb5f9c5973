// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Nothing true is refuted: whatever the extractor claims, the independent checker certifies or
// leaves undecided.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "extract/cases/extract_case.hpp"
#include "honest_verdict.hpp"

namespace tensortopo::test {
namespace {

/// An integer from the environment.
int setting(const char* name, int usual) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : usual;
}

/// What came of the certificates of a family.
struct Tally {
  std::map<std::string, int> statuses, open;
  std::size_t triangles = 0, claims = 0, vectors = 0, vectors_shown = 0;
};

/// The files, for a reader.
void keep(const std::string& name, const Exhibit& e, const std::string& report) {
  const char* folder = std::getenv("TENSORTOPO_REFUTED_FOLDER");
  if (folder == nullptr) return;
  const std::string stem = (std::filesystem::path(folder) / name).string();
  std::ofstream(stem + ".vtu") << e.field_text();
  std::ofstream(stem + ".vtp") << e.surface_text();
  std::ofstream(stem + ".json") << e.certificate.dump();
  std::ofstream(stem + ".txt") << report;
}

/// The cases of a family from TENSORTOPO_FIRST_CASE on. With TENSORTOPO_REFUTED_FOLDER the files of
/// those that are refuted are left there.
/// @param level_of  the level of a case
template <class LevelOf>
Tally judge(Family of, const std::string& kind, int count, const LevelOf& level_of) {
  const std::string family = name_of(of);
  HonestCourt court(kind + '_' + family);
  Tally tally;
  const int first = setting("TENSORTOPO_FIRST_CASE", 0);
  for (int number = first; number < first + count; ++number) {
    const FieldCase c = field_case(of, number);
    const Exhibit e = exhibit_with_arrays(c.mesh, {level_of(c)});
    const HonestVerdict verdict = court.judge(e);
    ++tally.statuses[verdict.status];
    tally.triangles += verdict.triangles, tally.claims += verdict.claims;
    tally.vectors += verdict.vectors, tally.vectors_shown += verdict.vectors_shown;
    for (const auto& [reason, times] : verdict.open) tally.open[reason] += times;
    if (verdict.status == "certified" || verdict.status == "undecided") continue;
    const std::string report = kind + ' ' + level_of(c) + '\n' + verdict.report;
    ADD_FAILURE() << family << " case " << number << ", " << report;
    keep(kind + '_' + family + '_' + std::to_string(number), e, report);
  }
  std::cout << "| " << kind << ' ' << family << " | " << count << " | "
            << tally.statuses["certified"] << " | " << tally.statuses["undecided"] << " | "
            << tally.statuses["refuted"] + tally.statuses["malformed"] << " | " << tally.claims
            << " | " << tally.vectors_shown << " of " << tally.vectors << " |";
  for (const auto& [reason, times] : tally.open) std::cout << ' ' << reason << ' ' << times << ';';
  std::cout << std::endl;
  return tally;
}

class HonestCertificates : public testing::TestWithParam<Family> {};

TEST_P(HonestCertificates, AreNotRefuted) {
  // Special meshes have up to 48 tetrahedra, and take as much longer.
  const int count = trials(GetParam() == Family::special_meshes ? 1 : 8);
  Tally tally = judge(GetParam(), "mode", count, [](const FieldCase& c) { return c.mode; });
  // Most cases have a surface, and most certificates are certified as a whole.
  EXPECT_GT(tally.triangles, static_cast<std::size_t>(count));
  EXPECT_GE(4 * tally.statuses["certified"] + 3, count);
  EXPECT_GT(tally.vectors_shown, 0u);
}

TEST_P(HonestCertificates, OfOtherInvariantsAreNotRefuted) {
  const int count = GetParam() == Family::special_meshes ? trials(1) : trials(4, 2);
  Tally tally =
      judge(GetParam(), "invariant", count, [](const FieldCase& c) { return c.invariant; });
  EXPECT_GT(tally.triangles, 0u);
  EXPECT_GE(4 * tally.statuses["certified"] + 3, count);
  EXPECT_GT(tally.vectors_shown, 0u);
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

/// A thin closed curve of a face that bends: three of its points may turn the other way.
TEST(HonestCertificatesOnceRefuted, OfAClosedCurveThatBendsAreNot) {
  HonestCourt court("bent");
  const HonestVerdict verdict = court.judge(field_case(Family::general, 7001655));
  EXPECT_EQ(verdict.status, "certified") << verdict.report;
}

/// Next to vertices of other magnitudes, from which the surface keeps its distance: the normal is
/// that of the anisotropy there, not on the level.
TEST(HonestCertificatesOnceRefuted, OfAnAnisotropyNextToACornerAreNot) {
  HonestCourt court("next_to_corner");
  for (const int number : {3000006, 3000019, 3000020}) {
    const FieldCase c = field_case(Family::powers_of_two, number);
    const HonestVerdict verdict = court.judge(exhibit_with_arrays(c.mesh, {c.invariant}));
    EXPECT_TRUE(verdict.status == "certified" || verdict.status == "undecided") << verdict.report;
    EXPECT_GT(verdict.vectors, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, HonestCertificates, testing::ValuesIn(all_families()),
                         [](const auto& family) { return name_of(family.param); });

}  // namespace
}  // namespace tensortopo::test
