// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "parts/part_files.hpp"

#include <algorithm>
#include <filesystem>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "certificate_check/check_certificate.hpp"
#include "files/file.hpp"

namespace certificate {

std::vector<std::string> piece_names(const std::string& file, const std::string& kind) {
  const auto fail = [&](const std::string& what) { throw Malformed(file, what); };
  const std::string bytes = read_file(file).bytes, type = "P" + kind;
  // A reader that stops at a zero, or that replaces entities, has another reading.
  if (bytes.find('\0') != std::string::npos || bytes.find('&') != std::string::npos ||
      bytes.find("<!") != std::string::npos)
    fail("has entities, comments, sections or zeros, which are not read here");
  if (bytes.find("<?", 1) != std::string::npos)
    fail("has instructions inside, which are not read here");
  const std::size_t encoding = bytes.find("encoding");
  if (bytes.starts_with("<?") && encoding < bytes.find("?>") &&
      bytes.compare(encoding, 16, "encoding=\"UTF-8\"") != 0)
    fail("is not declared as UTF-8");
  pugi::xml_document document;
  if (!document.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8))
    fail("is no XML");
  const pugi::xml_node root = document.child("VTKFile"), grid = root.child(type.c_str());
  if (root.attribute("type").value() != type || !grid) fail("is no VTK file of type " + type);
  if (root.next_sibling() || grid.next_sibling() || grid.previous_sibling())
    fail("has more than one " + type);
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const pugi::xml_node piece : grid.children("Piece")) {
    const auto attributes = piece.attributes();
    if (std::distance(attributes.begin(), attributes.end()) != 1 || !piece.attribute("Source") ||
        piece.first_child())
      fail("piece " + std::to_string(names.size()) + " has other than one attribute Source");
    names.emplace_back(piece.attribute("Source").value());
    if (names.back().empty()) fail("piece " + std::to_string(names.size() - 1) + " has no name");
    if (!known.insert(names.back()).second) fail("names " + names.back() + " twice");
    beside(file, names.back());
  }
  if (names.empty()) fail("names no pieces");
  return names;
}

std::string beside(const std::string& file, const std::string& name) {
  bool is_below = true;
  for (std::size_t begin = 0, end = 0; end < name.size() || begin == 0; begin = end + 1) {
    end = std::min(name.find('/', begin), name.size());
    const std::string_view part = std::string_view(name).substr(begin, end - begin);
    is_below = is_below && !part.empty() && part != "." && part != "..";
  }
  if (!is_below || std::filesystem::path(name).has_root_path())
    throw Malformed(file, "names " + name + ", which is not beside it or in a folder below; move the file");
  return (std::filesystem::path(file).parent_path() / name).string();
}

}  // namespace certificate
