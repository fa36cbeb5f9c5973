// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

namespace tensortopo {

void take_places_of_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The smallest number that is free, which is this one.
    const int opened = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened != stream) std::exit(EXIT_FAILURE);
  }
}

}  // namespace tensortopo
