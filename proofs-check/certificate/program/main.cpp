// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// tensortopo_check INPUT OUTPUT CERT [--json] [--quiet]
//     [--expect-mode M]... [--expect-tensor NAME] [--expect-complete]
//
// Checks a certificate. Exit status: 0 all claims hold and all demands are met, 1 some are refuted,
// undecided or not met, 2 wrong usage, 3 a file that cannot be read as what it should be.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
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

/// Takes an option that has a value, "--name VALUE" or "--name=VALUE", out of the words. False if
/// its value is missing.
bool take(std::vector<std::string>& words, const std::string& name,
          std::vector<std::string>& values) {
  for (std::size_t i = 0; i < words.size();) {
    const bool is_alone = words[i] == name;
    if (!is_alone && !words[i].starts_with(name + '=')) {
      ++i;
      continue;
    }
    if (is_alone && i + 1 == words.size()) return false;
    values.push_back(is_alone ? words[i + 1] : words[i].substr(name.size() + 1));
    const auto at = words.begin() + static_cast<std::ptrdiff_t>(i);
    words.erase(at, at + (is_alone ? 2 : 1));
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool json = std::erase(words, "--json") > 0;
  const bool quiet = std::erase(words, "--quiet") > 0;
  certificate::Demands demands;
  demands.complete = std::erase(words, "--expect-complete") > 0;
  std::vector<std::string> tensors;
  const bool has_values = take(words, "--expect-mode", demands.modes) &&
                          take(words, "--expect-tensor", tensors) && tensors.size() < 2;
  if (!tensors.empty()) demands.tensor = tensors[0];
  const bool option = !has_values || std::any_of(words.begin(), words.end(),
                                  [](const std::string& w) { return w.starts_with("--"); });
  if (words.size() != 3 || option) {
    std::cerr << "usage: tensortopo_check INPUT OUTPUT CERT [--json] [--quiet]\n"
                 "       [--expect-mode M]... [--expect-tensor NAME] [--expect-complete]\n";
    return 2;
  }
  certificate::Report().unmet(demands);  // are they understood?
  certificate::Progress progress;
  if (!quiet && isatty(STDERR_FILENO) == 1) progress = show;
  const certificate::Report report =
      certificate::check_certificate(words[0], words[1], words[2], progress);
  if (progress) std::fputs("\r\033[K", stderr);
  const std::vector<std::string> unmet = report.unmet(demands);
  if (json) {
    std::cout << certificate::to_json(report, unmet) << '\n';
  } else if (!quiet) {
    std::cout << certificate::to_text(report, unmet);
  }
  std::cout.flush();
  return report.status() == "certified" && unmet.empty() && std::cout ? 0 : 1;
} catch (const std::invalid_argument& error) {
  std::cerr << "tensortopo: " << error.what() << '\n';
  return 2;
} catch (const certificate::Malformed& error) {
  return fail(error.what());
} catch (const std::bad_alloc&) {
  return fail("out of memory");
} catch (const std::system_error& error) {
  return fail(std::string("the system gives no thread, or file: ") + error.what());
} catch (const std::exception& error) {
  return fail(std::string("internal error: ") + error.what());
}
