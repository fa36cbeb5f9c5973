// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vtk/known_attributes.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

namespace tensortopo::detail {
namespace {

using Names = std::vector<std::string_view>;

bool is_known(const pugi::xml_node& element, std::string_view attribute) {
  static const Names of_data{"Scalars",   "Vectors",     "Normals",  "Tensors",
                             "TCoords",   "Tangents",    "GlobalIds", "PedigreeIds",
                             "EdgeFlag",  "RationalWeights", "HigherOrderDegrees", "ProcessIds"};
  static const Names of_array{"type", "Name", "NumberOfComponents", "format", "offset",
                              "RangeMin", "RangeMax"};
  static const std::map<std::string_view, Names> known{
      {"VTKFile", {"type", "version", "byte_order", "header_type", "compressor"}},
      {"Piece",
       {"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips",
        "NumberOfPolys"}},
      {"PointData", of_data},
      {"CellData", of_data},
      {"DataArray", of_array},
      {"Array", of_array},
      {"AppendedData", {"encoding"}},
      {"InformationKey", {"name", "location", "length"}},
      {"Value", {"index"}}};
  const std::string_view of = element.name();
  const auto found = known.find(of);
  if (found == known.end()) return false;
  const Names& names = found->second;
  if (std::find(names.begin(), names.end(), attribute) != names.end()) return true;
  if (of != "DataArray" && of != "Array") return false;
  if (attribute == "NumberOfTuples")
    return element.parent().name() == std::string_view("FieldData");
  constexpr std::string_view name = "ComponentName";
  return attribute.starts_with(name) && attribute.size() > name.size() &&
         attribute.find_first_not_of("0123456789", name.size()) == std::string_view::npos;
}

struct Walker : pugi::xml_tree_walker {
  bool for_each(pugi::xml_node& node) override {
    if (node.type() != pugi::node_element) return true;
    for (const pugi::xml_attribute a : node.attributes())
      if (!is_known(node, a.name()))
        found = "attribute '" + std::string(a.name()) + "' of '" + node.name() + "'";
    return !found;
  }
  std::optional<std::string> found;
};

}  // namespace

std::optional<std::string> unknown_attribute(const pugi::xml_node& root) {
  Walker walker;
  pugi::xml_node node = root;
  if (walker.for_each(node)) node.traverse(walker);
  return walker.found;
}

}  // namespace tensortopo::detail
