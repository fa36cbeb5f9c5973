// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bytes/format_error.hpp"
#include "bytes/words.hpp"
#include "surfaces/ply_header.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_builder.hpp"

namespace tensortopo::detail {
namespace {

/// Reads the numbers of the body one after the other.
class PlyBody {
 public:
  PlyBody(const PlyHeader& header) : rest_(header.body), binary_(header.binary) {}

  template <class Value>
  Value next(ElementType type) {
    if (!binary_) {
      const std::string_view word = take_word(rest_);
      if (word.empty()) fail();
      return from_text<Value>(word, type);
    }
    const std::size_t size = size_of(type);
    if (rest_.size() < size) fail();
    const Value value = from_bytes<Value>(rest_.substr(0, size), type, *binary_).front();
    rest_.remove_prefix(size);
    return value;
  }

  /// How many numbers a list has: as many as there is room for.
  std::size_t next_count(ElementType type) {
    const auto count = next<std::int64_t>(type);
    if (count < 0) throw FormatError("has a list of " + std::to_string(count) + " numbers");
    if (static_cast<std::uint64_t>(count) > rest_.size()) fail();
    return static_cast<std::size_t>(count);
  }

  /// Refuses an element that the rest cannot hold: each item has a byte for each property at least.
  void require_room(const PlyElement& element) const {
    if (element.count > 0 && element.properties.empty())
      throw FormatError("has the element " + element.name + " without properties");
    if (element.count > rest_.size()) fail();
  }

  bool is_at_end() const { return trimmed(rest_).empty(); }

 private:
  [[noreturn]] static void fail() { throw FormatError("ends before what its header declares"); }

  std::string_view rest_;
  std::optional<std::endian> binary_;
};

/// One item of an element: its numbers, and the list that is asked for.
struct Item {
  std::vector<double> numbers;  ///< of each property, 0 of a list
  std::vector<std::int64_t> list;
};

/// Reads an element's items. Only the list of the property `list` is kept.
template <class Take>
void for_each_item(PlyBody& body, const PlyElement& element, std::size_t list, const Take& take) {
  body.require_room(element);
  Item item;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    item.numbers.clear(), item.list.clear();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (!property.count_type) {
        item.numbers.push_back(body.next<double>(property.type));
        continue;
      }
      item.numbers.push_back(0);
      const std::size_t count = body.next_count(*property.count_type);
      for (std::size_t n = 0; n < count; ++n) {
        if (k == list)
          item.list.push_back(body.next<std::int64_t>(property.type));
        else
          body.next<double>(property.type);
      }
    }
    take(item);
  }
}

constexpr std::size_t no_list = SIZE_MAX;

void read_vertices(PlyBody& body, const PlyElement& element, SurfaceFile& surface) {
  const std::array<std::size_t, 3> place{element.index_of("x"), element.index_of("y"),
                                         element.index_of("z")};
  for (const std::size_t i : place)
    if (element.properties[i].count_type) throw FormatError("has a list for a coordinate");
  std::vector<std::pair<std::size_t, SurfaceArray>> others;
  for (std::size_t k = 0; k < element.properties.size(); ++k)
    if (!element.properties[k].count_type && k != place[0] && k != place[1] && k != place[2])
      others.emplace_back(
          k,
          SurfaceArray{element.properties[k].name, 1, {}, is_integer(element.properties[k].type)});
  for_each_item(body, element, no_list, [&](const Item& item) {
    add_point(surface, {item.numbers[place[0]], item.numbers[place[1]], item.numbers[place[2]]});
    for (auto& [k, array] : others) array.values.push_back(item.numbers[k]);
  });
  for (auto& [k, array] : others) surface.point_data.push_back(std::move(array));
}

void read_faces(PlyBody& body, const PlyElement& element, SurfaceFile& surface) {
  std::size_t list = no_list;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& p = element.properties[k];
    if (p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index")) list = k;
  }
  if (list == no_list)
    throw FormatError("has no list vertex_indices of its element " + element.name);
  for_each_item(body, element, list, [&](const Item& item) { add_polygon(surface, item.list); });
}

void read_edges(PlyBody& body, const PlyElement& element, SurfaceFile& surface) {
  const std::size_t first = element.index_of("vertex1"), second = element.index_of("vertex2");
  for (const std::size_t k : {first, second})
    if (element.properties[k].count_type || !is_integer(element.properties[k].type))
      throw FormatError("has no whole number for an end of an edge");
  for_each_item(body, element, no_list, [&](const Item& item) {
    add_line(surface, std::array<std::int64_t, 2>{static_cast<std::int64_t>(item.numbers[first]),
                                                  static_cast<std::int64_t>(item.numbers[second])});
  });
}

}  // namespace

SurfaceFile read_ply(std::string_view bytes) {
  const PlyHeader header = read_ply_header(bytes);
  PlyBody body(header);
  SurfaceFile surface;
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    if ((element.name == "face" || element.name == "edge") && !has_vertices)
      throw FormatError("has its element " + element.name + " before its vertices");
    if (is_vertex)
      read_vertices(body, element, surface);
    else if (element.name == "face")
      read_faces(body, element, surface);
    else if (element.name == "edge")
      read_edges(body, element, surface);
    else
      for_each_item(body, element, no_list, [](const Item&) {});
    has_vertices = has_vertices || is_vertex;
  }
  if (!has_vertices) throw FormatError("has no element vertex");
  if (!header.binary && !body.is_at_end()) throw FormatError("holds more than its header declares");
  return surface;
}

}  // namespace tensortopo::detail
