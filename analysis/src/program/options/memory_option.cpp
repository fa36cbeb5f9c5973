// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "program/options/memory_option.hpp"

#include <map>
#include <sstream>
#include <string_view>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {

std::uint64_t parse_memory(const std::string& text) {
  static const std::map<std::string_view, double> units{
      {"", 1},         {"B", 1},        {"k", 1e3},      {"kB", 1e3},    {"K", 1e3},  {"KB", 1e3},
      {"M", 1e6},      {"MB", 1e6},     {"G", 1e9},      {"GB", 1e9},    {"T", 1e12}, {"TB", 1e12},
      {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
  const std::size_t end = text.find_first_not_of("0123456789.");
  const std::string number = text.substr(0, end);
  const std::string unit = end == std::string::npos ? "" : text.substr(end);
  const auto refuse = [&](const std::string& what) {
    throw UsageError("--memory " + text + ": " + what +
                     "; write a number of bytes, or one with kB, MB, GB, TB, KiB, MiB, GiB or TiB");
  };
  std::istringstream stream(number);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
    refuse("is no number");
  const auto found = units.find(unit);
  if (found == units.end()) refuse("the unit \"" + unit + "\" is not known");
  const double bytes = value * found->second;
  if (!(bytes >= 1) || bytes > 0x1p62) refuse("is no size of a memory");
  return static_cast<std::uint64_t>(bytes);
}

}  // namespace tensortopo
