// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_check INPUT OUTPUT CERT [--json] [--quiet]
//
// Checks a certificate. Exit status: 0 all claims hold, 1 some are refuted or undecided, 2 wrong
// usage, 3 a file that cannot be read as what it should be.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certificate_check/check_certificate.hpp"

namespace {

int fail(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
  if (isatty(STDERR_FILENO) == 1) std::cerr << "\r\033[K";  // where progress stood
  std::cerr << "tensortopo: " << message << '\n';
  return 3;
}

void show(std::string_view what, double part) {
  static int shown = -1;
  const int percent = static_cast<int>(100 * part);
  if (percent == std::exchange(shown, percent)) return;
  std::fprintf(stderr, "\r\033[K%3d %% %.*s", percent, static_cast<int>(what.size()), what.data());
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool json = std::erase(words, "--json") > 0;
  const bool quiet = std::erase(words, "--quiet") > 0;
  const bool option = std::any_of(words.begin(), words.end(),
                                  [](const std::string& w) { return w.starts_with("--"); });
  if (words.size() != 3 || option) {
    std::cerr << "usage: tensortopo_check INPUT OUTPUT CERT [--json] [--quiet]\n";
    return 2;
  }
  certificate::Progress progress;
  if (!quiet && isatty(STDERR_FILENO) == 1) progress = show;
  const certificate::Report report =
      certificate::check_certificate(words[0], words[1], words[2], progress);
  if (progress) std::fputs("\r\033[K", stderr);
  if (json) {
    std::cout << certificate::to_json(report) << '\n';
  } else if (!quiet) {
    std::cout << certificate::to_text(report);
  }
  std::cout.flush();
  return report.status() == "certified" && std::cout ? 0 : 1;
} catch (const certificate::Malformed& error) {
  return fail(error.what());
} catch (const std::bad_alloc&) {
  return fail("out of memory");
} catch (const std::exception& error) {
  return fail(std::string("internal error: ") + error.what());
}
