// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace certificate {

/// A VTK XML file of one piece, and the numbers in its arrays.
class XmlFile {
 public:
  /// @param kind what the file must hold, such as "UnstructuredGrid"
  XmlFile(const std::string& file, const char* kind);

  /// A count that the piece declares.
  std::size_t count(const char* attribute) const;
  /// The array of that name in a section of the piece.
  pugi::xml_node array(const char* section, const std::string& name) const;
  /// The only array of a section.
  pugi::xml_node array(const char* section) const;
  /// Its numbers: finite, widened to double.
  std::vector<double> reals(pugi::xml_node array, std::size_t components) const;
  /// Its numbers: integers that are not negative.
  std::vector<std::uint64_t> naturals(pugi::xml_node array) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  template <class Result, class Convert>
  std::vector<Result> numbers(pugi::xml_node array, const Convert& convert) const;
  std::string block(pugi::xml_node array) const;
  std::string decode(std::string_view text, bool base64) const;

  std::string file_, bytes_;
  std::string_view appended_;
  pugi::xml_document document_;
  pugi::xml_node piece_;
  bool appended_base64_ = false, zlib_ = false;
  std::size_t header_ = 8;
};

}  // namespace certificate
