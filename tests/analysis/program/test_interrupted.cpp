// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Temporary folders go with a program that a signal ends, as unfinished files do.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

namespace fs = std::filesystem;

/// Starts the program with a folder for temporary files.
pid_t start_program(std::vector<std::string> words, const std::string& temporary, int signal) {
  words.insert(words.begin(), TENSORTOPO_PROGRAM);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  std::signal(signal, SIG_DFL);
  setenv("TMPDIR", temporary.c_str(), 1);
  unsetenv("DISPLAY");
  execv(argv[0], argv.data());
  _exit(127);
}

/// Is there a file of this name in a folder of this one?
bool holds(const Folder& folder, const std::string& name) {
  const auto files = folder.files();
  return std::any_of(files.begin(), files.end(), [&](const std::string& inner) {
    std::error_code ignored;
    return fs::exists(fs::path(folder / inner) / name, ignored);
  });
}

/// Runs the program until it has a temporary file of this name, and ends it.
void expect_nothing_left(const std::vector<std::string>& words, const std::string& name,
                         int signal) {
  const Folder temporary;
  const pid_t child = start_program(words, temporary / ".", signal);
  ASSERT_GT(child, 0);
  int state = 0;
  for (int tries = 0; !holds(temporary, name) && tries < 6000; ++tries) usleep(5'000);
  EXPECT_TRUE(holds(temporary, name));
  EXPECT_EQ(waitpid(child, &state, WNOHANG), 0) << "it ended by itself";
  kill(child, signal);
  waitpid(child, &state, 0);
  EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == signal) << state;
  EXPECT_EQ(temporary.files(), std::vector<std::string>{});
}

TEST(Interrupted, AFilmLeavesNoFolder) {
  const Folder folder;
  // An ffmpeg that begins a film and never ends.
  fs::create_directory(folder / "bin");
  std::ofstream(folder / "bin/ffmpeg") << "#!/bin/sh\necho $$ > " + (folder / "pid") +
                                              "\nfor last; do :; done\n"
                                              ": > \"${last#file:}\"\ncat > /dev/null\n"
                                              "exec sleep 60\n";
  fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder / "bin:" + path).c_str(), 1);
  expect_nothing_left({"render", field("s4_slab"), "--animate", "0.2:0.4:2", "--size", "32x32",
                       "-o", folder / "film.gif", "--quiet"},
                      "film.gif", SIGTERM);
  setenv("PATH", path.c_str(), 1);
  pid_t ffmpeg = 0;
  std::ifstream(folder / "pid") >> ffmpeg;
  ASSERT_GT(ffmpeg, 0);
  kill(ffmpeg, SIGKILL);
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"bin", "pid"}));
}

TEST(Interrupted, ACheckedSweepLeavesNoFolder) {
  expect_nothing_left(
      {"analyze", field("s4_slab"), "--sweep", "0.5:0.6:2", "--check", "200", "--quiet"},
      "surface.vtp", SIGPIPE);
}

}  // namespace
}  // namespace tensortopo::test
