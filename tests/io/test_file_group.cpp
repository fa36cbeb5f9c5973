// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "field_files.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/write_text.hpp"
#include "write_case.hpp"

namespace tensortopo::test {
namespace {

TEST(FileGroups, FilesAppearTogether) {
  const auto first = temporary("group_a.json"), second = put("group_b.json", "before");
  std::filesystem::remove(first);
  const std::size_t files = files_beside(first);
  {
    FileGroup group;
    write_text(first, "a");
    write_text(second, "b");
    EXPECT_FALSE(std::filesystem::exists(first));
    EXPECT_EQ(slurp(second), "before");
    group.commit();
    EXPECT_EQ(slurp(first), "a");
    EXPECT_EQ(slurp(second), "b");
  }
  EXPECT_EQ(files_beside(first), files + 1);
  write_text(first, "alone");
  EXPECT_EQ(slurp(first), "alone");
}

TEST(FileGroups, WithoutACommitNothingHappened) {
  const auto first = temporary("group_c.json"), second = put("group_d.json", "before");
  const std::size_t files = files_beside(second);
  const auto write_both_and_fail = [&] {
    const FileGroup group;
    write_text(first, "a");
    write_text(second, "b");
    write_text(temporary("missing") / "c.json", "c");
  };
  EXPECT_THROW(write_both_and_fail(), IoError);
  EXPECT_EQ(slurp(second), "before");
  EXPECT_EQ(files_beside(second), files);
}

TEST(FileGroups, WhatAGroupWithinAnotherCommitsWaitsForTheOuterOne) {
  for (const bool kept : {false, true}) {
    const auto first = put("group_f.json", "before"), second = put("group_g.json", "before"),
               dropped = put("group_h.json", "before");
    const std::size_t files = files_beside(first);
    {
      FileGroup outer;
      write_text(first, "after");
      {
        FileGroup inner;
        write_text(second, "after");
        inner.commit();
      }
      {
        const FileGroup inner;
        write_text(dropped, "after");
      }
      EXPECT_EQ(slurp(second), "before");
      if (kept) outer.commit();
    }
    for (const auto& file : {first, second}) EXPECT_EQ(slurp(file), kept ? "after" : "before");
    EXPECT_EQ(slurp(dropped), "before");
    EXPECT_EQ(files_beside(first), files);
  }
}

TEST(FileGroups, AGroupApartDoesNotWait) {
  const auto file = put("group_i.json", "before");
  const FileGroup outer;
  {
    FileGroup apart(FileGroup::Bond::apart), inner;
    write_text(file, "after");
    inner.commit();
    EXPECT_EQ(slurp(file), "before");
    apart.commit();
  }
  EXPECT_EQ(slurp(file), "after");
}

TEST(FileGroups, UnfinishedFilesCanBeRemovedByAHandler) {
  // More than are kept open without a name.
  constexpr std::size_t many = 210;
  const auto file = put("group_e.json", "before");
  const std::size_t files = files_beside(file);
  const FileGroup group;
  for (std::size_t i = 0; i < many; ++i) write_text(file, "after");
  EXPECT_GT(files_beside(file), files);
  remove_unfinished_files();
  EXPECT_EQ(files_beside(file), files);
  EXPECT_EQ(slurp(file), "before");
}

TEST(FileGroups, ManyFilesAppearTogether) {
  for (int i = 0; i < 300; ++i)
    std::filesystem::remove(temporary("group_" + std::to_string(i) + ".json"));
  const auto file = put("group_0.json", "before");
  const std::size_t files = files_beside(file);
  {
    FileGroup group;
    for (int i = 0; i < 300; ++i)
      write_text(temporary("group_" + std::to_string(i) + ".json"), std::to_string(i));
    EXPECT_EQ(slurp(file), "before");
    group.commit();
  }
  EXPECT_EQ(files_beside(file), files + 299);
  for (const int i : {0, 199, 200, 299})
    EXPECT_EQ(slurp(temporary("group_" + std::to_string(i) + ".json")), std::to_string(i));
}

TEST(FileGroups, WhereFilesCanBeNamelessNothingIsSeenOfThem) {
  const auto file = put("group_n.json", "before");
  const int descriptor = open(file.parent_path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (descriptor < 0) GTEST_SKIP() << "this file system names all files";
  close(descriptor);
  const std::size_t files = files_beside(file);
  const FileGroup group;
  write_text(file, "after");
  EXPECT_EQ(files_beside(file), files);
}

}  // namespace
}  // namespace tensortopo::test
