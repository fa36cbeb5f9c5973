// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Any numbers and any bytes of the three files, altered at random.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <random>

#include "certificate_edits.hpp"
#include "curve_exhibit.hpp"
#include "forgery.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kSeed = 20241121;

/// Where two texts differ in numbers, as doubles; elsewhere they may differ in names or comments.
bool differ_in_numbers(const std::string& a, const std::string& b) {
  const auto numbers = [](const std::string& text) {
    std::vector<double> result;
    for (std::size_t at = text.find("<Points>"); at != std::string::npos;
         at = text.find("<DataArray", at + 1)) {
      const char* p = text.c_str() + text.find('>', text.find("<DataArray", at)) + 1;
      for (char* end = nullptr;; p = end) {
        result.push_back(std::strtod(p, &end));
        if (end == p) break;
      }
    }
    return result;
  };
  return numbers(a) != numbers(b);
}

/// What an exhibit puts in its second file.
std::string output_text(const Exhibit& e) { return e.surface_text(); }
std::string output_text(const CurveExhibit& e) { return e.curve_text(); }

/// @param may_be_true  as `tensortopo::test::may_be_true`
template <class Exhibits, class MayBeTrue>
void expect_edits_noticed(const Exhibits& exhibits, const MayBeTrue& may_be_true,
                          std::size_t edits) {
  std::mt19937_64 random(kSeed);
  Court court("edits");
  std::size_t tried = 0, equivalent = 0;
  for (const auto& honest : exhibits) {
    std::vector<Json::json_pointer> places = places_in(honest.certificate);
    // Reaches are many, and may be others.
    std::erase_if(places, [&](const auto& at) {
      return at.to_string().find("/reach/") != std::string::npos && random() % 16 != 0;
    });
    const std::string field = honest.field_text(), output = output_text(honest);
    const std::size_t share = edits / exhibits.size();
    for (std::size_t n = 0; n < share; ++n, ++tried) {
      Json altered = honest.certificate;
      while (altered == honest.certificate)
        for (std::size_t k = random() % 4 == 0 ? 3 : 1; k > 0; --k)
          edit_document(altered, places, random);
      const std::string text = altered.dump(-1, ' ', false, Json::error_handler_t::replace);
      if (court.verdict(field, output, text) != "certified") continue;
      ++equivalent;
      ASSERT_TRUE(may_be_true(honest.certificate, altered))
          << "seed " << kSeed << '\n'
          << Json::diff(honest.certificate, altered);
    }
  }
  std::cout << "seed " << kSeed << ": " << tried << " certificates, " << equivalent
            << " that may be true\n";
  EXPECT_LT(equivalent, tried / 8);
}

template <class Exhibits, class MayBeTrue>
void expect_bytes_noticed(const Exhibits& exhibits, const MayBeTrue& may_be_true,
                          std::size_t edits) {
  std::mt19937_64 random(kSeed + 1);
  Court court("bytes");
  std::size_t tried = 0, refused = 0;
  for (const auto& honest : exhibits) {
    const std::array<std::string, 3> files{honest.field_text(), output_text(honest),
                                           honest.certificate.dump()};
    const std::size_t share = edits / exhibits.size();
    for (std::size_t n = 0; n < share; ++n) {
      std::array<std::string, 3> altered = files;
      const std::size_t which = n % 3;
      std::string& text = altered[which];
      const std::size_t at = random() % text.size();
      if (n % 16 == 0) {
        text.resize(at);
      } else {
        text[at] = n % 2 == 0 ? static_cast<char>(random()) : "0123456789.-e"[random() % 13];
      }
      if (text == files[which]) continue;
      ++tried;
      if (court.verdict(altered[0], altered[1], altered[2]) != "certified") {
        ++refused;
      } else if (which == 2) {
        ASSERT_TRUE(may_be_true(honest.certificate, Json::parse(text))) << "seed " << kSeed;
      } else {
        ASSERT_FALSE(differ_in_numbers(files[which], text)) << "seed " << kSeed;
      }
    }
  }
  std::cout << "seed " << kSeed + 1 << ": " << tried << " files, " << refused << " refused\n";
  EXPECT_GT(refused, tried / 2);
}

const auto kEdits = static_cast<std::size_t>(trials(TENSORTOPO_EDITS));

TEST(RandomEdits, OfTheCertificateAreNoticed) {
  expect_edits_noticed(honest_exhibits(), may_be_true, kEdits * 3 / 4);
}

TEST(RandomEdits, OfAnyByteNeitherCrashNorPass) {
  expect_bytes_noticed(honest_exhibits(), may_be_true, kEdits / 4);
}

TEST(RandomEdits, OfCertificatesOfCurvesAreNoticed) {
  expect_edits_noticed(honest_curves(), may_be_true_of_curves, kEdits / 8);
}

TEST(RandomEdits, OfAnyByteOfCurvesNeitherCrashNorPass) {
  expect_bytes_noticed(honest_curves(), may_be_true_of_curves, kEdits / 16);
}

}  // namespace
}  // namespace tensortopo::test
