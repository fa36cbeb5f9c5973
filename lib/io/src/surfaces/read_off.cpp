// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <vector>

#include "bytes/format_error.hpp"
#include "bytes/words.hpp"
#include "surfaces/line_scanner.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_builder.hpp"

namespace tensortopo::detail {
namespace {

/// Takes the words of the next line, `least` or more.
void take(LineScanner& lines, std::vector<std::string_view>& words, std::size_t least,
          const std::string& what) {
  if (!lines.next(words)) throw FormatError("ends before " + what);
  if (words.size() < least) throw FormatError("has too few words for " + what);
}

SurfaceFile read(LineScanner& lines) {
  std::vector<std::string_view> words;
  take(lines, words, 1, "its header");
  const std::string_view kind = words[0];
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF")
    throw FormatError("is no .off file of triangles: it does not begin with OFF");
  words.erase(words.begin());
  if (words.empty()) take(lines, words, 2, "its counts");  // on a line of their own
  if (words.size() < 2) throw FormatError("has no counts of vertices and faces");
  const auto vertices = to_count(words[0]), faces = to_count(words[1]);
  if (!vertices || !faces) throw FormatError("has no counts of vertices and faces");

  // Nothing is reserved for what a file only declares.
  SurfaceFile surface;
  for (std::uint64_t i = 0; i < *vertices; ++i) {
    take(lines, words, 3, "vertex " + std::to_string(i));
    add_point(surface, {number_of(words[0]), number_of(words[1]), number_of(words[2])});
  }
  std::vector<std::int64_t> corners;
  for (std::uint64_t i = 0; i < *faces; ++i) {
    take(lines, words, 1, "face " + std::to_string(i));
    const auto count = to_count(words[0]);
    if (!count || *count == 0 || *count >= words.size())
      throw FormatError("face " + std::to_string(i) + " has not as many vertices as it says");
    corners.clear();
    for (std::size_t k = 1; k <= *count; ++k) corners.push_back(integer_of(words[k]));
    add_polygon(surface, corners);
  }
  return surface;
}

}  // namespace

SurfaceFile read_off(std::string_view bytes) {
  LineScanner lines(bytes);
  try {
    return read(lines);
  } catch (const FormatError& error) {
    throw FormatError(error.what() + (" (" + lines.place() + ")"));
  }
}

}  // namespace tensortopo::detail
