// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/component_names.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

namespace certificate {
namespace {

/// Leaves out what all names begin with.
void strip_front(std::vector<std::string>& names) {
  const auto all_have = [&](std::size_t k) {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return k < name.size() && name[k] == names[0][k];
    });
  };
  std::size_t common = 0;
  while (all_have(common)) ++common;
  for (std::string& name : names) name.erase(0, common);
}

using Entry = std::array<std::size_t, 2>;  ///< row and column

/// Nothing if one is not understood.
std::vector<Entry> entries_of(const std::vector<std::string>& names) {
  for (const std::string_view axes : {"xyz", "123", "012"}) {
    std::vector<Entry> result;
    for (const std::string& name : names) {
      const std::size_t row = name.empty() ? axes.npos : axes.find(name.front());
      const std::size_t column = name.empty() ? axes.npos : axes.find(name.back());
      if (name.size() > 2 || row == axes.npos || column == axes.npos) break;
      result.push_back({row, column});
    }
    if (result.size() == names.size()) return result;
  }
  return {};
}

}  // namespace

Spelling spelling_of(std::vector<std::string> names, const std::array<std::size_t, 6>& places) {
  const std::size_t count = names.size();
  if (count != 6 && count != 9) return Spelling::silent;
  for (std::string& name : names)
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (int side = 0; side < 2; ++side) {
    strip_front(names);
    for (std::string& name : names) std::reverse(name.begin(), name.end());
  }
  for (std::string& name : names)
    std::erase_if(name, [](char c) { return std::string_view("_-,.:; /").find(c) != std::string_view::npos; });
  std::vector<Entry> entries = entries_of(names);
  if (count == 6)
    for (Entry& e : entries) std::sort(e.begin(), e.end());
  if (entries.empty()) return Spelling::silent;
  if (std::set<Entry>(entries.begin(), entries.end()).size() != count) return Spelling::differs;
  constexpr std::array<Entry, 6> kMeant{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  for (std::size_t k = 0; k < 6; ++k) {
    Entry found = entries[places[k]];
    std::sort(found.begin(), found.end());
    if (found != kMeant[k]) return Spelling::differs;
  }
  return Spelling::agrees;
}

}  // namespace certificate
