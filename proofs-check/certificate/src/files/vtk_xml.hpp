// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <map>
#include <utility>
#include <vector>

#include "files/file.hpp"

namespace certificate {

/// A VTK XML file of one piece, and the numbers in its arrays. Its members throw Malformed.
///
/// It has one reading: each section is there once, each attribute of an element once and known, whole
/// numbers are digits, texts have nothing that stands for a character, attributes no brackets, nothing
/// is there that is not listed, an array is text, inline or appended and not two of these, integers are
/// such that doubles hold them. No cell or point is marked as a ghost. All numbers read together take at
/// most 64 bytes for each byte of the file, and 2^24 more.
class XmlFile {
 public:
  /// @param kind what the file must hold, such as "UnstructuredGrid"
  /// @param sections  of the piece, besides points and data
  /// @pre the file outlives this
  XmlFile(const File& file, const char* kind, std::vector<std::string_view> sections);

  /// A count that the piece declares.
  std::size_t count(const char* attribute) const;
  /// Name and components of each array in a section of the piece; each has a name, and is of numbers.
  std::vector<std::pair<std::string, std::size_t>> arrays(const char* section) const;
  /// The finite numbers of the array of that name in a section of the piece; of the points, of the only one.
  std::vector<double> numbers(const char* section, const std::string& name,
                              std::size_t components = 1) const;
  /// The same of an array of integers from 0 to 2^53.
  std::vector<std::uint64_t> naturals(const char* section, const char* name) const;
  /// The names of an array's components, empty where there is none.
  std::vector<std::string> component_names(const char* section, const std::string& name) const;
  /// The sections of the piece have only these arrays.
  void require_only(const char* section, const std::vector<std::string_view>& names) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string markup();
  void require_blank(std::string_view outside) const;
  void require_utf8(std::string_view xml) const;
  void require_one_reading(const char* kind, const std::vector<std::string_view>& sections);
  std::size_t natural(pugi::xml_node node, const char* attribute, std::size_t otherwise) const;
  pugi::xml_node only_array(const char* section, const std::string& name) const;
  void spend(std::size_t bytes) const;
  std::string first(std::string_view text, std::size_t size, bool base64) const;
  std::string take(std::string_view& text, std::size_t size, bool base64) const;
  template <class Stored>
  Stored item(const std::string& bytes, std::size_t i) const;
  std::uint64_t word(const std::string& words, std::size_t i) const;
  std::string decode(std::string_view text, bool base64, std::size_t item) const;
  template <class Stored>
  std::vector<double> read(pugi::xml_node array) const;

  const std::string &file_, &bytes_;
  std::string_view appended_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  std::map<std::pair<std::string, std::string>, pugi::xml_node> arrays_;  ///< by section and name
  bool appended_base64_ = false, zlib_ = false, highest_first_ = false, has_order_ = false;
  std::size_t header_ = 8;
  mutable std::size_t budget_ = 0;  ///< bytes that decoded numbers may still take
};

}  // namespace certificate
