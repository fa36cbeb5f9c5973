// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/component_names.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
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

constexpr std::array<Entry, 6> kMeant{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

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

constexpr std::string_view kSeparators = "_-,.:; /([{";

/// The entry that a name ends in: two axes, not after more letters or digits of the kind, or one of
/// x, y, z alone or after a separator. Else the one that its two digits are.
std::optional<Entry> entry_at_end(std::string_view name, std::string_view digits) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto from_end = [&](std::size_t i) { return name[name.size() - 1 - i]; };
  for (const std::string_view axes : {std::string_view("xyz"), digits}) {
    if (name.empty() || axes.find(from_end(0)) == axes.npos) continue;
    const std::size_t last = axes.find(from_end(0));
    const bool is_alone = name.size() == 1 || kSeparators.find(from_end(1)) != axes.npos;
    if (is_alone && axes == "xyz") return Entry{last, last};
    if (name.size() < 2 || axes.find(from_end(1)) == axes.npos) continue;
    if (name.size() > 2 && (axes == "xyz" ? axes.find(from_end(2)) != axes.npos : is_digit(from_end(2))))
      continue;
    return Entry{std::min(axes.find(from_end(1)), last), std::max(axes.find(from_end(1)), last)};
  }
  std::string all;
  std::copy_if(name.begin(), name.end(), std::back_inserter(all), is_digit);
  if (all.size() != 2 || all.find_first_not_of(digits) != all.npos) return std::nullopt;
  return Entry{std::min(digits.find(all[0]), digits.find(all[1])),
               std::max(digits.find(all[0]), digits.find(all[1]))};
}

/// Does one of the names end in another entry than the one in its place?
bool is_contradicted(const std::vector<std::string>& names,
                     const std::array<std::size_t, 6>& places) {
  const bool from_zero = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name.find('0') != name.npos && entry_at_end(name, "012");
  });
  for (std::size_t k = 0; k < 6; ++k) {
    const auto entry = entry_at_end(names[places[k]], from_zero ? "012" : "123");
    if (entry && *entry != kMeant[k]) return true;
  }
  return false;
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
  const std::vector<std::string> stripped = names;
  for (std::string& name : names)
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  std::vector<Entry> entries = entries_of(names);
  if (count == 6)
    for (Entry& e : entries) std::sort(e.begin(), e.end());
  if (entries.empty())
    return is_contradicted(stripped, places) ? Spelling::differs : Spelling::silent;
  if (std::set<Entry>(entries.begin(), entries.end()).size() != count) return Spelling::differs;
  for (std::size_t k = 0; k < 6; ++k) {
    Entry found = entries[places[k]];
    std::sort(found.begin(), found.end());
    if (found != kMeant[k]) return Spelling::differs;
  }
  return Spelling::agrees;
}

}  // namespace certificate
