// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/vtk_legacy.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"

namespace certificate {
namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool is_blank(std::string_view text) { return std::all_of(text.begin(), text.end(), is_space); }

/// What a number is in a binary file, and how it is rounded in a text.
struct Type {
  enum Kind { real, whole, natural, bit, text } kind;
  std::size_t size;  ///< bytes
};

/// A number from its bytes, the highest first.
double from_bytes(const char* bytes, Type type) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  const std::size_t unused = 64 - 8 * type.size;
  if (type.kind == Type::natural) return static_cast<double>(bits);
  if (type.kind == Type::whole)
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  return type.size == 8 ? std::bit_cast<double>(bits)
                        : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

class LegacyReader {
 public:
  LegacyReader(const std::string& file, const std::string& tensor, std::size_t components)
      : file_(file), bytes_(file_bytes(file)), rest_(bytes_), tensor_(tensor), width_(components) {}

  Grid read() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    const std::string_view first = line();
    if (!first.starts_with(kMagic)) fail("no legacy VTK file");
    const int version = std::atoi(first.data() + kMagic.size());
    line(256);  // a title
    const std::string mode = keyword();
    if (mode != "ascii" && mode != "binary") fail("neither ASCII nor BINARY");
    binary_ = mode == "binary";
    if (keyword() != "dataset" || keyword() != "unstructured_grid") fail("no unstructured grid; tensortopo convert makes one");
    for (std::string key = keyword(); !key.empty(); key = keyword()) {
      if ((key == "points" || key == "cells" || key == "cell_types") && !seen_.insert(key).second)
        fail("says something twice");
      if (key == "points") {
        points_ = natural();
        once(grid_.points, finite(numbers(3 * points_, type())));
      } else if (key == "cells") {
        version < 5 ? read_cells() : read_labelled_cells();
      } else if (key == "cell_types") {
        once(grid_.types, naturals(natural(), kInt));
      } else {
        read_attribute(key);
      }
    }
    if (grid_.tensors.empty()) fail("PointData has no array '" + tensor_ + "'");
    return std::move(grid_);
  }

 private:
  static constexpr Type kInt{Type::whole, 4};

  [[noreturn]] void fail(const std::string& what) const { throw Malformed(file_, what); }

  /// Others cut what is longer, and end a text at a character of code zero.
  std::string_view plain(std::string_view text, std::size_t longest = 250) const {
    if (text.size() > longest) fail("a word or a line that is too long");
    for (const char c : text)
      if ((static_cast<unsigned char>(c) < 0x20 && !is_space(c)) || c == 0x7f)
        fail("a control character");
    return text;
  }
  std::string_view line_of_text() {
    const std::string_view text = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(text.size() + 1, rest_.size()));
    return text;
  }
  std::string_view line(std::size_t longest = 250) { return plain(line_of_text(), longest); }

  std::string_view word() {
    const auto begin = std::find_if_not(rest_.begin(), rest_.end(), is_space);
    const auto end = std::find_if(begin, rest_.end(), is_space);
    rest_ = {end, rest_.end()};
    return plain({begin, end});
  }
  /// The end of a line on which nothing else is to stand.
  void end_of_line() {
    if (!is_blank(line())) fail("a line with more than belongs there");
  }

  static std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
  }
  std::string keyword() { return lower(word()); }

  /// Names have %XX for white space and the like.
  std::string name() { return decoded(word()); }
  std::string decoded(std::string_view text) const {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
      result += text[i];
      if (text[i] != '%') continue;
      unsigned code = 0;
      const char* const digits = text.data() + i + 1;
      if (i + 2 >= text.size() || std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2)
        fail("a name with '%' that no two hexadecimal digits follow");
      result.back() = static_cast<char>(code), i += 2;
    }
    return std::string(plain(result));
  }

  /// A count. What it counts takes a byte at least, so that products of some do not overflow.
  std::size_t natural() {
    const std::string_view text = word();
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    if (text.empty() || std::from_chars(text.data(), end, value).ptr != end ||
        value > std::min<std::size_t>(bytes_.size(), 0xffffffff))
      fail("a count that is none, or more than the file can hold");
    return value;
  }

  Type type() {
    static const std::map<std::string, Type> types{{"double", {Type::real, 8}},
                                                   {"float", {Type::real, 4}},
                                                   {"char", {Type::whole, 1}},
                                                   {"signed_char", {Type::whole, 1}},
                                                   {"unsigned_char", {Type::natural, 1}},
                                                   {"short", {Type::whole, 2}},
                                                   {"unsigned_short", {Type::natural, 2}},
                                                   {"int", kInt},
                                                   {"unsigned_int", {Type::natural, 4}},
                                                   {"long", {Type::whole, 8}},
                                                   {"unsigned_long", {Type::natural, 8}},
                                                   {"vtktypeint64", {Type::whole, 8}},
                                                   {"vtktypeuint64", {Type::natural, 8}},
                                                   {"vtkidtype", kInt},
                                                   {"bit", {Type::bit, 1}},
                                                   {"string", {Type::text, 1}},
                                                   {"utf8_string", {Type::text, 1}}};
    const auto found = types.find(keyword());
    if (found == types.end()) fail("an array of unknown type");
    return found->second;
  }

  /// The same as the last word of its line. (In a binary file `numbers` looks at that.)
  Type last_type() {
    const Type result = type();
    if (!binary_) end_of_line();
    return result;
  }

  void skip(std::size_t bytes) {
    if (bytes > rest_.size()) fail("data that end too early");
    rest_.remove_prefix(bytes);
  }

  /// Texts are lines; in a binary file the two highest bits of the first byte tell how many bytes
  /// the length takes.
  void skip_texts(std::size_t count) {
    if (!binary_) line();
    for (std::size_t i = 0; i < count; ++i) {
      if (rest_.empty()) fail("data that end too early");
      if (!binary_) {
        line_of_text();
        continue;
      }
      const auto first = static_cast<unsigned char>(rest_.front());
      const std::size_t more = (std::size_t{8} >> (first >> 6)) - 1;
      if (more >= rest_.size()) fail("data that end too early");
      std::uint64_t length = first & 63u;
      for (std::size_t k = 1; k <= more; ++k)
        length = length << 8 | static_cast<unsigned char>(rest_[k]);
      skip(1 + more);
      skip(length);
    }
  }

  /// The numbers that follow: bytes from the next line on, or words. None of what is no number.
  std::vector<double> numbers(std::size_t count, Type type) {
    if (binary_) end_of_line();
    if (type.kind == Type::text) return skip_texts(count), std::vector<double>{};
    if (type.kind == Type::bit && binary_) return skip((count + 7) / 8), std::vector<double>{};
    if (count > rest_.size() / (binary_ ? type.size : 1)) fail("numbers that end too early");
    std::vector<double> result(count);
    for (double& x : result) {
      if (binary_) {
        x = from_bytes(rest_.data(), type);
        rest_.remove_prefix(type.size);
        continue;
      }
      const std::string text(word());
      char* end = nullptr;
      if (type.kind != Type::real && text.find_first_not_of("-0123456789") != text.npos)
        fail("an integer that is none");
      if (text.find_first_of("xXpP") != text.npos) fail("a number that is not decimal");
      x = type.kind == Type::real && type.size == 4
              ? static_cast<double>(std::strtof(text.c_str(), &end))
              : std::strtod(text.c_str(), &end);
      if (text.empty() || *end != '\0')
        fail("text that is no number, or numbers that end too early");
    }
    return result;
  }

  std::vector<double> finite(std::vector<double> values) const {
    for (const double x : values)
      if (!std::isfinite(x)) fail("a number that is not finite");
    return values;
  }

  std::vector<std::uint64_t> naturals(std::size_t count, Type type) {
    std::vector<std::uint64_t> result;
    for (const double x : numbers(count, type)) {
      if (!(x >= 0 && x < 0x1p53) || x != std::floor(x)) fail("no natural number");
      result.push_back(static_cast<std::uint64_t>(x));
    }
    return result;
  }

  template <class Number>
  void once(std::vector<Number>& place, std::vector<Number> values) {
    if (!place.empty()) fail("says something twice");
    place = std::move(values);
  }

  /// Of each cell its number of corners, and these.
  void read_cells() {
    const std::size_t cells = natural();
    const auto entries = naturals(natural(), kInt);
    std::vector<std::uint64_t> connectivity, offsets;
    for (std::size_t at = 0; at < entries.size(); at += 1 + entries[at]) {
      if (entries[at] >= entries.size() - at) fail("cells that do not fit their number");
      const auto corners = entries.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      connectivity.insert(connectivity.end(), corners,
                          corners + static_cast<std::ptrdiff_t>(entries[at]));
      offsets.push_back(connectivity.size());
    }
    if (offsets.size() != cells) fail("not the cells that it declares");
    once(grid_.connectivity, std::move(connectivity));
    once(grid_.offsets, std::move(offsets));
  }

  /// As in XML, but that the offsets have a zero in front.
  void read_labelled_cells() {
    const std::size_t of_offsets = natural(), of_corners = natural();
    if (keyword() != "offsets") fail("cells without OFFSETS");
    auto offsets = naturals(of_offsets, type());
    if (offsets.empty() || offsets.front() != 0) fail("offsets that do not begin with zero");
    offsets.erase(offsets.begin());
    once(grid_.offsets, std::move(offsets));
    if (keyword() != "connectivity") fail("cells without CONNECTIVITY");
    once(grid_.connectivity, naturals(of_corners, type()));
  }

  void read_attribute(const std::string& key) {
    static const std::map<std::string, std::size_t> widths{
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    if (key == "point_data" || key == "cell_data") {
      of_points_ = key == "point_data";
      items_ = natural();
      names_.clear(), last_width_ = 0;
      if (items_ != (of_points_ ? points_ : grid_.types.size()))
        fail("data of other than all points or cells");
      end_of_line();
    } else if (key == "metadata") {
      read_metadata();
    } else if (key == "field") {
      name();
      for (std::size_t left = natural(); left > 0; --left) {
        std::string of_array = name();
        for (; of_array == "METADATA"; of_array = name()) read_metadata();
        const std::size_t components = natural(), items = natural();
        take(of_array, components, numbers(components * items, last_type()));
      }
    } else if (key == "scalars") {
      const std::string of_array = name();
      const Type of_numbers = type();
      const std::string_view rest = line();  // perhaps with the number of components
      const std::size_t components =
          is_blank(rest) ? 1 : static_cast<std::size_t>(std::atoi(rest.data()));
      if (keyword() != "lookup_table" || components > 1000) fail("SCALARS without LOOKUP_TABLE");
      name();
      take(of_array, components, numbers(components * items_, of_numbers));
    } else if (const auto found = widths.find(key); found != widths.end()) {
      const std::string of_array = name();
      take(of_array, found->second, numbers(found->second * items_, last_type()));
    } else {
      fail("has '" + key.substr(0, 40) + "' where a keyword belongs");
    }
  }

  /// About the array that was read last, as VTK writes it: names of its components, all of them, or
  /// other information, and then a line of no character.
  void read_metadata() {
    end_of_line();
    if (last_width_ == 0) fail("METADATA without an array before");
    for (std::string text = lower(line()); !text.empty(); text = lower(line())) {
      if (text == "component_names") {
        for (std::size_t i = 0; i < last_width_; ++i) {
          const std::string_view of_component = line();
          if (is_blank(of_component) || is_space(of_component.back()))
            fail("a component without a name");
          if (took_last_) grid_.names.push_back(decoded(of_component));
        }
        if (took_last_ && grid_.names.size() != last_width_) fail("says something twice");
      } else if (text.starts_with("information ")) {
        std::size_t count = 0;
        const char* const end = text.data() + text.size();
        if (std::from_chars(text.data() + 12, end, count).ptr != end || count > 100)
          fail("METADATA that is not as VTK writes it");
        for (; count > 0; --count)
          if (!line().starts_with("NAME ") || !line().starts_with("DATA "))
            fail("METADATA that is not as VTK writes it");
      } else {
        fail("METADATA that is not as VTK writes it");
      }
    }
  }

  /// Keeps the tensors, once.
  void take(const std::string& name, std::size_t components, std::vector<double> values) {
    if (name == "vtkGhostType" || name == "vtkGhostLevels")
      fail("has marks of ghost cells or points, '" + name +
           "'; leave them out, or make a file without with tensortopo convert");
    if (!names_.insert(name).second) fail("has two arrays '" + name + "'");
    last_width_ = components;
    took_last_ = of_points_ && name == tensor_;
    if (!took_last_) return;
    if (components != width_)
      fail("an array of other than " + std::to_string(width_) + " components");
    once(grid_.tensors, finite(std::move(values)));
  }

  std::string file_, bytes_;
  std::string_view rest_;
  std::string tensor_;
  std::size_t width_, items_ = 0, points_ = 0;
  std::size_t last_width_ = 0;   ///< components of the last array; 0 if there is none
  std::set<std::string> names_;  ///< of the arrays of points, or of cells
  bool binary_ = false, of_points_ = false, took_last_ = false;
  std::set<std::string> seen_;
  Grid grid_;
};

}  // namespace

Grid read_legacy_grid(const std::string& file, const std::string& tensor, std::size_t components) {
  return LegacyReader(file, tensor, components).read();
}

}  // namespace certificate
