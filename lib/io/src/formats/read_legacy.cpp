// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_legacy.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>
#include <utility>

#include "bytes/format_error.hpp"
#include "vtk/legacy_scanner.hpp"
#include "bytes/words.hpp"

namespace tensortopo::detail {
namespace {

/// Names are stored with %XX for white space and the like.
std::string decoded_name(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned char code = 0;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr ==
            name.data() + i + 3) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += name[i];
    }
  }
  return text;
}

bool is_lower_equal(std::string_view text, std::string_view lower) {
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

class LegacyReader {
 public:
  explicit LegacyReader(std::shared_ptr<const InputFile> file)
      : file_(std::move(file)), scan_(file_->bytes) {
    grid_.file = file_->path;
  }

  RawGrid read() {
    try {
      read_header();
      read_sections();
      if (grid_.lattice) {
        if (!have_origin_ || !have_spacing_)
          throw FormatError("holds no complete image: DIMENSIONS, ORIGIN and SPACING are needed");
        check_lattice(*grid_.lattice);
      } else {
        if (!have_points_ || !have_types_ || grid_.offsets.empty())
          throw FormatError("holds no complete grid: POINTS, CELLS and CELL_TYPES are needed");
        check_cells(grid_);
      }
    } catch (const FormatError& error) {
      throw IoError(IoError::Kind::invalid, file_->path,
                    std::string(error.what()) + " (" + scan_.place() + ")");
    }
    return std::move(grid_);
  }

  /// Whether the file's text ends with a digit, which others may have followed.
  bool ends_with_a_number() const {
    const char last = file_->bytes.empty() ? ' ' : file_->bytes.back();
    return !scan_.is_binary() && ((last >= '0' && last <= '9') || last == '.');
  }

 private:
  void read_header() {
    const std::string_view first = scan_.line();
    constexpr std::string_view magic = "# vtk DataFile Version ";
    if (!is_lower_equal(first.substr(0, magic.size()), "# vtk datafile version "))
      throw FormatError("is not a legacy VTK file: it does not begin with \"" + std::string(magic) +
                        "\"");
    const std::string_view version = trimmed(first.substr(magic.size()));
    std::from_chars(version.data(), version.data() + version.size(), major_);
    scan_.line();  // title
    const std::string_view mode = trimmed(scan_.line());
    if (is_lower_equal(mode, "binary"))
      scan_.set_binary(true);
    else if (!is_lower_equal(mode, "ascii"))
      throw FormatError("says neither ASCII nor BINARY in its third line");
    if (scan_.peek_keyword() != "dataset") throw FormatError("has no DATASET");
    scan_.word();
    const std::string_view kind = scan_.word();
    if (is_lower_equal(kind, "structured_points"))
      read_dimensions();
    else if (!is_lower_equal(kind, "unstructured_grid"))
      throw FormatError("holds \"" + std::string(kind.substr(0, 40)) +
                        "\", neither UNSTRUCTURED_GRID nor STRUCTURED_POINTS; ParaView's filter "
                        "Tetrahedralize makes an UNSTRUCTURED_GRID of volumes");
  }

  /// DIMENSIONS, which says what there is room for, comes before all data.
  void read_dimensions() {
    if (scan_.peek_keyword() != "dimensions") throw FormatError("has no DIMENSIONS");
    scan_.word();
    Lattice lattice;
    for (std::size_t& n : lattice.size) n = scan_.count("samples");
    for (std::size_t a = 0; a < 3; ++a) lattice.to_space[a][a] = 1;
    check_lattice(lattice);
    grid_.lattice = std::move(lattice);
  }

  /// Three numbers of ORIGIN or SPACING, which are text in binary files too.
  void read_placement(bool is_spacing) {
    bool& seen = is_spacing ? have_spacing_ : have_origin_;
    once(seen, is_spacing ? "SPACING" : "ORIGIN");
    seen = true;
    for (std::size_t a = 0; a < 3; ++a)
      grid_.lattice->to_space[a][is_spacing ? a : 3] =
          from_text<double>(scan_.word(), ElementType::f64);
  }

  void read_sections() {
    for (std::string key = scan_.peek_keyword(); !key.empty(); key = scan_.peek_keyword()) {
      scan_.word();
      if (grid_.lattice && (key == "spacing" || key == "aspect_ratio" || key == "origin"))
        read_placement(key != "origin");
      else if (!grid_.lattice && key == "points")
        read_points();
      else if (!grid_.lattice && key == "cells")
        read_cells();
      else if (!grid_.lattice && key == "cell_types")
        read_types();
      else if (key == "point_data")
        enter(grid_.point_data, grid_.points(), have_points_ || grid_.lattice, "POINT_DATA");
      else if (key == "cell_data")
        enter(grid_.cell_data, cells(), !grid_.offsets.empty() || grid_.lattice, "CELL_DATA");
      else if (key == "field")
        read_field();
      else if (key == "metadata")
        read_metadata();
      else if (data_ == nullptr || !read_attribute(key))
        throw FormatError("has the unknown keyword \"" + key + "\"");
    }
  }

  std::size_t cells() const {
    if (grid_.lattice) return grid_.lattice->cubes();
    return grid_.offsets.empty() ? 0 : grid_.offsets.size() - 1;
  }

  void once(bool seen, const char* what) const {
    if (seen) throw FormatError(std::string("has ") + what + " twice");
  }

  void read_points() {
    once(have_points_, "POINTS");
    const std::size_t count = scan_.count("points");
    const ElementType type = scan_.type();
    require_memory(count, 0, 0);
    grid_.coordinates = scan_.numbers(3 * std::uint64_t{count}, type).decode<double>();
    have_points_ = true;
  }

  void read_cells() {
    once(!grid_.offsets.empty(), "CELLS");
    const std::size_t first = scan_.count("cells"), second = scan_.count("cell entries");
    if (major_ >= 5) {
      grid_.offsets = labelled("offsets", first);
      grid_.connectivity = labelled("connectivity", second);
      if (grid_.offsets.empty()) grid_.offsets.assign(1, 0);
      return;
    }
    const auto entries = scan_.numbers(second, ElementType::i32).decode<std::int64_t>();
    if (first > entries.size()) throw FormatError("promises more cells than cell entries");
    grid_.offsets.reserve(first + 1);
    grid_.offsets.push_back(0);
    grid_.connectivity.reserve(entries.size() - first);
    std::size_t at = 0;
    for (std::size_t cell = 0; cell < first; ++cell) {
      const std::int64_t corners = at < entries.size() ? entries[at] : -1;
      if (corners < 0 || static_cast<std::size_t>(corners) > entries.size() - at - 1)
        throw FormatError("cell entries do not fit their number (cell " + std::to_string(cell) +
                          ")");
      for (std::int64_t i = 0; i < corners; ++i) grid_.connectivity.push_back(entries[++at]);
      ++at;
      grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
    }
    if (at != entries.size()) throw FormatError("has more cell entries than its cells use");
  }

  std::vector<std::int64_t> labelled(const std::string& label, std::size_t count) {
    if (scan_.peek_keyword() != label) throw FormatError("has no " + label + " after CELLS");
    scan_.word();
    const ElementType type = scan_.type();
    return scan_.numbers(count, type).decode<std::int64_t>();
  }

  void read_types() {
    once(have_types_, "CELL_TYPES");
    const std::size_t count = scan_.count("cell types");
    const auto types = scan_.numbers(count, ElementType::i32).decode<std::int64_t>();
    for (const std::int64_t type : types) {
      if (type < 0 || type > 255)
        throw FormatError("has the unknown cell type " + std::to_string(type));
      grid_.types.push_back(static_cast<std::uint8_t>(type));
    }
    have_types_ = true;
  }

  void enter(std::vector<ArraySource>& data, std::size_t size, bool ready, const char* what) {
    if (!ready) throw FormatError(std::string("has ") + what + " before what it belongs to");
    const std::size_t count = scan_.count("entries");
    if (count != size)
      throw FormatError(std::string(what) + " has " + std::to_string(count) + " entries where " +
                        std::to_string(size) + " belong");
    data_ = &data, tuples_ = size;
  }

  /// A number of components that can be multiplied without overflow.
  std::size_t components() {
    const std::size_t count = scan_.count("components");
    if (count > 1000000)
      throw FormatError("has an array of " + std::to_string(count) + " components");
    return count;
  }

  void keep(std::string name, std::size_t components, const LegacyNumbers& numbers) {
    if (data_ == nullptr) return;
    ArraySource source{std::move(name), components, {}, {}};
    source.values = [file = file_, numbers, name = source.name] {
      return naming_file(file->path, "array `" + name + "`",
                         [&] { return numbers.decode<double>(); });
    };
    data_->push_back(std::move(source));
  }

  /// The array at hand, of a type that may be no number. Returns whether it was kept.
  bool read_array(std::string name, std::size_t components, std::uint64_t tuples, bool wanted) {
    const std::uint64_t count = tuples * components;
    const std::string type = scan_.peek_keyword();
    if (type == "bit" || type == "string" || type == "utf8_string") {
      scan_.word();
      type == "bit" ? scan_.skip_bits(count) : scan_.skip_strings(count);
      return false;
    }
    const ElementType element = scan_.type();
    const LegacyNumbers numbers = scan_.numbers(count, element);
    if (wanted) keep(std::move(name), components, numbers);
    return wanted;
  }

  void read_field() {
    scan_.word();  // name of the field
    const std::size_t arrays = scan_.count("arrays");
    for (std::size_t i = 0; i < arrays; ++i) {
      while (scan_.peek_keyword() == "metadata") scan_.word(), read_metadata();
      std::string name = decoded_name(scan_.word());
      if (name.empty()) throw FormatError("ends before array " + std::to_string(i) + " of a field");
      const std::size_t n = components();
      const std::uint64_t tuples = scan_.count("tuples");
      if (tuples > file_->bytes.size() * 8) throw FormatError("promises too many tuples");
      if (data_ != nullptr && tuples != tuples_)
        throw FormatError("the array `" + name + "` has " + std::to_string(tuples) +
                          " tuples where " + std::to_string(tuples_) + " belong");
      last_kept_ = read_array(std::move(name), n, tuples, data_ != nullptr);
    }
  }

  bool read_attribute(const std::string& key) {
    if (key == "lookup_table") {
      scan_.word();
      const std::uint64_t size = scan_.count("colors");
      if (size > file_->bytes.size()) throw FormatError("promises too many colors");
      scan_.numbers(4 * size, scan_.is_binary() ? ElementType::u8 : ElementType::f32);
      return true;
    }
    std::string name = decoded_name(scan_.word());
    if (key == "color_scalars") {
      const std::size_t n = components();
      scan_.numbers(n * tuples_, scan_.is_binary() ? ElementType::u8 : ElementType::f32);
    } else if (key == "scalars") {
      read_scalars(std::move(name));
    } else if (key == "texture_coordinates") {
      const std::size_t n = components();
      last_kept_ = read_array(std::move(name), n, tuples_, true);
    } else if (key == "vectors" || key == "normals") {
      last_kept_ = read_array(std::move(name), 3, tuples_, true);
    } else if (key == "tensors" || key == "tensors6") {
      last_kept_ = read_array(std::move(name), key == "tensors" ? 9 : 6, tuples_, true);
    } else if (key == "global_ids" || key == "pedigree_ids" || key == "edge_flags") {
      last_kept_ = read_array(std::move(name), 1, tuples_, true);
    } else {
      return false;
    }
    return true;
  }

  /// SCALARS name type [components], then LOOKUP_TABLE name, then the numbers.
  void read_scalars(std::string name) {
    const bool bits = scan_.peek_keyword() == "bit";
    ElementType type = ElementType::u8;
    if (bits)
      scan_.word();
    else
      type = scan_.type();
    std::size_t n = 1;
    if (scan_.peek_keyword() != "lookup_table") n = components();
    if (scan_.peek_keyword() != "lookup_table")
      throw FormatError("has SCALARS without LOOKUP_TABLE");
    scan_.word(), scan_.word();
    if (bits)
      scan_.skip_bits(n * std::uint64_t{tuples_});
    else
      keep(std::move(name), n, scan_.numbers(n * std::uint64_t{tuples_}, type));
    last_kept_ = !bits;
  }

  /// Lines up to an empty one; COMPONENT_NAMES are those of the array before.
  void read_metadata() {
    scan_.line();
    for (std::string_view text = trimmed(scan_.line()); !text.empty();
         text = trimmed(scan_.line())) {
      if (text != "COMPONENT_NAMES" || !last_kept_ || data_ == nullptr || data_->empty()) continue;
      ArraySource& source = data_->back();
      source.component_names.clear();
      for (std::size_t i = 0; i < source.components && i < most_named_components; ++i)
        source.component_names.push_back(decoded_name(trimmed(scan_.line())));
    }
    last_kept_ = false;
  }

  std::shared_ptr<const InputFile> file_;
  LegacyScanner scan_;
  RawGrid grid_;
  int major_ = 0;
  bool have_points_ = false, have_types_ = false, have_origin_ = false, have_spacing_ = false;
  std::vector<ArraySource>* data_ = nullptr;  // where arrays go now; none before POINT_DATA
  std::size_t tuples_ = 0;
  bool last_kept_ = false;  // the last array read is data_->back()
};

}  // namespace

RawGrid read_legacy(const FieldSource& source) {
  LegacyReader reader(source.file);
  RawGrid grid = reader.read();
  if (reader.ends_with_a_number())
    source.notes.emplace_back(
        "ends without an end of line: if the file was cut off, its last number is not whole");
  return grid;
}

}  // namespace tensortopo::detail
