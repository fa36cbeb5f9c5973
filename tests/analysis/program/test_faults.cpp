// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What holds of every file that is written, when memory, disk or time run out: the outputs appear
// together and whole, or not at all; what was there before is untouched; nothing else is left; and
// one line says why, with the status of bad input or of what cannot be written.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "analysis/run_program.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

namespace fs = std::filesystem;

/// A way to write files: `@` stands for the folder with the field m.vtk and the surface in.vtp.
struct Writing {
  std::string name;
  std::vector<std::string> words, outputs;
};
std::ostream& operator<<(std::ostream& out, const Writing& w) { return out << w.name; }

std::vector<Writing> writings() {
  std::vector<Writing> all;
  for (const std::string extension : {"vtp", "ply", "obj", "off", "stl"})
    all.push_back({"extract_" + extension,
                   {"extract", "@/m.vtk", "--mode", "0.2", "-o", "@/s." + extension},
                   {"s." + extension}});
  for (const std::string extension : {"json", "cbor"})
    all.push_back(
        {"certify_" + extension,
         {"extract", "@/m.vtk", "--mode", "0.2", "-o", "@/s.vtp", "--certify", "@/c." + extension},
         {"s.vtp", "c." + extension}});
  all.push_back({"curves",
                 {"extract", "@/m.vtk", "--mode", "1", "-o", "@/c.vtp", "--certify", "@/c.json"},
                 {"c.vtp", "c.json"}});
  all.push_back(
      {"invariant",
       {"extract", "@/m.vtk", "--invariant", "magnitude", "--value", "3", "-o", "@/i.vtp"},
       {"i.vtp"}});
  all.push_back({"generate",
                 {"generate", "linear", "--count", "1", "-o", "@/g.vtu"},
                 {"g.vtu", "g.truth.json", "g.reference.vtp"}});
  all.push_back({"convert", {"convert", "@/m.vtk", "-o", "@/t.vtu"}, {"t.vtu"}});
  all.push_back({"render",
                 {"render", "@/m.vtk", "--mode", "0.2", "--size", "16x16", "-o", "@/p.png"},
                 {"p.png"}});
  all.push_back(
      {"sweep_chart", {"analyze", "@/m.vtk", "--sweep", "0.1:0.3:3", "-o", "@/d.png"}, {"d.png"}});
  return all;
}

struct Limits {
  rlim_t memory = RLIM_INFINITY, file = RLIM_INFINITY;
  bool closed_output = false;
  std::vector<int> missing_streams = {};
};

class Process {
 public:
  Process(const Folder& folder, const Folder& logs, std::vector<std::string> words,
          const Limits& limits = {})
      : out_(logs / "out"), err_(logs / "err") {
    for (std::string& word : words)
      if (word.starts_with("@")) word = folder / word.substr(2);
    words.insert(words.begin(), TENSORTOPO_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) return;
    dup2(open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (limits.closed_output) {
      int ends[2];
      if (pipe(ends) == 0) dup2(ends[1], STDOUT_FILENO), close(ends[0]), close(ends[1]);
    }
    for (const int stream : limits.missing_streams) close(stream);
    unsetenv("DISPLAY");
    const rlimit none{0, 0}, memory{limits.memory, limits.memory}, file{limits.file, limits.file};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_FSIZE, &file);
    setrlimit(RLIMIT_AS, &memory);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~Process() { wait(); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const { kill(child_, signal); }

  /// The exit status; less than zero for the signal that ended it.
  int wait() {
    if (child_ > 0) waitpid(std::exchange(child_, 0), &state_, 0);
    return WIFEXITED(state_) ? WEXITSTATUS(state_) : -WTERMSIG(state_);
  }
  std::string err() const { return contents(err_); }

 private:
  std::string out_, err_;
  pid_t child_ = 0;
  int state_ = 0;
};

class Faults : public testing::TestWithParam<Writing> {
 protected:
  Faults() {
    std::ofstream(folder_ / "m.vtk")
        << "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
           "POINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
           "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
           "TENSORS6 stress double\n3 -1 -2 0.5 0 0.25\n1 -1 0.5 2 3 0\n"
           "0 1 -2 1 2 4\n5 -3 -2 0 2 1\n";
    before();
    Process run(folder_, logs_, GetParam().words);
    status_ = run.wait();
    EXPECT_TRUE(status_ == 0 || status_ == 1) << run.err();
    for (const auto& output : GetParam().outputs) whole_[output] = contents(folder_ / output);
    names_ = folder_.files();
  }

  /// Puts old files where the outputs belong.
  void before() const {
    for (const auto& output : GetParam().outputs) std::ofstream(folder_ / output) << "before";
  }

  /// All outputs are whole, or all are as before; nothing else is there.
  void expect_all_or_nothing(const std::string& what, bool all) const {
    EXPECT_EQ(folder_.files(), names_) << what;
    for (const auto& [name, bytes] : whole_)
      EXPECT_TRUE(contents(folder_ / name) == (all ? bytes : "before")) << what << ' ' << name;
  }

  /// A process that is killed just when a file replaces another leaves it beside that: all of it.
  void remove_what_was_about_to_get_its_name() const {
    for (const auto& name : folder_.files()) {
      if (name.rfind(".tensortopo-", 0) != 0) continue;
      const std::string bytes = contents(folder_ / name);
      EXPECT_TRUE(std::any_of(whole_.begin(), whole_.end(), [&](const auto& output) {
        return output.second == bytes;
      })) << name;
      std::filesystem::remove(folder_ / name);
    }
  }

  void expect_one_line(const std::string& err, const std::string& what) const {
    EXPECT_EQ(err.rfind("tensortopo: ", 0), 0u) << what << err;
    EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << what << err;
  }

  Folder folder_, logs_;
  int status_ = 0;
  std::map<std::string, std::string> whole_;
  std::vector<std::string> names_;
};

/// The least memory with which the program starts at all.
rlim_t least_memory() {
  static const rlim_t least = [] {
    const Folder folder, logs;
    rlim_t memory = 16u << 20;
    for (;; memory += 4u << 20)
      if (Process(folder, logs, {"--version"}, {memory}).wait() == 0) return memory;
  }();
  return least;
}

TEST_P(Faults, LittleMemory) {
  const auto all = full_or_short<std::vector<rlim_t>>({0, 2, 4, 7, 11, 16, 24, 60}, {0, 4, 11, 24, 60});
  for (const rlim_t more : all) {
    before();
    const std::string what = std::to_string(more) + " MB more than none: ";
    Process run(folder_, logs_, GetParam().words, {least_memory() + (more << 20)});
    const int status = run.wait();
    EXPECT_TRUE(status == status_ || status == 3 || status == 4) << what << status << run.err();
    expect_all_or_nothing(what, status == status_);
    if (status == status_) continue;
    expect_one_line(run.err(), what);
  }
}

TEST_P(Faults, FullDisk) {
  for (const rlim_t size : {0u, 1u, 500u}) {
    const bool fits = std::all_of(whole_.begin(), whole_.end(),
                                  [&](const auto& output) { return output.second.size() <= size; });
    if (fits) continue;
    before();
    const Folder logs;
    Process run(folder_, logs, GetParam().words, {RLIM_INFINITY, size});
    EXPECT_EQ(run.wait(), 4) << size << ' ' << run.err();
    expect_all_or_nothing("size " + std::to_string(size), false);
  }
}

TEST_P(Faults, ClosedOutput) {
  before();
  Process run(folder_, logs_, GetParam().words, {RLIM_INFINITY, RLIM_INFINITY, true});
  EXPECT_EQ(run.wait(), -SIGPIPE);
  expect_all_or_nothing("closed output", false);
}

TEST_P(Faults, StandardStreamsThatAreMissing) {
  // All of them, or one of each size with the second.
  for (const int subset : full_or_short<std::vector<int>>({1, 2, 3, 4, 5, 6, 7}, {2, 6, 7})) {
    Limits limits;
    for (int stream = 0; stream < 3; ++stream)
      if ((subset >> stream & 1) != 0) limits.missing_streams.push_back(stream);
    before();
    Process run(folder_, logs_, GetParam().words, limits);
    const int status = run.wait();
    // Without standard output a summary cannot be written.
    const bool may_fail = (subset & 2) != 0 && status == 4;
    EXPECT_TRUE(status == status_ || may_fail) << subset << ' ' << status;
    const bool writes_a_summary = GetParam().words[0] == "extract" && (subset & 2) != 0;
    EXPECT_TRUE(may_fail || !writes_a_summary) << subset;
    expect_all_or_nothing("streams " + std::to_string(subset), !may_fail);
  }
}

TEST_P(Faults, Signals) {
  for (const int signal : {SIGKILL, SIGTERM, SIGINT})
    for (const useconds_t delay : {1'000u, 30'000u, 60'000u, 120'000u}) {
      before();
      Process run(folder_, logs_, GetParam().words);
      usleep(delay);
      run.send(signal);
      const int status = run.wait();
      EXPECT_TRUE(status == -signal || status == status_) << status;
      if (status == -SIGKILL) remove_what_was_about_to_get_its_name();
      // It may come between the first file's name and the second's.
      if (status == -signal && GetParam().outputs.size() > 1) {
        EXPECT_EQ(folder_.files(), names_);
        for (const auto& [name, bytes] : whole_) {
          const std::string is = contents(folder_ / name);
          EXPECT_TRUE(is == bytes || is == "before") << name;
        }
        continue;
      }
      const bool all = contents(folder_ / GetParam().outputs[0]) != "before";
      EXPECT_TRUE(all || status != status_);
      expect_all_or_nothing("signal " + std::to_string(signal), all);
    }
}

TEST_P(Faults, TwoRunsOnOneOutput) {
  for (int i = 0; i < trials(2); ++i) {
    before();
    const Folder other_logs;
    Process first(folder_, logs_, GetParam().words), second(folder_, other_logs, GetParam().words);
    EXPECT_EQ(first.wait(), status_);
    EXPECT_EQ(second.wait(), status_);
    expect_all_or_nothing("two runs", true);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryFile, Faults, testing::ValuesIn(writings()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace tensortopo::test
