// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/persistence/loop_pairs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {
namespace {

constexpr std::size_t kNoClass = std::numeric_limits<std::size_t>::max();

/// The changes to a component since it last had no loops.
struct LoopComponent {
  std::vector<const LoopChange*> births, deaths;
  long rank = 0;             ///< its first Betti number
  bool is_doubtful = false;  ///< that is not known
  bool is_tie = false;
  std::vector<std::size_t> last_pairs;  ///< made where it last had no loops
  std::size_t last_point = kNoClass;
  double last_low = 2;  ///< the least bound at the last point
  double low = 2;       ///< and at all before
};

/// Either a merge or a change.
struct Step {
  double middle = 0;
  const ModeMerge* merge = nullptr;
  const LoopChange* change = nullptr;
};

bool are_one_mode(const std::vector<const LoopChange*>& changes) {
  return std::all_of(changes.begin(), changes.end(), [&](const LoopChange* c) {
    return c->mode.low == c->mode.high && c->mode.low == changes.front()->mode.low;
  });
}

class LoopPairing {
 public:
  explicit LoopPairing(std::size_t maxima) : classes_(maxima), components_(maxima) {}

  std::vector<LoopPair> run(const std::vector<Step>& steps,
                            const std::vector<std::size_t>& doubtful) {
    for (const std::size_t i : doubtful) components_[i].is_doubtful = true;
    for (const Step& step : steps) {
      if (step.merge != nullptr)
        add(*step.merge);
      else if (step.change->member)
        add(*step.change);
      else
        // Any component may be the one.
        for (LoopComponent& component : components_) component.is_doubtful = true;
    }
    for (std::size_t i = 0; i < components_.size(); ++i) {
      const LoopComponent& component = components_[i];
      if (classes_.find(static_cast<std::uint32_t>(i)) != i || component.is_doubtful ||
          !component.deaths.empty())
        continue;
      for (const LoopChange* birth : component.births)
        for (std::size_t n = 0; n < birth->count; ++n)
          pairs_.push_back({birth->event, std::nullopt, component.is_tie});
    }
    return std::move(pairs_);
  }

 private:
  LoopComponent& component_of(std::size_t member) {
    return components_[classes_.find(static_cast<std::uint32_t>(member))];
  }

  /// Notes whether the enclosure of a change to a component overlaps one before at another point.
  void look_at(LoopComponent& component, std::size_t point, const ModeRange& mode) {
    if (point != component.last_point) {
      component.low = std::min(component.low, component.last_low);
      component.last_point = point;
      component.last_low = mode.low;
    }
    component.last_low = std::min(component.last_low, mode.low);
    if (mode.high < component.low) return;
    component.is_tie = true;
    for (const std::size_t i : component.last_pairs) pairs_[i].is_tie = true;
  }

  void add(const ModeMerge& merge) {
    if (!merge.is_proved) {
      if (merge.possible)
        for (const std::size_t i : *merge.possible) component_of(i).is_doubtful = true;
      else
        for (LoopComponent& component : components_) component.is_doubtful = true;
      return;
    }
    for (std::size_t k = 1; k < merge.reached.size(); ++k) {
      const auto i = classes_.find(static_cast<std::uint32_t>(merge.reached[0]));
      const auto j = classes_.find(static_cast<std::uint32_t>(merge.reached[k]));
      if (i == j) continue;
      LoopComponent a = std::move(components_[i]), b = std::move(components_[j]);
      for (LoopComponent* part : {&a, &b}) look_at(*part, merge.point, merge.mode);
      if (a.births.size() + a.deaths.size() < b.births.size() + b.deaths.size()) std::swap(a, b);
      a.births.insert(a.births.end(), b.births.begin(), b.births.end());
      a.deaths.insert(a.deaths.end(), b.deaths.begin(), b.deaths.end());
      a.rank += b.rank;
      a.is_doubtful |= b.is_doubtful;
      a.is_tie |= b.is_tie;
      a.last_pairs.insert(a.last_pairs.end(), b.last_pairs.begin(), b.last_pairs.end());
      a.low = std::min(a.low, b.low);
      a.last_low = std::min(a.last_low, b.last_low);
      classes_.unite(i, j);
      component_of(merge.reached[0]) = std::move(a);
    }
  }

  void add(const LoopChange& change) {
    LoopComponent& component = component_of(*change.member);
    component.is_doubtful |= change.is_open;
    look_at(component, change.point, change.mode);
    if (component.is_doubtful) return;
    (change.is_birth ? component.births : component.deaths).push_back(&change);
    const long count = static_cast<long>(change.count);
    component.rank += change.is_birth ? count : -count;
    if (component.rank < 0) component.is_doubtful = true;
    if (component.rank != 0 || component.is_doubtful) return;
    component.last_pairs.clear();
    make_pairs(component);
    component.births.clear();
    component.deaths.clear();
    component.is_tie = false;
  }

  void make_pairs(LoopComponent& component) {
    if (!are_known(component)) return;
    std::vector<std::size_t> births, deaths;
    for (const auto& [from, to] :
         {std::pair(&component.births, &births), std::pair(&component.deaths, &deaths)})
      for (const LoopChange* change : *from) to->insert(to->end(), change->count, change->event);
    for (std::size_t i = 0; i < births.size(); ++i) {
      component.last_pairs.push_back(pairs_.size());
      pairs_.push_back({births[i], deaths[i], component.is_tie});
    }
  }

  static bool are_known(const LoopComponent& component) {
    return component.births.size() == 1 || component.deaths.size() == 1 ||
           are_one_mode(component.births) || are_one_mode(component.deaths);
  }

  UnionFind classes_;
  std::vector<LoopComponent> components_;
  std::vector<LoopPair> pairs_;
};

}  // namespace

std::vector<LoopPair> loop_pairs(const MergeTree& tree, const std::vector<LoopChange>& changes,
                                 const std::vector<std::size_t>& doubtful) {
  std::vector<Step> steps;
  for (const ModeMerge& merge : tree.merges)
    // One that is not proved may be as early as its enclosure.
    steps.push_back({merge.is_proved ? merge.mode.middle() : merge.mode.high, &merge, nullptr});
  for (const LoopChange& change : changes)
    steps.push_back({change.member && !change.is_open ? change.mode.middle() : change.mode.high,
                     nullptr, &change});
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.middle > b.middle; });
  return LoopPairing(tree.maxima.size()).run(steps, doubtful);
}

}  // namespace tensortopo
