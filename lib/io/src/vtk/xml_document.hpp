// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "bytes/data_block.hpp"
#include "bytes/format_error.hpp"
#include "bytes/input_file.hpp"

namespace tensortopo::detail {

/// The markup of a VTK XML file, parsed, and its appended bytes, which are no XML.
struct XmlDocument {
  std::shared_ptr<const InputFile> file;
  pugi::xml_document markup;
  pugi::xml_node root;  ///< <VTKFile>
  BlockFormat format;

  std::string_view appended;  ///< after the underscore
  bool appended_is_base64 = false;
  std::vector<std::uint64_t> offsets;  ///< of all appended arrays, sorted

  mutable std::uint64_t decompressed = 0;  ///< numbers so far, see `read_array`
};

/// Throws FormatError if the file is not one of the given type (`UnstructuredGrid`, ...).
std::shared_ptr<const XmlDocument> parse_xml(std::shared_ptr<const InputFile> file,
                                             std::string_view type);

/// The numbers of a <DataArray>, which must be exactly `count`. Value is double or std::int64_t.
/// Compressed arrays together may hold no more numbers than 32 for each byte of the file, or two
/// million: smooth arrays do not pack that well, and a file of zeros must not fill the memory.
/// Throws FormatError.
template <class Value>
std::vector<Value> read_array(const XmlDocument& document, pugi::xml_node array, std::size_t count);

/// The same, with the array's name in the error.
template <class Value>
std::vector<Value> read_array(const XmlDocument& document, pugi::xml_node array, std::size_t count,
                              const std::string& name) {
  try {
    return read_array<Value>(document, array, count);
  } catch (const FormatError& error) {
    throw FormatError("the array " + name + " " + error.what());
  }
}

/// The text of an <Array> of one string; none if it is not one, or of more than 4096 bytes. Throws
/// FormatError.
std::optional<std::string> read_string(const XmlDocument& document, pugi::xml_node array);

/// The number of components of an array. Throws FormatError.
std::uint64_t components_of(pugi::xml_node array);

/// A count in an attribute, white space around it allowed. Throws FormatError.
std::uint64_t count_attribute(pugi::xml_node node, const char* name);

}  // namespace tensortopo::detail
