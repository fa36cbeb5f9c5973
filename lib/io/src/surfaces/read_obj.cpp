// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bytes/format_error.hpp"
#include "surfaces/line_scanner.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_builder.hpp"

namespace tensortopo::detail {
namespace {

/// What the format's statements begin with, but for those of geometry.
constexpr std::array<std::string_view, 37> other_statements{
    "vt",         "vn",        "vp",     "g",      "o",    "s",     "mg",    "p",
    "mtllib",     "usemtl",    "usemap", "maplib", "lod",  "bevel", "bmat",  "step",
    "c_interp",   "d_interp",  "deg",    "cstype", "curv", "curv2", "surf",  "parm",
    "trim",       "hole",      "scrv",   "sp",     "end",  "con",   "ctech", "stech",
    "shadow_obj", "trace_obj", "call",   "csh",    "res"};

/// The vertex that `i`, `i/t`, `i/t/n` or `i//n` names; negative numbers count from the last one.
std::int64_t vertex_of(std::string_view word, std::size_t points) {
  const std::int64_t number = integer_of(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(points);
  if (number == 0 || number > count || number < -count)
    throw FormatError("names vertex " + std::to_string(number) + " of " + std::to_string(points));
  return number > 0 ? number - 1 : count + number;
}

void take(const std::vector<std::string_view>& words, SurfaceFile& surface,
          std::vector<std::int64_t>& corners) {
  const std::string_view key = words[0];
  if (key == "v") {
    if (words.size() < 4) throw FormatError("a vertex has fewer than three coordinates");
    add_point(surface, {number_of(words[1]), number_of(words[2]), number_of(words[3])});
  } else if (key == "f" || key == "fo" || key == "l") {
    corners.clear();
    for (std::size_t i = 1; i < words.size(); ++i)
      corners.push_back(vertex_of(words[i], surface.points.size()));
    key == "l" ? add_line(surface, corners) : add_polygon(surface, corners);
  } else if (std::find(other_statements.begin(), other_statements.end(), key) ==
             other_statements.end()) {
    throw FormatError("has the unknown statement \"" + std::string(key.substr(0, 40)) + "\"");
  }
}

}  // namespace

SurfaceFile read_obj(std::string_view bytes) {
  LineScanner lines(bytes);
  SurfaceFile surface;
  std::vector<std::string_view> words;
  std::vector<std::int64_t> corners;
  try {
    while (lines.next(words)) take(words, surface, corners);
  } catch (const FormatError& error) {
    throw FormatError(error.what() + (" (" + lines.place() + ")"));
  }
  return surface;
}

}  // namespace tensortopo::detail
