// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "analysis/run_program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tensortopo::test {
namespace {

[[noreturn]] void become_program(std::vector<std::string> words, const std::string& out,
                                 const std::string& err) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  unsetenv("DISPLAY");
  execv(argv[0], argv.data());
  _exit(127);
}

Outcome run(const std::vector<std::string>& arguments, const Folder& folder,
            const std::string& out) {
  const std::string err = folder / "err";
  std::vector<std::string> words{TENSORTOPO_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_program(words, out, err);
  int state = 0;
  waitpid(child, &state, 0);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, {}, contents(err)};
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments) {
  const Folder folder;
  const std::string out = folder / "out";
  Outcome outcome = run(arguments, folder, out);
  outcome.out = contents(out);
  return outcome;
}

Outcome run_without_output(const std::vector<std::string>& arguments) {
  const Folder folder;
  return run(arguments, folder, "/dev/full");
}

std::string field(const std::string& name) {
  return std::string(TENSORTOPO_DATA) + "/" + name + "_small_C3D8I.vtu";
}

Outcome extract_slab(const Folder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"extract", field("s4_slab"), "-o", folder / "s.vtp"});
  return run_program(words);
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace tensortopo::test
