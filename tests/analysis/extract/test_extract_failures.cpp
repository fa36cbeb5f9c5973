// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/program/expect_line.hpp"
#include "analysis/run_program.hpp"

namespace tensortopo::test {
namespace {

struct BadWords {
  std::vector<std::string> words;
  std::string about;
};

TEST(ExtractFailures, BadUsageIsTwoAndLeavesNoFile) {
  const std::vector<BadWords> cases{
      {{"--mode", "0.5", "--no-such-option"}, "--no-such-option"},
      {{"--mode", "1", "--mode", "0.5", "--certify", "c.json"}, "degenerate curves"},
      {{"--mode", "0.5", "--method", "marching", "--certify", "c.json"}, "--certify"},
      {{"--mode", "0.5", "--max-error", "-1"}, "--max-error"},
      {{"--mode", "0.5", "--method", "no-such-method"}, "--method"},
      {{"--mode", "0", "--mode", "0.5", "--method", "hybrid"}, "--method hybrid"},
      {{"--mode", "1", "--method", "a-patches"}, "--method"},
      {{"--mode", "half"}, "half"},
      {{"--mode", "1.5"}, "1.5"},
      {{"--mode", "-11/10"}, "-11/10"},
      {{"--mode", "nan"}, "nan"},
      {{"--mode", "1/0"}, "1/0"},
      {{"--mode", "0.5", "--threads", "0"}, "--threads"},
      {{"--mode", "0.5", "--resolution", "-1"}, "--resolution"},
      {{"--mode", "0.5", "--resolution", "nan"}, "--resolution"},
      {{}, "--mode"},
  };
  for (const BadWords& bad : cases) {
    const Folder folder;
    const Outcome run = extract_slab(folder, bad.words);
    EXPECT_EQ(run.status, 2) << run.err;
    expect_error_line(run, bad.about);
    EXPECT_TRUE(folder.files().empty());
  }
}

TEST(ExtractFailures, UnknownExtensionIsBadUsage) {
  const Folder folder;
  const Outcome run =
      run_program({"extract", field("s4_slab"), "-o", folder / "s.xyz", "--mode", "0.5"});
  EXPECT_EQ(run.status, 2);
  expect_error_line(run, "s.xyz");
  EXPECT_TRUE(folder.files().empty());
}

TEST(ExtractFailures, CurvesNeedAFormatWithPolylines) {
  for (const char* name : {"c.stl", "c.off"}) {
    for (const std::vector<std::string>& modes :
         {std::vector<std::string>{"--mode", "1"}, {"--mode", "0.5", "--mode", "-1"}}) {
      const Folder folder;
      std::vector<std::string> words{"extract", field("s4_slab"), "-o", folder / name};
      words.insert(words.end(), modes.begin(), modes.end());
      const Outcome run = run_program(words);
      EXPECT_EQ(run.status, 2);
      expect_error_line(run, name);
      EXPECT_TRUE(folder.files().empty());
    }
  }
}

TEST(ExtractFailures, BadInputIsThree) {
  const Folder folder;
  std::ofstream(folder / "text.vtu") << "this is no mesh\n";
  const std::string whole = contents(field("s4_slab"));
  std::ofstream(folder / "cut.vtu", std::ios::binary) << whole.substr(0, whole.size() / 2);
  for (const char* name : {"missing.vtu", "text.vtu", "cut.vtu"}) {
    const Outcome run =
        run_program({"extract", folder / name, "-o", folder / "s.vtp", "--mode", "0.5"});
    EXPECT_EQ(run.status, 3) << run.err;
    expect_error_line(run, folder / name);
  }
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"cut.vtu", "text.vtu"}));
}

TEST(ExtractFailures, UnknownTensorIsBadInputByName) {
  const Folder folder;
  const Outcome run = extract_slab(folder, {"--mode", "0.5", "--tensor", "strain"});
  EXPECT_EQ(run.status, 3);
  expect_error_line(run, "strain");
  EXPECT_TRUE(folder.files().empty());
}

TEST(ExtractFailures, NoPlaceToWriteIsFour) {
  const Folder folder;
  const std::string output = folder / "no/such/folder/s.vtp";
  const Outcome run = run_program({"extract", field("s4_slab"), "-o", output, "--mode", "0.5"});
  EXPECT_EQ(run.status, 4);
  expect_error_line(run, output);
  EXPECT_TRUE(folder.files().empty());
}

TEST(ExtractFailures, AFileThatWasThereStays) {
  const Folder folder;
  std::ofstream(folder / "s.vtp") << "old";
  EXPECT_EQ(extract_slab(folder, {"--mode", "0.5", "--tensor", "strain"}).status, 3);
  EXPECT_EQ(contents(folder / "s.vtp"), "old");
}

// Two tetrahedra; the deviator vanishes inside an edge of the first, or at one of its vertices.
std::string mesh_with_a_zero(const Folder& folder, const char* first_tensor = R"(
-1 -2 0  -2 1 -3  0 -3 0)") {
  const std::string file = folder / "zero.vtk";
  std::ofstream(file) << R"(# vtk DataFile Version 3.0
one point without a deviator
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1
CELLS 2 10
4 0 1 2 3
4 1 2 3 4
CELL_TYPES 2
10 10
POINT_DATA 5
TENSORS stress double)" << first_tensor << R"(
1 2 0  2 -1 3  0 3 0
0 1 4  1 2 0  4 0 -2
5 0 1  0 -3 2  1 2 -2
-1 2 2  2 4 1  2 1 -3
)";
  return file;
}

TEST(ExtractFailures, UndecidedTetrahedraOfACertificateAreNamed) {
  const Folder folder;
  const Outcome run = run_program({"extract", mesh_with_a_zero(folder), "-o", folder / "s.vtp",
                                   "--mode", "0.5", "--certify", folder / "c.json", "--json"});
  EXPECT_EQ(run.status, 1) << run.err;
  const std::string said = "1 tetrahedron undecided, so that nothing is certified of the surface "
                           "there: 1 zero_deviator_inside (cell 0)";
  EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
  const auto cells = nlohmann::json::parse(run.out)["certificate"]["undecided_cells"];
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0]["cell"], 0);
  EXPECT_EQ(cells[0]["reason"], "zero_deviator_inside");
}

TEST(ExtractFailures, AnUnresolvedTetrahedronIsNamedAndTheRestIsWritten) {
  const Folder folder;
  const std::string out = folder / "s.vtp";
  const Outcome run =
      run_program({"extract", mesh_with_a_zero(folder), "-o", out, "--mode", "0.5", "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("1 of 2 tetrahedra unresolved (1 zero_deviator_inside)"),
            std::string::npos)
      << run.err;
  EXPECT_TRUE(std::filesystem::exists(out));
  const auto report = nlohmann::json::parse(run.out);
  ASSERT_EQ(report["unresolved_cells"].size(), 1u);
  EXPECT_EQ(report["unresolved_cells"][0]["cell"], 0);
  EXPECT_EQ(report["unresolved_cells"][0]["reason"], "zero_deviator_inside");
  EXPECT_EQ(report["surfaces"][0]["unresolved"]["zero_deviator_inside"], 1);
  EXPECT_GT(report["surfaces"][0]["triangles"], 0);
}

TEST(ExtractFailures, ADistanceThatIsNotProvedIsSaidWithAMode) {
  const Folder folder;
  const std::string out = folder / "s.vtp", mesh = folder / "one.vtu";
  ASSERT_EQ(run_program({"generate", "linear", "--field-only", "-o", mesh}).status, 0);
  const Outcome run = run_program({"extract", mesh, "-o", out, "--mode", "1/10", "--mode", "-1/10",
                                   "--max-error", "1e-9", "--json"});
  EXPECT_EQ(run.status, 1) << run.err;
  for (const auto& surface : nlohmann::json::parse(run.out)["surfaces"]) {
    const int count = surface["tets_farther"];
    const std::string begin =
        out + ": mode " + surface["mode_exact"].get<std::string>() + ": in " +
        (count == 1 ? "1 tetrahedron" : std::to_string(count) + " tetrahedra") +
        " (the first is cell ";
    EXPECT_EQ(run.err.find(begin) != std::string::npos, count > 0) << begin << "\n" << run.err;
  }
  std::filesystem::remove(out);
  const Outcome strict = run_program({"extract", mesh, "-o", out, "--mode", "1/10", "--max-error",
                                      "1e-30", "--strict", "--quiet"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_NE(strict.err.find("; nothing written"), std::string::npos) << strict.err;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ExtractFailures, AVertexWithoutDeviatorIsNoFailureAndIsCounted) {
  const Folder folder;
  const std::string file = mesh_with_a_zero(folder, "\n7 0 0  0 7 0  0 0 7");
  const std::vector<std::string> arguments{"extract", file,   "-o",  folder / "s.vtp",
                                           "--mode",  "0.5", "--strict"};
  const Outcome text = run_program(arguments);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("isotropic, where the mode is undefined: 1 vertex ("), std::string::npos)
      << text.out;
  auto with_json = arguments;
  with_json.push_back("--json");
  const auto report = nlohmann::json::parse(run_program(with_json).out);
  EXPECT_EQ(report["statistics"]["zero_deviator_vertices"], 1);
  EXPECT_EQ(report["statistics"]["tets_undefined"], 0);
  EXPECT_EQ(report["statistics"]["cone_points"], report["statistics"]["sheets_cones"]);
  EXPECT_GT(report["statistics"]["cone_points"], 0);
}

TEST(ExtractFailures, StrictRefusesWhatIsUnresolvedAndWritesNothing) {
  const Folder folder;
  const Outcome run = run_program({"extract", mesh_with_a_zero(folder), "-o", folder / "s.vtp",
                                   "--mode", "0.5", "--strict"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("(1 zero_deviator_inside); nothing written"), std::string::npos)
      << run.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"zero.vtk"});
}

TEST(ExtractFailures, WithoutItsCertificateNoSurfaceIsWritten) {
  for (const std::string level : {"--mode", "--invariant"}) {
    const Folder folder;
    std::filesystem::create_symlink("/dev/full", folder / "c.json");
    std::ofstream(folder / "s.vtp") << "before";
    std::vector<std::string> words{"--certify", folder / "c.json", level};
    words.push_back(level == "--mode" ? "0.5" : "anisotropy");
    if (level != "--mode") words.insert(words.end(), {"--value", "1/2"});
    const Outcome run = extract_slab(folder, words);
    EXPECT_EQ(run.status, 4);
    expect_error_line(run, "c.json");
    EXPECT_EQ(contents(folder / "s.vtp"), "before");
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"c.json", "s.vtp"}));
  }
}

TEST(ExtractFailures, AFieldWithoutItsTruthIsNotWritten) {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder / "g.truth.json");
  const Outcome run = run_program({"generate", "linear", "-o", folder / "g.vtu"});
  EXPECT_EQ(run.status, 4);
  expect_error_line(run, "g.truth.json");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"g.truth.json"});
}

/// The certificate is a pipe that is not emptied, so the program waits with the surface unfinished.
TEST(ExtractFailures, AnInterruptedRunLeavesNoFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Folder folder;
    const std::string pipe = folder / "c.json";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int end = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const std::string in = field("s4_slab"), s = folder / "s.vtp";
      std::signal(signal, SIG_DFL);
      execl(TENSORTOPO_PROGRAM, TENSORTOPO_PROGRAM, "extract", in.c_str(), "-o", s.c_str(),
            "--mode", "0.5", "--certify", pipe.c_str(), "--quiet", nullptr);
      _exit(127);
    }
    int state = 0;
    pollfd written{end, POLLIN, 0};
    EXPECT_EQ(poll(&written, 1, 100'000), 1);
    EXPECT_EQ(waitpid(child, &state, WNOHANG), 0);
    kill(child, signal);
    waitpid(child, &state, 0);
    EXPECT_TRUE(WIFSIGNALED(state) && WTERMSIG(state) == signal);
    close(end);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"c.json"});
  }
}

TEST(ExtractFailures, HelpThatNobodyGetsIsAFailure) {
  const Folder folder;
  const std::string words = std::string(TENSORTOPO_PROGRAM) + " --help > /dev/full 2> " +
                            (folder / "err");
  const int state = std::system(words.c_str());
  EXPECT_EQ(WEXITSTATUS(state), 4);
}

}  // namespace
}  // namespace tensortopo::test
