// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/compare_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "union_find.hpp"

namespace certificate {
namespace {

using Name = std::pair<std::string, std::string>;

std::string text_of(const Name& name) { return "array '" + name.second + "' of the " + name.first; }

const Array* find(const std::vector<Array>& arrays, const char* of, const char* name) {
  for (const Array& array : arrays)
    if (array.of == of && array.name == name && array.components == 1) return &array;
  return nullptr;
}

/// Is no double nearer?
bool is_nearest(double x, const mpq_class& exact) {
  const auto distance = [&](double y) { return mpq_class(abs(mpq_class(y) - exact)); };
  const double up = std::nextafter(x, INFINITY), down = std::nextafter(x, -INFINITY);
  return std::isfinite(up) && std::isfinite(down) && distance(x) <= distance(up) &&
         distance(x) <= distance(down);
}

/// The array has the level's number at each of its vertices.
/// @param exact  nothing if the level has another kind of number
void compare_numbers(const Array& array, const Json& range, const std::optional<mpq_class>& exact,
                     Ledger& ledger) {
  const Number first = range[0], end = first + range[1].get<Number>();
  std::optional<double> known;  // mostly all are the same
  for (Number v = first; v < end; ++v) {
    const double x = array.numbers[v];
    if (known == x) continue;
    if (!exact || !is_nearest(x, *exact))
      return ledger.refute(array.name + " at vertex " + std::to_string(v), Json(x).dump(),
                           exact ? exact->get_str() : "none");
    known = x;
  }
  ledger.certify();
}

/// Components are numbered in the order of their first cells, those of a level after those of the
/// levels before.
/// @param kind  of the cells: "triangles" or "lines"
template <class Cells>
void compare_components(const Array& array, const Json& levels, const char* kind,
                        const Cells& cells, Ledger& ledger) {
  std::size_t next = 0;
  for (const Json& level : levels) {
    const Number first = level[kind][0], end = first + level[kind][1].get<Number>();
    UnionFind joined;
    for (Number t = first; t < end; ++t)
      for (const std::uint32_t v : cells[t]) joined.join(cells[t][0], v);
    std::map<std::size_t, std::size_t> number;
    for (Number t = first; t < end; ++t) {
      const std::size_t component = joined.find(cells[t][0]);
      const auto [it, is_new] = number.try_emplace(component, next);
      next += is_new ? 1 : 0;
      if (array.numbers[t] != static_cast<double>(it->second))
        return ledger.refute("component of " + std::string(kind, std::strlen(kind) - 1) + ' ' +
                                 std::to_string(t),
                             Json(array.numbers[t]).dump(), std::to_string(it->second));
    }
  }
  ledger.certify();
}

}  // namespace

void compare_hashes(const Json& file_claims, const std::vector<Array>& arrays, Ledger& ledger) {
  const auto claims = file_claims.find("arrays");
  if (claims == file_claims.end()) {
    if (!arrays.empty())
      ledger.leave_open(
          text_of({arrays[0].of, arrays[0].name}) + (arrays.size() > 1 ? " and others" : ""),
                        "arrays are not bound by this certificate");
    return;
  }
  std::map<Name, std::array<std::string, 2>> found;  // as claimed, as there
  for (const Json& claim : *claims)
    found[{claim[0], claim[1]}][0] = claim[2].dump() + " components, " + claim[3].dump();
  for (const Array& array : arrays)
    found[{array.of, array.name}][1] =
        std::to_string(array.components) + " components, " + Json(array.sha256()).dump();
  for (auto& [name, texts] : found) {
    for (std::string& text : texts)
      if (text.empty()) text = "none";
    ledger.settle(texts[0] == texts[1], text_of(name), texts[0], texts[1]);
  }
}

namespace {

bool is_name_of_vectors(const std::string& name) {
  return name == "medium_eigenvector" || name == "dominant_eigenvector" || name == "normal";
}

/// Arrays whose names are claims have one number each, or are vectors, and belong where they mean
/// something, so that a reader of the file finds in them what was compared.
/// @param kind  of the cells
void compare_shapes(const std::vector<Array>& arrays, const std::string& kind, bool of_modes,
                    Ledger& ledger) {
  for (const Array& array : arrays) {
    const bool is_number = array.name == "mode" || array.name == "value";
    const bool is_vector = is_name_of_vectors(array.name);
    if (!is_number && !is_vector && array.name != "component") continue;
    const std::string of = array.name == "component" ? kind : "points";
    const std::size_t components = is_vector ? 3 : 1;
    if (array.of != of)
      ledger.refute(text_of({array.of, array.name}), "of the " + array.of, "of the " + of);
    else if (array.components != components)
      ledger.refute(text_of({array.of, array.name}),
                    std::to_string(array.components) + " components",
                    std::to_string(components) + (is_vector ? " components" : " component"));
    else if (is_number && (array.name == "mode") != of_modes)
      ledger.refute(text_of({array.of, array.name}), "a number of each level",
                    "the levels have another");
  }
}

bool are_of_modes(const Json& levels) {
  return std::all_of(levels.begin(), levels.end(),
                     [](const Json& level) { return level.contains("mode"); });
}

}  // namespace

void compare_arrays(const Json& levels, const Triangles& surface, Ledger& ledger) {
  if (!surface.points.empty())
    compare_shapes(surface.arrays, "triangles", are_of_modes(levels), ledger);
  const Array* const modes = find(surface.arrays, "points", "mode");
  const Array* const values = find(surface.arrays, "points", "value");
  for (const Json& level : levels) {
    std::optional<mpq_class> mode, value;
    if (level.contains("mode")) {
      mode = mode_of(level["mode"]);
    } else {
      value = value_of(level["value"], invariant_of(level["invariant"]));
    }
    if (modes != nullptr) compare_numbers(*modes, level["vertices"], mode, ledger);
    if (values != nullptr) compare_numbers(*values, level["vertices"], value, ledger);
  }
  if (const Array* components = find(surface.arrays, "triangles", "component"))
    compare_components(*components, levels, "triangles", surface.triangles, ledger);
}

void compare_arrays(const Json& levels, const Polylines& curves, Ledger& ledger) {
  compare_shapes(curves.arrays, "lines", true, ledger);
  if (const Array* const modes = find(curves.arrays, "points", "mode"))
    for (const Json& level : levels)
      compare_numbers(*modes, level["vertices"], static_cast<int>(kind_of(level["mode"])), ledger);
  if (const Array* components = find(curves.arrays, "lines", "component"))
    compare_components(*components, levels, "lines", curves.lines, ledger);
}

}  // namespace certificate
