// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace tensortopo {

/// A place to draw where there is no display: a private X server (Xvfb) as a child process.
///
/// While it lives, DISPLAY names it, and Mesa renders in software, the same way on every machine.
/// Where Xvfb is missing, the DISPLAY at hand is used. The server ends with the object, and if
/// this process dies.
class DisplayServer {
 public:
  /// Throws std::runtime_error, naming the package that is missing.
  DisplayServer();
  ~DisplayServer();
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;

 private:
  pid_t child_ = -1;
};

}  // namespace tensortopo
