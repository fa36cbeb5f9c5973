// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "grids/joined_scalars.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "grids/component_names.hpp"

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

void add_joined_scalars(std::vector<ArraySource>& arrays) {
  std::map<std::string, std::vector<const ArraySource*>> groups;
  for (const ArraySource& array : arrays) {
    const std::size_t n = array.name.size();
    if (array.components == 1 && n > 2 && is_axis(array.name[n - 1]) && is_axis(array.name[n - 2]))
      groups[array.name.substr(0, n - 2)].push_back(&array);
  }
  std::vector<ArraySource> joined;
  for (const auto& [prefix, members] : groups) {
    std::vector<std::string> names;
    for (const ArraySource* member : members) names.push_back(member->name);
    const std::vector<std::string> spelled = spelled_components(names);
    const std::vector<std::size_t> places = spelled.empty() ? std::vector<std::size_t>{}
                                                            : places_of(spelled);
    if (places.empty()) continue;
    ArraySource tensor{prefix, places.size(), {}, {}};
    while (tensor.name.size() > 1 && (tensor.name.back() == '_' || tensor.name.back() == '-'))
      tensor.name.pop_back();
    std::vector<std::function<std::vector<double>()>> parts;
    for (const std::size_t place : places) {
      tensor.component_names.push_back(names[place]);
      parts.push_back(members[place]->values);
    }
    tensor.values = [parts] {
      std::vector<double> all;
      for (std::size_t c = 0; c < parts.size(); ++c) {
        const std::vector<double> part = parts[c]();
        all.resize(part.size() * parts.size());
        for (std::size_t i = 0; i < part.size(); ++i) all[i * parts.size() + c] = part[i];
      }
      return all;
    };
    joined.push_back(std::move(tensor));
  }
  for (ArraySource& tensor : joined) arrays.push_back(std::move(tensor));
}

}  // namespace tensortopo::detail
