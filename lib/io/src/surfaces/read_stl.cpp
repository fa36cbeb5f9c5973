// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <string>
#include <vector>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "surfaces/line_scanner.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_builder.hpp"

namespace tensortopo::detail {
namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

void add_triangle(SurfaceFile& surface) {
  const auto last = static_cast<std::int64_t>(surface.points.size());
  add_polygon(surface, std::array<std::int64_t, 3>{last - 3, last - 2, last - 1});
}

std::uint64_t declared_triangles(std::string_view bytes) {
  return static_cast<std::uint64_t>(
      from_bytes<std::int64_t>(bytes.substr(80, 4), ElementType::u32, std::endian::little)[0]);
}

/// The size tells: binary files may begin with "solid", too.
bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + triangle_size * declared_triangles(bytes);
}

SurfaceFile read_binary(std::string_view bytes) {
  SurfaceFile surface;
  for (std::size_t at = header_size; at < bytes.size(); at += triangle_size) {
    const auto n =
        from_bytes<double>(bytes.substr(at + 12, 36), ElementType::f32, std::endian::little);
    for (std::size_t i = 0; i < 9; i += 3) add_point(surface, {n[i], n[i + 1], n[i + 2]});
    add_triangle(surface);
  }
  return surface;
}

std::string lower(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

SurfaceFile read_text_file(LineScanner& lines) {
  SurfaceFile surface;
  std::vector<std::string_view> words;
  std::size_t vertices = 0;
  bool in_solid = false, in_facet = false, in_loop = false;
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw FormatError(std::string("is no STL text: ") + what);
  };
  while (lines.next(words)) {
    const std::string key = lower(words[0]);
    if (key == "solid") {
      require(!in_solid, "a solid within a solid");
      in_solid = true;
    } else if (key == "facet") {
      require(in_solid && !in_facet, "a facet out of place");
      in_facet = true;
    } else if (key == "outer") {
      require(in_facet && !in_loop, "a loop out of place");
      in_loop = true, vertices = 0;
    } else if (key == "vertex") {
      require(in_loop && words.size() == 4 && vertices < 3, "a vertex out of place");
      add_point(surface, {number_of(words[1]), number_of(words[2]), number_of(words[3])});
      ++vertices;
    } else if (key == "endloop") {
      require(in_loop && vertices == 3, "a loop without three vertices");
      add_triangle(surface);
      in_loop = false;
    } else if (key == "endfacet") {
      require(in_facet && !in_loop, "an end of facet out of place");
      in_facet = false;
    } else if (key == "endsolid" || key == "end") {
      require(in_solid && !in_facet, "an end of solid out of place");
      in_solid = false;
    } else if (key != "color") {
      throw FormatError("has the unknown word \"" + key.substr(0, 40) + "\"");
    }
  }
  require(!in_solid, "it ends within a solid");
  return surface;
}

}  // namespace

SurfaceFile read_stl(std::string_view bytes) {
  if (is_binary(bytes)) return read_binary(bytes);
  LineScanner lines(bytes);
  std::vector<std::string_view> words;
  if (LineScanner first(bytes); !first.next(words) || lower(words[0]) != "solid")
    throw FormatError(bytes.size() >= header_size
                          ? "is no STL file: neither text, nor as long as its " +
                                std::to_string(declared_triangles(bytes)) + " triangles"
                          : "is no STL file: neither text, nor long enough for a header");
  try {
    return read_text_file(lines);
  } catch (const FormatError& error) {
    throw FormatError(error.what() + (" (" + lines.place() + ")"));
  }
}

}  // namespace tensortopo::detail
