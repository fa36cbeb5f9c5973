// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/display_server.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace tensortopo {
namespace {

constexpr int kPatienceMilliseconds = 20000;
constexpr int kExecFailed = 127;

// The child: becomes Xvfb, which writes the number of a free display to `report`.
[[noreturn]] void become_server(int report, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kExecFailed);
  // An interrupt from the keyboard is for the parent, which ends this process.
  setpgid(0, 0);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  fcntl(report, F_SETFD, 0);
  const std::string number = std::to_string(report);
  // Without -noreset a server starts anew when its last client leaves, and meanwhile refuses the
  // next picture's connection, which VTK answers by ending the process.
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "64x64x24", "-noreset",
         "-nolisten", "tcp", static_cast<char*>(nullptr));
  _exit(kExecFailed);
}

// What Xvfb says, up to the end of the line; empty if it ends or takes too long.
std::string read_line(int descriptor) {
  std::string line;
  pollfd wait{descriptor, POLLIN, 0};
  char c = 0;
  while (poll(&wait, 1, kPatienceMilliseconds) == 1 && read(descriptor, &c, 1) == 1) {
    if (c == '\n') return line;
    line += c;
  }
  return {};
}

void end(pid_t child) {
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
}

}  // namespace

DisplayServer::DisplayServer() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe for Xvfb");
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) become_server(ends[1], parent);
  close(ends[1]);
  const std::string display = child_ > 0 ? read_line(ends[0]) : std::string();
  close(ends[0]);
  if (display.empty()) {
    if (child_ > 0) end(child_);
    child_ = -1;
    const char* const given = std::getenv("DISPLAY");
    if (given != nullptr && *given != '\0') return;
    throw std::runtime_error(
        "cannot draw without a display: no X server 'Xvfb' starts (Debian packages xvfb and "
        "libgl1-mesa-dri)");
  }
  setenv("DISPLAY", (':' + display).c_str(), 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  unsetenv("XAUTHORITY");
}

DisplayServer::~DisplayServer() {
  if (child_ > 0) end(child_);
}

}  // namespace tensortopo
