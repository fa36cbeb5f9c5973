// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_frd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "bytes/words.hpp"
#include "formats/frd_scanner.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::detail {
namespace {

using NodeIndex = std::unordered_map<std::int64_t, std::size_t>;

/// Element types, from 1: the VTK type and the number of nodes.
struct FrdElement {
  std::uint8_t vtk_type = 0;
  std::size_t nodes = 0;
};
constexpr std::array<FrdElement, 13> element_types{{{},
                                                    {12, 8},
                                                    {13, 6},
                                                    {10, 4},
                                                    {25, 20},
                                                    {26, 15},
                                                    {24, 10},
                                                    {5, 3},
                                                    {22, 6},
                                                    {9, 4},
                                                    {23, 8},
                                                    {3, 2},
                                                    {21, 3}}};

/// Where the nodes of a cell as VTK orders them are in the file: the middles of the upright edges
/// come before those of the upper ones there.
std::size_t place_of_node(std::uint8_t vtk_type, std::size_t i) {
  if (vtk_type == 25 && i >= 12) return i < 16 ? i + 4 : i - 4;
  if (vtk_type == 26 && i >= 9) return i < 12 ? i + 3 : i - 3;
  return i;
}

/// Results at nodes, located but not decoded.
struct FrdResult {
  std::string name;
  std::vector<std::string> components;  ///< those that are stored
  FrdEncoding encoding = FrdEncoding::long_text;
  std::size_t nodes = 0;
  std::string_view values;
};

struct FrdStep {
  std::string key, text;
  std::vector<FrdResult> results;
};

FrdEncoding encoding_of(std::string_view line, std::size_t column) {
  const std::uint64_t digit = count_in(line, column, 2, "format of a block");
  if (digit > 3) throw FormatError(fmt::format("has a block of the unknown format {}", digit));
  return static_cast<FrdEncoding>(digit);
}

std::size_t number_width(FrdEncoding encoding) {
  return encoding == FrdEncoding::short_text ? 5 : 10;
}

std::size_t real_size(FrdEncoding encoding) {
  return encoding == FrdEncoding::floats ? sizeof(float) : sizeof(double);
}

template <class Value>
std::vector<Value> little(std::string_view bytes, ElementType type) {
  return from_bytes<Value>(bytes, type, std::endian::little);
}

/// Calls take(node number, real numbers) for each of `nodes` records.
template <class Take>
void each_record(std::string_view values, FrdEncoding encoding, std::size_t nodes,
                 std::size_t reals, const Take& take) {
  std::vector<double> numbers(reals);
  if (is_text(encoding)) {
    FrdScanner lines(values);
    const std::size_t width = number_width(encoding);
    std::size_t seen = 0;
    for (; !lines.at_end(); ++seen) {
      std::string_view line = lines.line();
      if (!line.starts_with(" -1")) throw FormatError("has a line in a block that begins no record");
      const auto node = static_cast<std::int64_t>(count_in(line, 3, width, "number of a node"));
      for (std::size_t i = 0; i < reals;) {
        std::string_view text = columns(line, 3 + width, line.size());
        for (const std::size_t end = std::min(reals, i + 6); i < end; ++i)
          numbers[i] = take_real(text);
        if (!trimmed(text).empty())
          throw FormatError(fmt::format("has more numbers than belong there (node {})", node));
        if (i == reals) break;
        line = lines.line();
        if (!line.starts_with(" -2"))
          throw FormatError(fmt::format("has too few numbers (node {})", node));
      }
      take(node, numbers);
    }
    if (seen != nodes)
      throw FormatError(fmt::format("holds {} nodes in a block that promises {}", seen, nodes));
    return;
  }
  const std::size_t size = real_size(encoding), stride = sizeof(std::int32_t) + reals * size;
  const ElementType type = encoding == FrdEncoding::floats ? ElementType::f32 : ElementType::f64;
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::string_view record = values.substr(i * stride, stride);
    const auto node = little<std::int64_t>(record.substr(0, 4), ElementType::i32).front();
    take(node, little<double>(record.substr(4), type));
  }
}

class FrdReader {
 public:
  explicit FrdReader(const FieldSource& source) : source_(source), scan_(source.file->bytes) {
    grid_.file = source.file->path;
  }

  std::vector<std::string> steps() {
    locate();
    std::vector<std::string> texts;
    for (const FrdStep& step : steps_) texts.push_back(step.text);
    return texts;
  }

  RawGrid read() {
    locate();
    const FrdStep& step = choose();
    drop_unused_nodes();
    const auto nodes = std::make_shared<const NodeIndex>(std::move(nodes_));
    for (const FrdResult& result : step.results) add(result, nodes);
    return std::move(grid_);
  }

 private:
  /// Reads nodes and elements, and finds the results. A file that is cut off, or damaged, after the
  /// step that is asked for will do.
  void locate() {
    try {
      read_blocks();
      if (nodes_.empty() || grid_.types.empty()) throw FormatError("holds no nodes or no elements");
    } catch (const FormatError& error) {
      if (const auto& step = source_.options.step; step && *step > 0 && *step < steps_.size()) {
        source_.notes.push_back(fmt::format("{} ({}), after the step that is taken", error.what(),
                                            scan_.place()));
        return;
      }
      throw IoError(IoError::Kind::invalid, grid_.file,
                    std::string(error.what()) + " (" + scan_.place() + ")");
    }
  }

  void read_blocks() {
    bool ended = false;
    while (!ended) {
      if (scan_.at_end()) throw FormatError("ends without its last line (9999): the file is cut off, or not complete yet");
      const std::string_view line = scan_.line();
      if (line.starts_with("    2C"))
        read_nodes(line);
      else if (line.starts_with("    3C"))
        read_elements(line);
      else if (line.starts_with("  100C"))
        read_result(line);
      else if (line.starts_with(" 9999"))
        ended = true;
      else if (!line.starts_with("    1"))
        throw FormatError("has a line that is none of a .frd file");
    }
  }

  void read_nodes(std::string_view head) {
    if (!nodes_.empty()) throw FormatError("has two blocks of nodes");
    const std::size_t count = count_in(head, 24, 12, "number of nodes");
    const FrdEncoding encoding = encoding_of(head, 73);
    const std::string_view values =
        is_text(encoding) ? scan_.text_block() : scan_.bytes(count, 4 + 3 * real_size(encoding));
    require_memory(count, 0, 0);
    each_record(values, encoding, count, 3, [&](std::int64_t node, const auto& place) {
      if (!nodes_.try_emplace(node, nodes_.size()).second)
        throw FormatError(fmt::format("has node {} twice", node));
      grid_.coordinates.insert(grid_.coordinates.end(), place.begin(), place.end());
    });
  }

  void read_elements(std::string_view head) {
    if (!grid_.offsets.empty()) throw FormatError("has two blocks of elements");
    const std::size_t count = count_in(head, 24, 12, "number of elements");
    const FrdEncoding encoding = encoding_of(head, 73);
    grid_.offsets.push_back(0);
    if (is_text(encoding)) {
      FrdScanner lines(scan_.text_block());
      while (!lines.at_end()) read_text_element(lines, number_width(encoding));
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        const auto head4 = little<std::int64_t>(scan_.bytes(4, 4), ElementType::i32);
        const FrdElement type = type_of(head4[1]);
        add_element(type, head4[3],
                    little<std::int64_t>(scan_.bytes(type.nodes, 4), ElementType::i32));
      }
    }
    if (grid_.types.size() != count)
      throw FormatError(fmt::format("holds {} elements in a block that promises {}",
                                    grid_.types.size(), count));
  }

  void read_text_element(FrdScanner& lines, std::size_t width) {
    std::string_view line = lines.line();
    if (!line.starts_with(" -1")) throw FormatError("has a line that begins no element");
    const FrdElement type =
        type_of(static_cast<std::int64_t>(count_in(line, 3 + width, 5, "type of an element")));
    const auto material =
        static_cast<std::int64_t>(count_in(line, 13 + width, 5, "material of an element"));
    const std::size_t per_line = width == 5 ? 15 : 10;
    std::vector<std::int64_t> nodes;
    while (nodes.size() < type.nodes) {
      if (!(line = lines.line()).starts_with(" -2"))
        throw FormatError("has an element with too few nodes");
      for (std::size_t i = 0; i < per_line && nodes.size() < type.nodes; ++i)
        nodes.push_back(
            static_cast<std::int64_t>(count_in(line, 3 + i * width, width, "number of a node")));
    }
    add_element(type, material, nodes);
  }

  FrdElement type_of(std::int64_t type) const {
    if (type < 1 || type >= static_cast<std::int64_t>(element_types.size()))
      throw FormatError(fmt::format("has an element of the unknown type {} (cell {})", type,
                                    grid_.types.size()));
    return element_types[static_cast<std::size_t>(type)];
  }

  void add_element(const FrdElement& type, std::int64_t material,
                   const std::vector<std::int64_t>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::int64_t node = nodes[place_of_node(type.vtk_type, i)];
      const auto found = nodes_.find(node);
      if (found == nodes_.end())
        throw FormatError(fmt::format("has an element with node {}, which does not exist (cell {})",
                                      node, grid_.types.size()));
      grid_.connectivity.push_back(static_cast<std::int64_t>(found->second));
    }
    grid_.types.push_back(type.vtk_type);
    grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
    materials_.push_back(static_cast<double>(material));
  }

  void read_result(std::string_view head) {
    FrdResult result;
    result.nodes = count_in(head, 24, 12, "number of nodes");
    result.encoding = encoding_of(head, 73);
    const auto number = trimmed(columns(head, 58, 5)), value = trimmed(columns(head, 12, 12));
    const std::string key = std::string(number) + " " + std::string(value);
    if (steps_.empty() || steps_.back().key != key)
      steps_.push_back({key, fmt::format("number {}, value {}", number, value), {}});

    const std::string_view title = scan_.line();
    if (!title.starts_with(" -4")) throw FormatError("has a result block without a name");
    result.name = trimmed(columns(title, 5, 8));
    const std::size_t listed = count_in(title, 13, 5, "number of components");
    const bool at_nodes = count_in(title, 18, 5, "kind of results") == 1;
    std::size_t lines = 0;
    for (; scan_.peek_line().starts_with(" -5"); ++lines) {
      const std::string_view line = scan_.line();
      // A magnitude is listed, but not stored.
      if (trimmed(columns(line, 33, 5)) != "1")
        result.components.emplace_back(trimmed(columns(line, 5, 8)));
    }
    if (lines != listed)
      throw FormatError(fmt::format("names {} components of {} where {} belong", lines,
                                    result.name.substr(0, 8), listed));
    if (!at_nodes) throw FormatError("has results that are not at nodes");
    if (result.components.empty()) throw FormatError("has a result block without components");
    result.values =
        is_text(result.encoding)
            ? scan_.text_block()
            : scan_.bytes(result.nodes, 4 + result.components.size() * real_size(result.encoding));
    steps_.back().results.push_back(std::move(result));
  }

  static bool has_tensors(const FrdStep& step) {
    return std::any_of(step.results.begin(), step.results.end(),
                       [](const FrdResult& result) { return result.components.size() == 6; });
  }

  const FrdStep& choose() const {
    const auto refuse = [&](const std::string& problem) {
      throw IoError(IoError::Kind::invalid, grid_.file, problem);
    };
    if (steps_.empty()) refuse("holds no results");
    std::vector<std::string> texts;
    for (const FrdStep& step : steps_) texts.push_back(step.text);
    const std::size_t chosen = chosen_step(source_, texts);
    const FrdStep& step = steps_[chosen];
    if (has_tensors(step)) return step;
    std::string has, others;
    for (const FrdResult& result : step.results) has += (has.empty() ? "" : ", ") + result.name;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (has_tensors(steps_[i])) others += (others.empty() ? "" : ", ") + std::to_string(i + 1);
    refuse(fmt::format("step {} ({}) has no results of 6 components, only {}{}", chosen + 1,
                       step.text, has,
                       others.empty() ? "; write stresses (*EL FILE, S)"
                                      : "; --step chooses another, these have: " + others));
    return step;
  }

  void drop_unused_nodes() {
    std::vector<std::size_t> place(nodes_.size(), SIZE_MAX);
    for (const std::int64_t v : grid_.connectivity) place[static_cast<std::size_t>(v)] = 0;
    std::size_t kept = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
      if (place[v] == SIZE_MAX) continue;
      for (std::size_t i = 0; i < 3; ++i)
        grid_.coordinates[3 * kept + i] = grid_.coordinates[3 * v + i];
      place[v] = kept++;
    }
    if (kept < place.size())
      source_.notes.push_back(fmt::format("{} nodes of no element left out", place.size() - kept));
    grid_.coordinates.resize(3 * kept);
    for (std::int64_t& v : grid_.connectivity)
      v = static_cast<std::int64_t>(place[static_cast<std::size_t>(v)]);
    for (auto& [number, v] : nodes_) v = place[v];

    const auto [least, most] = std::minmax_element(materials_.begin(), materials_.end());
    if (*least != *most)
      source_.notes.push_back(
          "elements have several materials, and nodes one tensor each: jumps between materials are "
          "averaged in the file");
    grid_.cell_data.push_back({"material", 1, {}, [values = materials_] { return values; }});
  }

  void add(const FrdResult& result, const std::shared_ptr<const NodeIndex>& nodes) {
    ArraySource array{result.name, result.components.size(), result.components, {}};
    array.values = [file = source_.file, result, nodes, points = grid_.points()] {
      return naming_file(file->path, "results `" + result.name + "`", [&] {
        const std::size_t n = result.components.size();
        std::vector<double> values(points * n, std::numeric_limits<double>::quiet_NaN());
        std::vector<char> has(points, 0);
        each_record(result.values, result.encoding, result.nodes, n,
                    [&](std::int64_t number, const std::vector<double>& numbers) {
                      const auto node = nodes->find(number);
                      if (node == nodes->end())
                        throw FormatError(fmt::format("are at node {}, which does not exist", number));
                      const std::size_t v = node->second;
                      if (v == SIZE_MAX) return;
                      if (std::exchange(has[v], 1) != 0)
                        throw FormatError(fmt::format("are at node {} twice", number));
                      for (std::size_t i = 0; i < n; ++i) values[v * n + i] = numbers[i];
                    });
        std::int64_t without = INT64_MAX;
        for (const auto& [number, v] : *nodes)
          if (v != SIZE_MAX && has[v] == 0) without = std::min(without, number);
        if (without != INT64_MAX)
          throw FormatError(fmt::format("are missing at node {}", without));
        return values;
      });
    };
    grid_.point_data.push_back(std::move(array));
  }

  const FieldSource& source_;
  FrdScanner scan_;
  RawGrid grid_;
  NodeIndex nodes_;
  std::vector<double> materials_;
  std::vector<FrdStep> steps_;
};

}  // namespace

std::vector<std::string> frd_steps(const std::shared_ptr<const InputFile>& file) {
  const ReadOptions options;
  Sha256 sum;
  std::vector<std::string> notes;
  return FrdReader(FieldSource{file, options, sum, notes}).steps();
}

std::vector<RawGrid> read_frd(const FieldSource& source) {
  std::vector<RawGrid> grids;
  grids.push_back(FrdReader(source).read());
  return grids;
}

}  // namespace tensortopo::detail
