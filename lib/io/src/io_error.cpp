// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/io/io_error.hpp"

#include <utility>

#include "bytes/printable.hpp"

namespace tensortopo {
namespace {

/// Names in files are anything: keep a message to one printable line of bearable length.
std::string one_line(std::string text) {
  text = detail::printable(std::move(text));
  constexpr std::size_t longest = 2000;
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

}  // namespace

IoError::IoError(Kind kind, std::filesystem::path file, const std::string& problem)
    : std::runtime_error(one_line(file.string() + ": " + problem)),
      kind_(kind),
      file_(std::move(file)) {}

IoError IoError::named_by(const std::filesystem::path& index) const {
  IoError error = *this;
  static_cast<std::runtime_error&>(error) =
      std::runtime_error(one_line(what() + (" (named by " + index.string() + ")")));
  return error;
}

}  // namespace tensortopo
