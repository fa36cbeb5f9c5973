// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// What keeps a VTK XML file to one reading: bytes, elements and attributes.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "files/utf8.hpp"
#include "files/vtk_xml.hpp"

namespace certificate {
namespace {

/// Is it an XML declaration of version 1, with no other encoding, and nothing else in it?
bool is_plain_declaration(std::string_view declaration) {
  std::string text(declaration);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (char& c : text)
    if (c == '\'') c = '"';
  std::istringstream words(text);
  std::string word;
  words >> word;  // <?xml
  std::vector<std::string> found;
  while (words >> word) found.push_back(word);
  if (!found.empty() && found.back() != "?>" && found.back().ends_with("?>")) {
    found.back().resize(found.back().size() - 2);
    found.push_back("?>");
  }
  auto next = found.begin();
  const auto take = [&](const std::set<std::string>& one_of) {
    const bool is_there = next != found.end() && one_of.contains(*next);
    next += is_there ? 1 : 0;
    return is_there;
  };
  if (!take({"version=\"1.0\"", "version=\"1.1\""})) return false;
  take({"encoding=\"utf-8\"", "encoding=\"us-ascii\"", "encoding=\"ascii\""});
  take({"standalone=\"yes\"", "standalone=\"no\""});
  return take({"?>"}) && next == found.end();
}

std::size_t skip_past(std::string_view text, std::string_view end, std::size_t from) {
  const std::size_t place = text.find(end, from);
  return place == std::string_view::npos ? place : place + end.size();
}

bool is_numeric(std::string_view type) {
  constexpr std::array<std::string_view, 10> kTypes{"Int8",   "UInt8",  "Int16",   "UInt16",  "Int32",
                                                    "UInt32", "Int64",  "UInt64",  "Float32", "Float64"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

/// Attributes that change nothing, or are read here. There are others that other readers obey.
bool is_known(const pugi::xml_node& element, std::string_view attribute) {
  static const std::map<std::string_view, std::set<std::string_view>> known{
      {"VTKFile", {"type", "version", "byte_order", "header_type", "compressor"}},
      {"Piece",
       {"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips",
        "NumberOfPolys"}},
      {"PointData",
       {"Scalars", "Vectors", "Normals", "Tensors", "TCoords", "Tangents", "GlobalIds",
        "PedigreeIds", "EdgeFlag", "RationalWeights", "HigherOrderDegrees", "ProcessIds"}},
      {"DataArray",
       {"type", "Name", "NumberOfComponents", "format", "offset", "RangeMin", "RangeMax"}},
      {"AppendedData", {"encoding"}},
      {"InformationKey", {"name", "location", "length"}},
      {"Value", {"index"}}};
  std::string_view name = element.name();
  if (name == "CellData") name = "PointData";
  if (name == "Array") name = "DataArray";
  const auto found = known.find(name);
  if (found == known.end()) return false;
  if (found->second.contains(attribute)) return true;
  if (name != "DataArray") return false;
  // Ids: other readers take the array for one of 64-bit integers, whatever its type says.
  if (attribute == "IdType")
    return element.attribute("type").value() == std::string_view("Int64") &&
           element.attribute("IdType").value() == std::string_view("1");
  if (attribute == "NumberOfTuples") return element.parent().name() == std::string_view("FieldData");
  constexpr std::string_view kName = "ComponentName";
  return attribute.starts_with(kName) && attribute.size() > kName.size() &&
         attribute.find_first_not_of("0123456789", kName.size()) == std::string_view::npos;
}

/// What a surface or curve says of its arrays beside their numbers, which nothing could derive.
std::string claim_beside_numbers(const pugi::xml_node& element, std::string_view attribute) {
  const std::string_view name = element.name(), value = element.attribute(attribute.data()).value();
  if (attribute.starts_with("ComponentName")) return "names of components";
  if (name == "InformationKey" && attribute == "name" && value != "L2_NORM_RANGE" &&
      value != "L2_NORM_FINITE_RANGE")
    return "the key " + std::string(value);
  // Scalars and vectors only say what is shown first; parts have the whole surface's normals.
  const bool is_section = name == "PointData" || name == "CellData";
  const bool are_normals = attribute == "Normals" && (value == "normal" || value == "whole_normal");
  if (is_section && attribute != "Scalars" && attribute != "Vectors" && !are_normals)
    return std::string(attribute) + " that are '" + std::string(value) + "'";
  return {};
}

}  // namespace

/// The part that is XML: from the underscore of the appended data on the bytes are none. Comments
/// are skipped, so that nothing in them is taken for an element.
std::string XmlFile::markup() {
  constexpr std::size_t kNone = std::string_view::npos, kMaxDepth = 16;
  const std::string_view all = bytes_;
  if (const std::size_t first = all.find_first_not_of(" \t\r\n");
      first == kNone || all[first] != '<')
    fail("no VTK XML file, which begins with '<'");
  std::size_t depth = 0, text = 0;  // where the text before an element begins
  bool is_in_array = false;
  for (std::size_t at = all.find('<'); at != kNone; text = at, at = all.find('<', at)) {
    // Some readers take arrays as they are, others replace what stands for a character.
    if (all.substr(text, at - text).find('&') != kNone) fail("a text with '&'");
    if (depth == 0) require_blank(all.substr(text, at - text));
    const std::string_view rest = all.substr(at);
    const std::size_t begin = at;
    if (rest.starts_with("<!--")) {
      at = skip_past(all, "-->", at + 4);
      if (at != kNone && all.substr(begin + 1, at - begin - 1).find('<') != kNone)
        fail("a comment with '<'");
      // Some readers take the text before it for the array, others that after it, or none.
      if (is_in_array) fail("a comment in an array");
    } else if (at == 0 && rest.starts_with("<?xml ")) {
      at = skip_past(all, "?>", at);
      if (at != kNone && !is_plain_declaration(all.substr(0, at)))
        fail("an XML declaration of another version or encoding, or with more");
    } else if (rest.starts_with("<?")) {
      fail("an instruction");
    } else if (rest.starts_with("<!")) {
      fail("a declaration, or a part that is marked as text");
    } else {
      std::size_t end = at + 1;
      for (char quote = 0; end < all.size() && (quote != 0 || all[end] != '>'); ++end) {
        // VTK looks for the end of an element's tag without regard to quotes.
        if (quote != 0 && (all[end] == '<' || all[end] == '>'))
          fail(std::string("an attribute with '") + all[end] + "'");
        if (quote != 0)
          quote = all[end] == quote ? '\0' : quote;
        else if (all[end] == '"' || all[end] == '\'')
          quote = all[end];
      }
      if (end >= all.size()) fail("no VTK XML file");
      const bool is_end = rest.starts_with("</"), is_begin = !is_end && all[end - 1] != '/';
      depth += is_begin ? 1 : 0, depth -= is_end && depth > 0 ? 1 : 0;
      if (depth > kMaxDepth) fail("elements that are nested too deeply");
      is_in_array = is_begin && rest.starts_with("<DataArray");
      if (rest.starts_with("<AppendedData")) {
        const std::size_t start = all.find_first_not_of(" \t\r\n", end + 1);
        if (start == kNone || all[start] != '_') fail("AppendedData without data");
        appended_ = all.substr(start + 1);
        return bytes_.substr(0, end) + "/></VTKFile>";
      }
      at = end + 1;
    }
    if (at == kNone) fail("no VTK XML file");
  }
  require_blank(all.substr(text));
  return bytes_;
}

/// XML has no text outside of its root element: some readers skip it, others refuse the file.
void XmlFile::require_blank(std::string_view outside) const {
  if (outside.find_first_not_of(" \t\r\n") != outside.npos) fail("text outside of its elements");
}

/// One encoding for all readers, without what some of them end at.
void XmlFile::require_utf8(std::string_view xml) const {
  if (!xml.starts_with('<')) fail("does not begin with '<'");
  for (std::size_t i = 0; i < xml.size();) {
    const auto c = static_cast<unsigned char>(xml[i]);
    if (c < 0x20 && c != '\t' && c != '\n' && c != '\r') fail("a control character");
    const std::size_t length = c < 0x80 ? 1 : length_of_character(xml.substr(i));
    if (length == 0) fail("is not encoded as UTF-8");
    if (const std::string_view rest = xml.substr(i, 4);
        rest.starts_with("&#0") || rest.starts_with("&#x0") || rest.starts_with("&#X0"))
      fail("a reference to a character of code zero");
    i += length;
  }
}

/// Nothing is there twice, nor anything that would be left unread.
void XmlFile::require_one_reading(const char* kind,
                                  const std::vector<std::string_view>& sections) {
  struct Walker : pugi::xml_tree_walker {
    const XmlFile& file;
    bool is_field;
    Walker(const XmlFile& f, bool field) : file(f), is_field(field) {}
    bool for_each(pugi::xml_node& node) override {
      std::vector<std::string_view> names;
      for (const pugi::xml_attribute a : node.attributes()) names.push_back(a.name());
      std::sort(names.begin(), names.end());
      if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
        file.fail("attribute '" + std::string(*twice) + "' is given twice");
      if (node.type() == pugi::node_element)
        for (const std::string_view name : names) {
          if (!is_known(node, name))
            file.fail("attribute '" + std::string(name) + "' of '" + node.name() +
                      "', which is not known here");
          if (is_field) continue;
          if (const auto claim = claim_beside_numbers(node, name); !claim.empty())
            file.fail("has " + claim + ", which only a field may have");
        }
      if (node.name() == std::string_view("DataArray") && !is_numeric(node.attribute("type").value()))
        file.fail("has an array of type '" + std::string(node.attribute("type").value()) +
                  "', which is not known here");
      return true;
    }
  } walker(*this, kind == std::string_view("UnstructuredGrid"));
  document_.traverse(walker);
  const auto only = [&](pugi::xml_node parent, const std::vector<std::string_view>& names) {
    std::vector<std::string_view> seen;
    for (const pugi::xml_node child : parent.children()) {
      if (child.type() == pugi::node_declaration) continue;
      const std::string_view name = child.name();
      if (child.type() != pugi::node_element ||
          std::find(names.begin(), names.end(), name) == names.end())
        fail("'" + std::string(name) + "' does not belong into '" + parent.name() + "'");
      if (std::find(seen.begin(), seen.end(), name) != seen.end())
        fail("has two sections '" + std::string(name) + "'");
      seen.push_back(name);
    }
  };
  only(document_, {"VTKFile"});
  const pugi::xml_node root = document_.child("VTKFile");
  only(root, {kind, "AppendedData"});
  only(root.child(kind), {"Piece", "FieldData"});
  std::vector<std::string_view> all{"Points", "PointData", "CellData"};
  all.insert(all.end(), sections.begin(), sections.end());
  only(root.child(kind).child("Piece"), all);
}

}  // namespace certificate
