// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "grids/joined_scalars.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "tensortopo/tensor/component_names.hpp"

namespace tensortopo::detail {
namespace {

bool is_axis(char c) { return std::string_view("xyzXYZ123").find(c) != std::string_view::npos; }

/// The places of XX, YY, ... (of nine: XX, XY, XZ, YX, ...) among names; empty if they are not all
/// there.
std::vector<std::size_t> places_of(const std::vector<std::string>& spelled) {
  const std::vector<std::string> six{"XX", "YY", "ZZ", "XY", "YZ", "XZ"},
      nine{"XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"};
  std::vector<std::size_t> places;
  for (const std::string& name : spelled.size() == 6 ? six : nine) {
    const auto found = std::find(spelled.begin(), spelled.end(), name);
    if (found == spelled.end()) return {};
    places.push_back(static_cast<std::size_t>(found - spelled.begin()));
  }
  return places;
}

}  // namespace

ArraySource joined(std::string name, std::span<const ArraySource> parts) {
  std::vector<std::function<std::vector<double>()>> columns;
  for (const ArraySource& part : parts) columns.push_back(part.values);
  ArraySource result{std::move(name), columns.size(), {}, {}};
  result.values = [columns] {
    std::vector<double> all;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::vector<double> column = columns[c]();
      all.resize(column.size() * columns.size());
      for (std::size_t i = 0; i < column.size(); ++i) all[i * columns.size() + c] = column[i];
    }
    return all;
  };
  return result;
}

void add_joined_scalars(std::vector<ArraySource>& arrays) {
  std::map<std::string, std::vector<const ArraySource*>> groups;
  for (const ArraySource& array : arrays) {
    const std::size_t n = array.name.size();
    if (array.components == 1 && n > 2 && is_axis(array.name[n - 1]) && is_axis(array.name[n - 2]))
      groups[array.name.substr(0, n - 2)].push_back(&array);
  }
  std::vector<ArraySource> tensors;
  for (const auto& [prefix, members] : groups) {
    std::vector<std::string> names;
    for (const ArraySource* member : members) names.push_back(member->name);
    const std::vector<std::string> spelled = spelled_components(names);
    const std::vector<std::size_t> places =
        spelled.empty() ? std::vector<std::size_t>{} : places_of(spelled);
    if (places.empty()) continue;
    std::vector<ArraySource> parts;
    std::vector<std::string> in_order;
    for (const std::size_t place : places) {
      in_order.push_back(names[place]);
      parts.push_back(*members[place]);
    }
    ArraySource tensor = joined(prefix, parts);
    tensor.component_names = in_order;
    while (tensor.name.size() > 1 && (tensor.name.back() == '_' || tensor.name.back() == '-'))
      tensor.name.pop_back();
    tensors.push_back(std::move(tensor));
  }
  for (ArraySource& tensor : tensors) arrays.push_back(std::move(tensor));
}

}  // namespace tensortopo::detail
