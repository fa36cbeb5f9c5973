// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_vtu.hpp"

#include <iterator>
#include <string>
#include <utility>

#include "bytes/format_error.hpp"
#include "formats/xml_arrays.hpp"
#include "vtk/xml_document.hpp"

namespace tensortopo::detail {
namespace {

using Document = std::shared_ptr<const XmlDocument>;

pugi::xml_node named_array(pugi::xml_node parent, const char* name) {
  const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
  if (!array) throw FormatError(std::string("has no array ") + name + " in <Cells>");
  if (components_of(array) != 1)
    throw FormatError(std::string("the array ") + name + " must have one component");
  return array;
}

void read_cells(const Document& document, pugi::xml_node piece, std::size_t cells, RawGrid& grid) {
  const pugi::xml_node parent = piece.child("Cells");
  grid.offsets.assign(1, 0);
  if (cells == 0) return;
  const auto integers = [&](const char* name, std::size_t count) {
    return read_array<std::int64_t>(*document, named_array(parent, name), count, name);
  };
  for (const std::int64_t type : integers("types", cells)) {
    if (type < 0 || type > 255)
      throw FormatError("has the unknown cell type " + std::to_string(type) + " (cell " +
                        std::to_string(grid.types.size()) + ")");
    grid.types.push_back(static_cast<std::uint8_t>(type));
  }
  const auto ends = integers("offsets", cells);
  grid.offsets.insert(grid.offsets.end(), ends.begin(), ends.end());
  if (ends.back() < 0) throw FormatError("cell offsets are negative");
  const auto corners = static_cast<std::uint64_t>(ends.back());
  require_memory(grid.points(), cells, corners);
  grid.connectivity = integers("connectivity", corners);
}

RawGrid read_piece(const Document& document, pugi::xml_node piece) {
  RawGrid grid;
  grid.file = document->file->path;
  const std::uint64_t points = count_attribute(piece, "NumberOfPoints");
  const std::uint64_t cells = count_attribute(piece, "NumberOfCells");
  require_memory(points, cells, 0);
  if (points > 0) {
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    if (!array) throw FormatError("has no array in <Points>");
    if (components_of(array) != 3) throw FormatError("points must have three components");
    grid.coordinates = read_array<double>(*document, array, 3 * points, "Points");
  }
  read_cells(document, piece, cells, grid);
  check_cells(grid);
  grid.point_data = list_arrays(document, piece.child("PointData"), points);
  grid.cell_data = list_arrays(document, piece.child("CellData"), cells);
  return grid;
}

}  // namespace

std::vector<RawGrid> read_vtu(const std::shared_ptr<const InputFile>& file) {
  const Document document =
      naming_file(file->path, "", [&] { return parse_xml(file, "UnstructuredGrid"); });
  std::vector<RawGrid> grids;
  for (const pugi::xml_node piece : document->root.child("UnstructuredGrid").children("Piece")) {
    const std::string place = grids.empty() && !piece.next_sibling("Piece")
                                  ? ""
                                  : "piece " + std::to_string(grids.size());
    grids.push_back(naming_file(file->path, place, [&] { return read_piece(document, piece); }));
  }
  if (grids.empty())
    throw IoError(IoError::Kind::invalid, file->path, "holds no grid: no element Piece");
  return grids;
}

std::vector<std::filesystem::path> read_pvtu(const std::shared_ptr<const InputFile>& file) {
  return naming_file(file->path, "", [&] {
    const Document document = parse_xml(file, "PUnstructuredGrid");
    std::vector<std::filesystem::path> pieces;
    for (const pugi::xml_node piece : document->root.child("PUnstructuredGrid").children("Piece")) {
      const std::string source = piece.attribute("Source").value();
      if (source.empty())
        throw FormatError("names no file for piece " + std::to_string(pieces.size()));
      pieces.push_back(file->path.parent_path() / source);
    }
    if (pieces.empty()) throw FormatError("names no pieces");
    return pieces;
  });
}

}  // namespace tensortopo::detail
