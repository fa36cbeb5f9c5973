// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/curves/curve_graph.hpp"

#include <algorithm>

namespace tensortopo {

CurveGraph::CurveGraph(const std::vector<CurveLink>& links, std::size_t places)
    : links_(links), first_at_(places + 1, 0), link_at_(2 * links.size()) {
  for (const auto& link : links)
    for (const std::size_t end : link.ends) ++first_at_[end + 1];
  for (std::size_t p = 0; p < places; ++p) first_at_[p + 1] += first_at_[p];
  auto next = first_at_;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const std::size_t end : links[i].ends) link_at_[next[end]++] = i;
}

/// On as long as just one link goes on, until all around.
void CurveGraph::walk(CurveStep step, std::vector<char>& used,
                      std::vector<CurveStep>& steps) const {
  while (true) {
    used[step.link] = 1;
    steps.push_back(step);
    const std::size_t place = links_[step.link].ends[1 - step.from];
    const auto links = at(place);
    if (links.size() != 2) return;
    const std::size_t next = links[0] == step.link ? links[1] : links[0];
    if (used[next]) return;
    step = {next, links_[next].ends[0] == place ? 0u : 1u};
  }
}

std::vector<CurveStep> CurveGraph::component_of(std::size_t link, std::vector<char>& used) const {
  std::vector<std::size_t> found{link}, places;
  used[link] = 1;
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const std::size_t place : links_[found[i]].ends) {
      places.push_back(place);
      for (const std::size_t next : at(place))
        if (!used[next]) {
          used[next] = 1;
          found.push_back(next);
        }
    }
  for (const std::size_t i : found) used[i] = 0;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<CurveStep> steps;
  const auto start_at = [&](std::size_t place) {
    for (const std::size_t next : at(place))
      if (!used[next]) walk({next, links_[next].ends[0] == place ? 0u : 1u}, used, steps);
  };
  for (const std::size_t place : places)
    if (at(place).size() != 2) start_at(place);
  if (steps.empty()) start_at(places.front());
  return steps;
}

std::vector<std::vector<CurveStep>> CurveGraph::components() const {
  std::vector<std::vector<CurveStep>> result;
  std::vector<char> used(links_.size(), 0);
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (!used[i]) result.push_back(component_of(i, used));
  return result;
}

}  // namespace tensortopo
