// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "reactions.hpp"

#include <charconv>
#include <optional>
#include <sstream>
#include <string>

#include "file_bytes.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::scenarios {

namespace {

// Fortran drops the E before an exponent of three digits.
std::optional<double> fortran_number(std::string text) {
  const auto sign = text.find_last_of("+-");
  if (sign != text.npos && sign > 0 && text[sign - 1] != 'E') text.insert(sign, 1, 'E');
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  // Too small for a double is zero.
  if (error == std::errc::result_out_of_range && text.find("E-") != text.npos) return 0.0;
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return x;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> found;
  for (std::string word; in >> word;) found.push_back(word);
  return found;
}

}  // namespace

Reactions read_reactions(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& problem) {
    throw IoError(IoError::Kind::invalid, file, problem);
  };
  const auto force = [&](const std::vector<std::string>& from, std::size_t first) {
    const auto x = fortran_number(from[first]), y = fortran_number(from[first + 1]),
               z = fortran_number(from[first + 2]);
    if (!x || !y || !z) refuse("has a force that is no number");
    return Vector3<double>{*x, *y, *z};
  };
  std::istringstream in(file_bytes(file));
  Reactions result;
  enum { elsewhere, at_nodes, total } part = elsewhere;
  bool has_total = false;
  for (std::string line; std::getline(in, line);) {
    const auto parts = words(line);
    if (line.starts_with(" forces (fx,fy,fz) for set BOTTOM")) {
      part = at_nodes;
    } else if (line.starts_with(" total force (fx,fy,fz) for set BOTTOM")) {
      part = total;
    } else if (part == at_nodes && parts.size() == 4) {
      const auto node = fortran_number(parts[0]);
      if (!node || *node < 1 || *node > 1e9) refuse("has a force at no node");
      result.nodes.push_back({static_cast<Index>(*node) - 1, force(parts, 1)});
    } else if (part == total && parts.size() == 3) {
      result.total = force(parts, 0);
      has_total = true;
      part = elsewhere;
    }
  }
  if (result.nodes.empty() || !has_total)
    refuse("lacks the reactions of the set BOTTOM; did the solve end well?");
  return result;
}

}  // namespace tensortopo::scenarios
