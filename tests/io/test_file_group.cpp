// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include "field_files.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/write_text.hpp"

namespace tensortopo::test {
namespace {

std::size_t files_beside(const std::filesystem::path& file) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    ++count;
  return count;
}

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

TEST(FileGroups, UnfinishedFilesCanBeRemovedByAHandler) {
  const auto file = put("group_e.json", "before");
  const std::size_t files = files_beside(file);
  const FileGroup group;
  write_text(file, "after");
  EXPECT_EQ(files_beside(file), files + 1);
  remove_unfinished_files();
  EXPECT_EQ(files_beside(file), files);
  EXPECT_EQ(slurp(file), "before");
}

}  // namespace
}  // namespace tensortopo::test
