// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The files of a command and what it says of them are there together or not at all. (Of `bench`
// too, by the same lines, but that takes long.)
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

TEST(LostSummary, LeavesNoFile) {
  const Folder sources;
  const std::string mesh = sources / "g.vtu", surface = sources / "s.vtp";
  ASSERT_EQ(run_program({"generate", "complex", "--tets", "48", "-o", mesh, "--field-only"}).status,
            0);
  ASSERT_EQ(run_program({"extract", mesh, "-o", surface, "--mode", "0.5"}).status, 0);
  const auto in_folder = [](const Folder& folder) {
    return [&folder](const char* name) { return folder / name; };
  };
  using Words = std::vector<std::string>;
  using Place = std::function<std::string(const char*)>;
  const std::vector<std::function<Words(const Place&)>> commands{
      [&](const Place& to) {
        return Words{"extract", mesh,  "-o",        to("s.vtp"),
                     "--mode",  "0.5", "--certify", to("c.json")};
      },
      [&](const Place& to) {
        return Words{"extract",   mesh,      "-o", to("s.vtp"), "--invariant",
                     "magnitude", "--value", "1",  "--certify", to("c.json")};
      },
      [&](const Place& to) {
        return Words{"generate", "linear", "--count", "2", "-o", to("g.vtu")};
      },
      [&](const Place& to) {
        return Words{"render", mesh,    "--animate", "0.2:0.4:2",
                     "--size", "32x32", "-o",        to("p.png")};
      },
      [&](const Place& to) {
        return Words{"analyze", mesh, "--sweep", "0:0.5:2", "-o", to("d.png")};
      },
      [&](const Place& to) {
        return Words{"analyze", surface,     "--mesh",   mesh,
                     "-o",      to("a.vtp"), "--ridges", to("r.vtp")};
      }};
  for (const auto& command : commands) {
    const Folder folder;
    const Outcome run = run_without_output(command(in_folder(folder)));
    EXPECT_EQ(run.status, 4) << run.err;
    EXPECT_NE(run.err.find("standard output: cannot write"), std::string::npos) << run.err;
    EXPECT_EQ(folder.files(), std::vector<std::string>{}) << command(in_folder(folder))[0];
  }
}

/// As in `tensortopo extract ... | head -0`.
TEST(LostSummary, LeavesNoFileWhenItsReaderIsGone) {
  const Folder folder;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const std::string in = field("s4_slab"), s = folder / "s.vtp";
    signal(SIGPIPE, SIG_DFL);
    dup2(ends[1], STDOUT_FILENO);
    execl(TENSORTOPO_PROGRAM, TENSORTOPO_PROGRAM, "extract", in.c_str(), "-o", s.c_str(), "--mode",
          "0.5", "--json", nullptr);
    _exit(127);
  }
  close(ends[1]);
  int state = 0;
  waitpid(child, &state, 0);
  EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == SIGPIPE) << state;
  EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace tensortopo::test
