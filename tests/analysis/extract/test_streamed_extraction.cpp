// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// A field in pieces that is extracted without being in memory as a whole.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

class StreamedExtraction : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_program({"generate", "kelvin", "--tets", "5000", "--pieces", "4", "--field-only",
                           "-o", pieces_, "--quiet"})
                  .status,
              0);
  }
  Outcome extract(const std::string& field, const std::string& name,
                  std::vector<std::string> more) const {
    std::vector<std::string> words{"extract", field, "-o",     folder_ / (name + ".vtp"),
                                   "--mode",  "1/2", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  /// Leaves no file.
  void expect_refused(const std::string& text, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"--stream"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = extract(pieces_, "none", words);
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.err.find(text), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "none.vtp"));
  }

  const Folder folder_;
  const std::string pieces_ = folder_ / "field.pvtu", whole_ = folder_ / "whole.vtu";
};

TEST_F(StreamedExtraction, GivesTheBytesOfTheWhole) {
  ASSERT_EQ(run_program({"convert", pieces_, "-o", whole_, "--quiet"}).status, 0);
  const std::string at_once = folder_ / "at_once.vtu";
  ASSERT_EQ(run_program(
                {"generate", "kelvin", "--tets", "5000", "--field-only", "-o", at_once, "--quiet"})
                .status,
            0);
  const std::string a = folder_ / "a.json", b = folder_ / "b.json";
  ASSERT_LE(extract(whole_, "converted", {"--certify", a}).status, 1);
  ASSERT_LE(extract(pieces_, "whole", {}).status, 1);
  const Outcome run = extract(pieces_, "streamed", {"--stream", "--certify", b});
  ASSERT_LE(run.status, 1) << run.err;
  const std::string bytes = contents(folder_ / "whole.vtp");
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == contents(folder_ / "streamed.vtp"));
  EXPECT_TRUE(contents(a) == contents(b));
  EXPECT_LE(run_program({"check", whole_, folder_ / "streamed.vtp", b}).status, 1);
  ASSERT_LE(extract(at_once, "at_once", {"--certify", a}).status, 1);
  EXPECT_TRUE(contents(a) == contents(b));
}

/// Alone, certified; and in one file with surfaces.
TEST_F(StreamedExtraction, GivesTheBytesOfTheWholeCurves) {
  ASSERT_EQ(run_program({"convert", pieces_, "-o", whole_, "--quiet"}).status, 0);
  const std::vector<std::vector<std::string>> cases{
      {"--mode", "1"}, {"--mode=1", "--generalized"}, {"--mode", "1", "--mode", "0.9", "--mode=-1"}};
  // The file names its input, and a certificate is of one file.
  struct Way {
    const std::string& input;
    std::vector<std::string> words;
    bool is_certified;
  };
  const std::vector<Way> ways{{pieces_, {}, false},
                              {pieces_, {"--pieces", "5"}, false},
                              {pieces_, {"--stream"}, true},
                              {whole_, {}, true},
                              {whole_, {"--pieces", "5"}, true}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::vector<std::string> bytes, certificates;
    for (const Way& way : ways) {
      const std::string output = folder_ / "curves.vtp", certificate = folder_ / "curves.json";
      std::vector<std::string> words{"extract", way.input, "-o", output, "--quiet"};
      words.insert(words.end(), cases[i].begin(), cases[i].end());
      words.insert(words.end(), way.words.begin(), way.words.end());
      const bool is_certified = way.is_certified && i < 2;
      if (is_certified) words.insert(words.end(), {"--certify", certificate});
      const Outcome run = run_program(words);
      ASSERT_LE(run.status, 1) << run.err;
      bytes.push_back(contents(output));
      if (is_certified) certificates.push_back(contents(certificate));
    }
    EXPECT_GT(bytes[0].size(), 2000u);
    EXPECT_TRUE(bytes[0] == bytes[1] && bytes[0] == bytes[2]) << i;
    EXPECT_TRUE(bytes[3] == bytes[4]) << i;
    EXPECT_EQ(certificates.size(), i < 2 ? 3u : 0u);
    for (const std::string& certificate : certificates)
      EXPECT_TRUE(certificate == certificates[0]) << i;
  }
}

TEST_F(StreamedExtraction, RefusesWhatNeedsTheWholeField) {
  expect_refused("--max-error: needs the whole field", {"--max-error", "1"});
  expect_refused("does not go with reading piece by piece", {"--merge-points"});
}

TEST_F(StreamedExtraction, NoticesAPieceThatIsMissingOrOfAnotherField) {
  const std::string other = folder_ / "other.pvtu";
  ASSERT_EQ(run_program({"generate", "kelvin", "--tets", "5000", "--pieces", "4", "--seed", "2",
                         "--field-only", "-o", other, "--quiet"})
                .status,
            0);
  const std::string piece = folder_ / "field-0002.vtu";
  std::filesystem::copy_file(folder_ / "other-0002.vtu", piece,
                             std::filesystem::copy_options::overwrite_existing);
  expect_refused("different tensors at the same point");
  std::filesystem::remove(piece);
  expect_refused("field-0002.vtu");
}

}  // namespace
}  // namespace tensortopo::test
