// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/global_control.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>

#include <CLI/CLI.hpp>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>

#include "program/exhaustion.hpp"
#include "program/options/distinct_files.hpp"
#include "program/options/given_values.hpp"
#include "program/output/help.hpp"
#include "program/output/versions.hpp"
#include "program/standard_streams.hpp"
#include "program/subcommands/subcommands.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/io_error.hpp"

namespace {

using tensortopo::ExitStatus;
using tensortopo::IoError;

ExitStatus fail(ExitStatus status, std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  std::cerr << "tensortopo: " << message << '\n';
  return status;
}

ExitStatus status_of(IoError::Kind kind) {
  switch (kind) {
    case IoError::Kind::unwritable:
      return ExitStatus::cannot_write;
    case IoError::Kind::inapplicable:
      return ExitStatus::bad_usage;
    case IoError::Kind::unreadable:
    case IoError::Kind::invalid:
      break;
  }
  return ExitStatus::bad_input;
}

// Stages make large arrays and free them by turns: what the system would take back it would have to
// clear page by page before the next stage gets it. The largest arrays are those of reading; kept,
// they would be a twentieth of the peak, in parts of no use to later stages.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 16 << 20);
#endif
}

extern "C" void end_by(int signal) {
  tensortopo::remove_unfinished_files();
  std::raise(signal);  // it has its old meaning again
}

// An interruption leaves no unfinished file, nor does a reader of the output that went away. Where
// signals are ignored (nohup) they stay so; a file too large for the shell's limit is a disk that
// is full.
void prepare_for_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = end_by;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

// What goes wrong is told once, in a line of ours.
class Silence : public vtkOutputWindow {
 public:
  static Silence* New() { return new Silence; }
  void DisplayText(const char*) override {}
};

void silence_vtk() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkNew<Silence>());
}

// Runs what the caller chose; every way to fail ends here.
ExitStatus run(const tensortopo::Action& action, const tensortopo::CommonOptions& common) {
  try {
    tensortopo::require_given_values(common);
    tensortopo::require_distinct_files(common);
    const int threads = common.threads;
    std::optional<tbb::global_control> control;
    if (threads > 0) {
      control.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(threads));
    }
    // The summary is part of what is asked for: without it no file appears.
    tensortopo::FileGroup files;
    const ExitStatus status = action();
    files.commit();
    return status;
  } catch (const tensortopo::UsageError& error) {
    return fail(ExitStatus::bad_usage, error.what());
  } catch (const IoError& error) {
    return fail(status_of(error.kind()), error.what());
  } catch (const std::exception& error) {
    if (const char* what = tensortopo::exhausted(error)) return fail(ExitStatus::bad_input, what);
    return fail(ExitStatus::our_fault, std::string("internal error: ") + error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  tensortopo::take_places_of_closed_streams();
  tensortopo::prepare_for_exhaustion();
  prepare_for_signals();
  keep_memory();
  silence_vtk();
  CLI::App app{"Topology of 3D symmetric tensor fields: mode surfaces of piecewise linear fields",
               "tensortopo"};
  app.set_version_flag("--version", tensortopo::version_text(),
                       "Print the version, and those of the libraries, and exit");
  app.require_subcommand(1);
  tensortopo::set_help_style(app);
  tensortopo::CommonOptions common;
  tensortopo::Action action;
  tensortopo::add_extract_subcommand(app, common, action);
  tensortopo::add_convert_subcommand(app, common, action);
  tensortopo::add_analyze_subcommand(app, common, action);
  tensortopo::add_report_subcommand(app, common, action);
  tensortopo::add_render_subcommand(app, common, action);
  tensortopo::add_bench_subcommand(app, common, action);
  tensortopo::add_check_subcommand(app, common, action);
  tensortopo::add_generate_subcommand(app, common, action);
  tensortopo::add_conformance_subcommand(app, common, action);
  tensortopo::add_verify_subcommand(app, common, action);
  tensortopo::add_proofs_subcommand(app, common, action);
  tensortopo::add_help_subcommand(app, common, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    const int status = app.exit(help);
    std::cout.flush();
    if (std::cout) return status;
    return static_cast<int>(fail(ExitStatus::cannot_write, "standard output: cannot write"));
  } catch (const CLI::ParseError& error) {
    // Of a word that it does not know the parser says that another is missing, or too many are.
    const bool may_be_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                                dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const std::string unknown =
        may_be_unknown ? tensortopo::unknown_word(app, argc, argv) : std::string();
    return static_cast<int>(
        fail(ExitStatus::bad_usage,
             unknown.empty() ? std::string(error.what()) + " (see --help)" : unknown));
  }
  common.chosen = app.get_subcommands().front();
  return static_cast<int>(run(action, common));
}
