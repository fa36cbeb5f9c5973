// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "calculix_files.hpp"
#include "restart_file.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::test {
namespace {

using namespace scenarios;

// One hexahedron, whose numbers are all different, with an inner node as C3D8I has them.
RestartFile example() {
  RestartFile content;
  double next = 0.1;
  for (int i = 0; i < 9; ++i) {
    content.points.push_back({next, next + 1, next + 2});
    content.displacements.push_back({next + 3, next + 4, next + 5});
    next += 0.3;
  }
  RestartFile::HexStress hex;
  for (auto& t : hex) {
    t = {next, next + 1, next + 2, next + 3, next + 4, next + 5};
    next += 0.7;
  }
  content.stresses.push_back(hex);
  return content;
}

RestartFile parsed(const std::string& bytes) { return parse_restart_file(bytes, "job"); }

void expect_refused(const std::string& bytes, const std::string& words) {
  try {
    parsed(bytes);
    ADD_FAILURE() << "read what should be refused: " << words;
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(RestartFile, NumbersComeBackBitForBitAndInOurOrder) {
  const RestartFile written = example(), found = parsed(restart_bytes(written));
  EXPECT_EQ(found.points, written.points);
  EXPECT_EQ(found.displacements, written.displacements);
  EXPECT_EQ(found.stresses, written.stresses);
}

TEST(RestartFile, EveryTruncationIsRefused) {
  const std::string bytes = restart_bytes(example());
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_THROW(parsed(bytes.substr(0, n)), IoError);
}

TEST(RestartFile, EveryDamagedByteGivesAResultOrAnError) {
  const std::string bytes = restart_bytes(example());
  int refused = 0;
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    std::string damaged = bytes;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x81);
    try {
      EXPECT_EQ(parsed(damaged).stresses.size(), 1u);
    } catch (const IoError&) {
      ++refused;
    }
  }
  // At least the marks of all records and the counts in use.
  EXPECT_GT(refused, 8 * 20);
}

TEST(RestartFile, WhatIsWrongIsSaid) {
  expect_refused("*HEADING", "ends within a record");
  expect_refused(record("no version"), "no restart file");
  RestartFile content = example();
  content.stresses[0][3].yz = std::numeric_limits<double>::quiet_NaN();
  expect_refused(restart_bytes(content), "not a number");
  const std::string bytes = restart_bytes(example());
  const auto replaced = [&](std::string from, std::string to) {
    std::string other = bytes;
    const auto at = other.find(from);
    EXPECT_NE(at, other.npos);
    return other.replace(at, from.size(), to);
  };
  using namespace std::string_literals;
  expect_refused(replaced("\x08\0\0\0\x03\0\0\0\x01\0\0\0"s, "\x04\0\0\0\x03\0\0\0\x01\0\0\0"s),
                 "no hexahedra");
  // A second hexahedron is announced, and its stresses are not there.
  expect_refused(replaced(record("\x01\0\0\0"s) + record("\0\0\0\0"s),
                          record("\x02\0\0\0"s) + record("\0\0\0\0"s)),
                 "no record of stresses");
}

TEST(RestartFile, AMissingFileIsUnreadable) {
  try {
    read_restart_file(Folder() / "job.rout");
    ADD_FAILURE();
  } catch (const IoError& error) {
    EXPECT_EQ(error.kind(), IoError::Kind::unreadable);
  }
}

}  // namespace
}  // namespace tensortopo::test
