// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "readers.hpp"
#include "tensortopo/io/field_formats.hpp"
#include "tensortopo/io/surface_formats.hpp"

namespace tensortopo::test {
namespace {

/// Inputs by reader: seeds, and what fuzzing found.
std::map<std::string, std::vector<std::string>> corpus() {
  std::map<std::string, std::vector<std::string>> result;
  for (const auto& folder : std::filesystem::directory_iterator(TENSORTOPO_CORPUS))
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      std::ifstream stream(entry.path(), std::ios::binary);
      result[folder.path().filename().string()].emplace_back(std::istreambuf_iterator(stream),
                                                             std::istreambuf_iterator<char>());
    }
  return result;
}

class Corpus : public testing::TestWithParam<FuzzedReader> {};

TEST_P(Corpus, GivesResultsOrErrorsOfOneLine) {
  const auto all = corpus();
  ASSERT_TRUE(all.contains(GetParam().name));
  for (const std::string& bytes : all.at(GetParam().name))
    EXPECT_NO_THROW(GetParam().read(bytes)) << bytes.substr(0, 300);
}

TEST_P(Corpus, SoDoesWhatIsCutOffOrAltered) {
  std::mt19937 random(7);
  const auto draw = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  const std::vector<std::string> numbers{"-1", "0", "2147483648", "18446744073709551615", "nan",
                                         "1e999", "-9223372036854775808", "4294967295", "1 2"};
  std::size_t tried = 0;
  const auto all = corpus();
  for (const std::string& bytes : all.at(GetParam().name)) {
    if (bytes.empty() || bytes.size() > 20000) continue;
    for (int i = 0; i < 60; ++i, ++tried) {
      std::string altered = bytes;
      const std::size_t at = draw(bytes.size());
      const std::size_t digit = bytes.find_first_of("0123456789", at);
      if (i % 4 == 0)
        altered.resize(at);
      else if (i % 4 == 1)
        altered[at] = static_cast<char>(draw(256));
      else if (i % 4 == 2 && digit != std::string::npos)
        altered.replace(digit, 1 + draw(3), numbers[draw(numbers.size())]);
      else
        altered.erase(at, 1 + draw(20));
      EXPECT_NO_THROW(GetParam().read(altered)) << altered.substr(0, 300);
    }
  }
  EXPECT_GE(tried, 60u);
}

TEST(CorpusOfFormats, HasATargetForEach) {
  std::set<std::string> names;
  for (const FuzzedReader& reader : fuzzed_readers()) names.insert(reader.name);
  std::size_t compared = 0;
  for (const FieldFormat& format : field_formats()) {
    EXPECT_TRUE(names.contains(std::string(format.fuzzed_as))) << format.extension;
    ++compared;
  }
  EXPECT_GE(compared, 10u);
  for (const SurfaceFormat& format : surface_formats()) {
    EXPECT_TRUE(names.contains(std::string(format.fuzzed_as))) << format.extension;
    ++compared;
  }
  EXPECT_GE(compared, 15u);
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(fuzzed_readers()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace tensortopo::test
