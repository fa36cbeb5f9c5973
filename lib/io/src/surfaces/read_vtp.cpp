// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "surfaces/read_formats.hpp"
#include "surfaces/surface_builder.hpp"
#include "vtk/xml_document.hpp"

namespace tensortopo::detail {
namespace {

/// The only child of this name, or none; two of them could be read in two ways.
pugi::xml_node only_child(pugi::xml_node parent, const char* name) {
  const pugi::xml_node child = parent.child(name);
  if (child.next_sibling(name)) throw FormatError(std::string("has two sections ") + name);
  return child;
}

std::uint64_t count_of(pugi::xml_node piece, const char* name) {
  const std::uint64_t count = piece.attribute(name) ? count_attribute(piece, name) : 0;
  require_memory(count, count, 0);
  return count;
}

std::vector<std::int64_t> integers(const XmlDocument& document, pugi::xml_node section,
                                   const char* name, std::size_t count) {
  pugi::xml_node found;
  for (const pugi::xml_node array : section.children("DataArray")) {
    if (array.attribute("Name").value() != std::string_view(name)) continue;
    if (found) throw FormatError(std::string("has two arrays ") + name);
    found = array;
  }
  if (!found) throw FormatError(std::string("has no array ") + name);
  if (components_of(found) != 1)
    throw FormatError(std::string("the array ") + name + " must have one component");
  return read_array<std::int64_t>(document, found, count, name);
}

/// The lists of points of one section, numbered within the piece.
std::vector<std::vector<std::int64_t>> read_lists(const XmlDocument& document, pugi::xml_node piece,
                                                  const char* section, const char* counted,
                                                  std::size_t points) {
  const std::uint64_t count = count_of(piece, counted);
  std::vector<std::vector<std::int64_t>> lists;
  const pugi::xml_node node = only_child(piece, section);
  if (count == 0) return lists;
  const auto ends = integers(document, node, "offsets", count);
  if (ends.back() < 0) throw FormatError("cell offsets are negative");
  require_memory(points, count, static_cast<std::uint64_t>(ends.back()));
  const auto corners =
      integers(document, node, "connectivity", static_cast<std::size_t>(ends.back()));
  std::int64_t begin = 0;
  for (const std::int64_t end : ends) {
    if (end < begin || end > ends.back())
      throw FormatError("cell offsets do not rise within the connectivity (" +
                        std::string(section) + ", cell " + std::to_string(lists.size()) + ")");
    lists.emplace_back(corners.begin() + begin, corners.begin() + end);
    for (const std::int64_t v : lists.back())
      if (v < 0 || static_cast<std::size_t>(v) >= points)
        throw FormatError("a cell names point " + std::to_string(v) + " of " +
                          std::to_string(points) + " points (" + section + ", cell " +
                          std::to_string(lists.size() - 1) + ")");
    begin = end;
  }
  return lists;
}

bool is_integer_array(pugi::xml_node array) {
  const auto type = xml_element_type(array.attribute("type").value());
  return type && is_integer(*type);
}

std::vector<SurfaceArray> read_data(const XmlDocument& document, pugi::xml_node section,
                                    std::size_t tuples) {
  std::vector<SurfaceArray> arrays;
  for (const pugi::xml_node node : section.children("DataArray")) {
    SurfaceArray array{
        node.attribute("Name").value(), components_of(node), {}, is_integer_array(node)};
    if (array.components > 1000)
      throw FormatError("the array `" + array.name.substr(0, 80) + "` has too many components");
    for (const SurfaceArray& other : arrays)
      if (other.name == array.name)
        throw FormatError("has two arrays `" + array.name.substr(0, 80) + "`");
    if (arrays.size() == 1000) throw FormatError("has too many arrays");
    array.values = read_array<double>(document, node, tuples * array.components,
                                      "`" + array.name.substr(0, 80) + "`");
    arrays.push_back(std::move(array));
  }
  return arrays;
}

/// The cells of a piece in the order of its data: vertices, lines, polygons, strips.
struct Cells {
  std::vector<std::vector<std::int64_t>> verts, lines, polygons, strips;

  std::size_t size() const { return verts.size() + lines.size() + polygons.size() + strips.size(); }
};

/// Appends a piece's arrays to those before, which must be the same.
void append(std::vector<SurfaceArray>& all, std::vector<SurfaceArray> more, bool is_first) {
  if (is_first) {
    all = std::move(more);
    return;
  }
  bool same = all.size() == more.size();
  for (std::size_t i = 0; same && i < all.size(); ++i)
    same = all[i].name == more[i].name && all[i].components == more[i].components;
  if (!same) throw FormatError("has other arrays than the pieces before");
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].is_integer = all[i].is_integer && more[i].is_integer;
    all[i].values.insert(all[i].values.end(), more[i].values.begin(), more[i].values.end());
  }
}

/// The values of one cell, for each array.
void copy_cell(const std::vector<SurfaceArray>& from, std::size_t cell,
               std::vector<SurfaceArray>& to) {
  for (std::size_t a = 0; a < from.size(); ++a)
    for (std::size_t k = 0; k < from[a].components; ++k)
      to[a].values.push_back(from[a].values[cell * from[a].components + k]);
}

std::vector<SurfaceArray> without_values(const std::vector<SurfaceArray>& arrays) {
  std::vector<SurfaceArray> result;
  for (const SurfaceArray& array : arrays)
    result.push_back({array.name, array.components, {}, array.is_integer});
  return result;
}

struct Piece {
  SurfaceFile surface;
  std::vector<SurfaceArray> line_data, polygon_data;
};

Piece read_piece(const XmlDocument& document, pugi::xml_node node) {
  Piece piece;
  SurfaceFile& surface = piece.surface;
  const std::uint64_t points = count_of(node, "NumberOfPoints");
  if (points > 0) {
    const pugi::xml_node section = only_child(node, "Points");
    const pugi::xml_node array = only_child(section, "DataArray");
    if (!array) throw FormatError("has no array in <Points>");
    if (components_of(array) != 3) throw FormatError("points must have three components");
    const auto x = read_array<double>(document, array, 3 * points, "Points");
    for (std::size_t i = 0; i < x.size(); i += 3) add_point(surface, {x[i], x[i + 1], x[i + 2]});
  }
  const auto lists = [&](const char* section, const char* counted) {
    return read_lists(document, node, section, counted, points);
  };
  const Cells cells{lists("Verts", "NumberOfVerts"), lists("Lines", "NumberOfLines"),
                    lists("Polys", "NumberOfPolys"), lists("Strips", "NumberOfStrips")};
  const pugi::xml_node point_data = only_child(node, "PointData");
  surface.point_data = read_data(document, point_data, points);
  surface.scalars = point_data.attribute("Scalars").value();
  surface.normals = point_data.attribute("Normals").value();
  const auto data = read_data(document, only_child(node, "CellData"), cells.size());
  piece.line_data = piece.polygon_data = without_values(data);
  std::size_t cell = cells.verts.size();
  for (const auto& line : cells.lines) {
    if (line.size() >= 2) copy_cell(data, cell, piece.line_data);
    add_line(surface, line);
    ++cell;
  }
  for (const auto& polygon : cells.polygons) {
    if (polygon.size() >= 3) copy_cell(data, cell, piece.polygon_data);
    add_polygon(surface, polygon);
    ++cell;
  }
  for (const auto& strip : cells.strips) {
    for (std::size_t i = 2; i < strip.size(); ++i) {
      const std::size_t odd = i % 2;
      const std::array<std::int64_t, 3> triangle{strip[i - 2 + odd], strip[i - 1 - odd], strip[i]};
      copy_cell(data, cell, piece.polygon_data);
      add_polygon(surface, triangle);
    }
    ++cell;
  }
  return piece;
}

void append(IndexLists& all, const IndexLists& more, std::size_t first_point) {
  const std::size_t first = all.points.size();
  for (const std::int32_t v : more.points)
    all.points.push_back(static_cast<std::int32_t>(first_point + static_cast<std::size_t>(v)));
  for (const std::size_t end : more.ends) all.ends.push_back(first + end);
}

/// Texts that say nothing of the surface itself: one that cannot be read is left out.
std::map<std::string, std::string> read_texts(const XmlDocument& document, pugi::xml_node section) {
  std::map<std::string, std::string> texts;
  for (const pugi::xml_node array : section.children("Array")) {
    try {
      if (const auto text = read_string(document, array); text && texts.size() < 1000)
        texts[array.attribute("Name").value()] = *text;
    } catch (const FormatError&) {
      continue;
    }
  }
  return texts;
}

}  // namespace

SurfaceFile read_vtp(const std::shared_ptr<const InputFile>& file) {
  const auto document = parse_xml(file, "PolyData");
  SurfaceFile all;
  std::vector<SurfaceArray> line_data, polygon_data;
  bool is_first = true;
  const pugi::xml_node data = only_child(document->root, "PolyData");
  all.texts = read_texts(*document, data.child("FieldData"));
  for (const pugi::xml_node node : data.children("Piece")) {
    Piece piece = read_piece(*document, node);
    const std::size_t before = all.points.size();
    require_memory(before + piece.surface.points.size(), 0, 0);
    all.points.insert(all.points.end(), piece.surface.points.begin(), piece.surface.points.end());
    append(all.lines, piece.surface.lines, before);
    append(all.polygons, piece.surface.polygons, before);
    append(all.point_data, std::move(piece.surface.point_data), is_first);
    if (is_first) {
      all.scalars = piece.surface.scalars;
      all.normals = piece.surface.normals;
    }
    append(line_data, std::move(piece.line_data), is_first);
    append(polygon_data, std::move(piece.polygon_data), is_first);
    is_first = false;
  }
  if (is_first) throw FormatError("holds no surface: no element Piece");
  all.cell_data = std::move(line_data);
  append(all.cell_data, std::move(polygon_data), false);
  return all;
}

}  // namespace tensortopo::detail
