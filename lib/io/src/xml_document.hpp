// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "data_block.hpp"
#include "input_file.hpp"

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
};

/// Throws FormatError if the file is not one of the given type (`UnstructuredGrid`, ...).
std::shared_ptr<const XmlDocument> parse_xml(std::shared_ptr<const InputFile> file,
                                             std::string_view type);

/// The numbers of a <DataArray>, which must be exactly `count`. Value is double or std::int64_t.
/// Throws FormatError.
template <class Value>
std::vector<Value> read_array(const XmlDocument& document, pugi::xml_node array, std::size_t count);

/// A count in an attribute, white space around it allowed. Throws FormatError.
std::uint64_t count_attribute(pugi::xml_node node, const char* name);

}  // namespace tensortopo::detail
