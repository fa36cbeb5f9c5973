// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_exodus.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "bytes/format_error.hpp"
#include "formats/netcdf_file.hpp"
#include "grids/joined_scalars.hpp"

namespace tensortopo::detail {
namespace {

using File = std::shared_ptr<const InputFile>;

struct ExodusElement {
  std::string_view name;  ///< begins so
  std::size_t nodes;
  std::uint8_t vtk_type;
};
constexpr std::array<ExodusElement, 9> solid_elements{{{"TET", 4, 10},
                                                       {"TET", 10, 24},
                                                       {"HEX", 8, 12},
                                                       {"HEX", 20, 25},
                                                       {"HEX", 27, 29},
                                                       {"WED", 6, 13},
                                                       {"WED", 15, 26},
                                                       {"PYR", 5, 14},
                                                       {"PYR", 13, 27}}};
constexpr std::array<std::string_view, 10> flat_elements{"SPH", "CIR", "BAR", "BEA", "TRU",
                                                         "EDG", "TRI", "QUA", "SHE", "NUL"};

/// VTK's type; a polygon for all elements of lower dimension, which are skipped.
std::uint8_t type_of(std::string name, std::size_t nodes, std::size_t block) {
  name = name.substr(0, name.find('\0'));
  for (char& c : name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  for (const ExodusElement& known : solid_elements)
    if (name.starts_with(known.name) && nodes == known.nodes) return known.vtk_type;
  constexpr std::uint8_t polygon = 7;
  for (const std::string_view known : flat_elements)
    if (name.starts_with(known)) return polygon;
  throw FormatError(fmt::format("has elements {} of {} nodes, which are not supported (block {})",
                                name.substr(0, 32), nodes, block));
}

/// Where the nodes of a cell as VTK orders them are in the file: middles of upright edges before
/// those of the upper ones, the centre before those of faces, which begin with z.
std::size_t place_in_element(std::uint8_t vtk_type, std::size_t i) {
  constexpr std::array<std::size_t, 7> of_faces{23, 24, 25, 26, 21, 22, 20};
  if ((vtk_type == 25 || vtk_type == 29) && i >= 12 && i < 20) return i < 16 ? i + 4 : i - 4;
  if (vtk_type == 26 && i >= 9) return i < 12 ? i + 3 : i - 3;
  if (vtk_type == 29 && i >= 20) return of_faces[i - 20];
  return i;
}

/// Joins scalars that VTK's writer has made of an array of six components: it names them XX, XY,
/// XZ, YY, YZ, ZZ, whatever they are, so that the array has no known order.
void join_six_of_vtk(std::vector<ArraySource>& arrays) {
  constexpr std::array<std::string_view, 6> ends{"XX", "XY", "XZ", "YY", "YZ", "ZZ"};
  std::vector<ArraySource> kept;
  for (std::size_t i = 0; i < arrays.size();) {
    const std::string& first = arrays[i].name;
    const std::string prefix =
        first.substr(0, first.size() - std::min<std::size_t>(2, first.size()));
    std::size_t n = 0;
    while (n < 6 && i + n < arrays.size() && arrays[i + n].name == prefix + std::string(ends[n]))
      ++n;
    if (n == 6) {
      kept.push_back(joined(prefix, {arrays.data() + i, n}));
      kept.back().has_no_usual_order = true;
    } else {
      n = 1;
      kept.push_back(arrays[i]);
    }
    i += n;
  }
  arrays = std::move(kept);
}

class ExodusReader {
 public:
  ExodusReader(const FieldSource& source, std::shared_ptr<const NetcdfFile> data)
      : source_(source), data_(std::move(data)) {
    grid_.file = source.file->path;
  }

  RawGrid read(std::size_t step, bool has_steps) {
    nodes_ = data_->dimension("num_nodes");
    if (data_->dimension("num_dim") != 3) throw FormatError("is no mesh in space (num_dim)");
    if (nodes_ == 0) throw FormatError("has no nodes");
    require_memory(nodes_, 0, 0);
    read_coordinates();
    grid_.offsets.push_back(0);
    const std::size_t blocks = data_->dimension("num_el_blk");
    if (blocks > source_.file->bytes.size()) throw FormatError("promises too many blocks");
    for (std::size_t b = 1; b <= blocks; ++b) read_block(b);
    check_cells(grid_);
    if (has_steps) {
      list_at_nodes(step);
      list_of_elements(step);
    }
    for (auto* arrays : {&grid_.point_data, &grid_.cell_data}) {
      if (data_->text("title").starts_with("Created by vtkExodusIIWriter"))
        join_six_of_vtk(*arrays);
      add_joined_scalars(*arrays);
    }
    grid_.cell_data.push_back({"ObjectId", 1, {}, [ids = ids_] { return ids; }});
    return std::move(grid_);
  }

 private:
  struct Block {
    std::size_t number = 0, elements = 0;
  };

  void read_coordinates() {
    std::array<std::vector<double>, 3> axes;
    if (data_->find("coord") != nullptr) {
      const auto all = data_->values<double>(data_->variable("coord", {3, nodes_}));
      for (std::size_t a = 0; a < 3; ++a)
        axes[a].assign(all.begin() + static_cast<std::ptrdiff_t>(a * nodes_),
                       all.begin() + static_cast<std::ptrdiff_t>((a + 1) * nodes_));
    } else {
      for (std::size_t a = 0; a < 3; ++a)
        axes[a] =
            data_->values<double>(data_->variable(std::string("coord") + "xyz" [a], { nodes_ }));
    }
    for (std::size_t v = 0; v < nodes_; ++v)
      for (const auto& axis : axes) grid_.coordinates.push_back(axis[v]);
  }

  void read_block(std::size_t b) {
    const auto* const connect = data_->find("connect" + std::to_string(b));
    if (connect == nullptr) return;  // empty
    if (connect->sizes.size() != 2 || connect->has_records)
      throw FormatError("has elements without nodes (block " + std::to_string(b) + ")");
    const std::size_t count = connect->sizes[0], nodes = connect->sizes[1];
    const auto name = connect->texts.find("elem_type");
    if (name == connect->texts.end())
      throw FormatError("does not say the type of elements (block " + std::to_string(b) + ")");
    const std::uint8_t type = type_of(name->second, nodes, b);
    const auto corners = data_->values<std::int64_t>(*connect);
    for (std::size_t e = 0; e < count; ++e) {
      for (std::size_t i = 0; i < nodes; ++i) {
        const std::int64_t node = corners[e * nodes + place_in_element(type, i)];
        if (node == INT64_MIN) throw FormatError("has an element with an impossible node");
        grid_.connectivity.push_back(node - 1);
      }
      grid_.types.push_back(type);
      grid_.offsets.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
    }
    blocks_.push_back({b, count});
    double id = static_cast<double>(b);
    if (const auto* const numbers = data_->find("eb_prop1");
        numbers != nullptr && numbers->sizes.size() == 1 && numbers->sizes[0] >= b)
      id = data_->values<double>(*numbers)[b - 1];
    ids_.insert(ids_.end(), count, id);
  }

  /// Names of variables; none if there are no variables.
  std::vector<std::string> names(const char* variable) const {
    const auto* const found = data_->find(variable);
    return found == nullptr ? std::vector<std::string>{} : data_->rows(*found);
  }

  void list_at_nodes(std::size_t step) {
    const std::vector<std::string> all = names("name_nod_var");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string variable = "vals_nod_var" + std::to_string(i + 1);
      grid_.point_data.push_back(
          {all[i], 1, {}, [file = source_.file, data = data_, variable, step, nodes = nodes_] {
             return naming_file(file->path, "", [&] {
               return data->values<double>(data->variable(variable, {nodes}), step);
             });
           }});
    }
  }

  void list_of_elements(std::size_t step) {
    const std::vector<std::string> all = names("name_elem_var");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string variable = "vals_elem_var" + std::to_string(i + 1) + "eb";
      grid_.cell_data.push_back(
          {all[i], 1, {}, [file = source_.file, data = data_, variable, step, blocks = blocks_] {
             return naming_file(file->path, "", [&] {
               std::vector<double> values;
               for (const Block& block : blocks) {
                 const std::string name = variable + std::to_string(block.number);
                 const std::size_t end = values.size() + block.elements;
                 if (data->find(name) != nullptr)
                   for (const double x :
                        data->values<double>(data->variable(name, {block.elements}), step))
                     values.push_back(x);
                 values.resize(end, std::numeric_limits<double>::quiet_NaN());
               }
               return values;
             });
           }});
    }
  }

  const FieldSource& source_;
  std::shared_ptr<const NetcdfFile> data_;
  RawGrid grid_;
  std::size_t nodes_ = 0;
  std::vector<Block> blocks_;
  std::vector<double> ids_;
};

std::vector<std::string> steps_of(const NetcdfFile& data) {
  std::vector<std::string> texts;
  const auto* const times = data.find("time_whole");
  if (times == nullptr || !times->has_records || !times->sizes.empty()) return texts;
  for (std::size_t i = 0; i < data.records(); ++i)
    texts.push_back(fmt::format("time {}", data.values<double>(*times, i).front()));
  return texts;
}

}  // namespace

std::vector<std::string> exodus_steps(const File& file) {
  return naming_file(file->path, "", [&] { return steps_of(NetcdfFile(file->bytes)); });
}

std::vector<RawGrid> read_exodus(const FieldSource& source) {
  return naming_file(source.file->path, "", [&] {
    const auto data = std::make_shared<const NetcdfFile>(source.file->bytes);
    const std::vector<std::string> steps = steps_of(*data);
    const std::size_t step = steps.empty() ? 0 : chosen_step(source, steps);
    std::vector<RawGrid> grids;
    grids.push_back(ExodusReader(source, data).read(step, !steps.empty()));
    return grids;
  });
}

}  // namespace tensortopo::detail
