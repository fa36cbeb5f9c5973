// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/tensor/component_order.hpp"

#include <utility>

namespace tensortopo {
namespace {

struct Entry {
  std::string_view name, listing;
  std::array<std::uint8_t, 6> places;
};

constexpr std::array<Entry, 6> entries{{
    {"vtk", "XX YY ZZ XY YZ XZ", {0, 1, 2, 3, 4, 5}},
    {"voigt", "XX YY ZZ YZ XZ XY", {0, 1, 2, 5, 3, 4}},
    {"abaqus", "XX YY ZZ XY XZ YZ", {0, 1, 2, 3, 5, 4}},
    {"nifti", "XX XY YY XZ YZ ZZ", {0, 2, 5, 1, 4, 3}},
    {"fsl", "XX XY XZ YY YZ ZZ", {0, 3, 5, 1, 4, 2}},
    {"full", "XX XY XZ YX YY YZ ZX ZY ZZ", {0, 4, 8, 1, 5, 2}},
}};

constexpr std::array<std::pair<std::string_view, ComponentOrder>, 7> names{{
    {"vtk", ComponentOrder::vtk},
    {"voigt", ComponentOrder::voigt},
    {"abaqus", ComponentOrder::abaqus},
    {"mrtrix", ComponentOrder::abaqus},
    {"nifti", ComponentOrder::nifti},
    {"dipy", ComponentOrder::nifti},
    {"fsl", ComponentOrder::fsl},
}};

const Entry& entry(ComponentOrder order) { return entries[static_cast<std::size_t>(order)]; }

}  // namespace

std::string TensorComponents::text() const {
  const char* const why = source == ComponentSource::named   ? "named in the file"
                          : source == ComponentSource::given ? "as given"
                                                             : "assumed";
  return std::string(listing_of(order)) + " (" + std::string(name_of(order)) + ", " + why + ")";
}

std::string_view name_of(ComponentOrder order) { return entry(order).name; }

std::string_view listing_of(ComponentOrder order) { return entry(order).listing; }

std::optional<ComponentOrder> component_order(std::string_view name) {
  for (const auto& [known, order] : names)
    if (known == name) return order;
  return std::nullopt;
}

const std::vector<std::string_view>& component_order_names() {
  static const std::vector<std::string_view> list = [] {
    std::vector<std::string_view> result;
    for (const auto& [name, order] : names) result.push_back(name);
    return result;
  }();
  return list;
}

std::array<std::uint8_t, 6> places_in(ComponentOrder order) { return entry(order).places; }

}  // namespace tensortopo
