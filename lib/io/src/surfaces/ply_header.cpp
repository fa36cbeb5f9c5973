// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surfaces/ply_header.hpp"

#include <algorithm>
#include <array>

#include "bytes/format_error.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {
namespace {

struct TypeName {
  std::string_view name, other;
  ElementType type;
};

constexpr std::array<TypeName, 8> types{{{"char", "int8", ElementType::i8},
                                         {"uchar", "uint8", ElementType::u8},
                                         {"short", "int16", ElementType::i16},
                                         {"ushort", "uint16", ElementType::u16},
                                         {"int", "int32", ElementType::i32},
                                         {"uint", "uint32", ElementType::u32},
                                         {"float", "float32", ElementType::f32},
                                         {"double", "float64", ElementType::f64}}};

ElementType type_of(std::string_view name) {
  for (const TypeName& type : types)
    if (name == type.name || name == type.other) return type.type;
  throw FormatError("has the unknown type \"" + std::string(name.substr(0, 40)) + "\"");
}

/// Takes a line off the front; throws FormatError if there is none.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) throw FormatError("ends within its header");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return trimmed(line);
}

void add_property(std::string_view line, PlyElement& element) {
  PlyProperty property;
  std::string_view type = take_word(line);
  if (type == "list") {
    property.count_type = type_of(take_word(line));
    if (!is_integer(*property.count_type)) throw FormatError("counts a list with fractions");
    type = take_word(line);
  }
  property.type = type_of(type);
  property.name = take_word(line);
  for (const PlyProperty& other : element.properties)
    if (other.name == property.name)
      throw FormatError("has the property " + property.name.substr(0, 40) + " twice");
  if (property.name.empty()) throw FormatError("has a property without a name");
  if (element.properties.size() == 1000) throw FormatError("has too many properties");
  element.properties.push_back(std::move(property));
}

void set_format(std::string_view line, PlyHeader& header) {
  const std::string_view format = take_word(line);
  if (format == "binary_little_endian")
    header.binary = std::endian::little;
  else if (format == "binary_big_endian")
    header.binary = std::endian::big;
  else if (format != "ascii")
    throw FormatError("has the unknown format \"" + std::string(format.substr(0, 40)) + "\"");
  if (take_word(line) != "1.0") throw FormatError("is of another version than 1.0");
}

}  // namespace

std::size_t PlyElement::index_of(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  if (found == properties.end())
    throw FormatError("has no property " + std::string(property) + " of its element " + name);
  return static_cast<std::size_t>(found - properties.begin());
}

PlyHeader read_ply_header(std::string_view bytes) {
  PlyHeader header;
  header.body = bytes;
  if (take_line(header.body) != "ply") throw FormatError("does not begin with \"ply\"");
  bool has_format = false;
  for (std::string_view line = take_line(header.body); line != "end_header";
       line = take_line(header.body)) {
    const std::string_view key = take_word(line);
    if (key == "format" && !has_format) {
      set_format(line, header);
      has_format = true;
    } else if (key == "element") {
      PlyElement element;
      element.name = take_word(line);
      const auto count = to_count(take_word(line));
      if (!count) throw FormatError("has no count of its element " + element.name.substr(0, 40));
      element.count = *count;
      for (const PlyElement& other : header.elements)
        if (other.name == element.name)
          throw FormatError("has the element " + element.name.substr(0, 40) + " twice");
      if (header.elements.size() == 1000) throw FormatError("has too many elements");
      header.elements.push_back(std::move(element));
    } else if (key == "property" && !header.elements.empty()) {
      add_property(line, header.elements.back());
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      throw FormatError("has the header line \"" + std::string(key.substr(0, 40)) +
                        "\" out of place");
    }
  }
  if (!has_format) throw FormatError("has no format");
  return header;
}

}  // namespace tensortopo::detail
