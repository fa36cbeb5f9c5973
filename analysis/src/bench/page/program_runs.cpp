// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/page/program_runs.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>
#include <utility>

#include "append_format.hpp"
#include "bench/bench_command.hpp"
#include "bench/timing.hpp"
#include "short_text.hpp"
#include "tensortopo/io/io_error.hpp"
#include "tensortopo/io/temporary_folder.hpp"

namespace tensortopo {
namespace {

constexpr int kRepeat = 3;

/// In the child: becomes the program, or ends.
[[noreturn]] void become_self(char** words, const char* output) {
  const int out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (out < 0 || dup2(out, STDOUT_FILENO) < 0) _exit(127);
  execv("/proc/self/exe", words);
  _exit(127);
}

/// Bytes of the numbers that a run reads and writes.
double numbers_of(const nlohmann::json& report) {
  const auto& input = report.at("input");
  double bytes =
      72 * input.at("vertices").get<double>() + 24 * input.at("tetrahedra").get<double>();
  for (const auto& surface : report.at("surfaces"))
    bytes +=
        112 * surface.at("vertices").get<double>() + 20 * surface.at("triangles").get<double>();
  return bytes;
}

struct Runs {
  std::vector<ProgramRun> all;

  double median(const std::function<double(const ProgramRun&)>& number) const {
    std::vector<double> numbers;
    for (const ProgramRun& run : all) numbers.push_back(number(run));
    return numbers[median_place(numbers)];
  }
  double seconds() const {
    return median([](const ProgramRun& run) { return run.seconds; });
  }
  const nlohmann::json& report() const { return all.front().report; }
};

}  // namespace

ProgramRun run_self(std::vector<std::string> arguments) {
  TemporaryFolder folder;
  const std::string output = folder.file("report.json").string();
  std::vector<std::string> words{"tensortopo"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--json", "--quiet"});
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ProgramRun run;
  int status = 0;
  rusage usage{};
  run.seconds = seconds_of([&] {
    const pid_t child = fork();
    if (child == 0) become_self(pointers.data(), output.c_str());
    if (child < 0 || wait4(child, &status, 0, &usage) != child) status = -1;
  });
  if (status < 0 || !WIFEXITED(status) || WEXITSTATUS(status) > 1)
    throw IoError(IoError::Kind::unreadable, "/proc/self/exe",
                  "cannot be measured: tensortopo " + arguments.front() + " does not end well");
  run.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
  std::ifstream text(output, std::ios::binary);
  run.report = nlohmann::json::parse(text);
  return run;
}

std::string programs_table(const MeasurementsCommand& command, TimeBudget& budget,
                           const Progress& progress) {
  std::string text =
      "\n## Programs\n\nWhole programs, files read and written: `extract`, `extract --certify`, "
      "`check`. Claims as the independent checker judges them. Peak memory is that of `extract`, "
      "over the memory of the numbers that it reads and writes.\n\n"
      "| field | modes | unresolved tetrahedra | claims | certified | undecided | refuted | "
      "extract, s | reading and writing | certify over extract | check over extract | certificate "
      "over .vtp | peak over input and output |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& input : command.inputs)
    for (const ModeValue& mode : command.modes) {
      if (progress) progress("programs on " + input.stem().string(), 0);
      TemporaryFolder folder;
      const std::string output = folder.file("s.vtp").string(),
                        certificate = folder.file("c.json").string();
      std::vector<std::string> extract{"extract", input.string(), "-o",
                                       output,    "--mode",       mode.text()};
      if (mode.sign() != 0) extract.emplace_back("--generalized");
      extract.insert(extract.end(), {"--threads", std::to_string(threads_in_use())});
      extract.insert(extract.end(), command.read_words.begin(), command.read_words.end());
      std::vector<std::string> certify = extract;
      certify.insert(certify.end(), {"--certify", certificate});
      const std::array<std::vector<std::string>, 3> all{
          extract, certify, {"check", input.string(), output, certificate}};
      std::array<Runs, 3> runs;
      std::vector<Contender> programs;
      for (std::size_t i = 0; i < all.size(); ++i)
        programs.push_back({all[i].front(), [&, i] {
                              runs[i].all.push_back(run_self(all[i]));
                              return std::size_t{0};
                            }});
      (void)time_in_turn(programs, kRepeat, {}, budget.take(kProgramsWeight));
      const auto& [plain, certified, check] = runs;
      const double seconds = plain.seconds();
      const double files = plain.median([](const ProgramRun& run) {
        const auto& stages = run.report.at("seconds");
        return (stages.at("read").get<double>() + stages.at("write").get<double>()) / run.seconds;
      });
      const double peak =
          plain.median([](const ProgramRun& run) { return static_cast<double>(run.peak_bytes); });
      const auto& report = certified.report();
      append_format(
          text,
          "| {} | {}{} | {} | {} | {} | {} | {} | {:.2f} | {:.0f} % | {:.1f} | {:.1f} | {:.1f} | "
          "{:.1f} |\n",
          input.stem().string(), mode.sign() == 0 ? "" : "±", short_text(mode),
          report.at("unresolved_cells").size(), check.report().at("claims").get<long>(),
          check.report().at("certified").get<long>(), check.report().at("undecided").get<long>(),
          check.report().at("refuted").get<long>(), seconds, 100 * files,
          certified.seconds() / seconds, check.seconds() / seconds,
          report.at("certificate").at("bytes").get<double>() /
              report.at("output").at("bytes").get<double>(),
          peak / numbers_of(plain.report()));
    }
  return text;
}

}  // namespace tensortopo
