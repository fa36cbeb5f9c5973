// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_check.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tensortopo {

namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

class Components {
 public:
  std::int32_t of(std::int32_t v) {
    auto found = parent_.try_emplace(v, v).first;
    while (found->second != found->first) {
      auto up = parent_.find(found->second);
      found->second = up->second;
      found = up;
    }
    return found->first;
  }
  void join(std::int32_t u, std::int32_t v) { parent_[of(u)] = of(v); }

 private:
  std::map<std::int32_t, std::int32_t> parent_;
};

}  // namespace

bool are_planned_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                        std::span<const std::vector<std::int32_t>> rims,
                        std::span<const SheetTopology> sheets) {
  std::set<Edge> directed;
  Components components;
  std::set<std::int32_t> vertices;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      if (a == b || !directed.emplace(a, b).second) return false;
      components.join(a, b);
      vertices.insert(a);
    }
  std::set<Edge> rim_edges;
  for (const auto& rim : rims)
    for (std::size_t i = 0; i < rim.size(); ++i)
      if (!rim_edges.emplace(rim[i], rim[(i + 1) % rim.size()]).second) return false;
  for (const auto& [a, b] : rim_edges)
    if (!directed.contains({a, b}) || directed.contains({b, a})) return false;
  std::map<std::int32_t, int> euler;
  for (const auto v : vertices) ++euler[components.of(v)];
  for (const auto& t : triangles) ++euler[components.of(t[0])];
  for (const auto& [a, b] : directed) {
    const bool paired = directed.contains({b, a});
    if (!paired && !rim_edges.contains({a, b})) return false;
    if (!paired || a < b) --euler[components.of(a)];
  }
  if (euler.size() != sheets.size()) return false;
  std::set<std::int32_t> taken;
  for (const auto& sheet : sheets) {
    if (sheet.loops.empty()) return false;
    const auto component = components.of(rims[static_cast<std::size_t>(sheet.loops[0])][0]);
    for (const int loop : sheet.loops)
      if (components.of(rims[static_cast<std::size_t>(loop)][0]) != component) return false;
    if (!taken.insert(component).second) return false;
    const auto found = euler.find(component);
    if (found == euler.end() || found->second != sheet.euler_characteristic) return false;
  }
  return true;
}

}  // namespace tensortopo
