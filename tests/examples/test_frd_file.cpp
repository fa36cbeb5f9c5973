// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "calculix_files.hpp"
#include "frd_file.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

struct Example {
  HexMesh mesh = box_mesh({2, 1, 1}, {2, 1, 1});
  std::vector<Vector3<double>> displacements;
  std::vector<SymmetricTensor<double>> stresses;
  Example() {
    for (int i = 0; i < 12; ++i) {
      displacements.push_back({i + 0.5, i + 0.25, -i - 0.125});
      stresses.push_back({i + 0.5, i - 1.0, i + 2.0, -i - 3.0, i + 4.0, i + 5.0});
    }
  }
  std::string bytes() const { return frd_bytes(mesh, displacements, stresses); }
};

FrdFile read(const std::string& bytes) { return parse_frd_file(bytes, "job"); }

TEST(FrdFile, FloatsComeBack) {
  const Example example;
  const FrdFile found = read(example.bytes());
  EXPECT_EQ(found.displacements, example.displacements);
  EXPECT_EQ(found.stresses, example.stresses);
}

TEST(FrdFile, EveryTruncationIsRefused) {
  const std::string bytes = Example().bytes();
  for (std::size_t n = 0; n + 1 < bytes.size(); ++n)
    EXPECT_THROW(read(bytes.substr(0, n)), IoError) << n;
}

TEST(FrdFile, EveryDamagedByteGivesAResultOrAnError) {
  const std::string bytes = Example().bytes();
  int refused = 0;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    std::string damaged = bytes;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x5a);
    try {
      EXPECT_FALSE(read(damaged).stresses.empty());
    } catch (const IoError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);  // numbers of nodes in both results, at least
}

TEST(FrdFile, TextIsRefused) {
  std::string bytes = Example().bytes();
  const auto at = bytes.find("           2\n -4  DISP");
  ASSERT_NE(at, bytes.npos);
  bytes[at + 11] = '1';
  EXPECT_THROW(read(bytes), IoError);
}

}  // namespace
}  // namespace tensortopo::test
