// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/tensor/component_names.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

namespace tensortopo {
namespace {

constexpr std::string_view separators = "_-,.:; /([{";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c);
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// How many characters all names have in common at the front.
std::size_t common_front(const std::vector<std::string>& names) {
  std::size_t n = names.front().size();
  for (const std::string& name : names) {
    const auto end =
        std::mismatch(name.begin(), name.end(), names.front().begin(), names.front().end());
    n = std::min(n, static_cast<std::size_t>(end.first - name.begin()));
  }
  return n;
}

/// Leaves out what all names begin and end with.
void strip_common(std::vector<std::string>& names) {
  for (int side = 0; side < 2; ++side) {
    const std::size_t n = common_front(names);
    for (std::string& name : names) {
      name.erase(0, n);
      std::reverse(name.begin(), name.end());
    }
  }
}

/// The entry that each name spells, or nothing if one is not understood.
std::vector<std::string> entries_of(const std::vector<std::string>& names) {
  if (names.size() != 6 && names.size() != 9) return {};
  std::vector<std::string> spelled;
  for (const std::string& name : names) spelled.push_back(lower(name));
  strip_common(spelled);
  for (std::string& name : spelled)
    std::erase_if(name, [](char c) { return !is_letter_or_digit(c); });
  std::string axes;
  for (const std::string_view candidate : {"xyz", "123", "012"}) {
    const bool fits = std::all_of(spelled.begin(), spelled.end(), [&](const std::string& name) {
      return !name.empty() && name.size() <= 2 &&
             name.find_first_not_of(candidate) == std::string::npos;
    });
    if (fits) axes = candidate;
    if (fits) break;
  }
  if (axes.empty()) return {};
  std::size_t single = 0;
  for (std::string& name : spelled) {
    for (char& c : name) c = "XYZ"[axes.find(c)];
    if (name.size() == 1) ++single, name += name;
    if (names.size() == 6 && name[0] > name[1]) std::swap(name[0], name[1]);
  }
  if (single != 0 && (single != 3 || names.size() != 6)) return {};
  return spelled;
}

bool has_repeated(const std::vector<std::string>& entries) {
  return std::set<std::string>(entries.begin(), entries.end()).size() != entries.size();
}

/// The entry that a name ends in, of the upper triangle: two axes, not after more letters or digits of
/// the kind, or one of x, y, z alone or after a separator. Else the one that its two digits are, or
/// empty.
std::string entry_at_end(std::string_view name, std::string_view digits) {
  const auto at = [&](std::string_view axes, std::size_t from_end) {
    return name.size() > from_end ? axes.find(name[name.size() - 1 - from_end]) : axes.npos;
  };
  const auto spelled = [](std::size_t a, std::size_t b) {
    return std::string{"XYZ"[std::min(a, b)], "XYZ"[std::max(a, b)]};
  };
  for (const std::string_view axes : {std::string_view("xyz"), digits}) {
    const std::size_t last = at(axes, 0), before = at(axes, 1);
    if (last == axes.npos) continue;
    if (axes == "xyz" && (name.size() == 1 || at(separators, 1) != axes.npos))
      return spelled(last, last);
    if (before != axes.npos && at(axes == "xyz" ? axes : "0123456789", 2) == axes.npos)
      return spelled(before, last);
  }
  std::string all;
  std::copy_if(name.begin(), name.end(), std::back_inserter(all), is_digit);
  if (all.size() != 2 || all.find_first_not_of(digits) != all.npos) return {};
  return spelled(digits.find(all[0]), digits.find(all[1]));
}

/// Whether a name ends in another entry than the order has in its place (`tau_yz`, `E12`).
bool is_contradicted(std::vector<std::string> names, ComponentOrder order) {
  for (std::string& name : names) name = lower(name);
  strip_common(names);
  const bool from_zero = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name.find('0') != name.npos && !entry_at_end(name, "012").empty();
  });
  constexpr std::array<std::string_view, 6> meant{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  const auto places = places_in(order);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string entry = entry_at_end(names[places[k]], from_zero ? "012" : "123");
    if (!entry.empty() && entry != meant[k]) return true;
  }
  return false;
}

/// The order that lists these entries, if we have it.
std::optional<ComponentOrder> order_that_lists(const std::vector<std::string>& entries) {
  std::string listing;
  for (const std::string& name : entries) listing += (listing.empty() ? "" : " ") + name;
  using enum ComponentOrder;
  // Of a symmetric tensor, column by column is the same.
  if (listing == "XX YX ZX XY YY ZY XZ YZ ZZ") return full;
  for (const ComponentOrder order : {vtk, voigt, abaqus, nifti, fsl, full})
    if (listing == listing_of(order)) return order;
  return std::nullopt;
}

}  // namespace

bool are_named(const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), [](const auto& name) { return !name.empty(); });
}

std::vector<std::string> spelled_components(const std::vector<std::string>& names) {
  std::vector<std::string> entries = entries_of(names);
  return has_repeated(entries) ? std::vector<std::string>{} : entries;
}

TensorComponents decide_order(const std::vector<std::string>& names, std::size_t count,
                              std::optional<ComponentOrder> asked,
                              const ComponentsWording& wording) {
  const bool is_full = count == 9;
  if (!are_named(names)) {
    if (asked) return {*asked, ComponentSource::given};
    return {is_full ? ComponentOrder::full : ComponentOrder::vtk, ComponentSource::assumed};
  }
  const auto refuse = [&](const std::string& problem, bool contradicts_caller = false) {
    std::string listing;
    for (const std::string& name : names)
      listing += (listing.empty() ? "" : " ") + name.substr(0, 40);
    throw ComponentNamesError(
        "the components of `" + wording.array + "` are named \"" + listing + "\", " + problem,
        contradicts_caller);
  };
  const std::vector<std::string> entries = entries_of(names);
  if (has_repeated(entries)) refuse("two of them alike; correct the names");
  if (const auto spelled = order_that_lists(entries)) {
    if (asked && *asked != *spelled)
      refuse("which is the order " + std::string(name_of(*spelled)) + "; " + wording.option + " " +
                 std::string(name_of(*asked)) + " contradicts it",
             true);
    return {*spelled, ComponentSource::named};
  }
  if (!entries.empty())
    refuse("an order that is not supported; write them " +
           std::string(is_full ? "row by row" : "in an order that has a name, as XX YY ZZ XY YZ XZ"));
  if (!asked)
    refuse("which says no order; " + (is_full ? "name them XX XY XZ YX ..., or not at all"
                                              : "say it with " + wording.option));
  if (is_contradicted(names, *asked))
    refuse("some of which end in other entries; " + wording.option + " " +
               std::string(name_of(*asked)) + " contradicts them",
           true);
  return {*asked, ComponentSource::given};
}

}  // namespace tensortopo
