// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/vtk_legacy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "certificate_check/check_certificate.hpp"
#include "files/document.hpp"
#include "files/legacy_lines.hpp"
#include "files/word_number.hpp"

namespace certificate {
namespace {

constexpr LegacyType kInt{LegacyType::whole, 4}, kByte{LegacyType::natural, 1},
    kFloat{LegacyType::real, 4};

/// "5.1" and the like: the major version.
std::optional<int> version_of(std::string_view text) {
  if (text.size() != 3 || text[1] != '.' || text[0] < '1' || text[0] > '5' || text[2] < '0' ||
      text[2] > '9')
    return std::nullopt;
  return text[0] - '0';
}

class LegacyReader {
 public:
  LegacyReader(const File& file, const std::string& tensor, std::size_t components)
      : lines_(file.name, file.bytes), tensor_(tensor), width_(components) {}

  Grid read() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    const std::string_view first = lines_.line();
    if (!first.starts_with(kMagic)) lines_.fail("no legacy VTK file");
    const auto version = version_of(first.substr(kMagic.size()));
    if (!version) lines_.fail("a version that is none from 1.0 to 5.9");
    lines_.line();  // a title
    const std::string mode = lower_case(lines_.words(1)[0]);
    if (mode != "ascii" && mode != "binary") lines_.fail("neither ASCII nor BINARY");
    lines_.set_binary(mode == "binary");
    const Words kind = lines_.words(2);
    if (lower_case(kind[0]) != "dataset" || lower_case(kind[1]) != "unstructured_grid")
      lines_.fail("no unstructured grid; tensortopo convert makes one");
    for (Words words = lines_.words(); !words.empty(); words = lines_.words())
      read_section(words, *version);
    if (grid_.tensors.empty()) lines_.fail("PointData has no array '" + tensor_ + "'");
    return std::move(grid_);
  }

 private:
  using Words = LegacyLines::Words;

  void read_section(const Words& words, int version) {
    const std::string key = lower_case(words[0]);
    const bool of_data = key == "point_data" || key == "cell_data";
    const bool of_grid = key == "points" || key == "cells" || key == "cell_types";
    if ((of_grid || of_data) && !seen_.insert(key).second) lines_.fail("says something twice");
    if (of_grid && place_ != Place::grid) lines_.fail("has a grid behind its data");
    if (key != "metadata") last_width_ = 0;
    if (key == "points") {
      require(words, 3);
      points_ = lines_.natural(words[1]);
      grid_.points = finite(lines_.numbers(3 * points_, number_type(words[2])));
      last_width_ = 3, took_last_ = false;
    } else if (key == "cells") {
      require(words, 3);
      version < 5 ? read_cells(words) : read_labelled_cells(words);
    } else if (key == "cell_types") {
      require(words, 2);
      grid_.types = naturals(lines_.natural(words[1]), kInt);
      constexpr std::uint64_t kPolyhedron = 42;  // of faces, which are not looked at
      if (std::find(grid_.types.begin(), grid_.types.end(), kPolyhedron) != grid_.types.end())
        lines_.fail("has polyhedra; tensortopo convert makes a file without");
    } else if (of_data) {
      require(words, 2);
      place_ = key == "point_data" ? Place::points : Place::cells;
      items_ = lines_.natural(words[1]);
      names_.clear(), groups_.clear();
      if (items_ != (place_ == Place::points ? points_ : grid_.types.size()))
        lines_.fail("data of other than all points or cells");
    } else if (key == "field") {
      require(words, 3);
      read_arrays(lines_.natural(words[2]));
    } else if (key == "metadata") {
      require(words, 1);
      read_metadata();
    } else {
      if (place_ == Place::grid)
        lines_.fail("has '" + key.substr(0, 40) + "' where a part of the grid belongs");
      read_attribute(key, words);
    }
  }

  void require(const Words& words, std::size_t count) const {
    if (words.size() != count)
      lines_.fail("a line of other than " + std::to_string(count) + " words");
  }

  std::vector<double> finite(std::vector<double> values) const {
    for (const double x : values)
      if (!std::isfinite(x)) lines_.fail("a number that is not finite");
    return values;
  }

  std::vector<std::uint64_t> naturals(std::size_t count, LegacyType type) {
    std::vector<std::uint64_t> result;
    for (const double x : lines_.numbers(count, type)) {
      if (!(x >= 0 && x < 0x1p53) || x != std::floor(x)) lines_.fail("no natural number");
      result.push_back(static_cast<std::uint64_t>(x));
    }
    return result;
  }

  /// Of each cell its number of corners, and these.
  void read_cells(const Words& words) {
    const auto entries = naturals(lines_.natural(words[2]), kInt);
    for (std::size_t at = 0; at < entries.size(); at += 1 + entries[at]) {
      if (entries[at] >= entries.size() - at) lines_.fail("cells that do not fit their number");
      const auto corners = entries.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      grid_.connectivity.insert(grid_.connectivity.end(), corners,
                                corners + static_cast<std::ptrdiff_t>(entries[at]));
      grid_.offsets.push_back(grid_.connectivity.size());
    }
    if (grid_.offsets.size() != lines_.natural(words[1]))
      lines_.fail("not the cells that it declares");
  }

  /// As in XML, but that the offsets have a zero in front.
  void read_labelled_cells(const Words& words) {
    std::string type;  // other readers give up if the two differ
    grid_.offsets = labelled("offsets", lines_.natural(words[1]), type);
    if (grid_.offsets.empty() || grid_.offsets.front() != 0)
      lines_.fail("offsets that do not begin with zero");
    grid_.offsets.erase(grid_.offsets.begin());
    grid_.connectivity = labelled("connectivity", lines_.natural(words[2]), type);
  }
  /// @param type  of the numbers; empty: any
  std::vector<std::uint64_t> labelled(std::string_view label, std::size_t count,
                                      std::string& type) {
    const Words words = lines_.words(2);
    const std::string own = lower_case(words[1]);
    if (lower_case(words[0]) != label || (own != "int" && own != "vtktypeint64" && own != "vtkidtype"))
      lines_.fail("cells without " + std::string(label) + " of integers");
    if (type.empty()) type = own;
    if ((type == "int") != (own == "int")) lines_.fail("offsets and connectivity of different types");
    return naturals(count, lines_.type(own));
  }

  /// Of kinds and shapes for which other readers do not give up: then they go on elsewhere.
  void read_attribute(const std::string& key, const Words& words) {
    static const std::map<std::string, std::size_t> widths{
        {"vectors", 3}, {"normals", 3}, {"tensors", 9}, {"tensors6", 6}, {"global_ids", 1}};
    const std::string group = key == "color_scalars" ? "scalars" : key == "tensors6" ? "tensors" : key;
    if (!groups_.insert(group).second && words.size() > 1 && lines_.name(words[1]) == tensor_)
      lines_.fail("the array '" + tensor_ + "' is not the first of " + key +
                  ", so that others leave it out; tensortopo convert makes a file without that");
    if (const auto found = widths.find(key); found != widths.end()) {
      require(words, 3);
      read_array(words[1], found->second, items_, number_type(words[2]));
    } else if (key == "texture_coordinates") {
      require(words, 4);
      const std::size_t dimension = lines_.natural(words[2]);
      if (dimension < 1 || dimension > 3) lines_.fail("TEXTURE_COORDINATES of other than 1 to 3 numbers");
      read_array(words[1], dimension, items_, number_type(words[3]));
    } else if (key == "scalars") {
      if (words.size() != 3) require(words, 4);
      const std::size_t components = words.size() == 3 ? 1 : lines_.natural(words[3]);
      const Words table = lines_.words(2);
      if (lower_case(table[0]) != "lookup_table" || components == 0)
        lines_.fail("SCALARS without components or LOOKUP_TABLE");
      read_array(words[1], components, items_, number_type(words[2]));
    } else if (key == "color_scalars") {
      require(words, 3);
      if (lines_.name(words[1]) == tensor_)
        lines_.fail("the array '" + tensor_ + "' as COLOR_SCALARS, which are changed when they are read");
      read_array(words[1], lines_.natural(words[2]), items_, lines_.is_binary() ? kByte : kFloat);
      last_width_ = 0;
    } else if (key == "lookup_table") {
      require(words, 3);
      lines_.numbers(4 * lines_.natural(words[2]), lines_.is_binary() ? kByte : kFloat);
    } else {
      lines_.fail("has '" + key.substr(0, 40) + "', which is not known here; tensortopo convert makes a file without");
    }
  }

  void read_arrays(std::size_t count) {
    while (count > 0) {
      const Words words = lines_.words();
      if (words.size() == 1 && lower_case(words[0]) == "metadata") {
        read_metadata();
        continue;
      }
      --count;
      last_width_ = 0;
      if (words.size() == 1 && words[0] == "NULL_ARRAY") continue;
      require(words, 4);
      // After an array other readers look for these letters alone.
      if (words[0] == "NULL_ARRAY" || lower_case(words[0]).starts_with("metadata"))
        lines_.fail("an array with the name of a keyword");
      const std::size_t items = lines_.natural(words[2]);
      if (place_ != Place::grid && items != items_)
        lines_.fail("an array of other than all points or cells");
      read_array(words[0], lines_.natural(words[1]), items, lines_.type(words[3]));
    }
  }

  /// Texts are of fields only.
  LegacyType number_type(std::string_view word) const {
    const LegacyType type = lines_.type(word);
    if (type.kind == LegacyType::text) lines_.fail("an attribute of texts");
    return type;
  }

  /// All arrays come through here. Keeps the tensors, once.
  void read_array(std::string_view word, std::size_t components, std::size_t items,
                  LegacyType stored) {
    const std::string name = lines_.name(word);
    std::vector<double> values;
    if (stored.kind == LegacyType::text)
      lines_.skip_texts(components * items);
    else
      values = lines_.numbers(components * items, stored);
    if (marks_ghosts(name)) lines_.fail(ghosts_refused(name));
    if (!names_.insert(name).second) lines_.fail("has two arrays '" + name + "'");
    if (name == tensor_ && place_ != Place::points)
      lines_.fail("has an array '" + name + "' not of points, too; tensortopo convert makes a file without");
    last_width_ = components;
    took_last_ = place_ == Place::points && name == tensor_;
    if (!took_last_) return;
    if (components != width_ || stored.kind == LegacyType::text)
      lines_.fail("an array of other than " + std::to_string(width_) + " numbers each");
    grid_.tensors = finite(std::move(values));
  }

  /// About the array just read: names of its components, all of them, or other information, and
  /// then a line of no character.
  void read_metadata() {
    if (last_width_ == 0) lines_.fail("METADATA without an array before");
    for (std::string text = lower_case(lines_.line()); !text.empty();
         text = lower_case(lines_.line())) {
      if (text == "component_names") {
        read_names();
      } else if (text.starts_with("information ")) {
        for (std::size_t left = lines_.natural(std::string_view(text).substr(12)); left > 0; --left)
          read_information();
      } else {
        lines_.fail("METADATA that is not as VTK writes it");
      }
    }
    last_width_ = 0;
  }

  void read_names() {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < last_width_; ++i) {
      const std::string_view text = lines_.line();
      if (text.find_first_not_of(' ') == text.npos || text.ends_with(' '))
        lines_.fail("a component without a name");
      names.push_back(lines_.name(text));
    }
    if (!took_last_) return;
    if (!grid_.names.empty()) lines_.fail("says something twice");
    grid_.names = std::move(names);
  }

  /// A range, or a unit.
  void read_information() {
    const std::string_view key = lines_.line();
    if (key == "NAME UNITS_LABEL LOCATION vtkDataArray") {
      if (const Words words = lines_.words_in(lines_.line()); words.size() == 2 && words[0] == "DATA")
        return;
    } else if (key == "NAME L2_NORM_RANGE LOCATION vtkDataArray" ||
               key == "NAME L2_NORM_FINITE_RANGE LOCATION vtkDataArray") {
      const Words words = lines_.words_in(lines_.line());
      if (words.size() == 4 && words[0] == "DATA" && words[1] == "2" && number_of_word<double>(words[2]) &&
          number_of_word<double>(words[3]))
        return;
    }
    lines_.fail("METADATA that is not as VTK writes it");
  }

  enum class Place { grid, points, cells };

  LegacyLines lines_;
  std::string tensor_;
  std::size_t width_, items_ = 0, points_ = 0;
  Place place_ = Place::grid;
  std::size_t last_width_ = 0;   ///< components of the last array; 0 if METADATA cannot follow
  bool took_last_ = false;
  std::set<std::string> names_;   ///< of the arrays of points, or of cells
  std::set<std::string> groups_;  ///< of their attributes
  std::set<std::string> seen_;   ///< what is there once
  Grid grid_;
};

}  // namespace

Grid read_legacy_grid(const File& file, const std::string& tensor, std::size_t components) {
  return LegacyReader(file, tensor, components).read();
}

}  // namespace certificate
