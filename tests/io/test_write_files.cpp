// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What is written appears whole or not at all, wherever it goes.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "field_files.hpp"
#include "tensortopo/io/write_mesh.hpp"
#include "tensortopo/io/write_text.hpp"
#include "write_case.hpp"

namespace tensortopo::test {
namespace {

TEST(Write, ToNowhereFailsAndLeavesNothing) {
  const auto folder = temporary("missing");
  EXPECT_THROW(write_text(folder / "a.json", "{}"), IoError);
  EXPECT_THROW(write_surface(surface_of_two(), mesh_of_two(), folder / "a.vtp"), IoError);
  EXPECT_FALSE(std::filesystem::exists(folder));
  std::filesystem::create_directories(temporary("folder.vtp"));
  try {
    write_surface(surface_of_two(), mesh_of_two(), temporary("folder.vtp"));
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.kind(), unwritable);
    EXPECT_EQ(error.file(), temporary("folder.vtp"));
  }
}

/// Lets no file of this process grow beyond some bytes, as a full disk would.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    before_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small{bytes, limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, before_);
  }

 private:
  void (*before_)(int);
  rlimit limit_{};
};

TEST(Write, OnAFullDiskTheOldFileStays) {
  TetMesh field = cube_field(12);
  SurfaceMesh s;
  s.points = field.points;
  for (const auto& t : field.tets) s.triangles.push_back({t[0], t[1], t[2]});
  for (const std::string name : {"a.vtp", "a.ply", "a.obj", "a.stl", "a.off", "a.vtu", "a.json"}) {
    const auto file = put(name, "before");
    const std::size_t files = files_beside(file);
    bool failed = false;
    {
      const SmallDisk disk(3000);
      try {
        if (name == "a.vtu")
          write_mesh(field, file);
        else if (name == "a.json")
          write_text(file, std::string(5000, 'x'));
        else
          write_surface(s, field, file);
      } catch (const IoError& error) {
        failed = error.kind() == unwritable && error.file() == file;
      }
    }
    EXPECT_TRUE(failed) << name;
    EXPECT_EQ(slurp(file), "before") << name;
    EXPECT_EQ(files_beside(file), files) << name;
  }
}

TEST(Write, ReplacesAnExistingFileAndLeavesNoOther) {
  const auto file = put("a.json", "old and longer");
  write_text(file, "new");
  EXPECT_EQ(slurp(file), "new");
  EXPECT_EQ(files_beside(file), 1u);
}

TEST(Write, ThroughALinkReplacesItsTarget) {
  const auto target = put("target.json", "old"), link = temporary("link.json");
  std::filesystem::remove(link);
  std::filesystem::create_symlink(target, link);
  write_text(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(slurp(target), "new");
}

TEST(Write, ThroughALinkToNowhereMakesItsTarget) {
  const auto target = temporary("not_yet.json"), link = temporary("early.json");
  std::filesystem::remove(target);
  std::filesystem::remove(link);
  std::filesystem::create_symlink("not_yet.json", link);
  write_text(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(slurp(target), "new");
}

TEST(Write, LeavesADeviceADevice) {
  write_text("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Write, GivesThePermissionsOfAnyNewFile) {
  const auto file = temporary("a.json"), other = put("b.json", "");
  write_text(file, "x");
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::status(other).permissions());
}

TEST(Write, RelativeNamesAreOfTheCurrentFolder) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(temporary("x").parent_path());
  EXPECT_NO_THROW(write_text("here.json", "x"));
  EXPECT_TRUE(std::filesystem::exists("here.json"));
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace tensortopo::test
