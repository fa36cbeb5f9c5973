// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/read_vti.hpp"

#include <array>
#include <string>
#include <utility>

#include "bytes/element.hpp"
#include "bytes/format_error.hpp"
#include "bytes/words.hpp"
#include "formats/xml_arrays.hpp"
#include "tensortopo/io/io_error.hpp"

namespace tensortopo::detail {
namespace {

/// Exactly `Count` numbers in an attribute.
template <class Value, std::size_t Count>
std::array<Value, Count> numbers_of(pugi::xml_node node, const char* name, const char* otherwise) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute && otherwise == nullptr)
    throw FormatError(std::string("has no ") + name + " in <" + node.name() + ">");
  std::string_view text = attribute ? attribute.value() : otherwise;
  constexpr auto type = std::is_integral_v<Value> ? ElementType::i32 : ElementType::f64;
  std::array<Value, Count> numbers{};
  for (Value& x : numbers) x = from_text<Value>(take_word(text), type);
  if (!take_word(text).empty())
    throw FormatError(std::string("has too many numbers in ") + name + " of <" + node.name() + ">");
  return numbers;
}

RawGrid read_image_piece(const std::shared_ptr<const XmlDocument>& document, pugi::xml_node image,
                         pugi::xml_node piece) {
  const auto origin = numbers_of<double, 3>(image, "Origin", nullptr);
  const auto spacing = numbers_of<double, 3>(image, "Spacing", nullptr);
  const auto direction = numbers_of<double, 9>(image, "Direction", "1 0 0 0 1 0 0 0 1");
  const auto extent = numbers_of<std::int64_t, 6>(piece, "Extent", nullptr);
  Lattice lattice;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t low = extent[2 * a], high = extent[2 * a + 1];
    if (high < low) throw FormatError("has an empty Extent");
    lattice.first[a] = low;
    lattice.size[a] = static_cast<std::size_t>(high - low + 1);
    for (std::size_t b = 0; b < 3; ++b) lattice.to_space[a][b] = direction[3 * a + b] * spacing[b];
    lattice.to_space[a][3] = origin[a];
  }
  check_lattice(lattice);
  RawGrid grid;
  grid.file = document->file->path;
  grid.point_data = list_arrays(document, piece.child("PointData"), lattice.points());
  grid.cell_data = list_arrays(document, piece.child("CellData"), lattice.cubes());
  grid.lattice = std::move(lattice);
  return grid;
}

}  // namespace

std::vector<RawGrid> read_vti(const FieldSource& source) {
  return naming_file(source.file->path, "", [&] {
    const auto document = parse_xml(source.file, "ImageData");
    const pugi::xml_node image = document->root.child("ImageData");
    std::vector<RawGrid> grids;
    for (const pugi::xml_node piece : image.children("Piece"))
      grids.push_back(read_image_piece(document, image, piece));
    if (grids.empty()) throw FormatError("holds no image: no element Piece");
    return grids;
  });
}

}  // namespace tensortopo::detail
